#!/bin/sh
# Models as a person meets them: what info and progress tell, and that no model file, however broken,
# brings the program down. With the sanitizer build, each within a limit of time.
. "$(dirname "$0")/check.sh"
dioptre=$PWD/build/asan/dioptre
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
holds "$work/out" '"meshes": \[\{"file": "spot.obj", "triangles": 5856, "positions": 2930, "normals": 0, "uvs": 3225, "degenerate_triangles": 0, "missing_triangles": 0, "missing_normals": 0, "missing_uvs": 0\}, \{' 'JSON has the same'

holds "$work/out" '"triangles": 5862, "triangle_bytes": [0-9]+,' 'and what memory its triangles take'

for file in "$work"/hand-*.obj "$work/obj-hand-mtllib-traversal.obj" "$work/teapot.obj"; do
    scene "${file##*/}"
    expect 0 '' "${file##*/} is drawn" limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 16x12
done
rm "$work/obj-hand-mtllib-traversal.obj" "$work/o.bmp"
for file in "$work"/obj-hand-*.obj "$work"/ply-hand-*.ply; do
    scene "${file##*/}"
    expect 3 "^$work/s.lua:2: ${file##*/}: " "${file##*/} is refused" limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 16x12
    [ -e "$work/o.bmp" ] && fail "${file##*/} wrote a picture"
done
finish
