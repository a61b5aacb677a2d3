# The page, in Node.js and in browsers. Source this file.
# shellcheck shell=bash disable=SC2154

# site: builds the page, by Debian's compiler if rustup cannot add the target. Leaves the output in $folder/site.
site() {
    local root=$PWD
    # Sets the tolerance of README.md's size in percent: changes of the tracer and Debian's compiler change the size.
    if rustup target add wasm32-unknown-unknown > /dev/null 2>&1; then
        percent=1
        # In its own folder it does not wait for other builds.
        (cd "$built" && CARGO_TARGET_DIR=$built/wasm "$root/src/web/build" site) | tee "$folder/site"
    else
        percent=2
        # Without backtraces, the standard library takes an eighth less time.
        (cd "$built" && by_debian env \
            CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER="$(rustc --print sysroot)/lib/rustlib/x86_64-unknown-linux-gnu/bin/rust-lld" \
            "$root/src/web/build" site -Zbuild-std=std,panic_abort -Zbuild-std-features=) | tee "$folder/site"
    fi
}

# try_build: tests the errors and the output of src/web/build.
try_build() {
    printf '#!/bin/sh\necho /nowhere\n' > "$folder/rustc"
    chmod +x "$folder/rustc"
    ! RUSTC=$folder/rustc src/web/build "$folder/none" > /dev/null 2> "$folder/error" || wrong 0 1
    grep -q "rustup target add wasm32-unknown-unknown" "$folder/error" || fail "$(< "$folder/error")"
    [[ ! -e $folder/none ]] || fail "folder is left behind"
    ! src/web/build > /dev/null 2> "$folder/error" || wrong 0 1
    grep -q "usage: src/web/build FOLDER" "$folder/error" || fail "$(< "$folder/error")"
    # The path is relative to the current folder.
    [[ ! -e site && -e $built/site/index.html ]] || fail "page is missing from $built/site"
    grep -q "^Building eightfold.bin" "$folder/site" || fail "progress is missing"
    grep -q "^Serve it: *python3 -m http.server --directory site$" "$folder/site" || fail "command for a server is missing"
}

wasm() {
    tests/install node=nodejs convert=imagemagick
    convert tests/golden/model.png -depth 8 rgb:"$folder/model"
    [[ -e $folder/site ]] || site
    local module
    for module in eightfold plain; do
        echo "$module.bin: $(node tests/web/frame.mjs "$built/site/$module.bin" "$folder/model")"
    done
}

# start_sound: starts PulseAudio with a null device in real time.
start_sound() {
    tests/install pulseaudio=pulseaudio
    mkdir -m 700 "$folder/pulse"
    PULSE_RUNTIME_PATH=$folder/pulse pulseaudio -n --daemonize=no --exit-idle-time=-1 --load=module-null-sink \
        --load="module-native-protocol-unix socket=$folder/pulse/native" > /dev/null 2>&1 &
    started+=($!)
    eventually test -S "$folder/pulse/native"
}

web() {
    tests/install node=nodejs chromium=chromium firefox-esr=firefox-esr WebKitWebDriver=webkit2gtk-driver
    # Cargo would link both modules again.
    [[ -e $folder/site ]] || site
    try_build
    local bytes
    # A browser loads the page and one of the modules.
    bytes=$(sed -n 's/^site: .* bytes, \([0-9,]*\) of which a browser loads$/\1/p' "$folder/site" | tr -d ,)
    ((bytes <= 320000)) || fail "page size is $bytes; must be at most 320000"
    local stated
    stated=$(sed -n 's/^| browsers |.*| \([0-9][0-9,]*\) by `src\/web\/build` |.*/\1/p' README.md | tr -d ,)
    ((stated * 100 > bytes * (100 - percent) && stated * 100 < bytes * (100 + percent))) || fail "README.md: page size is $stated; must be $bytes"
    # SIMD128 is as wide as SSE2. The build shares the tracer of the intro's release build.
    CARGO_BUILD_BUILD_DIR=${built%/platforms} CARGO_TARGET_DIR=$built/sse2 cargo build --quiet --release --package eightfold \
        --bin eightfold --features sse2
    local intro=$built/sse2/release/eightfold
    # The file device plays as fast as it can write.
    cat > "$folder/asound.conf" << END
pcm.!default { type file, slave.pcm { type null }, file "$folder/heard", format raw }
ctl.!default { type hw, card 0 }
END
    env -u DISPLAY ALSA_CONFIG_PATH="$folder/asound.conf" "$intro" --seconds 5 --size 64x48
    node tests/web/page.mjs "$built/site" "$intro" "$folder/heard" "$built"
    # WebKit never resumes PulseAudio's null device, so it plays without a device.
    local none=unix:$folder/none
    PULSE_SERVER=$none node tests/web/engines.mjs firefox "$built/site" "$intro" silent
    start_sound
    start_x
    PULSE_SERVER=$none node tests/web/engines.mjs webkit "$built/site" "$intro"
    PULSE_SERVER=unix:$folder/pulse/native node tests/web/engines.mjs firefox "$built/site" "$intro"
    node tests/web/engines.mjs chromium "$built/site" "$intro"
}
