# Every build of the intro for Windows, in Wine. Source this file.
# shellcheck shell=bash disable=SC2154

# start_wine: starts Wine and a window manager, once. Sets `wine`, and `own`, the intro for Linux.
start_wine() {
    [[ -z ${wine:-} ]] || return 0
    tests/install /usr/lib/wine/wine64=wine64
    wine=/usr/lib/wine/wine64 wineserver=/usr/lib/wine/wineserver64
    export WINEPREFIX=$folder/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree=;mshtml='
    start_x
    start_openbox
    # A server that ends between programs would reset the second's connection.
    mkdir "$WINEPREFIX"
    $wineserver --persistent
    $wine wineboot --init > /dev/null 2>&1
    cargo build --quiet --release --package eightfold --bin eightfold
    # The linked program starts faster than the packed one. Other builds leave theirs in the same folder.
    for own in "${CARGO_TARGET_DIR:-target}"/release/deps/eightfold-*.unpacked; do
        ! cmp -s "${own%.unpacked}" "${CARGO_TARGET_DIR:-target}/release/eightfold" || break
    done
}

# try_windows PROGRAM: tests any build for Windows: text, frames, window, keys, fullscreen, sound.
try_windows() {
    local program=$1 code=0
    echo "eightfold.exe: $(stat -c %s "$program") bytes"
    # Subsystem 2 opens no console.
    [[ $(objdump -p "$program") == *"Windows GUI"* ]] || fail "opens a console"
    $wine "$program" --help | tr -d '\r' | diff - <("$own" --help) || fail "--help differs from Linux"
    $wine "$program" --size 0 2> "$folder/error" || code=$?
    [[ $code == 2 && $(< "$folder/error") == *"--size is '0'; must be WxH: "* ]] || wrong "$code" 2 "$folder/error"
    local still=(--still 47 --size 320x240 --quality exhaustive)
    $wine "$program" "${still[@]}" | cmp - <("$own" "${still[@]}") || fail "frame differs from Linux"

    cat > "$folder/asound.conf" << END
pcm.!default { type file, slave.pcm { type null }, file "$folder/heard", format raw }
ctl.!default { type hw, card 0 }
END
    rm -f "$folder/heard"
    ALSA_CONFIG_PATH=$folder/asound.conf $wine "$program" --seconds 600 --size 640x400 --fps 20 --quality thesis > "$folder/report" 2> "$folder/errors" &
    local intro=$!
    eventually has_size Eightfold 640x400
    eventually shows_picture Eightfold windows
    xdotool search --name Eightfold windowactivate
    eventually has_size_by f Eightfold 1280x800
    eventually shows_picture Eightfold windows-fullscreen
    eventually has_size_by w Eightfold 640x400
    xdotool key q
    wait $intro || wrong $? 0
    grep "frames in" "$folder/report" || fail "report is missing"
    [[ ! -s $folder/errors ]] || fail "$(< "$folder/errors")"
    (($(tr -d '\0' < "$folder/heard" | wc -c) > 0)) || fail "sound is missing"
}

# first_samples FILE: prints the first 400 stereo samples after the silence.
first_samples() {
    od -An -v -t f4 -w8 "$1" | awk '$1 != 0 || $2 != 0 { seen = 1 } seen { print } seen && ++count == 400 { exit }'
}

# try_modes PROGRAM: tests that fullscreen follows the monitor's mode without a window manager.
try_modes() {
    tests/install xrandr=x11-xserver-utils
    kill "$manager"
    xrandr --newmode small 40 800 840 968 1056 600 601 605 628
    xrandr --addmode screen small
    $wine "$1" --silent --seconds 600 --size 400x300 --fps 20 --quality thesis > "$folder/report" &
    local intro=$!
    eventually has_size Eightfold 400x300
    xdotool search --onlyvisible --name Eightfold windowfocus
    eventually has_size_by f Eightfold 1280x800
    xrandr --output screen --mode small
    eventually has_size Eightfold 800x600
    xdotool key q
    wait $intro || wrong $? 0
    xrandr --output screen --mode 1280x800
}

exe() {
    start_wine
    cargo exe --quiet
    local program=${CARGO_TARGET_DIR:-target}/exe/eightfold.exe
    try_windows "$program"
    try_exe "$program"
    try_modes "$program"
}
