# Assertions about programs on other platforms. Source this file.
# shellcheck shell=bash

fail() {
    echo "FAILED: ${place:-${BASH_SOURCE[1]}:${BASH_LINENO[0]}}: $1" >&2
    exit 1
}

# wrong CODE EXPECTED [FILE]: fails because of an exit code.
wrong() {
    local place=${BASH_SOURCE[1]}:${BASH_LINENO[0]}
    fail "exit code is $1; must be $2${3:+: $(< "$3")}"
}

# eventually COMMAND...: retries a command for two minutes, since the machine can be busy.
eventually() {
    local end=$((SECONDS + 120))
    while ((SECONDS < end)); do
        "$@" > /dev/null 2>&1 && return
        sleep 0.1
    done
    fail "not within two minutes: $*"
}
