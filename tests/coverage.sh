#!/bin/sh
# Which lines and branches of the rooms run in the unit tests and in some scripts, the engines left
# out; the shares must not fall. `make coverage` builds what it needs. COVERAGE_ONLY=1 judges the
# counters that are there.
. "$(dirname "$0")/check.sh"
# Floors, percent. To be raised to what a whole run measures, less one.
lines=45
branches=45
scripts='command-line film farm lesson models pictures nff probe engines chart lab terminal'
export JOBS="${JOBS:-2}"

# one COMMAND...: runs a test with the build that counts; what it says matters elsewhere.
if [ -z "${COVERAGE_ONLY:-}" ]; then
    find build/coverage -name '*.gcda' -delete
    {
        ls tests/test_*.c | sed 's|^tests/\(.*\)\.c$|build/coverage/tests/\1|'
        for script in $scripts; do [ -e tests/$script.sh ] && echo "tests/$script.sh"; done
        echo tests/soak.sh
    } | BUILD=build/coverage DIOPTRE=build/coverage/dioptre xargs -P "$JOBS" -I{} sh -c 'timeout 900 {} >/dev/null 2>&1 </dev/null || echo "# {} fails here"'
fi
gcovr --root . --object-directory build/coverage --filter 'src/' --exclude 'src/trace/' --exclude 'src/lab/methods/' \
    --exclude '.*_plugin\.c' --gcov-ignore-parse-errors --json-summary "$work/summary.json" --txt "$work/table" \
    --json-summary-pretty 2>"$work/err" || fail "gcovr: $(head -5 "$work/err")"
echo '# The least covered files, lines:'
awk '$1 ~ /^src/ && $2 > 20 { print $4, $1, $2 - $3 " of " $2 " lines" }' "$work/table" | sort -n | head -12 | sed 's/^/#   /'
for kind in line branch; do
    found=$(grep -oE "\"${kind}_percent\": [0-9.]+" "$work/summary.json" | tail -1 | sed 's/.*: //')
    floor=$([ $kind = line ] && echo $lines || echo $branches)
    awk "BEGIN { exit !($found >= $floor) }" && ok "$kind coverage $found %, at least $floor" || fail "$kind coverage $found %, not $floor"
done
finish
