#!/bin/sh
# Engines as a person meets them: all draw the box, and the program runs on a processor without AVX2.
. "$(dirname "$0")/check.sh"
box=scenes/box.lua
shapes=tests/peers/shapes.lua

draw() { "$dioptre" render "$box" -o "$work/$1.bmp" -s 96x72 --samples 2 --engine "$1"; }
draw_shapes() { "$dioptre" render "$shapes" -o "$work/shapes-$1.bmp" -s 192x144 --samples 2 --engine "$1"; }

# same_bits WORDS SCENE OPTION...: engines of one number draw the same picture.
same_bits() {
    what=$1
    shift
    for engine in $singles f64x4 f64x1; do
        "$dioptre" render "$@" -o "$work/bits-$engine.bmp" --engine $engine || fail "$engine draws $what"
    done
    for engine in $singles; do
        [ $engine = f32x1 ] ||
            same "$work/bits-$engine.bmp" "$work/bits-f32x1.bmp" "$engine gives the bits of f32x1 for $what"
    done
    same "$work/bits-f64x4.bmp" "$work/bits-f64x1.bmp" "f64x4 gives the bits of f64x1 for $what"
}

if grep -q avx2 /proc/cpuinfo; then
    singles='f32x8 f32x4 f32x1'
    if grep -q avx512dq /proc/cpuinfo; then
        singles="f32x16 $singles"
    else
        echo 'skipped f32x16: this processor has no AVX-512'
    fi
    same_bits 'the box' "$box" -s 96x72 --samples 2
    same_bits 'the shapes that the box lacks' "$shapes" -s 192x144 --samples 2
    same_bits 'a field without end' tests/scenes/endless-row.lua -s 80x60
    same_bits 'a field that rays graze' tests/scenes/grazed-field.lua -s 80x60
    same_bits 'fields that cross, in few steps' tests/scenes/few-steps.lua -s 200x150
    for methods in a c d; do
        same_bits "method $methods far from a sphere" tests/scenes/far-sphere.lua -s 160x120 --methods $methods
        same_bits "method $methods far from a tree" tests/scenes/far-spheres.lua -s 160x120 --methods $methods
    done
    same_bits 'the list of report D' tests/scenes/turns-used-up.lua -s 32x24 --methods d
    draw f32x8
    draw f128x1 && ok 'f128x1 draws the box' || fail 'f128x1 draws the box'
    "$dioptre" compare "$work/f32x8.bmp" "$work/f128x1.bmp" --json >"$work/out"
    holds "$work/out" '"share_off": (0,|0\.00[0-4]|[0-9.]+e-)' 'float is within a step of quad but at edges'
else
    echo 'skipped: this processor has no AVX2'
fi

# A processor of 2008, emulated.
old="qemu-x86_64 -cpu core2duo $dioptre"
draw f32x4
expect 0 '' 'without AVX2: info' $old info "$box"
holds "$work/out" 'f32x4' 'without AVX2: f32x4 is taken'
expect 0 '' 'without AVX2: render' $old render "$box" -o "$work/old.bmp" -s 96x72 --samples 2
same "$work/old.bmp" "$work/f32x4.bmp" 'without AVX2: the same bits'
# The emulator has AVX2, and no AVX-512.
expect 0 '' 'without AVX-512: info' qemu-x86_64 -cpu max "$dioptre" info "$box"
holds "$work/out" '^engine +f32x8: the default for this processor$' 'without AVX-512: auto takes f32x8'
expect 0 '' 'info on this processor' "$dioptre" info "$box"
case $(sed -n 's/^vendor_id[^:]*: //p; s/^cpu family[^:]*: //p; s/^model\t*: //p' /proc/cpuinfo | head -3 | tr '\n' ' ') in
'GenuineIntel 6 143 ' | 'GenuineIntel 6 207 ' | 'AuthenticAMD 25 17 ')
    holds "$work/out" '^engine +f32x16: AVX-512 was measured' 'auto takes f32x16 where that was measured to be faster'
    ;;
*) holds "$work/out" '^engine +f32x(8|4): the default' 'auto takes the default where nothing was measured' ;;
esac
expect 2 'AVX2' 'without AVX2: f32x8 is refused' $old info "$box" --engine f32x8
expect 2 'AVX-512' 'without AVX-512: f32x16 is refused' $old info "$box" --engine f32x16

# One program, two compilers: the same bits.
build/clang/dioptre render "$box" -o "$work/clang.bmp" -s 96x72 --samples 2 --engine f32x4
same "$work/clang.bmp" "$work/f32x4.bmp" 'gcc and clang give the same bits'
build/clang/dioptre render "$shapes" -o "$work/clang.bmp" -s 192x144 --samples 2 --engine f32x4
draw_shapes f32x4
pictures=scenes/report-d-pictures.lua
for program in build/dioptre build/clang/dioptre; do
    $program render $pictures -o "$work/$(echo $program | tr / -).bmp" -s 96x60 --samples 2 --engine f32x4
done
same "$work/build-dioptre.bmp" "$work/build-clang-dioptre.bmp" 'gcc and clang give the same bits for pictures'
same "$work/clang.bmp" "$work/shapes-f32x4.bmp" 'gcc and clang give the same bits for all shapes'
for scene in glass-of-water glass-teapot chess; do
    build/clang/dioptre render "scenes/$scene.lua" -o "$work/clang.bmp" -s 96x72 --samples 1 --engine f32x4
    "$dioptre" render "scenes/$scene.lua" -o "$work/gcc.bmp" -s 96x72 --samples 1 --engine f32x4
    same "$work/clang.bmp" "$work/gcc.bmp" "gcc and clang give the same bits for $scene"
done
finish
