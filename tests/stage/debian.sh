# Debian's Rust 1.96, which can compile the standard library for other platforms; to be sourced.

# Fetches it with the source of the standard library and unpacks it into a folder, nothing being installed, unless it is there
# already. Fails where apt does not have it. On success `debian` is an array of NAME=VALUE for `env`, by which cargo and rustc are Debian's.
fetch_debian_rust() {
    local folder=$1 package
    mkdir -p "$folder"
    [[ -x $folder/root/usr/bin/rustc ]] || unpack_debian_rust || return
    local usr=$folder/root/usr
    debian=(PATH="$usr/bin:$PATH" RUSTC="$usr/bin/rustc" LD_LIBRARY_PATH="$usr/lib/x86_64-linux-gnu")
}

# Does so into $folder.
unpack_debian_rust() {
    (cd "$folder" && apt-get download rustc-web cargo-web rust-web-src libstd-rust-web-1.96 libstd-rust-web-dev libllvm22 \
        libgit2-1.5 libssh2-1 libmbedcrypto7 libmbedtls14 libmbedx509-1 libhttp-parser2.9) > /dev/null 2>&1 || return
    for package in "$folder"/*.deb; do
        dpkg -x "$package" "$folder/root"
    done
}
