#!/bin/sh
# Compares dioptre with fragment shaders on scenes that are marched: the same fields in GLSL
# (tests/peers/shaders), drawn by Mesa's software rasteriser. Says, too, how many frames per second we
# draw of every scene that is marched. Called by `make peers`; see tests/peers/fragment.c.
#
# Both have two threads. The bars are for times of the processor, all threads together, so that what
# else the machine does hardly matters; frames per second are by the clock, the best of all rounds.
#
# Environment: BUILD (folder of the program; build), ROUNDS (runs of each; 5), MAPS (a folder: where
# the pictures are left).
# Exit status: 0 when every bar is reached; 1 when one is not, or when something is missing.
set -eu
cd "$(dirname "$0")/../.."
. tests/peers/common.sh
. tests/peers/figures.sh
ROUNDS=${ROUNDS:-5}
MAPS=${MAPS:-}
FRAMES=8 # Of ours a run, and of Mesa's: the system counts hundredths of a second.
TWINS='endless-frames menger-sponge turned-frame'
SCENES="$TWINS cube-frame mandelbulb melting twins"

# Times as fast as Mesa on the repeated frames.
MESA_BAR=3
# Share of pixels within one step: a shader's normals are differences, which smear edges.
ALIKE_BAR=0.98

# draw_ours SCENE ENGINE FRAMES: measures us.
draw_ours() {
    "$BUILD/dioptre" bench --json "scenes/$1.lua" -s 800x600 --samples 1 -j 2 --engine "$2" \
        --frames "$3"
}

# draw_mesa SCENE FRAMES: measures Mesa, and leaves its picture in the work folder.
draw_mesa() {
    shaders=tests/peers/shaders
    LIBGL_ALWAYS_SOFTWARE=1 GALLIUM_DRIVER=llvmpipe LP_NUM_THREADS=2 xvfb-run -a \
        "$BUILD/peer-fragment" 800 600 "$2" "$work/$1-mesa.bmp" \
        $shaders/frame.frag "$shaders/$1.frag" $shaders/march.frag
}

# time_twin SCENE: one round of a scene that has a twin.
time_twin() {
    for engine in $ENGINES; do
        user_time "$work/long" draw_ours "$1" "$engine" $((FRAMES + 1))
        number ms_min "$work/log" >>"$work/$1.$engine.clock"
        user_time "$work/short" draw_ours "$1" "$engine" 1
        append_difference "$work/long" "$work/short" $FRAMES "$work/$1.$engine"
    done
    user_time "$work/long" draw_mesa "$1" $((FRAMES + 1))
    cut -d' ' -f1 "$work/log" >>"$work/$1.mesa.clock"
    cut -d' ' -f2- "$work/log" >"$work/mesa"
    user_time "$work/short" draw_mesa "$1" 1
    append_difference "$work/long" "$work/short" $FRAMES "$work/$1.mesa"
}

# rate SCENE WHO: frames per second by the clock.
rate() {
    sort -g "$work/$1.$2.clock" | awk 'NR == 1 { printf "%.1f", 1000 / $1 }'
}

# report_row SCENE WHO TEXT: a row of the table.
report_row() {
    printf '%-16s %-14s %10.2f %10s\n' "$1" "$3" "$(median "$work/$1.$2")" "$(rate "$1" "$2")"
}

# times_mesa SCENE: how many times Mesa's processor time is ours.
times_mesa() {
    awk "BEGIN { printf \"%.2f\", $(median "$work/$1.mesa") / $(median "$work/$1.$BEST") }"
}

# report_pictures SCENE: whether the two show the same.
report_pictures() {
    "$BUILD/dioptre" render "scenes/$1.lua" -s 800x600 --samples 1 --quiet -o "$work/ours.bmp"
    if [ -n "$MAPS" ]; then
        cp "$work/ours.bmp" "$MAPS/$1.bmp"
        cp "$work/$1-mesa.bmp" "$MAPS/$1-mesa.bmp"
    fi
    "$work/edges" "$work/ours.bmp" "$work/$1-mesa.bmp" >"$work/edges.txt"
    read -r pixels off elsewhere <"$work/edges.txt"
    keep_figures marching "$1,$(median "$work/$1.f32x8"),$([ "$BEST" = f32x8 ] || median "$work/$1.$BEST"),$(median "$work/$1.mesa"),$pixels,$off"
    bar "$1: pixels alike" "$off of $pixels are off by more than one step, $elsewhere of them on no edge; at most $(
        awk "BEGIN { print 100 * (1 - $ALIKE_BAR) }") % may be" "1 - $off / $pixels >= $ALIKE_BAR"
}

# report_scene SCENE: frames per second of a scene without a twin.
report_scene() {
    for engine in $ENGINES; do
        draw_ours "$1" "$engine" $FRAMES >"$work/log"
        number ms_min "$work/log" >"$work/$1.$engine.clock"
        printf '%-16s %-14s %10s %10s\n' "$1" "dioptre $engine" "" "$(rate "$1" "$engine")"
    done
}

need "$BUILD/peer-fragment" "make peers"
need xvfb-run "apt-get install xvfb"
make_edges
round=1
while [ "$round" -le "$ROUNDS" ]; do
    for scene in $TWINS; do time_twin "$scene"; done
    round=$((round + 1))
done
printf '\nmarching, 800x600, one ray per pixel, two threads; Mesa: %s\n' "$(cat "$work/mesa")"
printf '%-16s %-14s %10s %10s\n' scene "" "cpu ms" "frames/s"
for scene in $SCENES; do
    case " $TWINS " in
    *" $scene "*)
        for engine in $ENGINES; do report_row "$scene" "$engine" "dioptre $engine"; done
        report_row "$scene" mesa Mesa
        ;;
    *) report_scene "$scene" ;;
    esac
done
begin_figures marching scene,f32x8_ms,f32x16_ms,mesa_ms,pixels,off
for scene in $TWINS; do report_pictures "$scene"; done
for scene in menger-sponge turned-frame; do
    echo "      $scene: $BEST is $(times_mesa $scene) times as fast as Mesa"
done
bar "$BEST faster than Mesa on endless-frames" "$(times_mesa endless-frames) times, at least $MESA_BAR" \
    "$(times_mesa endless-frames) >= $MESA_BAR"
exit "$failed"
