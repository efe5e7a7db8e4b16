#!/bin/sh
# Progress on a terminal: a line with an estimate, which is gone at the end. `script` is the terminal.
. "$(dirname "$0")/check.sh"

# on_terminal WORD...: runs a command on a terminal of its own; its words are in $work/screen, and what
# it shows at the end, after every carriage return, in $work/last.
on_terminal() {
    quoted=
    for word in "$@"; do quoted="$quoted '$word'"; done
    timeout 120 script -qec "$quoted" /dev/null >"$work/screen" </dev/null
    status=$?
    tr '\r' '\n' <"$work/screen" | grep -v '^$' | tail -n 1 >"$work/last"
}
cleared=$(printf '\033\\[K')

# One thread of the slowest engine in float: about two seconds, ten times the time to the first report.
slow='--engine f32x1 -j 1'
# shellcheck disable=SC2086 # words
on_terminal "$dioptre" render scenes/box.lua $slow -s 320x240 --samples 64 --sampling full -o "$work/a.bmp"
[ $status = 0 ] && [ -s "$work/a.bmp" ] && ok 'a picture is drawn on a terminal' || fail "status $status: $(head -c 300 "$work/screen")"
holds "$work/screen" '[ 0-9][0-9] %, [0-9]+ s left' 'it shows how much is done, and an estimate'
holds "$work/last" "^ *$cleared" 'the line is gone at the end'
# shellcheck disable=SC2086 # words
on_terminal "$dioptre" animate scenes/melting.lua $slow -s 160x120 --samples 16 --frames 0-3 -o "$work/f-%d.bmp"
holds "$work/screen" '[0-9] of 4 frames, +[0-9]+ %, [0-9]+ s left' 'a film shows its frames'
# shellcheck disable=SC2086 # words
on_terminal "$dioptre" render scenes/box.lua $slow -s 320x240 --samples 64 --sampling full --quiet -o "$work/a.bmp"
[ $status = 0 ] && ! grep -q 'left' "$work/screen" && ok 'not with --quiet' || fail "--quiet: $(head -c 300 "$work/screen")"

# A model that takes longer than half a second to read; its name is no command for the terminal.
name=$(printf 'red\033[31m.ply')
awk 'BEGIN {
    n = 1400
    printf "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n", n * n
    printf "element face %d\nproperty list uchar int vertex_indices\nend_header\n", (n - 1) * (n - 1)
    for (i = 0; i < n; i++) for (k = 0; k < n; k++) print i, k, (i * 7 + k * 13) % 5
    for (i = 1; i < n; i++) for (k = 1; k < n; k++) { a = (i - 1) * n + k - 1; print 4, a, a + 1, a + n + 1, a + n }
}' >"$work/$name"
printf 'camera { position = {0, 0, 5} }\nlight {}\nmesh { file = "red\\27[31m.ply" }\n' >"$work/model.lua"
on_terminal "$dioptre" render "$work/model.lua" -s 8x6 --samples 1 --engine f32x4 -o "$work/m.bmp"
[ $status = 0 ] && ok 'a large model is read on a terminal' || fail "status $status: $(head -c 300 "$work/screen")"
holds "$work/screen" '\.ply: +[0-9]+ %, [0-9]+ s left' 'it shows how much of the model is read'
if grep -q "$(printf '\033')\\[31m" "$work/screen"; then fail 'its name reaches the terminal as a command'; else ok 'its name is no command for the terminal'; fi
finish
