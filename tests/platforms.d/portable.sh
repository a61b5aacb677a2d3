# The portable backend, on X and in Weston. Source this file.
# shellcheck shell=bash disable=SC2154

# build_portable: builds the intro and the lab with the portable backend. Sets `portable`, their folder.
build_portable() {
    portable=$built/portable/release
    CARGO_TARGET_DIR=$built/portable cargo build --quiet --release --package eightfold --package eightfold-lab \
        --features eightfold/portable --bin eightfold --bin lab
}

# play ARGUMENT...: starts the portable intro. Sets `intro`, its process.
play() {
    "$portable/eightfold" --silent --loop "$@" > "$folder/report" 2> "$folder/errors" &
    intro=$!
}

# reports_by COMMAND...: whether the intro prints its report after a command.
reports_by() {
    "$@"
    sleep 0.5
    [[ -s $folder/report ]]
}

# ends_by COMMAND...: asserts that a command ends the intro, with a report and without errors.
ends_by() {
    eventually reports_by "$@"
    wait "$intro" || wrong $? 0 "$folder/errors"
    [[ ! -s $folder/errors ]] || fail "$(< "$folder/errors")"
    grep "frames in" "$folder/report" || fail "report is missing"
}

# shows_numbers: whether the corner of the intro's window has white letters, about 280 pixels. The eclipse's stars have three there.
shows_numbers() {
    [[ $(import -window Eightfold -crop 250x30+0+0 +repage -threshold 99% -format '%[fx:mean*w*h>50]' info:-) == 1 ]]
}

differs() {
    ! import -window "$1" rgb:- | cmp -s - "$2"
}

portable() {
    CARGO_TARGET_DIR=$built/portable cargo test --quiet --package eightfold-window --features portable
    build_portable
    start_x
    start_openbox
    play --size 640x400
    eventually has_size Eightfold 640x400
    eventually shows_picture Eightfold portable
    ! shows_numbers || fail "numbers are shown before h"
    xdotool search --name Eightfold windowactivate --sync key h
    eventually shows_numbers
    # A held key counts once.
    xdotool keydown h sleep 1.2 keyup h sleep 0.5
    ! shows_numbers || fail "numbers are shown after a held key"
    xdotool search --name Eightfold windowsize 320 200
    eventually has_size Eightfold 320x200
    eventually shows_picture Eightfold portable-resized
    ends_by xdotool key Escape
    play --size 320x200
    eventually has_size Eightfold 320x200
    ends_by xdotool search --name Eightfold windowactivate --sync key q
    play --size 320x200
    eventually has_size Eightfold 320x200
    ends_by wmctrl -c Eightfold

    "$portable/lab" view --scene model --time 2 --size 320x200 > "$folder/report" 2> "$folder/errors" &
    intro=$!
    local window
    window=$(xdotool search --sync --onlyvisible --name Eightfold)
    eventually shows_picture "$window" portable-view
    xdotool windowactivate --sync "$window" mousemove --window "$window" 160 100
    local input
    for input in "click 4" "key Right"; do
        sleep 1
        import -window "$window" rgb:"$folder/before"
        # shellcheck disable=SC2086
        xdotool $input
        eventually differs "$window" "$folder/before"
    done
    xdotool key Escape
    wait $intro || wrong $? 0 "$folder/errors"
}

# shows_desktop: whether the screen is not black, and the same for half a second. Leaves a screenshot.
shows_desktop() {
    shows_picture root wayland-before || return
    sleep 0.5
    shows_picture root wayland-desktop && cmp <(convert "$built/wayland-before.png" rgb:-) \
        <(convert "$built/wayland-desktop.png" rgb:-)
}

# differing NAME PART: takes a screenshot, and prints the number of pixels in a part that differ from the desktop.
differing() {
    import -window root "$built/$1.png"
    compare -extract "$2" -metric AE "$built/wayland-desktop.png" "$built/$1.png" null: 2>&1 || true
}

# covers NAME WIDTHxHEIGHT SHARE: whether a share of an area differs from the desktop. Leaves a screenshot.
covers() {
    awk -v differing="$(differing "$1" 1280x800+0+0)" -v sides="$2" -v share="$3" \
        'BEGIN { split(sides, side, "x"); exit !(differing > side[1] * side[2] * share) }'
}

wayland() {
    tests/install weston=weston compare=imagemagick
    build_portable
    start_x
    # Weston has a keyboard and a pointer, which minifb needs, only inside an X window.
    export XDG_RUNTIME_DIR=$folder/runtime WAYLAND_DISPLAY=eightfold
    mkdir -m 700 "$XDG_RUNTIME_DIR"
    weston --backend=x11-backend.so --use-pixman --socket=eightfold --width=1280 --height=800 --no-config > /dev/null 2>&1 &
    started+=($!)
    eventually test -S "$XDG_RUNTIME_DIR/eightfold"
    eventually shows_desktop
    play
    eventually covers wayland 1024x768 0.9
    # Without a window manager Weston gets the focus by hand.
    xdotool windowfocus "$(xwininfo -name "Weston Compositor - screen0" | awk '/Window id/ { print $4 }')"
    xdotool mousemove 640 400
    sleep 1
    xdotool click 1
    sleep 1
    ends_by xdotool key Escape
}
