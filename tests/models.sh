#!/bin/sh
# Models as a person meets them: what info and progress tell, and that no model file, however broken,
# brings the program down. With the sanitizer build, each within a limit of time.
. "$(dirname "$0")/check.sh"
dioptre=$PWD/${DIOPTRE:-build/asan/dioptre}
limited() { timeout 20 "$@"; }
cp scenes/models/*.obj tests/meshes/*.obj tests/meshes/*.ply "$work"

# scene FILE...: a scene file that names these models.
scene() {
    echo 'camera { position = {0, 0, 9} } light {}' >"$work/s.lua"
    for file in "$@"; do echo "mesh { file = '$file' }" >>"$work/s.lua"; done
}

scene spot.obj hand-mixed-refs.obj spot.obj
expect 0 '' 'info of models' limited "$dioptre" info "$work/s.lua"
[ "$(grep -c '^mesh ' "$work/out")" = 2 ] && ok 'a model is told of once' || fail "models: $(cat "$work/out")"
holds "$work/out" '^mesh +spot.obj: 5856 triangles, 2930 positions, \(u, v\)$' 'info tells what is in a model'
holds "$work/out" "hand-mixed-refs.obj: 6 triangles.*; corners given their triangle's normal: 12" 'info tells what was put right'
expect 0 '' 'info of models, in JSON' limited "$dioptre" info --json "$work/s.lua"
holds "$work/out" '"meshes": \[\{"file": "spot.obj", "triangles": 5856, "positions": 2930, "normals": 0, "uvs": 3225, "degenerate_triangles": 0, "missing_triangles": 0, "missing_normals": 0, "missing_uvs": 0, "skipped_statements": 0\}, \{' 'JSON has the same'

holds "$work/out" '"triangles": 5862, "triangle_bytes": [0-9]+,' 'and what memory its triangles take'

# what render says, and info too: statements that are not understood, polygons that cannot be cut.
cat >"$work/odd.obj" <<'END'
# A word that is not known, a surface that is no polygon, and a polygon whose edges cross.
	foo 1 2
v 0 1 0
v 3 0 0
v 0 0 0
v 1 2 0
v 1 3 0
cstype bezier
f 1 2 3 4 5 # crossed
f 1 3 2
END
scene odd.obj
expect 0 "^$work/s.lua:2: odd.obj:2: 2 statements are not understood and left out; this is the first" \
    'render says what was left out of a model' limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 16x12
holds "$work/err" "^$work/s.lua:2: odd.obj: 2 triangles are missing, as edges of polygons cross" 'and which polygons'
expect 0 'odd.obj:2: 2 statements' 'info says so too' limited "$dioptre" info "$work/s.lua"
holds "$work/out" 'missing, as polygons cannot be cut: 2; statements not understood, left out: 2$' 'and counts them'

# A triangle with an edge of a tenth of a millimetre lies 123 kilometres away: only doubles tell its corners apart.
printf 'v 123456.789 0 0\nv 123456.7891 0 0\nv 123456.789 0.0001 0\nf 1 2 3\n' >"$work/far.obj"
for shape in "mesh { file = 'far.obj'" 'triangle { a = {123456.789, 0, 0}, b = {123456.7891, 0, 0}, c = {123456.789, 0.0001, 0}'; do
    cat >"$work/far.lua" <<END
camera { position = {123456.78904, 0.00004, 0.0001}, look_at = {123456.78904, 0.00004, 0}, fov = 90 }
ambient(1)
$shape, material = material { color = {1, 0, 0}, diffuse = 0 } }
END
    expect 0 '' "far away: ${shape%% *}" limited "$dioptre" render "$work/far.lua" -o "$work/far-${shape%% *}.bmp" -s 24x24 --engine f64x1
done
same "$work/far-mesh.bmp" "$work/far-triangle.bmp" 'engines in double see the doubles of a model'
reds=$(tail -c 1728 "$work/far-mesh.bmp" | od -An -v -tu1 -w3 | grep -c '255')
# An eighth of the picture.
[ "$reds" -ge 64 ] && ok 'all of its pixels' || fail "only $reds pixels show the far triangle"

for file in "$work"/hand-*.obj "$work/obj-hand-mtllib-traversal.obj" "$work/teapot.obj"; do
    scene "${file##*/}"
    expect 0 '' "${file##*/} is drawn" limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 16x12
done
rm "$work/obj-hand-mtllib-traversal.obj" "$work/o.bmp"
for file in "$work"/obj-hand-*.obj "$work"/ply-hand-*.ply; do
    scene "${file##*/}"
    expect 3 "^$work/s.lua:2: ${file##*/}(:[0-9]+)?: " "${file##*/} is refused" limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 16x12
    [ -e "$work/o.bmp" ] && fail "${file##*/} wrote a picture"
done
finish
