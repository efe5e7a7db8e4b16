#!/bin/sh
# Runs every test: the unit tests of the release and of the sanitizer build, then the scripts that use
# the program as a person would. Two at a time (JOBS), but for what measures time. Prints what failed
# in full, its failed checks once more at the end, where a log that is cut still has them, and then
# `N passed, N failed`.
set -u
cd "$(dirname "$0")/.."
# use_sigaltstack=0: the runtime of gcc 12 takes the alternate stack of a thread that ends for an overflow.
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:use_sigaltstack=0
export UBSAN_OPTIONS=print_stacktrace=1
logs=build/test-logs

# --one COMMAND: runs a test, a word or several, and notes how it went. Ten minutes are many times what
# the slowest takes: only a test that hangs meets the limit.
if [ "${1:-}" = --one ]; then
    log=$logs/$(echo "$2" | tr -c 'a-zA-Z0-9\n' -)
    start=$(date +%s)
    # shellcheck disable=SC2086 # a command and its environment
    if timeout 600 env $2 >"$log" 2>&1 </dev/null; then
        echo "ok $2 ($(($(date +%s) - start)) s)" >"$log.result"
        grep -E '^(worst errors|  [a-z ]+ f[0-9]+x|skipped|\[  SKIPPED \] test)' "$log" >>"$log.result"
    else
        echo "not ok $2 ($(($(date +%s) - start)) s)" | cat - "$log" >"$log.result"
    fi
    # In one piece, whatever runs beside it.
    exec flock "$logs" cat "$log.result"
fi

rm -rf "$logs" && mkdir -p "$logs"
# The longest first, so that none is left over at the end.
{
    echo tests/fuzz.sh
    for build in build/asan build; do
        ls -S tests/test_*.c | sed "s|^tests/\(.*\)\.c$|$build/tests/\1|"
        if [ $build = build/asan ]; then
            for script in film readme farm lesson models pictures documentation bad-input outputs hostile-modules limits \
                nff spd language lab gappa chart engines probe command-line desktop terminal trouble faults threads memcheck \
                hardening judges style; do
                echo "tests/$script.sh"
            done
            echo BUILD=build/asan tests/soak.sh
            echo BUILD=build/tsan SOAK_SECONDS=10 tests/soak.sh
        fi
    done
} >"$logs/tests"
xargs -d '\n' -P "${JOBS:-2}" -n 1 tests/run.sh --one <"$logs/tests" || echo "not ok: some tests could not be run"
# What measures time has the machine to itself.
for script in schedule window bar objects scene-list latency; do
    echo "BUILD=build tests/$script.sh" >>"$logs/tests"
    tests/run.sh --one "BUILD=build tests/$script.sh"
done
passed=$(head -qn 1 "$logs"/*.result | grep -c "^ok ")
failed=$(head -qn 1 "$logs"/*.result | grep -c "^not ok ")
for result in $(grep -l "^not ok " "$logs"/*.result); do
    head -n 1 "$result"
    # The failed checks; a test that died without one says at its end why.
    sed 1d "$result" | grep -aE '^not ok|FAILED|Error|ERROR|error:' | tail -n 20
    tail -n 5 "$result"
done
echo "$passed passed, $failed failed"
# A test without a result has not run.
[ $((passed + failed)) = "$(wc -l <"$logs/tests")" ] || { echo "of $(wc -l <"$logs/tests") tests"; exit 1; }
[ "$failed" = 0 ]
