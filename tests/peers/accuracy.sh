#!/bin/sh
# `make peers`, third part: who is nearer to the truth where methods fail. Rays one by one beside
# Embree (accuracy.c), then pictures beside POV-Ray, which works in double: the truth is the same
# scene in quads, and what is counted are the pixels that are off by more than one step of 8 bits.
set -eu
cd "$(dirname "$0")/../.."
. tests/peers/common.sh
need povray "make peers installs it"

"$BUILD/peer-accuracy" f32x8 f64x4 || failed=1

WIDTH=320
HEIGHT=240

# glass RADIUS AWAY: a ball of glass before three stripes, all of it AWAY along each axis.
glass() {
    awk -v s="$1" -v w="$2" -v lua="$work/scene.lua" -v pov="$work/scene.pov" '
    function at(x, y, z) { return sprintf("%.17g, %.17g, %.17g", w + s * x, w + s * y, w + s * z) }
    function along(x, y, z) { return sprintf("%.17g, %.17g, %.17g", s * x, s * y, s * z) }
    function stripe(y, red, green, blue) {
        printf "quad { corner = {%s}, u = {%s}, v = {%s}, material = material { color = {0, 0, 0}, emission = {%g, %g, %g} } }\n", \
            at(-9, y, -4), along(18, 0, 0), along(0, 0.5, 0), red, green, blue >lua
        printf "polygon { 5, <%s>, <%s>, <%s>, <%s>, <%s> pigment { rgb <%g, %g, %g> } finish { ambient 1 diffuse 0 } }\n", \
            at(-9, y, -4), at(9, y, -4), at(9, y + 0.5, -4), at(-9, y + 0.5, -4), at(-9, y, -4), red, green, blue >pov
    }
    BEGIN {
        printf "camera { position = {%s}, look_at = {%s}, fov = 40 }\nimage { depth = 8 } sky { color = {0.2, 0.3, 0.5} }\n", \
            at(0, 0, 5), at(0, 0, 0) >lua
        printf "sphere { center = {%s}, radius = %.17g, material = material { color = {0, 0, 0}, transparency = 1, ior = 1.5 } }\n", \
            at(0, 0, 0), s >lua
        printf "#version 3.7;\nglobal_settings { assumed_gamma 1.0 max_trace_level 9 adc_bailout 0.000001 ambient_light rgb 1 }\n" >pov
        printf "background { rgb <0.2, 0.3, 0.5> }\ncamera { perspective location <%s> right -x * 4/3 up y look_at <%s> angle 40 }\n", \
            at(0, 0, 5), at(0, 0, 0) >pov
        printf "sphere { <%s>, %.17g pigment { rgbt 1 } finish { ambient 0 diffuse 0 phong 0 specular 0 reflection { 0, 1 fresnel on } conserve_energy } interior { ior 1.5 } }\n", \
            at(0, 0, 0), s >pov
        stripe(-1.5, 0.9, 0.2, 0.1)
        stripe(-0.25, 0.1, 0.8, 0.2)
        stripe(1, 0.9, 0.9, 0.2)
    }'
}

# far RADIUS DISTANCE: a white ball before black; it fills most of the picture.
far() {
    awk -v r="$1" -v k="$2" -v lua="$work/scene.lua" -v pov="$work/scene.pov" 'BEGIN {
        angle = 2 * atan2(1.5 * r / k, 1) * 180 / atan2(0, -1)
        printf "camera { position = {0, 0, %.17g}, look_at = {0, 0, 0}, fov = %.17g }\n", k, angle >lua
        printf "sphere { radius = %.17g, material = material { color = {0, 0, 0}, emission = {1, 1, 1} } }\n", r >lua
        print "#version 3.7;\nglobal_settings { assumed_gamma 1.0 ambient_light rgb 1 }" >pov
        printf "camera { perspective location <0, 0, %.17g> right -x * 4/3 up y look_at <0, 0, 0> angle %.17g }\n", k, angle >pov
        printf "sphere { <0, 0, 0>, %.17g pigment { rgb 1 } finish { ambient 1 diffuse 0 } }\n", r >pov
    }'
}

# draw ENGINE FILE: ours.
draw() {
    "$BUILD/dioptre" render "$work/scene.lua" --samples 1 -s "${WIDTH}x$HEIGHT" --engine "$1" -q -o "$2"
}

# share_off FILE: of the pixels, that are off by more than a step from the truth.
share_off() {
    "$BUILD/dioptre" compare "$work/truth.bmp" "$1" --json |
        sed -n 's/.*"share_off": *\([-+.0-9e]*\).*/\1/p' | awk '{ printf "%8.3f", 100 * $1 }'
}

# line NAME: draws the scene by everybody and prints how much of it is wrong.
line() {
    draw f128x1 "$work/truth.bmp"
    printf '  %-44s' "$1"
    for engine in f32x8 f64x4; do
        draw $engine "$work/ours.bmp"
        printf ' | %s' "$(share_off "$work/ours.bmp")"
    done
    povray "+I$work/scene.pov" "+O$work/theirs.png" "+W$WIDTH" "+H$HEIGHT" -A +Q9 -D -V -P +WT1 \
        Display_Gamma=sRGB File_Gamma=sRGB >"$work/log" 2>&1 || {
        cat "$work/log" >&2
        exit 1
    }
    printf ' | %s\n' "$(share_off "$work/theirs.png")"
}

printf '\n%% of pixels off by more than a step\n  %-44s | %8s | %8s | %8s\n' '' f32x8 f64x4 POV-Ray
for size in '1 1e2' '1 1e4' '1e-3 10' '1e3 1e7' '1e5 1e9'; do
    # shellcheck disable=SC2086 # Radius and distance.
    far $size
    line "a ball of radius ${size% *}, ${size#* } away"
done
for radius in 1 1e-3 1e3; do
    glass $radius 0
    line "a ball of glass of radius $radius"
done
for away in 1e2 1e4 1e6; do
    glass 1 $away
    line "a ball of glass of radius 1, $away from zero"
done
exit "$failed"
