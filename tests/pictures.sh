#!/bin/sh
# Pictures as a person meets them: what info tells, what files say of themselves, and that no picture file,
# however broken, brings the program down, on a surface or in the sky. With the sanitizer build, each within
# a limit of time.
. "$(dirname "$0")/check.sh"
release=$dioptre
dioptre=$PWD/${DIOPTRE:-build/asan/dioptre}
limited() { timeout 20 "$@"; }
cp tests/pictures/*.* "$work"

# surface FILE, sky FILE: a scene that shows a picture, on its line 2.
surface() { printf "camera {} ambient(1)\nquad { corner = {-9, -9, -1}, u = {18, 0, 0}, v = {0, 18, 0}, material = material { texture = '%s' } }" "$1" >"$work/s.lua"; }
sky() { printf "camera {}\nsky { image = '%s' }" "$1" >"$work/s.lua"; }
# draws NAME COLOR: the scene must be drawn; COLOR is a pattern of the pixel in its middle.
draws() {
    expect 0 '' "$1 is drawn" limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 9x9
    od -An -tx1 -j178 -N3 "$work/o.bmp" | tr -d ' ' >"$work/pixel"
    [ -n "$2" ] && holds "$work/pixel" "^$2$" "$1 has its colour"
    rm -f "$work/o.bmp"
}
# refused NAME WORDS: it must not be drawn, for such a reason.
refused() {
    expect 3 "^$work/s.lua:2: $1: .*$2" "$1 is refused" limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 9x9
    if [ -e "$work/o.bmp" ]; then fail "$1 wrote a picture"; fi
}

# --- legal files -----------------------------------------------------------------------------------
# Blue, green and red of #804020; JPEG may be off by one step.
for file in "$work"/good-*; do
    picture=${file##*/}
    case $picture in
    good-grey.png | good-pal.png) color= ;;
    *.jpg) color='(1f|20|21)(3f|40|41)(7f|80|81)' ;;
    *) color=204080 ;;
    esac
    surface "$picture"; draws "$picture" "$color"
    sky "$picture"; draws "$picture in the sky" "$color"
done

# --- files that are cut off: drawn with what is there and a word about it, or refused -----------------
for ending in jpg tif png bmp; do
    "$release" render scenes/box.lua -q -s 48x32 --samples 1 -o "$work/whole.$ending"
    head -c $(($(stat -c %s "$work/whole.$ending") / 2)) "$work/whole.$ending" >"$work/half.$ending"
    surface "half.$ending"
    case $ending in
    jpg | tif)
        expect 0 "^$work/s.lua:2: half.$ending: it is cut off or damaged, and some of it is missing" \
            "half a .$ending is drawn, with a word" limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 9x9
        limited "$dioptre" info --json "$work/s.lua" >"$work/out" 2>"$work/err"
        holds "$work/out" '"damaged": true' 'and info says so'
        rm "$work/o.bmp"
        ;;
    *) refused "half.$ending" '' ;;
    esac
    surface "whole.$ending"
    expect 0 '' "all of a .$ending is drawn, without a word" limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 9x9
    rm "$work/o.bmp"
done

# --- broken files ----------------------------------------------------------------------------------
for file in "$work"/bmp-* "$work"/hdr-* "$work"/jpg-* "$work"/png-* "$work"/pnm-* "$work"/tga-*; do
    picture=${file##*/}
    # Some libraries read these two, others go astray in them; either is fine.
    case $picture in
    jpg-bad-iptc.jpg | jpg-exif-recursive.jpg)
        surface "$picture"
        limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 9x9 2>"$work/err"
        status=$?
        { [ $status = 0 ] || { [ $status = 3 ] && grep -q "^$work/s.lua:2: $picture: " "$work/err"; }; } &&
            ok "$picture is drawn or refused" || fail "$picture: status $status, $(head -3 "$work/err")"
        rm -f "$work/o.bmp"
        continue
        ;;
    esac
    surface "$picture"; refused "$picture" ''
    sky "$picture"; refused "$picture" ''
done
surface jpg-bomb-65500.jpg; refused jpg-bomb-65500.jpg '65500 x 65500'
# 16384 x 16384 floats are within the limits of size and far beyond that of memory.
printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16384 +X 16384\n' >"$work/large.hdr"
surface large.hdr; refused large.hdr 'more than 1024 MiB'

# Sixty names of one file take the memory of one: read sixty times, it would take 2.8 GiB.
echo 'camera {}' >"$work/links.lua"
"$release" render "$work/links.lua" -o "$work/wide.png" -s 4096x4096 2>"$work/err" || fail 'a wide picture'
mkdir "$work/links"
for i in $(seq 60); do ln "$work/wide.png" "$work/links/$i.png"; done
echo 'camera {} for i = 1, 60 do sphere { material = material { texture = i .. ".png" } } end' >"$work/links/s.lua"
expect 0 '' 'sixty links to one picture' sh -c "ulimit -v 2000000; exec '$release' info '$work/links/s.lua'"

# --- what is no file of the scene's ----------------------------------------------------------------
mkdir "$work/folder.png" "$work/scene"
mkfifo "$work/pipe.png"
surface none.png; refused none.png 'No such file'
surface folder.png; refused folder.png 'a folder'
surface pipe.png; refused pipe.png 'a pipe'
surface s.lua; refused s.lua 'must end in .bmp, png'
surface ../good-one.png; mv "$work/s.lua" "$work/scene"
expect 3 'scene/s.lua:2: ../good-one.png: No such file in the scene' 'a picture outside the folder' "$dioptre" render "$work/scene/s.lua" -o "$work/o.bmp"
ln -s ../good-one.png "$work/scene/link.png"
surface link.png; mv "$work/s.lua" "$work/scene"
expect 3 'link.png: No such file in the scene' 'a link to a picture outside the folder' "$dioptre" render "$work/scene/s.lua" -o "$work/o.bmp"

cp "$work/good-one.png" "$work/scene/inside.png"
for way in ../scene/inside.png ../folder.png/../scene/inside.png ../none/../scene/./inside.png; do
    surface "$way"; mv "$work/s.lua" "$work/scene"
    expect 0 '' "out of the folder and back: $way" "$dioptre" render "$work/scene/s.lua" -o "$work/o.bmp" -s 8x8
done
for way in ../scen/inside.png ../scene/../inside.png ../../../../../../../../../../../../scene/inside.png ../scene ..; do
    surface "$way"; mv "$work/s.lua" "$work/scene"
    expect 3 'No such file in the scene' "out of the folder: $way" "$dioptre" render "$work/scene/s.lua" -o "$work/o.bmp"
done

# --- time ------------------------------------------------------------------------------------------
printf 'camera {}\nlocal far = ("sub/../"):rep(580) .. "none.lua"\nwhile true do pcall(include, far) end' >"$work/scene/s.lua"
mkdir "$work/scene/sub"
started=$(cut -d' ' -f14,15,16,17 "/proc/$$/stat" | tr " " +)
expect 3 'more than 10 s of processor time' 'paths that take long to look up' "$dioptre" info "$work/scene/s.lua"
spent=$(($(cut -d' ' -f14,15,16,17 "/proc/$$/stat" | tr ' ' +) - ($started)))
[ "$spent" -lt $((15 * $(getconf CLK_TCK))) ] && ok 'and they count' || fail "looking up took $spent ticks"

# --- words -----------------------------------------------------------------------------------------
# bad WORDS TEXT: a scene that is refused on its line 2.
bad() {
    printf 'camera {}\n%s' "$2" >"$work/s.lua"
    expect 3 "s.lua:2: $1" "refused: $2" limited "$dioptre" info "$work/s.lua"
}
bad 'sky takes image, or colours' 'sky { image = "good-one.png", color = 1 }'
bad 'sky takes image, or colours' 'sky { image = "good-one.png", zenith = 1 }'
bad 'sky takes rotate only with image' 'sky { rotate = 90 }'
bad 'texture must be the name of a picture' 'material { texture = 7 }'
bad 'texture must not have a zero byte' 'material { texture = "good-one.png\0" }'

cp scenes/models/teapot.obj scenes/models/spot-low.obj "$work"
bad 'teapot.obj: it has no \(u, v\) to lay the picture good-one.png' 'mesh { file = "teapot.obj" }
mesh { file = "teapot.obj", material = material { texture = "good-one.png" } }'
printf 'camera {}\nmesh { file = "teapot.obj" } mesh { file = "spot-low.obj", material = material { texture = "good-one.png" } }\nmaterial { texture = "good-one.png" }' >"$work/s.lua"
expect 0 '' 'a model with (u, v) takes a picture, another does without' limited "$dioptre" info "$work/s.lua"

# --- info ------------------------------------------------------------------------------------------
printf 'camera {} sky { image = "good-one.png" }\nsphere { material = material { texture = "./good-one.png" } } material { texture = "good-16.tif" }' >"$work/s.lua"
expect 0 '' 'info of pictures' limited "$dioptre" info "$work/s.lua"
[ "$(grep -c '^texture ' "$work/out")" = 2 ] && ok 'a picture is told of once' || fail "pictures: $(cat "$work/out")"
holds "$work/out" '^texture +good-one.png: 1 x 1, sRGB, 8 bits, 0.0 MB$' 'info tells what is in a picture'
holds "$work/out" '^texture +good-16.tif: 8 x 8, linear light, floats' '16 bits are kept finer'
expect 0 '' 'info of pictures, in JSON' limited "$dioptre" info --json "$work/s.lua"
holds "$work/out" '"textures": \[\{"file": "good-one.png", "width": 1, "height": 1, "texels": "srgb", "bytes": [0-9]+, "damaged": false\}, \{' 'JSON has the same'

# --- without the module ----------------------------------------------------------------------------
mkdir "$work/bin"
cp "$release" "$(dirname "$release")/dioptre-worker" "$work/bin"
sky good-one.png
expect 1 's.lua:2: good-one.png: .*dioptre-images.so.*install libopenimageio-dev' 'without the module: which package' "$work/bin/dioptre" render "$work/s.lua" -o "$work/o.bmp"
"$release" render scenes/box.lua -o "$work/box.bmp" -s 8x8
sky box.bmp
expect 0 '' 'without the module: BMP works' "$work/bin/dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 8x8
# Which libraries the program itself loads, the loader tells on its standard error; a worker has none.
# libraries NAME SCENE: how many of that name.
libraries() { LD_DEBUG=files "$release" render "$2" -o "$work/o.bmp" -s 8x8 2>&1 | grep -ac "calling init: .*$1"; }
[ "$(libraries libcairo scenes/box.lua)" -ge 1 ] && ok 'the loader tells' || fail 'the loader does not tell'
[ "$(libraries libOpenImageIO scenes/box.lua)" = 0 ] && ok 'no picture: no library of pictures' ||
    fail 'the box loads OpenImageIO'
[ "$(libraries libOpenImageIO "$work/s.lua")" = 0 ] && ok 'BMP: nor there' || fail 'BMP loads OpenImageIO'
sky good-one.png
[ "$(libraries libOpenImageIO "$work/s.lua")" = 0 ] && ok 'a PNG: the library is the worker'"'"'s alone' ||
    fail 'a PNG loads OpenImageIO into the program'
# Whether a worker loads the module that brings this library, a module tells that ends its process at once.
echo '#include <unistd.h>
__attribute__((constructor)) static void end(void) { _exit(9); }' >"$work/ends.c"
"${CC:-cc}" -shared -fPIC -o "$work/bin/dioptre-images.so" "$work/ends.c"
expect 1 's.lua:2: good-one.png: ' 'a PNG: a worker loads the module' "$work/bin/dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 8x8
sky box.bmp
expect 0 '' 'BMP: no worker loads it' "$work/bin/dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 8x8
sky good-one.png

# --- files that are written --------------------------------------------------------------------------
printf 'camera {} sky { color = {4, 0.1, 1e-5} }' >"$work/s.lua"
for ending in png jpg tif exr hdr; do
    "$release" render "$work/s.lua" -o "$work/o.$ending" -s 8x8 --engine f32x1 --samples 4 --depth 3 --offset fixed --epsilon 0.01
    "$release" render "$work/s.lua" -o "$work/again.$ending" -s 8x8 --engine f32x1 --samples 4 --depth 3 --offset fixed --epsilon 0.01 -j 1
    same "$work/o.$ending" "$work/again.$ending" "the same bytes again: $ending"
    strings "$work/o.$ending" >"$work/out"
    holds "$work/out" "dioptre $(sed -n 's/^VERSION *:= *//p' Makefile)" "$ending names the program"
    holds "$work/out" 'scene s.lua, time 0 s, engine f32x1, 8x8, samples 4, depth 3, offset fixed 0.01, cutoff 0.25, sampling adaptive, methods own, pixel center' "$ending says how it came about"
    if grep -qE "$work|20[0-9][0-9]:" "$work/out"; then fail "$ending tells a path or a date"; else ok "$ending tells no path and no date"; fi
done
# A disk that fills up, in every format: the old file stays, and nothing is left over.
for ending in png jpg tif exr hdr; do
    cp "$work/again.$ending" "$work/o.$ending"
    (ulimit -f 4; trap '' XFSZ; exec "$release" render scenes/box.lua -o "$work/o.$ending" -s 400x300 --samples 1) 2>"$work/err"
    [ $? = 1 ] && ok "full disk: status 1, $ending" || fail "full disk, $ending: $(cat "$work/err")"
    holds "$work/err" "o.$ending': File too large" "full disk: says so, $ending"
    same "$work/o.$ending" "$work/again.$ending" "full disk: the old file is whole, $ending"
    [ "$(find "$work" -name "o.$ending*" | wc -l)" = 1 ] && ok "full disk: nothing left over, $ending" || fail "full disk: something is left of $ending"
done

# Linear light, not cut at 1 and not rounded to steps: as a panorama it lights a scene again.
for ending in exr hdr; do
    printf 'camera {} image { encoding = "linear" }\nsky { image = "o.%s" }' $ending >"$work/t.lua"
    "$release" render "$work/t.lua" -o "$work/t.exr" -s 8x8
    printf 'camera {} image { encoding = "linear" }\nambient(1/16) quad { corner = {-9, -9, -1}, u = {18, 0, 0}, v = {0, 18, 0}, material = material { texture = "t.exr" } }' >"$work/t.lua"
    "$release" render "$work/t.lua" -o "$work/t.bmp" -s 8x8
    od -An -tx1 -j54 -N3 "$work/t.bmp" | tr -d ' ' >"$work/pixel"
    holds "$work/pixel" '^00(01|02)40$' "$ending keeps light above 1"
done
finish
