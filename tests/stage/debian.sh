# Debian's Rust 1.96, which can compile the standard library for other platforms. Source this file.

# fetch_debian_rust FOLDER: downloads Rust and unpacks it into a folder, once, without installing it. Sets `debian`, an array of
# NAME=VALUE for `env` that selects it. Fails if apt does not have it.
fetch_debian_rust() {
    local folder=$1 package
    mkdir -p "$folder"
    [[ -x $folder/root/usr/bin/rustc ]] || unpack_debian_rust || return
    local usr=$folder/root/usr
    debian=(PATH="$usr/bin:$PATH" RUSTC="$usr/bin/rustc" LD_LIBRARY_PATH="$usr/lib/x86_64-linux-gnu")
}

unpack_debian_rust() {
    (cd "$folder" && apt-get download rustc-web cargo-web rust-web-src libstd-rust-web-1.96 libstd-rust-web-dev libllvm22 \
        libgit2-1.5 libssh2-1 libmbedcrypto7 libmbedtls14 libmbedx509-1 libhttp-parser2.9) > /dev/null 2>&1 || return
    for package in "$folder"/*.deb; do
        dpkg -x "$package" "$folder/root"
    done
}
