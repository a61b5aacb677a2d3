# Builds of the intro, and rows about them. Source this file.
# shellcheck shell=bash disable=SC2154

# row NAME BYTES REMARK: prints a row of the lane's table.
row() {
    printf '%-32s %10s  %s\n' "$@" | tee -a "$lane/table"
}

failed() {
    tail -n 30 "$lane/log"
    row "$1" "" "FAILED: $2"
}

# judge NAME PROGRAM: tests that a program runs, and measures it.
judge() {
    if [[ $("$2" --version) == eightfold\ * ]]; then
        measure "$@"
    else
        failed "$1" "--version differs; must be eightfold"
    fi
}

# measure NAME PROGRAM: prints the size, and the warning about it.
measure() {
    local name=$1 program=$2 size warnings
    size=$(stat -c %s "$program")
    warnings=$(grep -E 'warning: .*(not packed|must be at most)' "$lane/log" | sort -u || true)
    if ((size > 65536)) && [[ $(grep -c . <<< "$warnings") != 1 ]]; then
        failed "$name" "$size bytes, and not one warning: $warnings"
    else
        row "$name" "$size" "${warnings#*warning: }"
    fi
}

# fit NAME PROGRAM: tests that a program also fits.
fit() {
    judge "$@"
    if (($(stat -c %s "$2") > 65536)); then
        failed "$1" "over 65,536 bytes"
    fi
}

# build TEST NAME PROGRAM COMMAND...: builds a program, and tests it by fit, judge or measure.
build() {
    local test=$1 name=$2 program=$3
    shift 3
    if "$@" > "$lane/log" 2>&1; then
        "$test" "$name" "$program"
    else
        failed "$name" "does not build"
    fi
}

# try NAME VARIABLE=VALUE...: builds the intro. A named target lets all flags share the build scripts.
try() {
    local name=$1 place=$lane/${COMPILER:-default}
    shift
    rm -f "$place/$target/release/eightfold"
    build "${TEST:-judge}" "$name" "$place/$target/release/eightfold" env CARGO_TARGET_DIR="$place" "$@" \
        cargo build --release --target "$target" --package eightfold --bin eightfold
}
