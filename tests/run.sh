#!/bin/sh
# Runs every test: the unit tests of the release and the sanitizer build, then the scripts that use
# the program as a person would. Ends with `N passed, N failed`.
set -u
cd "$(dirname "$0")/.."
# use_sigaltstack=0: the runtime of gcc 12 takes the alternate stack of a thread that ends for an overflow.
export ASAN_OPTIONS=detect_leaks=1:allocator_may_return_null=1:use_sigaltstack=0
export UBSAN_OPTIONS=print_stacktrace=1
passed=0
failed=0

# check NAME COMMAND...: runs a command, prints its output only if it failed. Ten minutes are many
# times what the slowest takes: only a hang meets the limit.
check() {
    name=$1
    shift
    start=$(date +%s)
    if timeout 600 "$@" >build/test.log 2>&1 </dev/null; then
        passed=$((passed + 1))
        echo "ok $name ($(($(date +%s) - start)) s)"
        grep -E '^(worst errors|  [a-z ]+ f[0-9]+x|skipped)' build/test.log
    else
        failed=$((failed + 1))
        echo "not ok $name"
        cat build/test.log
    fi
}

for build in build build/asan; do
    for test in "$build"/tests/test_*; do
        case $test in *.d) continue ;; esac
        check "$test" "$test"
    done
done
for script in command-line probe language bad-input models pictures engines film farm desktop lab chart lesson readme documentation style; do
    check "$script" "tests/$script.sh"
done
check window env BUILD=build tests/window.sh
check scene-list tests/scene-list.sh
check trouble tests/trouble.sh
check soak env BUILD=build/asan tests/soak.sh
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
