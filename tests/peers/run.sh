#!/bin/sh
# Compares dioptre with its peers Tachyon 0.99 and POV-Ray 3.7 on scenes/box.lua, and with POV-Ray on
# tests/peers/shapes.lua and tests/peers/spot.lua: how fast each is with one thread, and how far our
# picture is from POV-Ray's. Called by `make peers`.
#
# Environment: BUILD (folder of the program; build), ROUNDS (runs of each; 5).
# Exit status: 0 when every bar is reached; 1 when one is not, or when something is missing.
set -eu
cd "$(dirname "$0")/../.."
. tests/peers/common.sh
ROUNDS=${ROUNDS:-5}
SIZE=800x600
FRAMES=30 # Of ours a run: one frame is too short for the clock and the processor's moods.

# The bars: times as fast as each peer, and the share of pixels within one step of POV-Ray's.
TACHYON_BAR=20
POVRAY_BAR=45
SHAPES_BAR=20 # POV-Ray on the other shapes, and on a mesh.
ALIKE_BAR=0.999

# Checksum of box.lua, without comments and spaces, that the peers' scenes were copied from.
COPIED_FROM=377351294

# Says so when box.lua is no longer what the peers' scenes were copied from.
check_scene() {
    sum=$(sed 's/--.*//; s/[[:space:]]//g; /^$/d' scenes/box.lua | cksum | cut -d' ' -f1)
    if [ "$sum" != "$COPIED_FROM" ]; then
        echo "peers: scenes/box.lua has changed since box.pov and box.tachyon were copied from it;" \
            "the comparison may be of different scenes (its checksum is now $sum)" >&2
    fi
}

# number NAME FILE: the number that a JSON object in FILE gives under NAME.
number() {
    sed -n 's/.*"'"$1"'": *\([-+.0-9eE]*\).*/\1/p' "$2"
}

# Makes the model of spot.lua into the meshes that spot.pov includes.
make_meshes() {
    awk -f tests/peers/mesh2.awk scenes/models/spot.obj >"$work/flat.inc"
    awk -v smooth=1 -f tests/peers/mesh2.awk scenes/models/spot.obj >"$work/smooth.inc"
}

# median FILE: of the numbers in FILE, one a line.
median() {
    sort -g "$1" | awk '{ a[NR] = $1 } END { print (a[int((NR + 1) / 2)] + a[int(NR / 2) + 1]) / 2 }'
}

# time_dioptre SCENE NAME: ours; the times go to NAME and the engine.
time_dioptre() {
    for engine in $ENGINES; do
        "$BUILD/dioptre" bench --json "$1" --base-dir scenes/models -s $SIZE --samples 1 --depth 5 \
            -j 1 --engine "$engine" --frames $FRAMES >"$work/bench.json"
        number ms_median "$work/bench.json" >>"$work/$2.$engine"
        number mrays_per_s "$work/bench.json" >>"$work/$2.$engine.mrays"
    done
}

# Tachyon says how long it traced, without reading the scene and writing the picture.
time_tachyon() {
    tachyon tests/peers/box.tachyon -numthreads 1 -fullshade -shade_phong +V \
        -format BMP -o "$work/tachyon.bmp" >"$work/tachyon.log"
    tr '\r' '\n' <"$work/tachyon.log" |
        sed -n 's/.*Ray Tracing Time: *\([.0-9]*\) seconds.*/\1/p' |
        awk '{ print 1000 * $1 }' >>"$work/tachyon"
}

# povray_scene NAME OPTION...: POV-Ray with a scene, one thread, no anti-aliasing; its log is in povray.log.
povray_scene() {
    scene=$1
    shift
    if ! povray "+Itests/peers/$scene.pov" "+L$work" +W800 +H600 -A +WT1 +Q9 -D -V -P "$@" \
        2>"$work/povray.log"; then
        cat "$work/povray.log" >&2
        exit 1
    fi
}

# time_povray NAME: so does POV-Ray, in wall-clock time; -F: it writes no picture.
time_povray() {
    povray_scene "$1" -F
    sed -n 's/.*Trace Time:.*(\([.0-9]*\) seconds).*/\1/p' "$work/povray.log" |
        awk '{ print 1000 * $1 }' >>"$work/$1.povray"
}

# One after the other, round by round, so that a slow moment of the machine hits all of them.
measure_speed() {
    round=1
    while [ "$round" -le "$ROUNDS" ]; do
        time_dioptre scenes/box.lua box
        time_tachyon
        time_povray box
        time_dioptre tests/peers/shapes.lua shapes
        time_povray shapes
        time_dioptre tests/peers/spot.lua spot
        time_povray spot
        round=$((round + 1))
    done
}

report_speed() {
    ours=$(median "$work/box.$BEST")
    tachyon=$(median "$work/tachyon")
    povray=$(median "$work/box.povray")
    tachyon_ratio=$(awk "BEGIN { printf \"%.1f\", $tachyon / $ours }")
    povray_ratio=$(awk "BEGIN { printf \"%.1f\", $povray / $ours }")
    echo "scenes/box.lua, $SIZE, one ray a pixel, depth 5, one thread; medians of $ROUNDS runs"
    printf '%-16s %10s %8s\n' "" "ms a frame" "times"
    for engine in $ENGINES; do
        printf '%-16s %10.2f %8s   (%.1f Mrays/s; Tachyon %.1f, POV-Ray %.1f times as long)\n' \
            "dioptre $engine" "$(median "$work/box.$engine")" "" "$(median "$work/box.$engine.mrays")" \
            "$(awk "BEGIN { print $tachyon / $(median "$work/box.$engine") }")" \
            "$(awk "BEGIN { print $povray / $(median "$work/box.$engine") }")"
    done
    printf '%-16s %10.2f %8s\n' "Tachyon" "$tachyon" "$tachyon_ratio"
    printf '%-16s %10.2f %8s\n' "POV-Ray" "$povray" "$povray_ratio"
    bar "$BEST faster than Tachyon" "$tachyon_ratio times, at least $TACHYON_BAR" \
        "$tachyon / $ours >= $TACHYON_BAR"
    bar "$BEST faster than POV-Ray" "$povray_ratio times, at least $POVRAY_BAR" \
        "$povray / $ours >= $POVRAY_BAR"
}

# report_povray NAME TEXT: the other scenes, against POV-Ray only.
report_povray() {
    ours=$(median "$work/$1.$BEST")
    povray=$(median "$work/$1.povray")
    ratio=$(awk "BEGIN { printf \"%.1f\", $povray / $ours }")
    echo
    echo "tests/peers/$1.lua, likewise: $2"
    printf '%-16s %10.2f\n' "dioptre $BEST" "$ours" "POV-Ray" "$povray"
    bar "$BEST faster than POV-Ray" "$ratio times, at least $SHAPES_BAR" \
        "$povray / $ours >= $SHAPES_BAR"
}

# draw_pictures SCENE NAME: ours, and POV-Ray's of its twin.
draw_pictures() {
    "$BUILD/dioptre" render "$1" --base-dir scenes/models -s $SIZE --samples 1 --depth 5 -j 1 \
        --engine f32x8 --quiet -o "$work/ours.bmp"
    povray_scene "$2" +FB "+O$work/povray.bmp" File_Gamma=sRGB Dither=off
}

report_difference() {
    # 1: the pictures are not alike, which is what is to be found out here.
    "$BUILD/dioptre" compare --json "$work/ours.bmp" "$work/povray.bmp" >"$work/compare.json" || [ $? -eq 1 ]
    ${CC:-cc} -std=gnu11 -O2 -Iinclude -Isrc -D_GNU_SOURCE -o "$work/edges" tests/peers/edges.c \
        src/assets/bmp.c src/render/picture.c src/scene/error.c
    "$work/edges" "$work/ours.bmp" "$work/povray.bmp" >"$work/edges.txt"
    read -r pixels off elsewhere <"$work/edges.txt"
    off_share=$(number share_off "$work/compare.json")
    echo "picture against POV-Ray's: $off of $pixels pixels are off by more than one step;" \
        "rmse $(number rmse "$work/compare.json"), psnr $(number psnr "$work/compare.json") dB"
    bar "pixels alike" "$(awk "BEGIN { printf \"%.4f\", 100 * (1 - $off_share) }") %, at least $(
        awk "BEGIN { print 100 * $ALIKE_BAR }") %" "1 - $off_share >= $ALIKE_BAR"
    bar "the others on edges" "$elsewhere are not" "$elsewhere == 0"
}

need tachyon "apt-get install tachyon"
need povray "apt-get install povray"
need "$BUILD/dioptre" "make"
check_scene
make_meshes
measure_speed
report_speed
draw_pictures scenes/box.lua box
report_difference
report_povray shapes "cylinder, pipe, disk, triangle, a turned box, an egg"
draw_pictures tests/peers/shapes.lua shapes
report_difference
report_povray spot "a mesh of 5856 triangles, twice: flat and smooth"
draw_pictures tests/peers/spot.lua spot
report_difference
exit "$failed"
