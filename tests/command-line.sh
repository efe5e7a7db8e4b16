#!/bin/sh
# The command line, as a script uses it: statuses, outputs, JSON, standard input.
. "$(dirname "$0")/check.sh"
box=scenes/box.lua

expect 0 '' 'help' "$dioptre" --help
holds "$work/out" 'render' 'help names the commands'
for command in view render animate probe info compare bench lab needs chart; do
    expect 0 '' "help of $command" "$dioptre" "$command" -h
    holds "$work/out" "^usage: dioptre $command" "help of $command says how it is used"
done
expect 0 '' 'version' "$dioptre" -V
holds "$work/out" '^dioptre [0-9]+\.[0-9]+' 'version has a number'
expect 2 'which command' 'no command, without a display' env -u DISPLAY -u WAYLAND_DISPLAY "$dioptre"
expect 2 "does not take" "an option without a command" "$dioptre" -q
expect 2 'no option' 'unknown option' "$dioptre" render "$box" --nonsense
expect 2 'does not take' 'option of another command' "$dioptre" render "$box" -o x.bmp --json
expect 2 'needs -o' 'render without output' "$dioptre" render "$box"
expect 2 'usage' 'render without scene' "$dioptre" render -o x.bmp
expect 2 'too many' 'too many arguments' "$dioptre" compare a b c
expect 2 'auto' 'unknown engine' "$dioptre" info "$box" --engine f16
expect 2 'none, fixed or bound' 'unknown offset' "$dioptre" info "$box" --offset some
for size in 0x0 0x10 10x0 800 800x 800x600x1 -1x5 20000x20000 99999999999x1 800,600; do
    expect 2 'size takes WxH' "size $size" "$dioptre" render "$box" -o "$work/x.bmp" -s "$size"
done
for option in '--samples 0' '--samples x' '--depth -1' '-j 0' '-j 1.5' '--epsilon -1' '--epsilon nan' \
    '-t inf' '--progress loud'; do
    # shellcheck disable=SC2086 # an option and its value
    expect 2 'takes' "bad $option" "$dioptre" render "$box" -o "$work/x.bmp" $option
done
# Letters in one word, names that are empty, options that are cut or have a value too many.
expect 2 '^dioptre: there is no option -Z$' 'a wrong letter before others' "$dioptre" render -Zq x.lua
expect 2 '^dioptre: there is no option -Z$' 'a wrong letter after others' "$dioptre" render -qZ x.lua
expect 2 '^dioptre: there is no option -Z$' 'a wrong letter without a command' "$dioptre" -Zq
expect 2 '^dioptre: there is no option --foo=3$' 'a wrong word with a value' "$dioptre" render --foo=3
expect 2 '^dioptre: -o needs a value$' 'a letter that needs a value, after others' "$dioptre" render x.lua -qo
expect 2 '^dioptre: --size needs a value$' 'a word that needs a value' "$dioptre" render x.lua --size
expect 2 '^dioptre: --quiet takes no value$' 'a flag with a value' "$dioptre" render --quiet=3 x.lua
expect 2 '^dioptre: --o is ambiguous: --output, --out, --offset$' 'a cut option that may be several' "$dioptre" render --o x.bmp
expect 2 '^dioptre: --size takes WxH' 'a cut option that is clear' "$dioptre" render --si 3
expect 2 '^dioptre: argument 1 of render is empty$' 'an empty scene' "$dioptre" render '' -o "$work/x.bmp"
expect 2 '^dioptre: argument 1 of view is empty$' 'an empty scene to view' "$dioptre" view ''
expect 2 '^dioptre: argument 2 of compare is empty$' 'an empty picture' "$dioptre" compare x.bmp ''
for option in '-o' '--base-dir'; do
    expect 2 '^dioptre: --[a-z-]* takes a name, not '"''"'$' "empty $option" "$dioptre" render "$box" -o "$work/x.bmp" "$option" ''
done
expect 2 "^dioptre: --base-dir takes a folder that exists, not '$work/none'\$" 'a folder that is not there' \
    "$dioptre" render "$box" -o "$work/x.bmp" --base-dir "$work/none"
for size in ' 8x8' '+8x8' '8x 8' '8x' 'x8' '8x8x8'; do
    expect 2 '^dioptre: --size takes WxH' "the size '$size'" "$dioptre" render "$box" -o "$work/x.bmp" -s "$size"
done
expect 2 'too many arguments: .-o' 'options after --' "$dioptre" render -- "$box" -o "$work/x.bmp"
expect 0 '' 'the last of two sizes' "$dioptre" render "$box" -s 9x9 -o "$work/two.bmp" -s 4x3
[ "$(stat -c %s "$work/two.bmp")" = 90 ] && ok 'counts' || fail "it has $(stat -c %s "$work/two.bmp") bytes"
[ ! -e "$work/x.bmp" ] && ok 'wrong usage writes nothing' || fail 'wrong usage writes nothing'

expect 0 '' 'render bmp' "$dioptre" render "$box" -o "$work/a.bmp" -s 160x120
expect 0 '' 'render again' "$dioptre" render "$box" -o "$work/b.bmp" --size=160x120 -j 1
same "$work/a.bmp" "$work/b.bmp" 'the same picture twice, byte for byte'
expect 0 '' 'render png' "$dioptre" render "$box" -o "$work/a.png" -s 160x120
expect 0 '' 'compare equal' "$dioptre" compare "$work/a.bmp" "$work/a.png" --json
holds "$work/out" '"worst_step": 0, "share_off": 0, "rmse": 0, "psnr": null' 'compare finds them equal'
# Half the light: step 188 of sRGB, 128 of a linear picture; a file of linear light holds the same.
echo 'camera {} sky { color = 0.5 }' >"$work/srgb.lua"
echo 'camera {} sky { color = 0.5 } image { encoding = "linear" }' >"$work/linear.lua"
for scene in srgb linear; do
    expect 0 '' "render $scene exr" "$dioptre" render "$work/$scene.lua" -o "$work/$scene.exr" -s 4x3
done
expect 0 '' 'linear light is the same by either encoding' \
    "$dioptre" compare "$work/srgb.exr" "$work/linear.exr" --threshold 1
"$dioptre" render - -o "$work/c.bmp" -s 160x120 <"$box"
same "$work/a.bmp" "$work/c.bmp" 'a scene from standard input'
expect 0 '' 'one pixel' "$dioptre" render "$box" -o "$work/p.bmp" -s 1x1
expect 0 '' 'render with one sample' "$dioptre" render "$box" -o "$work/one.bmp" -s 160x120 --samples 1
expect 1 '' 'compare different' "$dioptre" compare "$work/a.bmp" "$work/one.bmp" --map "$work/map.bmp"
expect 2 'map.svg' 'compare knows the name of the map before it reads' "$dioptre" compare none.bmp none.bmp --map "$work/map.svg"
[ -s "$work/map.bmp" ] && ok 'compare writes the map' || fail 'compare writes the map'
expect 0 '' 'compare within a threshold' "$dioptre" compare "$work/a.bmp" "$work/one.bmp" --threshold 255
expect 3 'sizes differ' 'compare sizes' "$dioptre" compare "$work/a.bmp" "$work/p.bmp"
expect 4 'No such file' 'compare a missing file' "$dioptre" compare "$work/a.bmp" "$work/none.bmp"
expect 4 'readme|ending|README' 'compare what is no picture' "$dioptre" compare "$work/a.bmp" README.md

expect 0 '' 'info' "$dioptre" info "$box"
holds "$work/out" '6 quad' 'info counts shapes'
holds "$work/out" '^time +not used' 'info says that no time changes the box'
holds "$work/out" '^acceleration tree none \(8 shapes; used from 24\)$' 'info says why there is no tree'
holds "$work/out" '^reflections +[0-9]+ mirrors?, [0-9]+ glass shapes?, depth [0-9]+, cutoff [0-9.]+ steps$' 'info counts mirrors and glass'
expect 0 '' 'info json' "$dioptre" info "$box" --json --engine f64x1
holds "$work/out" '"engine": "f64x1".*"left_out": \[' 'info json names engine and what is left out'
holds "$work/out" '"bvh": \{"in_bvh": 0, "linear": 8, "threshold": 24\}' 'info json says why there is no tree'
# Light that goes to and fro between balls: said before the picture is drawn, and counted afterwards.
expect 0 'some .* will lack light.*of the camera rays lack light' 'render says beforehand that light will be missing' \
    sh -c '"$1" render tests/scenes/half-mirrors.lua -s 64x48 -o "$2" 2>&1 | tr "\n" " " >&2' - "$dioptre" "$work/panes.bmp"
expect 0 '' 'info of balls' "$dioptre" info tests/scenes/half-mirrors.lua -s 64x48
holds "$work/out" '^missing light +[1-9][0-9]* of [0-9]+ camera rays lack more than the cutoff, at most [0-9.]+ steps$' 'info says what light will be missing'
for scene in "$box" tests/scenes/five-panes.lua; do
    expect 0 '' "render of $scene says nothing of the kind" "$dioptre" render "$scene" -s 64x48 -o "$work/panes.bmp"
done
for normals in smooth flat; do
    printf '%s\n' 'camera { position = {0, 0, 4} }' "mesh { file = \"spot-low.obj\", normals = \"$normals\"," \
        'material = material { transparency = 1, ior = 1.5 } }' >"$work/$normals.lua"
done
cp scenes/models/spot-low.obj "$work"
expect 0 ':2: glass with smooth normals' 'render says that smooth glass is fragile' \
    "$dioptre" render "$work/smooth.lua" -s 16x12 -o "$work/panes.bmp"
expect 0 '' 'and nothing of flat glass' "$dioptre" render "$work/flat.lua" -s 16x12 -o "$work/panes.bmp"
[ ! -s "$work/err" ] && ok 'not a word' || fail "of flat glass: $(cat "$work/err")"
# A name that is not UTF-8, has quotes and a control character: what comes out is JSON all the same.
odd=$work/$(printf 'odd\377"\\\001\303\251.lua')
cp "$box" "$odd"
for command in "info" "bench --frames 1 -s 8x6" "needs -s 8x6"; do
    # shellcheck disable=SC2086 # a command and its options
    expect 0 '' "$command of an odd name" "$dioptre" $command "$odd" --json
    python3 -m json.tool <"$work/out" >"$work/tree.json" 2>"$work/err" &&
        ok "$command --json is JSON" || fail "$command --json: $(cat "$work/err")"
    holds "$work/out" 'odd\\ufffd\\"\\\\\\u0001é\.lua"' "$command --json escapes the name"
done
expect 0 '' 'info of a scene with a time' "$dioptre" info scenes/orbits.lua
holds "$work/out" '^time +used' 'info says that the time changes it'
expect 0 '' 'info json of it' "$dioptre" info scenes/orbits.lua --json
holds "$work/out" '"is_time_dependent": true' 'and so does info json'
echo 'camera {} sdf { function(x, y, z) return 2 * (x * x + y * y) + z * z - 1 end }' >"$work/steep.lua"
expect 0 'steep.lua:1: this field grows by .* it is divided by' 'info of a steep function' "$dioptre" info "$work/steep.lua"
holds "$work/out" '^functions +7 operations, slope [0-9.]+, divided by [0-9.]+$' 'info says its operations and its slope'
expect 0 'steep.lua:1: ' 'info json of it' "$dioptre" info "$work/steep.lua" --json
holds "$work/out" '"field_functions": \[\{"line": 1, "operations": 7, "slope": [0-9.]+, "divided_by": [0-9.]+\}\]' 'and so does info json'
expect 0 'steep.lua:1: ' 'render says it, too' "$dioptre" render "$work/steep.lua" -s 8x8 -o "$work/steep.bmp"
echo 'camera {} sdf { function(x, y, z, t) return 2 * x - t end }' >"$work/steep.lua"
expect 0 'steep.lua:1: ' 'animate says it' "$dioptre" animate "$work/steep.lua" -s 8x8 --frames 0-3 -o "$work/%d.bmp"
[ "$(grep -c 'steep.lua:1: ' "$work/err")" = 1 ] && ok 'once for all frames' || fail "animate says it so often: $(cat "$work/err")"
# Two squares in one place.
printf '%s\n' 'camera { position = {0, 0, 4} } ambient(1)' 'quad { material = material { color = {1, 0, 0} } }' \
    'quad { u = {0.5, 0, 0}, material = material { color = {0, 0, 1} } }' >"$work/same.lua"
expect 0 'lines 2 and 3 coincide' 'render says which surfaces coincide' \
    "$dioptre" render "$work/same.lua" -s 8x8 -o "$work/same.bmp"
echo 'camera {} for i = 1, 500 do sphere { center = {i, 0, -9} } end plane {}' >"$work/many.lua"
expect 0 '' 'info of many shapes' "$dioptre" info "$work/many.lua"
holds "$work/out" '^acceleration tree over 500 shapes \(1 outside it; used from [0-9]+\)$' 'info says that there is a tree'
expect 0 '' 'bench json' "$dioptre" bench "$box" --json -s 80x60 --frames 3 --samples 1
holds "$work/out" '^\{"scene": "scenes/box.lua", "engine": "[a-z0-9]+", "threads": [0-9]+, "width": 80, "height": 60, "frames": 3, "ms_min": [0-9.e-]+, "ms_median": [0-9.e-]+, "rays": [0-9]+, "mrays_per_s": [0-9.e+]+, "samples_per_pixel": [0-9.]+\}$' 'bench json has its names'
for rays in primary random; do
    expect 0 '' "bench --rays $rays" "$dioptre" bench "$box" --json -s 80x60 --frames 2 --rays $rays
    holds "$work/out" '"rays": 4800,' "bench --rays $rays traces a ray per pixel"
done
cp "$box" "$work/own.lua"
expect 2 'writes a .svg file' 'a drawing over the scene' "$dioptre" probe "$work/own.lua" 4 3 --svg "$work/own.lua"
same "$box" "$work/own.lua" 'the scene is as it was'
expect 0 '"progress"' 'progress as json' "$dioptre" render "$box" -o "$work/j.bmp" --progress json -s 80x60
expect 0 '"done": 3, "frames": 3, "progress": 1.0000' 'progress of bench' \
    "$dioptre" bench "$box" -s 80x60 --frames 3 --progress json
expect 0 '"done": 1, "tests": 1, "progress": 1.0000' 'progress of lab' "$dioptre" lab sphere-pole --out "$work/lab" --progress json
expect 0 '"done": 1, "charts": 1, "progress": 1.0000' 'progress of chart' \
    "$dioptre" chart "$box" -s 80x60 --out "$work/lab" --progress json
expect 0 '^\{"stage": "depth and tolerances"\}$' 'progress of needs' "$dioptre" needs "$box" -s 80x60 --progress json
expect 0 '' 'no progress of needs' "$dioptre" needs "$box" -s 80x60 --progress none
expect 0 '' 'progress is only for terminals' "$dioptre" render "$box" -o "$work/q.bmp" -s 80x60
expect 2 'own, a, b, c or d' 'unknown methods' "$dioptre" render "$box" -o "$work/x.bmp" --methods e
expect 2 'center or corner' 'unknown point of a pixel' "$dioptre" render "$box" -o "$work/x.bmp" --pixel middle
for offset in none fixed bound; do
    expect 0 '' "offset $offset" "$dioptre" render "$box" -o "$work/$offset.bmp" -s 160x120 --offset $offset
done
same "$work/a.bmp" "$work/bound.bmp" 'bound is the default offset'
differing "$work/none.bmp" "$work/bound.bmp" 'no offset shows acne'

# What begins with no place in a file is said by the program.
expect 3 '^dioptre: none.lua: No such file' 'a scene that is not there' "$dioptre" render none.lua -o "$work/x.bmp"
echo 'camera {} print("hello") sphere { material = material { tex = "a.png" } }' >"$work/words.lua"
expect 3 '^[^ ]*/words.lua:1: .*did you mean `texture`' 'an abbreviated word' "$dioptre" info "$work/words.lua" -q
! grep -q hello "$work/err" && ok 'quietly, what a scene prints is left out' || fail 'a scene prints although it is quiet'
for command in info bench needs; do
    options="-q -s 8x6"
    [ $command = bench ] && options="$options --frames 1"
    # shellcheck disable=SC2086 # words
    expect 0 '' "$command, quietly" "$dioptre" $command "$box" $options
    [ ! -s "$work/out" ] && ok 'prints nothing' || fail "$command -q prints $(head -1 "$work/out")"
    # shellcheck disable=SC2086
    "$dioptre" $command "$box" $options --json >"$work/out"
    holds "$work/out" '^{' 'but JSON that is asked for'
done
expect 0 '' '--help is final' "$dioptre" render --help --no-such-option
expect 0 '' '--version is final' "$dioptre" --version --no-such-option
expect 2 'no-such-option' 'but not before a wrong option' "$dioptre" render --no-such-option --help
if [ -w /dev/full ]; then
    "$dioptre" compare "$work/none.bmp" "$work/bound.bmp" >/dev/full 2>"$work/err"
    holds "$work/err" 'cannot write to standard output' 'a full disk, where pictures differ'
fi
expect 0 '' 'a folder in a folder' "$dioptre" chart "$box" -q -s 8x6 --out "$work/outer/inner"
[ -d "$work/outer/inner" ] && ok 'both are made' || fail 'no folder is made'

# The engine is chosen for the size that is drawn: narrow pixels need double precision.
printf 'camera { fov = 0.05, position = {0, 0, 50} }\nimage { width = 8, height = 6 }\nlight {}\nsphere {}\n' >"$work/size.lua"
sed 's/width = 8, height = 6/width = 8000, height = 6000/' "$work/size.lua" >"$work/large.lua"
"$dioptre" info "$work/size.lua" -s 8000x6000 --samples 1 | grep '^engine' >"$work/a"
"$dioptre" info "$work/large.lua" --samples 1 | grep '^engine' >"$work/b"
same "$work/a" "$work/b" 'an option and the scene choose the same engine for the same size'
"$dioptre" info "$work/size.lua" --samples 1 | grep '^engine' >"$work/b"
differing "$work/a" "$work/b" 'and another for a small picture'

# without PACKAGE LIBRARY TARGET: make says what to install, where no library is to be found.
without() {
    expect 2 "^$2 is missing: .*$1" "make without $1" \
        env PKG_CONFIG_LIBDIR="$work" PKG_CONFIG_PATH= make BUILD="$work/build" "$work/build/$3"
}
without libsdl2-dev sdl2 dioptre
without libopenimageio-dev OpenImageIO dioptre-images.so
without libassimp-dev assimp dioptre-meshes.so
finish
