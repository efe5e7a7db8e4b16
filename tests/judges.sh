#!/bin/sh
# The programs of `make bench` and `make peers` run, and those that judge our rays find nothing wrong.
# Their times are not looked at here.
. "$(dirname "$0")/check.sh"
printf 'camera {}\nmesh { file = "spot.obj", normals = "flat" }\n' >"$work/spot.lua"
expect 0 '' 'rays beside Embree' "$BUILD/peer-embree" "$work/spot.lua" scenes/models f32x8
for rays in primary close random shadow; do
    wrong=$(awk -v name=$rays-differ '$1 == name { print $3 }' "$work/out")
    [ "$wrong" = 0 ] && ok "$rays rays: none is wrong" || fail "$rays rays: '$wrong' are wrong"
done
expect 0 '' 'errors beside Embree' "$BUILD/peer-accuracy" f64x4
# Columns: of spheres and triangles, per cent of false misses and hits, and the error of the distance.
awk -F'|' '/^  [0-9]/ { split($2, ours, " "); n++; if (ours[1] > 0 || ours[2] > 0 || ours[3] > 1e-13) print }
    END { if (n < 14) print n " lines" }' "$work/out" >"$work/wrong"
[ ! -s "$work/wrong" ] && ok 'double misses and invents no hit' || fail "double errs: $(cat "$work/wrong")"
expect 0 '' 'steps of marching' "$BUILD/tests/bench/march-steps" steps
[ "$(grep -c '^1,' "$work/out")" -ge 6 ] && ok 'for each angle' || fail "steps: $(cat "$work/out")"
expect 0 '' 'when a tree pays' "$BUILD/tests/bench/tree" f32x8 tests/bench/scattered-boxes.lua boxes
expect 0 '' 'what a scene needs' "$BUILD/bench-needs" scenes/box.lua
expect 0 '' 'pixels with acne or a leak' "$BUILD/bench-acne" scenes/box.lua
[ "$(cat "$work/out")" = box.lua,480000,0,0 ] && ok 'the box has none' || fail "the box: $(cat "$work/out")"
finish
