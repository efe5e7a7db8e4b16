#!/bin/sh
# Which lines and branches of the rooms run in the unit tests and in scripts: all C and C++ files of src/
# that this system compiles, modules and workers with them, but for engines (src/trace) and methods of
# the laboratory, which are compiled many times and go uncounted, as fast as ever. Headers and libraries
# are not counted, nor the branches that C++ adds for exceptions. Both shares have a floor. `make coverage`
# builds what it needs. COVERAGE_ONLY=1 judges the counters that are there.
. "$(dirname "$0")/check.sh"
# Floors, percent: what a whole run has reached on a busy machine, in which five tests did not pass. What
# runs in workers that are test programs themselves is not counted.
lines=90
branches=77
# Scripts that take minutes at most; the last one opens windows.
scripts='command-line film farm lesson models pictures nff probe engines chart lab terminal soak'
export JOBS="${JOBS:-2}"

if [ -z "${COVERAGE_ONLY:-}" ]; then
    find build/coverage -name '*.gcda' -delete
    # Where counters cannot be written (a full disk is tested, too), the program's own words matter.
    export GCOV_ERROR_FILE=/dev/null
    # What the tests say matters elsewhere: here they need only run.
    {
        ls tests/test_*.c | sed 's|^tests/\(.*\)\.c$|build/coverage/tests/\1|'
        for script in $scripts; do echo "tests/$script.sh"; done
    } | BUILD=build/coverage DIOPTRE=build/coverage/dioptre xargs -P "$JOBS" -I{} sh -c 'timeout 900 {} >/dev/null 2>&1 </dev/null || echo "# {} fails here"'
fi
gcovr --root . --object-directory build/coverage --filter 'src/' --exclude 'src/trace/' --exclude 'src/lab/methods/' \
    --exclude-throw-branches --gcov-ignore-parse-errors --txt "$work/table" --print-summary \
    >"$work/summary" 2>"$work/err" || fail "gcovr: $(head -5 "$work/err")"
echo '# The least covered files, lines:'
awk '$1 ~ /^src/ && $2 > 20 { print $4, $1, $2 - $3 " of " $2 " lines" }' "$work/table" | sort -n | head -12 | sed 's/^/#   /'
# floor KIND PERCENT: the share of all files together must not be lower.
floor() {
    found=$(sed -n "s/^$1: \([0-9.]*\)%.*/\1/p" "$work/summary")
    awk "BEGIN { exit !(\"$found\" != \"\" && ${found:-0} >= $2) }" && ok "$1: $found %, at least $2" ||
        fail "$1: ${found:-unknown} %, not $2"
}
floor lines $lines
floor branches $branches
finish
