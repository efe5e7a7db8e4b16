#!/bin/sh
# With 16 threads, none may wait long for the last tiles. This machine may have two: bench-schedule simulates
# the others. With tiles of 8 rows they are 15.7 times as fast as one on this scene, with 16 rows 13.0 times.
. "$(dirname "$0")/check.sh"
SCENE=scenes/report-d-glass.lua
LEAST=14.5 # Times as fast as one thread.

if row=$("$BUILD/bench-schedule" $SCENE 2>"$work/err"); then
    if awk -v times="${row##*,}" -v least=$LEAST 'BEGIN { exit !(times >= least) }'; then
        ok "16 threads: ${row##*,} times as fast as one"
    else
        fail "16 threads: ${row##*,} times as fast as one, at least $LEAST"
    fi
else
    fail "no simulation: $(cat "$work/err")"
fi
finish
