#!/bin/sh
# Gappa proves the error bounds of hit points (doc/laboratory.md, "Error bounds that are proved"):
# tests/gappa/*.g, once for float and once for double, with the constants of the C source in them.
. "$(dirname "$0")/check.sh"

command -v gappa >/dev/null || {
    fail 'gappa is missing: sudo apt-get install gappa'
    exit 1
}
shapes=src/trace/shapes

# --- the source is the one that the scripts describe ------------------------------------------------
# source_has FILE TEXT...: each text is a line of a file, but for white space.
source_has() {
    file=$1
    shift
    for text; do
        tr -s ' \n' ' ' <"$file" | grep -qF "$text" && ok "$file: $text" || fail "$file has no longer: $text"
    done
}
source_has $shapes/plane_equation.h \
    'Vec3 normal = vec3_splat(plane->normal); Vec3 anchor = vec3_splat(plane->anchor);' \
    'real height = vec3_dot(normal, vec3_subtract(point, anchor));' \
    'point = vec3_subtract(point, vec3_scale(normal, height));' \
    'real magnitude = vec3_max_abs(point) + real_of(plane->magnitude);' \
    'return (SurfacePoint){point, normal, PLANE_ERROR * ROUNDOFF * magnitude};'
for shape in plane disk quad triangle; do
    source_has $shapes/$shape.c 'plane_equation_surface(&'
done
source_has $shapes/sphere.c 'Vec3 normal = vec3_normalize(from_center);' \
    'real radius = real_of((scalar)sphere->radius);' \
    'Vec3 point = vec3_add(vec3_splat(vec3s_narrow(sphere->center)), vec3_scale(normal, radius));' \
    'return (SurfacePoint){point, normal, SPHERE_ERROR * ROUNDOFF * (vec3_max_abs(point) + radius)};'
source_has $shapes/box.c '*point[axis] = real_select(is_face_axis, real_select(is_high, high, low), inside);' \
    'surface.error = BOX_ERROR * ROUNDOFF * vec3_max_abs(surface.point);'
source_has src/trace/math/vec3.h 'return a.x * b.x + a.y * b.y + a.z * b.z;' \
    'return vec3_scale(v, 1 / real_sqrt(vec3_dot(v, v)));'
source_has src/trace/math/real.h '#define ROUNDOFF 0x1p-24f' '#define ROUNDOFF 0x1p-53'

# --- the theorems -------------------------------------------------------------------------------------
# roundings NUMBER: so many half ulps of 1, as Gappa writes numbers, rounded up to a 1024th.
roundings() {
    awk -v number="$1" -v bits="$bits" 'BEGIN { n = number * 1024; i = int(n); printf "%db-%d", i < n ? i + 1 : i, bits + 10 }'
}

# proves SCRIPT NAME=VALUE...: whether Gappa proves a script with these values.
proves() {
    sed "s/@BITS@/$bits/g" "tests/gappa/$1.g" >"$work/theorem.g"
    shift
    for pair; do
        sed "s/@${pair%%=*}@/${pair#*=}/g" "$work/theorem.g" >"$work/theorem.next" && mv "$work/theorem.next" "$work/theorem.g"
    done
    # A proof takes under a second. A statement that is false would be split for ever.
    timeout 60 gappa -Eprecision=150 -Eno-auto-dichotomy "$work/theorem.g" >"$work/out" 2>&1
}

# theorem SHAPE CONSTANT BOUND SCRIPT NAME=VALUE...: the last step of a proof. It holds with the constant of the
# source, and not with half the bound: then the script would prove anything.
theorem() {
    shape=$1 constant=$2 bound=$3
    shift 3
    script=$1
    shift
    proves "$script" ERROR="$constant" BOUND="$(roundings "$bound")" "$@" &&
        ok "$shape, $bits bits: $constant half ulps in the source; the error is at most $bound" ||
        fail "$shape, $bits bits: not proved, $(cat "$work/out")"
    [ "$bound" = 0 ] && return
    proves "$script" ERROR="$constant" BOUND="$(roundings "$(awk "BEGIN { print $bound / 2 }")")" "$@" &&
        fail "$shape, $bits bits: half of it is proved, too" || ok "$shape, $bits bits: half of it is not proved"
    proves "$script" ERROR=1 BOUND="$(roundings "$bound")" "$@" &&
        fail "$shape, $bits bits: a constant of 1 would do, too" || ok "$shape, $bits bits: a constant of 1 is refused"
}

# lemma SCRIPT NAME=VALUE...: a step before the last.
lemma() {
    proves "$@" && ok "$1, $bits bits" || fail "$1, $bits bits: not proved, $(cat "$work/out")"
}

# constant FILE NAME: a whole number that a header defines.
constant() {
    sed -n "s/^#define $2 \([0-9]*\)$/\1/p" "$1"
}
plane_error=$(constant $shapes/plane_equation.h PLANE_ERROR)
sphere_error=$(constant $shapes/sphere.c SPHERE_ERROR)
box_error=$(constant $shapes/box.c BOX_ERROR)
case "$plane_error,$sphere_error,$box_error" in
,* | *,,* | *,) fail 'the source no longer defines PLANE_ERROR, SPHERE_ERROR and BOX_ERROR as numbers' ;;
*) ok "the source has PLANE_ERROR $plane_error, SPHERE_ERROR $sphere_error, BOX_ERROR $box_error" ;;
esac

# Float has a wide precision, from which the engine rounds; in double it is the same type. HEIGHT is an
# assumption: how far the point may be off the plane before it is moved, in lengths of M.
in_float='' in_double=''
for bits in 24 53; do
    if [ $bits = 24 ]; then
        narrowed=1b-24 height=1b-10 component=3.001 terms=5.198 sum=6.21 spread=1.002 plane=7.97
        inverse=3.7 vector=6.66 radius=7.67 along=3.467 center=1.7334 sphere=7.8 box=1.75
    else
        narrowed=0 height=1b-5 component=2.001 terms=3.466 sum=4.54 spread=1.04 plane=6.6
        inverse=3.7 vector=5.66 radius=5.67 along=1.7334 center=0 sphere=5.8 box=0
    fi
    lemma plane-component NARROWED=$narrowed COMPONENT="$(roundings $component)"
    lemma plane-height COMPONENT="$(roundings $component)" TERMS="$(roundings $terms)" HEIGHT=$height \
        SUM="$(roundings $sum)"
    theorem 'plane, disk, quad and triangle' "$plane_error" $plane plane-point NARROWED=$narrowed HEIGHT=$height \
        SUM="$(roundings $sum)" SPREAD=$spread MOVE="$(roundings 2.01)" LAST="$(roundings 1.7334)"
    lemma sphere-length DOT="$(roundings 3.3)"
    lemma sphere-vector DOT="$(roundings 3.3)" NARROWED=$narrowed INVERSE="$(roundings $inverse)" \
        VECTOR="$(roundings $vector)"
    theorem sphere "$sphere_error" $sphere sphere-point NARROWED=$narrowed RADIUS="$(roundings $radius)" \
        LAST="$(roundings $along)" CENTER="$(roundings $center)" ACROSS="$(roundings 13)"
    theorem box "$box_error" $box box-point NARROWED=$narrowed
    lemma box-start ERROR="$box_error" START="$(roundings 6.9)"
    [ $bits = 24 ] && in_float="$sphere $plane $box" || in_double="$sphere $plane $box"
done

# The page has the same figures: sphere, flat shapes, box; in float, then in double.
page=doc/laboratory.md
set -- $in_float $in_double
holds $page "^. sphere . $sphere_error u \(P \+ R\) . $1 u \(P \+ R\) . $4 u \(P \+ R\) .\$" "$page has the sphere's bounds"
holds $page "^. plane, disk, quad, triangle . $plane_error u \(P \+ A\) . $2 u \(P \+ A\) . $5 u \(P \+ A\) .\$" \
    "$page has the bounds of flat shapes"
holds $page "^. box . $box_error u P . $3 u P . $6 .\$" "$page has the box's bounds"
finish
