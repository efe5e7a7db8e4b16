#!/bin/sh
# Compares dioptre with its peers Tachyon 0.99 and POV-Ray 3.7 on scenes/box.lua and on a box with
# glass, and with POV-Ray on the other scenes here: how fast each is with one thread, and how far our
# picture is from POV-Ray's. Called by `make peers`.
#
# Times are of the processor, as the system counts them for the whole program: what else the machine
# does hardly matters. What comes before the first ray is subtracted: each is run once more with a
# picture of next to nothing.
#
# Environment: BUILD (folder of the program; build), ROUNDS (runs of each; 5), MAPS (a folder: where
# pictures of the differences are left).
# Exit status: 0 when every bar is reached; 1 when one is not, or when something is missing.
set -eu
cd "$(dirname "$0")/../.."
. tests/peers/common.sh
. tests/peers/figures.sh
ROUNDS=${ROUNDS:-5}
MAPS=${MAPS:-}
SIZE=800x600
FRAMES=30 # Of ours a run: the system counts hundredths of a second.

# The bars: times as fast as each peer, and the share of pixels within one step of POV-Ray's.
TACHYON_BAR=20
POVRAY_BAR=45
SHAPES_BAR=20 # POV-Ray on the other shapes, on a mesh, and on a box with mirrors and glass.
# Floors under what was measured, so that it gets no worse.
CLEAR_BAR=9    # Tachyon on clear glass.
CROWDED_BAR=5  # POV-Ray where there is hardly anything but mirrors and glass.
PICTURES_BAR=8 # POV-Ray on pictures.
ALIKE_BAR=0.999
# Pixels that are off on no edge. Glass shows whole edges within less than a pixel.
ELSEWHERE_BAR=0
GLASS_ELSEWHERE_BAR=5
SOFT_ELSEWHERE_BAR=5 # Shadows without an outline.

# Checksum of box.lua, without comments and spaces, that the peers' scenes were copied from.
COPIED_FROM=3443134196

# Says so when box.lua is no longer what the peers' scenes were copied from.
check_scene() {
    sum=$(sed 's/--.*//; s/[[:space:]]//g; /^$/d' scenes/box.lua | cksum | cut -d' ' -f1)
    if [ "$sum" != "$COPIED_FROM" ]; then
        echo "peers: scenes/box.lua has changed since box.pov and box.tachyon were copied from it;" \
            "the comparison may be of different scenes (its checksum is now $sum)" >&2
    fi
}

# Makes the model of spot.lua into the meshes that spot.pov includes.
make_meshes() {
    awk -f tests/peers/mesh2.awk scenes/models/spot.obj >"$work/flat.inc"
    awk -v smooth=1 -f tests/peers/mesh2.awk scenes/models/spot.obj >"$work/smooth.inc"
}

# bench_dioptre SCENE DEPTH ENGINE FRAMES: draws pictures.
bench_dioptre() {
    "$BUILD/dioptre" bench --json "$1" --base-dir "$(folder_of "$1")" -s "$SIZE" --samples 1 \
        --depth "$2" -j 1 --engine "$3" --frames "$4"
}

# folder_of SCENE: where the files lie that it names.
folder_of() {
    case $1 in
    */pictures.lua) echo scenes/pictures ;;
    *) echo scenes/models ;;
    esac
}

# time_dioptre SCENE NAME DEPTH: ours; the times go to NAME and the engine.
time_dioptre() {
    for engine in $ENGINES; do
        user_time "$work/long" bench_dioptre "$1" "$3" "$engine" $((FRAMES + 1))
        number rays "$work/log" >"$work/$2.rays"
        user_time "$work/short" bench_dioptre "$1" "$3" "$engine" 1
        append_difference "$work/long" "$work/short" $FRAMES "$work/$2.$engine"
    done
}

# trace_tachyon SCENE OPTION...: Tachyon with a scene and one thread.
trace_tachyon() {
    tachyon "$@" -numthreads 1 -fullshade -shade_phong -format BMP -o "$work/tachyon.bmp"
}

# time_tachyon NAME SCENE: Tachyon, without the time that reading and writing take.
time_tachyon() {
    user_time "$work/long" trace_tachyon "$2"
    user_time "$work/short" trace_tachyon "$2" -res 8 6
    append_difference "$work/long" "$work/short" 1 "$work/$1.tachyon"
}

# povray_scene NAME WIDTH HEIGHT OPTION...: POV-Ray with a scene, one thread, no anti-aliasing.
povray_scene() {
    scene=$1
    size="+W$2 +H$3"
    shift 3
    # shellcheck disable=SC2086 # Two options.
    povray "+Itests/peers/$scene.pov" "+L$work" +Lscenes/pictures $size -A +WT1 +Q9 -D -V -P "$@"
}

# time_povray NAME: so does POV-Ray; -F: it writes no picture.
time_povray() {
    user_time "$work/long" povray_scene "$1" 800 600 -F
    user_time "$work/short" povray_scene "$1" 8 6 -F
    append_difference "$work/long" "$work/short" 1 "$work/$1.povray"
}

# One after the other, round by round, so that a slow moment of the machine hits all of them.
measure_speed() {
    round=1
    while [ "$round" -le "$ROUNDS" ]; do
        time_dioptre scenes/box.lua box 5
        time_tachyon box tests/peers/box.tachyon
        time_povray box
        time_dioptre "$work/clear-box.lua" clear-box 8
        time_tachyon clear-box tests/peers/clear-box.tachyon
        for scene in shapes spot glass-box pictures; do
            time_dioptre tests/peers/$scene.lua $scene 5
            time_povray $scene
        done
        time_dioptre tests/peers/glass.lua glass 8
        time_povray glass
        round=$((round + 1))
    done
}

# report_ours NAME: the times of our engines.
report_ours() {
    for engine in $ENGINES; do
        printf '%-16s %10.2f   (%.1f Mrays/s)\n' "dioptre $engine" "$(median "$work/$1.$engine")" \
            "$(awk "BEGIN { print $(cat "$work/$1.rays") / 1000 / $(median "$work/$1.$engine") }")"
    done
}

# report_peer NAME PEER TEXT BAR: a peer's time, and how many times it is ours.
report_peer() {
    theirs=$(median "$work/$1.$2")
    printf '%-16s %10.2f  ' "$3" "$theirs"
    for engine in $ENGINES; do
        awk "BEGIN { printf \" %.1f times $engine\", $theirs / $(median "$work/$1.$engine") }"
    done
    echo
    keep_figures speed "$1,$2,$theirs,$(median "$work/$1.f32x8"),$([ "$BEST" = f32x8 ] || median "$work/$1.$BEST")"
    ratio=$(awk "BEGIN { printf \"%.1f\", $theirs / $(median "$work/$1.$BEST") }")
    bar "$BEST faster than $3" "$ratio times, at least $4" "$ratio >= $4"
}

# draw_pictures SCENE NAME DEPTH SIZE SAMPLES: ours, and POV-Ray's of its twin.
draw_pictures() {
    "$BUILD/dioptre" render "$1" --base-dir "$(folder_of "$1")" -s "$4" --samples "$5" --sampling full \
        --depth "$3" -j 1 --engine f32x8 --quiet -o "$work/ours.bmp"
    if ! povray_scene "$2" "${4%x*}" "${4#*x}" +FB "+O$work/povray.bmp" File_Gamma=sRGB Dither=off \
        2>"$work/log"; then
        cat "$work/log" >&2
        exit 1
    fi
}

# report_difference NAME ELSEWHERE-BAR: how far the pictures are from each other, and where.
report_difference() {
    # 1: the pictures are not alike, which is what is to be found out here.
    "$BUILD/dioptre" compare --json "$work/ours.bmp" "$work/povray.bmp" >"$work/compare.json" || [ $? -eq 1 ]
    "$work/edges" "$work/ours.bmp" "$work/povray.bmp" >"$work/edges.txt"
    if [ -n "$MAPS" ]; then
        "$BUILD/dioptre" compare --quiet --map "$MAPS/$1.png" "$work/ours.bmp" "$work/povray.bmp" ||
            [ $? -eq 1 ]
    fi
    read -r pixels off elsewhere <"$work/edges.txt"
    off_share=$(number share_off "$work/compare.json")
    keep_figures pictures "$1,$pixels,$off,$elsewhere"
    echo "picture against POV-Ray's: $off of $pixels pixels are off by more than one step;" \
        "rmse $(number rmse "$work/compare.json"), psnr $(number psnr "$work/compare.json") dB"
    bar "pixels alike" "$(awk "BEGIN { printf \"%.4f\", 100 * (1 - $off_share) }") %, at least $(
        awk "BEGIN { print 100 * $ALIKE_BAR }") %" "1 - $off_share >= $ALIKE_BAR"
    bar "the others on edges" "$elsewhere are not, at most $2" "$elsewhere <= $2"
}

# report SCENE NAME DEPTH BAR ELSEWHERE-BAR TEXT: one scene, against POV-Ray.
report() {
    printf '\n%s, depth %s: %s\n' "$1" "$3" "$6"
    report_ours "$2"
    report_peer "$2" povray POV-Ray "$4"
    draw_pictures "$1" "$2" "$3" "$SIZE" 1
    report_difference "$2" "$5"
}

# report_light NAME SIZE SAMPLES ELSEWHERE-BAR TEXT: only how far the pictures are from each other.
report_light() {
    printf '\ntests/peers/%s.lua, %s, %s rays per pixel: %s\n' "$1" "$2" "$3" "$5"
    draw_pictures "tests/peers/$1.lua" "$1" 0 "$2" "$3"
    report_difference "$1" "$4"
}

need tachyon "apt-get install tachyon"
need povray "apt-get install povray"
need "$BUILD/dioptre" "make"
check_scene
make_meshes
make_edges
# Tachyon lets light through, but does not bend it: so for it our glass does not, either.
sed 's/ior = 1.5/ior = 1/' tests/peers/glass-box.lua >"$work/clear-box.lua"
measure_speed
begin_figures speed scene,peer,peer_ms,f32x8_ms,f32x16_ms
begin_figures pictures scene,pixels,off,off_on_no_edge
echo "$SIZE, one ray per pixel, one thread; ms of the processor per picture, medians of $ROUNDS runs"
report scenes/box.lua box 5 $POVRAY_BAR $ELSEWHERE_BAR "mirrors"
report_peer box tachyon Tachyon $TACHYON_BAR
report tests/peers/shapes.lua shapes 5 $SHAPES_BAR $ELSEWHERE_BAR \
    "cylinder, pipe, disk, triangle, a turned box, an egg"
report tests/peers/spot.lua spot 5 $SHAPES_BAR $ELSEWHERE_BAR \
    "a mesh of 5856 triangles, twice: flat and smooth"
report tests/peers/glass-box.lua glass-box 5 $SHAPES_BAR $GLASS_ELSEWHERE_BAR \
    "the box, with a glass ball, a bubble and a tinted pane"
printf '\nthe same box, glass that does not bend light: Tachyon knows no other\n'
report_ours clear-box
report_peer clear-box tachyon Tachyon $CLEAR_BAR
report tests/peers/glass.lua glass 8 $CROWDED_BAR $GLASS_ELSEWHERE_BAR \
    "mirrors and glass wherever one looks, two lamps"
report tests/peers/pictures.lua pictures 5 $PICTURES_BAR $ELSEWHERE_BAR \
    "a map on a sphere, a glass ball, a panorama"
report_light sun "$SIZE" 1 $ELSEWHERE_BAR "parallel light"
report_light fading "$SIZE" 1 $ELSEWHERE_BAR "lamps that weaken with the square of the distance"
# A ray to a lamp is met or not, so POV-Ray draws a soft shadow in as many steps as it has lamps, and we
# in as many as there are rays per pixel.
report_light soft 200x150 4096 $SOFT_ELSEWHERE_BAR "the soft shadows of a ball of light"
exit "$failed"
