#!/bin/sh
# Compares dioptre with Embree 3 on models: how many rays per second each traces with one thread, how
# long it builds, how much memory it takes, and whether the two answer the same. Called by
# `make peers`; see tests/peers/embree.c.
#
# Environment: BUILD (folder of the program; build), MODELS (a folder with stanford-bunny.obj and
# dragon-871k.obj, either packed as .xz or not; they are not ours to give, so without it only Spot
# is compared, for whom there is no bar).
# Exit status: 0 when every bar is reached; 1 when one is not, or when something is missing.
set -eu
cd "$(dirname "$0")/../.."
. tests/peers/common.sh
. tests/peers/figures.sh
MODELS=${MODELS:-}

# The bars: how many times Embree's rate of rays, and how many times its time and memory fit in ours.
PRIMARY_BAR=1.5
RANDOM_BAR=0.9
BUILD_BAR=1
MEMORY_BAR=1

# field NAME NUMBER: a field of a line of what was measured.
field() {
    awk -v name="$1" -v number="$2" '$1 == name { print $number }' "$work/figures"
}

# ratio_bar NAME BAR: how many times as good as Embree ours must be.
ratio_bar() {
    bar "$model, $1" "$(field "$1" 4) times as good as Embree, at least $2" "$(field "$1" 4) >= $2"
}

# check_answers NAME: rays that the two answer differently must not be ours that are wrong.
check_answers() {
    bar "$model, $1: the same answers" \
        "$(field "$1-differ" 2) of 1048576 rays are answered differently, ours wrongly $(
            field "$1-differ" 3), Embree's $(field "$1-differ" 4)" "$(field "$1-differ" 3) == 0"
}

# check_bars: those that the best engine has to reach on a large model.
check_bars() {
    ratio_bar primary $PRIMARY_BAR
    ratio_bar random $RANDOM_BAR
    ratio_bar build $BUILD_BAR
    ratio_bar memory $MEMORY_BAR
}

# measure FILE: compares on a model, with every engine.
measure() {
    model=$(basename "$1" .obj)
    printf 'camera {}\nmesh { file = "%s.obj", normals = "flat" }\n' "$model" >"$work/scene.lua"
    for engine in $ENGINES; do
        "$BUILD/peer-embree" "$work/scene.lua" "$(dirname "$1")" "$engine" >"$work/figures"
        printf '\n%s, 1024x1024 rays, one thread; the best of 9 rounds in turn\n' "$model"
        printf '%-14s %9s %9s %7s %7s\n' "" "$engine" Embree times median
        grep -v -e -differ "$work/figures"
        for rays in primary close random shadow; do check_answers $rays; done
        keep_figures meshes "$model,$engine,$(field primary 5),$(field random 5),$(field shadow 5),$(field build 5),$(field memory 2),$(field memory 3)"
        if [ "$engine" = "$BEST" ] && [ "$model" != spot ]; then check_bars; fi
    done
}

# measure_if_there NAME: compares on a model of $MODELS, or says that it is not there.
measure_if_there() {
    if [ -n "$MODELS" ] && [ -f "$MODELS/$1.obj" ]; then
        measure "$MODELS/$1.obj"
    elif [ -n "$MODELS" ] && [ -f "$MODELS/$1.obj.xz" ]; then
        xz -dc "$MODELS/$1.obj.xz" >"$work/$1.obj"
        measure "$work/$1.obj"
        rm "$work/$1.obj"
    else
        echo "SKIP  $1: there is no \$MODELS/$1.obj (MODELS=${MODELS:-}), nor $1.obj.xz"
    fi
}

need "$BUILD/peer-embree" "make peers"
begin_figures meshes mesh,engine,primary,random,shadow,build,bytes,embree_bytes
measure scenes/models/spot.obj
measure_if_there stanford-bunny
measure_if_there dragon-871k
exit "$failed"
