#!/bin/sh
# Scenes in NFF: the picture of the same scene in Lua, what info tells, and that no file, however broken, does more than an
# error with file and line.
. "$(dirname "$0")/check.sh"

# --- the same scene in both languages ------------------------------------------------------------
# For 65 columns of pixels, tan(fov / 2) = 65/64 tan(20 degrees).
cat >"$work/twin.nff" <<'END'
# a comment
b 0.1 0.2 0.4
v
from 0 2 9   # the eye
at 0 1 0
up 0 1 0
angle 40
hither 1
resolution 65 49
l 4 6 5
l -4 6 5 1 0.5 0.25
f 0.8 0.2 0.1 0.5 0.25 20 0 0
s 0 1 0 0.75
c 2 0 0 0.5  2 2 0 0.5
f 0.2 0.8 0.1 0.25 0 100000 0.5 1.25
c -2 0 0 0.75
  -2 2 0 0.25
f 0.8 0.2 0.1 0.5 0.25 20 0 0
c 1 0 2 0
  1 0.5 2 0.25
f 0.9 0.9 0.9 0.9 0 1 0 0
p 4
-9 0 -9
-9 0 9   9 0 9
9 0 -9
pp 3
-1 2 -2  0 0 1
1 2 -2   0 0 2
0 3 -2   0 1 1
END
cat >"$work/twin.lua" <<'END'
camera { position = {0, 2, 9}, look_at = {0, 1, 0},
         fov = math.deg(2 * math.atan(math.tan(math.rad(20)) * 65 / 64)) }
image { width = 65, height = 49 }
sky { color = {0.1, 0.2, 0.4} }
light { position = {4, 6, 5}, intensity = 1 / math.sqrt(2) }
light { position = {-4, 6, 5}, color = {1, 0.5, 0.25} }
local red = material { color = {0.8, 0.2, 0.1}, diffuse = 0.5 / 0.75, specular = 0.25 / 0.75, shininess = 20,
                       reflectivity = 0.25 }
local glass = material { color = {0.2, 0.8, 0.1}, diffuse = 0.5, specular = 0, transparency = 0.5, ior = 1.25 }
local floor = material { color = {0.9, 0.9, 0.9}, diffuse = 0.9, specular = 0 }
sphere { center = {0, 1, 0}, radius = 0.75, material = red }
cylinder { base = {2, 0, 0}, top = {2, 2, 0}, radius = 0.5, capped = false, material = red }
cone { base = {-2, 0, 0}, top = {-2, 2, 0}, radius = 0.75, top_radius = 0.25, capped = false, material = glass }
cone { base = {1, 0, 2}, top = {1, 0.5, 2}, radius = 0, top_radius = 0.25, capped = false, material = red }
mesh { file = "floor.obj", normals = "flat", material = floor }
mesh { file = "smooth.obj", normals = "file", material = floor }
END
printf 'v -9 0 -9\nv -9 0 9\nv 9 0 9\nv 9 0 -9\nf 1 2 3\nf 1 3 4\n' >"$work/floor.obj"
printf 'v -1 2 -2\nv 1 2 -2\nv 0 3 -2\nvn 0 0 1\nvn 0 0 2\nvn 0 1 1\nf 1//1 2//2 3//3\n' >"$work/smooth.obj"
for engine in f32x8 f64x1; do
    for language in nff lua; do
        expect 0 '' "twin.$language in $engine" timeout 60 "$dioptre" render "$work/twin.$language" -o "$work/$language.bmp" --engine $engine
    done
    same "$work/nff.bmp" "$work/lua.bmp" "NFF and Lua make the same picture in $engine"
    rm -f "$work/nff.bmp" "$work/lua.bmp"
done
expect 0 '' 'info of NFF' timeout 60 "$dioptre" info "$work/twin.nff"
holds "$work/out" '^shapes +6: 1 sphere 1 cylinder 2 cone 2 mesh$' 'info counts its shapes'
holds "$work/out" '^materials +3$' 'the same numbers are the same material'
holds "$work/out" '^mesh +twin.nff:22: 2 triangles, 4 positions$' 'info names the line of its polygons'
sed 's/$/\r/' "$work/twin.nff" >"$work/crlf.nff"
expect 0 '' 'lines may end as on Windows' timeout 60 "$dioptre" info "$work/crlf.nff"

# --- polygons ------------------------------------------------------------------------------------
head=$(printf 'v from 0 0 9 at 0 0 0 up 0 1 0 angle 40 resolution 65 49\nl 0 0 9\n')
printf '%s\np 6\n0 0 0 2 0 0 2 2 0 1 0.5 0 0.5 1 0 0 2 0\n' "$head" >"$work/s.nff"
expect 0 '' 'a polygon that is not convex' timeout 60 "$dioptre" info "$work/s.nff"
holds "$work/out" ': 4 triangles, 6 positions$' 'it is cut into four triangles'
printf '%s\np 3 0 0 0 1 0 0 0 1 0\np 4 0 0 0 1 1 1 2 2 2 3 3 3\n' "$head" >"$work/s.nff"
expect 0 '' 'a polygon without area' timeout 60 "$dioptre" info "$work/s.nff"
holds "$work/out" ': 1 triangle, 3 positions; without area, left out: 2$' 'info says that it is left out'
# 60,000 polygons: a second of a slow processor, most of it to start and to build the tree.
awk -v head="$head" 'BEGIN { print head; for (i = 0; i < 60000; i++) { x = i % 300; y = int(i / 300)
    printf "p 4\n%d %d 0\n%d %d 0\n%d %d 0\n%d %d 0\n", x, y, x + 1, y, x + 1, y + 1, x, y + 1 } }' >"$work/s.nff"
expect 0 '' '60,000 polygons' timeout 60 "$dioptre" info "$work/s.nff"
holds "$work/out" ': 120000 triangles, 60501 positions$' 'they are one mesh of shared positions'

# --- what is wrong -------------------------------------------------------------------------------
# wrong LINE WORDS TEXT: the text after two good lines is refused at a line.
wrong() {
    printf '%s\n%b' "$head" "$3" >"$work/s.nff"
    expect 3 "^dioptre: $work/s.nff:$1: .*$2|^$work/s.nff:$1: .*$2" "refused: $2" timeout 60 "$dioptre" render "$work/s.nff" -o "$work/o.bmp"
    [ -e "$work/o.bmp" ] && fail "$2 wrote a picture"
}
wrong 3 '`tpp` is no statement of NFF' 'tpp 3 0 0 0\n'
wrong 4 '`c` needs 8 numbers; the file ends after 7' '\nc 0 0 0 1 0 0 1\n'
wrong 3 '`s` needs 4 numbers; number 3 is `x1`' 's 0 0 x1 1\n'
wrong 3 'center must be a finite number' 's 0 nan 0 1\n'
wrong 3 'center must be a finite number' 's 0 0 1e999 1\n'
wrong 3 'center must be at least' 's 0 0 1e30 1\n'
wrong 3 'radius must be at least' 's 0 0 0 0\n'
wrong 3 'seen from inside only' 's 0 0 0 -1\n'
wrong 3 'seen from inside only' 'c 0 0 0 -1 0 0 1 -1\n'
wrong 3 'cone has no length' 'c 0 0 0 1 0 0 0 0.5\n'
wrong 3 'cylinder has no length' 'c 1 1 1 1 1 1 1 1\n'
wrong 3 'from 3 to 1e\+06, not 2' 'p 2 0 0 0 1 1 1\n'
wrong 3 'from 3 to 1e\+06, not 1e\+09' 'pp 1e9\n'
wrong 3 'from 3 to 1e\+06, not 3.5' 'p 3.5\n'
wrong 3 'coordinates must be finite' 'p 3 0 0 0 1 0 0 0 inf 0\n'
wrong 3 'no triangle in it that has an area' 'p 3 0 0 0 1 1 1 2 2 2\n'
wrong 3 'color must be at least 0' 'f -1 0 0 1 0 1 0 0\n'
wrong 3 'transparency must be at least 0 and at most 1' 'f 1 1 1 1 0 1 1.5 1\n'
wrong 3 'ior must be at least' 'f 1 1 1 1 0 1 0.5 0\n'
wrong 3 '`l` needs 3 numbers; number 2 is `l`' 'l 1 2 3 4\nl 1 2 3\n'
wrong 3 '`v` has no `from`' 'v at 0 0 0 up 0 1 0 angle 40 resolution 9 9\n'
wrong 3 'width must be a whole number' 'v from 0 0 9 at 0 0 0 up 0 1 0 angle 40 resolution 9.5 9\n'
wrong 3 'fov must be at least' 'v from 0 0 9 at 0 0 0 up 0 1 0 angle 180 resolution 9 9\n'
wrong 3 'must not look at its own position' 'v from 0 0 9 at 0 0 9 up 0 1 0 angle 40 resolution 9 9\n'
wrong 3 'up must not be zero' 'v from 0 0 9 at 0 0 0 up 0 0 0 angle 40 resolution 9 9\n'
wrong 3 '\\27' '\033[31mred\n'
wrong 3 'is no statement' "$(awk 'BEGIN { for (i = 0; i < 100000; i++) printf "y" }')\n"
printf 's 0 0 0 1\n' >"$work/s.nff"
expect 3 's.nff:1: there is no `v` in the file' 'a file without a camera' timeout 60 "$dioptre" info "$work/s.nff"
printf 's 0 0 0 1\n\0\n' >"$work/s.nff"
expect 3 's.nff:2: this is not text' 'a file with a zero byte' timeout 60 "$dioptre" info "$work/s.nff"
: >"$work/s.nff"
expect 3 's.nff:1: there is no `v` in the file' 'an empty file' timeout 60 "$dioptre" info "$work/s.nff"
# Forty broken files: any end is good but a crash.
awk 'BEGIN { srand(7); while ((getline line < ARGV[1]) > 0) text = text line "\n"
    for (n = 0; n < 40; n++) { out = ARGV[2] "/broken" n ".nff"; copy = text
        for (k = 0; k < 5; k++) { at = 1 + int(rand() * length(copy)); copy = substr(copy, 1, at - 1) sprintf("%c", 32 + int(rand() * 95)) substr(copy, at + 1 + int(rand() * 20)) }
        printf "%s", copy > out; close(out) } }' "$work/twin.nff" "$work"
crashes=0
for file in "$work"/broken*.nff; do
    timeout 60 "$dioptre" info "$file" >"$work/out" 2>"$work/err" </dev/null
    status=$?
    [ $status = 0 ] || { [ $status = 3 ] && grep -q "$file:[0-9]*: " "$work/err" && ! grep -q 'process that ran' "$work/err"; } ||
        { crashes=$((crashes + 1)); echo "$status $(cat "$work/err")"; }
done
[ $crashes = 0 ] && ok 'forty broken files are read or refused' || fail "$crashes broken files"
# --- what cannot be cut ----------------------------------------------------------------------------
printf 'v\nfrom 0 0 9\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 16 16\n' >"$work/crossed.nff"
printf 'p 5\n0 1 0\n3 0 0\n0 0 0\n1 2 0\n1 3 0\np 3\n0 0 0\n1 0 0\n0 1 0\n' >>"$work/crossed.nff"
expect 0 "^$work/crossed.nff:8: 2 triangles are missing, as edges of polygons cross" 'a polygon whose edges cross is told of' \
    "$dioptre" render "$work/crossed.nff" -o "$work/o.bmp"
finish
