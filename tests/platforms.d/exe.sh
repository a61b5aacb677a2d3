# The 64 KiB build for Windows, in Wine. Source this file.
# shellcheck shell=bash disable=SC2154

# try_exe PROGRAM: tests the 64 KiB build for Windows, after `try_windows`.
try_exe() {
    local program=$1
    try_code
    try_frames
    try_damage
    try_consoleless
    try_arguments
    try_libraries
    try_sound
    try_two_windows
    try_console
}

# No instruction accesses memory below the stack pointer; `lea` does not access memory.
try_code() {
    local folder=${CARGO_TARGET_DIR:-target}/exe linked stub code_of code
    linked=$(ls -t "$folder"/deps/eightfold-*.unpacked | head -n 1)
    stub=$(ls -t "$folder"/build/eightfold-*/out/linker/stub.o | head -n 1)
    for code_of in "$linked" "$stub"; do
        code=$(objdump -d --no-show-raw-insn "$code_of") || fail "objdump cannot read $code_of"
        ! grep -v '\<lea ' <<< "$code" | grep -e '-0x[0-9a-f]*(%rsp' || fail "memory below the stack pointer is used"
    done
}

# Frames have the bits of Linux in every scene, by every instruction set of this CPU.
try_frames() {
    local isa seconds
    for isa in $("$own" --help | sed -n 's/^--isa NAME .*: //p'); do
        for seconds in 5 17 33 47 60 75 86 98 110; do
            local still=(--still "$seconds" --size 160x120 --isa "$isa")
            $wine "$program" "${still[@]}" | cmp - <("$own" "${still[@]}") || fail "frame of $isa at $seconds s differs from Linux"
        done
    done
}

# Damaged files print an error, truncated files do not start, and no memory is both writable and executable.
try_damage() {
    local at code intro
    for at in 800 5000 40000; do
        code=0
        cp "$program" "$folder/damaged.exe"
        printf damaged. | dd of="$folder/damaged.exe" bs=1 seek=$at conv=notrunc status=none
        $wine "$folder/damaged.exe" --version > "$folder/report" 2> "$folder/error" || code=$?
        [[ $code == 1 && $(< "$folder/error") == "eightfold: this file is damaged" ]] || wrong "$code at byte $at" 1 "$folder/error"
        head -c $at "$program" > "$folder/cut.exe"
        ! timeout 20 $wine "$folder/cut.exe" --version > "$folder/report" 2>&1 || wrong "0 after $at bytes" 1
    done
    $wine "$program" --still 47 --size 3840x2160 --quality exhaustive > "$folder/still" &
    intro=$!
    eventually eval "grep -q '^0042[1-9a-f].* r-xp' /proc/$intro/maps"
    ! grep "^004.* rwx" /proc/$intro/maps || fail "memory is writable and executable"
    kill $intro
    wait $intro || true
}

# Output fails with an exit code, except without a console, as by a double click.
try_consoleless() {
    local code=0
    $wine "$program" --version > /dev/full || code=$?
    [[ $code == 1 ]] || wrong "$code" 1
    $wine start /wait /unix "$program" --version > "$folder/report" || wrong $? 0
    [[ ! -s $folder/report ]] || fail "$(< "$folder/report")"
}

# Bad arguments have the text and the exit code of Linux.
try_arguments() {
    local code=0
    $wine "$program" "--quality=\"é\\\" x" 2> "$folder/error" || code=$?
    [[ $code == 2 && $(< "$folder/error") == *"--quality is '\"?\\\" x'; must be NAME: "* ]] || wrong "$code" 2 "$folder/error"
    local line words own_code
    while read -r line; do
        read -ra words <<< "$line"
        code=0 own_code=0
        "$own" "${words[@]}" > "$folder/report" 2> "$folder/errors" || own_code=$?
        $wine "$program" "${words[@]}" < /dev/null > "$folder/second" 2> "$folder/error" || code=$?
        cmp "$folder/second" "$folder/report" || fail "$line: output differs from Linux"
        tr -d '\r' < "$folder/error" | diff - "$folder/errors" || fail "$line: error differs from Linux"
        ((code == own_code)) || fail "$line: exit code is $code; must be $own_code"
    done << END
--version
--size 3841x2160
--size
--threads 65
--nonsense
--still 116
--quality best
--quality fine --exhaustive
--isa=neon
--loop=1
--psnr 0
--still=3 --size=33x17
END

    $wine "$program" --silent --threads 64 --seconds 0.5 --size 320x200 | grep -q "threads 64" || fail "thread count differs from 64"
}

# The error names a missing library.
try_libraries() {
    local code=0
    WINEDLLOVERRIDES="$WINEDLLOVERRIDES;winmm=" $wine "$program" --version 2> "$folder/error" || code=$?
    [[ $code == 1 && $(tr -d '\r' < "$folder/error") == "eightfold: winmm.dll is missing" ]] || wrong "$code" 1 "$folder/error"
}

# Sound has the first samples of Linux. Without a device the intro plays silently.
try_sound() {
    mv "$folder/heard" "$folder/heard.windows"
    env -u DISPLAY ALSA_CONFIG_PATH="$folder/asound.conf" "$own" --seconds 1 --size 64x48 > /dev/null 2>&1
    cmp <(first_samples "$folder/heard.windows") <(first_samples "$folder/heard") || fail "sound differs from Linux"

    local drivers=('HKCU\Software\Wine\Drivers' /v Audio)
    $wine reg add "${drivers[@]}" /d '' /f > /dev/null
    $wine "$program" --seconds 0.5 --size 320x200 > /dev/null 2> "$folder/errors" || wrong $? 0
    $wine reg delete "${drivers[@]}" /f > /dev/null
    [[ $(tr -d '\r' < "$folder/errors") == *"eightfold: sound device is missing; playing silently"* ]] || fail "$(< "$folder/errors")"
}

# Two windows: the first is resized and minimised while the second plays, and closed.
try_two_windows() {
    local intro second window
    $wine "$program" --silent --seconds 600 --size 640x400 --fps 20 --quality thesis > "$folder/report" &
    intro=$!
    eventually has_size Eightfold 640x400
    window=$(xdotool search --onlyvisible --name Eightfold)
    xdotool windowsize "$window" 320 200
    eventually has_size Eightfold 320x200
    eventually shows_picture "$window" windows-resized
    xdotool windowminimize "$window"
    eventually is_hidden "$window"
    $wine "$program" --silent --seconds 600 --size 400x300 > "$folder/second" 2>&1 &
    second=$!
    eventually shows_second
    sleep 1
    xdotool key Escape
    wait $second || wrong $? 0
    xdotool windowactivate "$window"
    eventually has_size Eightfold 320x200
    wmctrl -ic "$window"
    wait $intro || wrong $? 0
    [[ $(cat "$folder/report" "$folder/second" | grep -c "frames in") == 2 ]] || fail "count of reports differs from 2"
}

# A console shows the report with ± in it. The intro ends with its console.
try_console() {
    local intro
    local console=("$wine cmd /c $program --silent --quality fastest --size 320x200" "$folder/console")
    script -qec "${console[0]} --seconds 5" "${console[1]}" < /dev/null > /dev/null || wrong $? 0
    # The console wraps at 80 columns.
    tr -d '\r\n' < "${console[1]}" | grep -q " ± .* dB to exhaustive, " || fail "$(< "${console[1]}")"
    # Under `nohup`, the hangup that ends a console is ignored.
    env --default-signal=HUP script -qec "${console[0]} --seconds 600" "${console[1]}" < /dev/null > /dev/null 2>&1 &
    intro=$!
    eventually has_size Eightfold 320x200
    kill -KILL $intro
    eventually is_gone Eightfold
}
