#!/bin/sh
# Which lines and branches of the rooms run in the unit tests and in scripts: all C and C++ files of src/
# that this system compiles, modules and workers with them, but for engines (src/trace) and methods of
# the laboratory, which are compiled many times and go uncounted, as fast as ever. Headers and libraries
# are not counted, nor the branches that C++ adds for exceptions. Both shares have a floor. `make coverage`
# builds what it needs. COVERAGE_ONLY=1 judges the counters that are there.
. "$(dirname "$0")/check.sh"
# Floors, percent: what has been reached (96.5 and 83.5), less half a percent for what hangs on time.
lines=96
branches=83
# Scripts that compile nothing and measure no time; the last ones open windows. faults makes writing fail,
# of counters, too: it runs first, and what it has spoilt is removed.
scripts='command-line outputs bad-input film farm lesson models pictures nff probe engines chart lab terminal trouble
    hostile-modules limits bar objects scene-list soak'
export JOBS="${JOBS:-2}"

# run: runs the commands of its input. What they say matters elsewhere: here they need only run.
run() {
    BUILD=build/coverage DIOPTRE=build/coverage/dioptre xargs -P "$JOBS" -I{} sh -c 'timeout 900 {} >/dev/null 2>&1 </dev/null || echo "# {} fails here"'
}
# counters_are_sound FILE: whether it begins as gcc's counters do, with the version of the notes beside it.
version() { head -c 8 "$1" | tail -c 4; }
counters_are_sound() { [ "$(head -c 4 "$1")" = adcg ] && [ "$(version "$1")" = "$(version "${1%.gcda}.gcno")" ]; }

if [ -z "${COVERAGE_ONLY:-}" ]; then
    find build/coverage -name '*.gcda' -delete
    # Where counters cannot be written (a full disk is tested, too), the program's own words matter.
    export GCOV_ERROR_FILE=/dev/null
    echo tests/faults.sh | run
    find build/coverage -name '*.gcda' | while read -r file; do counters_are_sound "$file" || rm "$file"; done
    {
        ls tests/test_*.c | sed 's|^tests/\(.*\)\.c$|build/coverage/tests/\1|'
        for script in $scripts; do echo "tests/$script.sh"; done
    } | run
fi
find build/coverage -name '*.gcda' | while read -r file; do
    counters_are_sound "$file" || { echo "# $file was cut off"; rm "$file"; }
done
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
