# The library and the intro for other processors and systems. Source this file.
# shellcheck shell=bash disable=SC2154

compile() {
    local target
    for target in aarch64-unknown-linux-gnu aarch64-apple-darwin x86_64-apple-darwin x86_64-pc-windows-gnu \
        i686-unknown-linux-gnu riscv64gc-unknown-linux-gnu wasm32-unknown-unknown thumbv7em-none-eabihf; do
        echo "The library for $target"
        RUSTFLAGS=-Dwarnings by_debian cargo check --quiet --package eightfold-tracer --package eightfold --lib \
            --no-default-features -Zbuild-std=core --target "$target"
    done
    # There is no compiler here for the Objective-C part of minifb.
    echo "The intro for aarch64-apple-darwin"
    by_debian env SDKROOT=/ CC_aarch64_apple_darwin=true AR_aarch64_apple_darwin=true cargo check --quiet --package eightfold \
        --bin eightfold -Zbuild-std=std,panic_abort --target aarch64-apple-darwin
}

aarch64() {
    tests/install aarch64-linux-gnu-gcc=gcc-aarch64-linux-gnu aarch64-linux-gnu-g++=g++-aarch64-linux-gnu \
        qemu-aarch64-static=qemu-user-static compare=imagemagick
    local compilers=(CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
        CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER="qemu-aarch64-static -L /usr/aarch64-linux-gnu"
        CC_aarch64_unknown_linux_gnu=aarch64-linux-gnu-gcc CXX_aarch64_unknown_linux_gnu=aarch64-linux-gnu-g++)
    local test=(env "${compilers[@]}" cargo test --quiet --no-default-features -Zbuild-std --target aarch64-unknown-linux-gnu
        --package eightfold)
    by_debian "${test[@]}" --package eightfold-tracer --lib
    # The show's golden pictures need the program for x86-64.
    by_debian "${test[@]}" --test image -- golden:: --skip show_matches_golden_pictures

    # Without a display: there is no libX11 for this CPU here.
    by_debian env "${compilers[@]}" cargo build --quiet --release --package eightfold --bin eightfold \
        -Zbuild-std=std,panic_abort --target aarch64-unknown-linux-gnu
    local program=$built/debian/aarch64-unknown-linux-gnu/release/eightfold
    echo "The intro for aarch64: $(stat -c %s "$program") bytes"
    local intro=(qemu-aarch64-static -L /usr/aarch64-linux-gnu "$program")
    cargo build --quiet --release --package eightfold --bin eightfold
    local still=(--still 47 --size 320x240 --quality exhaustive)
    "${intro[@]}" "${still[@]}" > "$folder/neon.ppm"
    "${CARGO_TARGET_DIR:-target}/release/eightfold" "${still[@]}" > "$folder/own.ppm"
    # Silhouettes: at most one pixel in a thousand differs by more than 1/255.
    local apart
    apart=$(compare -metric AE -fuzz 0.4% "$folder/neon.ppm" "$folder/own.ppm" null: 2>&1) || true
    awk -v apart="$apart" 'BEGIN { exit !(apart <= 76) }' || fail "pixels unlike x86-64: $apart; must be at most 76"
    env -u DISPLAY "${intro[@]}" --silent --seconds 0.5 --size 64x48 | grep "frames in"
}
