# An X server, and the windows on it. Source this file.
# shellcheck shell=bash disable=SC2154

# start_x: starts an X server with a screen of 1280x800. Sets DISPLAY.
start_x() {
    tests/install Xvfb=xvfb xdotool=xdotool import=imagemagick xwininfo=x11-utils
    exec 9> "$folder/display"
    Xvfb -displayfd 9 -screen 0 1280x800x24 -nolisten tcp -noreset > /dev/null 2>&1 &
    started+=($!)
    eventually grep -q . "$folder/display"
    DISPLAY=:$(< "$folder/display")
    export DISPLAY
}

start_openbox() {
    tests/install openbox=openbox wmctrl=wmctrl
    openbox > /dev/null 2>&1 &
    manager=$!
    started+=("$manager")
    eventually wmctrl -m
}

# has_size NAME WIDTHxHEIGHT: whether a visible window has this size.
has_size() {
    local window
    window=$(xwininfo -name "$1")
    [[ $window == *"-geometry $2"[+-]* && $window == *IsViewable* ]]
}

# has_size_by KEY NAME WIDTHxHEIGHT: presses a key until a window has this size. Keys are lost before the window has the focus.
has_size_by() {
    has_size "$2" "$3" || { xdotool key "$1" && sleep 0.3 && has_size "$2" "$3"; }
}

# shows_picture WINDOW NAME: whether at most a tenth of a window is black. Leaves a screenshot.
shows_picture() {
    local picture=$built/$2.png coloured
    import -window "$1" "$picture"
    coloured=$(convert "$picture" -fill white +opaque black -format '%[fx:mean]' info:)
    awk -v coloured="$coloured" 'BEGIN { exit !(coloured > 0.9) }'
}

# shows_second: whether the only visible window is 400x300.
shows_second() {
    local window
    window=$(xdotool search --onlyvisible --name Eightfold) && [[ $(xwininfo -id "$window") == *"-geometry 400x300"[+-]* ]]
}

is_hidden() {
    [[ $(xwininfo -id "$1") == *IsUnMapped* ]]
}

is_gone() {
    ! xwininfo -name "$1"
}
