#!/bin/sh
# The camera rays that hit anything in the scenes of the Standard Procedural Databases, at 513 x 513: as printed in 1999, in
# every number type. Quad traces the pixels at edges. doc/spd.md has the numbers, and explains the two that differ.
. "$(dirname "$0")/check.sh"
scene() { gunzip -c "tests/spd/$1.nff.gz" | sed 's/^resolution .*/resolution 513 513/' >"$work/$1.nff"; }

# hits NAME PRINTED OURS: the scene has OURS hits in every engine, and doc/spd.md says both numbers.
hits() {
    "$BUILD/tests/spd_hits" "$work/$1.nff" f32x8 f64x4 edge:f128x1 >"$work/hits" 2>&1
    printf 'f32x8 %s 0\nf64x4 %s 0\nf128x1 %s 0\n' "$3" "$3" "$3" >"$work/expected"
    same "$work/hits" "$work/expected" "$1: $3 rays hit in float, double and quad"
    cmp -s "$work/hits" "$work/expected" || cat "$work/hits"
    holds doc/spd.md "^\| $1 \| [^|]*\| $2 \| $3 \|" "doc/spd.md says so of $1"
}

for name in balls gears lattice mount rings teapot tetra tree; do scene $name; done
for size in 6 12; do awk -v size=$size -f tests/spd/teapot.awk "$work/teapot.nff" >"$work/teapot$size.nff"; done
hits balls 263169 263169
hits gears 245332 245332
hits lattice 261170 261170
hits mount 173685 173686
hits rings 263169 263169
hits teapot12 161546 161546
hits tetra 49950 49950
# Without a printed number.
hits teapot - 161449
hits tree - 156019

# The script's teapot is that of the file: the same vertices, up to the last of six digits.
awk '/^pp?/ { for (k = 0; k < 3; k++) { getline; print $1, $2, $3 } }' "$work/teapot.nff" >"$work/file"
awk '/^pp?/ { for (k = 0; k < 3; k++) { getline; print $1, $2, $3 } }' "$work/teapot6.nff" >"$work/script"
paste -d ' ' "$work/file" "$work/script" | awk '{ for (k = 1; k <= 3; k++) { d = $k - $(k + 3); if (d > 1.01e-5 || d < -1.01e-5) exit 1 } n++ }
    END { exit n != 6876 }' && ok 'size 6 of the script is teapot.nff' || fail 'teapot.awk does not make teapot.nff'
finish
