# Summarises the output of `cargo test`: a line per suite, the total, and the failed tests.

# "Running tests/image/main.rs (...)", "Running unittests src/lib.rs (target/.../deps/NAME-...)", "Doc-tests NAME".
function start(name) {
    finish()
    suite = name
}

# A suite without a line "test result" has no harness, and counts as one test.
function finish() {
    if (suite == "") return
    if (!has_result) passed = 1
    if (passed + failed + left_out)
        printf "%-36s %7d %7d %9d %9.1f\n", suite, passed, failed, left_out, seconds
    all_passed += passed; all_failed += failed; all_left_out += left_out; all_seconds += seconds
    suite = ""; has_result = passed = failed = left_out = seconds = 0
}

BEGIN {
    printf "\n%-36s %7s %7s %9s %9s\n", "suite", "passed", "failed", "skipped", "seconds"
}

/^ +Running unittests / {
    name = $NF
    sub(/.*\//, "", name); sub(/-[0-9a-f]+\)$/, "", name)
    start(name " " $3)
}
/^ +Running (tests|src)\// { start($2) }
/^ +Doc-tests / { start("examples of " $2) }
/: not run, needs / { left_out++ }
/^test .* \.\.\. FAILED$/ { failures = failures "\n    " suite ": " $2 }
/^test result: / {
    has_result = 1
    # Cargo counts skipped tests as passed.
    passed = $4 - left_out; failed = $6; left_out += $8
    seconds = $NF + 0
}
# A failed suite without a harness: "error: test failed, to rerun pass `--test NAME`".
/^error: test failed, to rerun pass/ && !has_result {
    has_result = failed = 1
    failures = failures "\n    " suite
}

END {
    finish()
    printf "%-36s %7d %7d %9d %9.1f\n", "all", all_passed, all_failed, all_left_out, all_seconds
    if (failures) print "\nfailed:" failures
}
