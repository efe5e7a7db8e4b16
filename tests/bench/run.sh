#!/bin/sh
# What size, lamps, depth and samples cost, and from how many shapes on a tree pays: CSV in $BUILD/bench,
# charts in doc. Called by `make bench`. All variants take turns, so that a busy moment of the machine meets all alike; one
# thread, 800x600, one ray per pixel and its shadow ray.
#
# Environment: BUILD (folder of the program; build), ROUNDS (turns; 7), ENGINES, MADE_WITH (compiler
# and flags, for the files).
set -eu
export LC_ALL=C # Decimal points, not commas.
cd "$(dirname "$0")/../.."
BUILD=${BUILD:-build}
ROUNDS=${ROUNDS:-7}
SPHERES='10 20 50 100 200 500 1000 2000 5000 10000 20000 50000 100000'
ROWS='16 23 36 51 72 112 159 224 354 475' # 4 n (n - 1) triangles: 960 to 900,600.
LAMPS='1 2 3 4 6 8 12 16'
DEPTHS='1 2 3 4 6 8 12 16'
SAMPLES='1 2 4 8 16 32 64'
FRAMES=4                                  # Pictures a turn, of which the fastest counts.
if [ -z "${ENGINES:-}" ]; then
    ENGINES='f32x8 f64x4'
    ! grep -q avx512dq /proc/cpuinfo || ENGINES="f32x16 $ENGINES"
fi
folder=$BUILD/bench
mkdir -p "$folder"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

machine="$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1), $(date -u +%Y-%m-%d), ${MADE_WITH:-}"

# timed NAME SCENE COUNT OPTION...: adds a line with a name, a count, ms of the fastest picture, rays.
timed() {
    name=$1 scene=$2 count=$3
    shift 3
    "$BUILD/dioptre" bench "$scene" --json -q -s 800x600 -j 1 --frames $FRAMES "$@" |
        sed -E "s/.*\"ms_min\": ([^,]*),.*\"rays\": ([^,]*),.*/$name $count \1 \2/"
}

# frame SCENE TIME COUNT: a line for each engine.
frame() {
    for engine in $ENGINES; do
        timed "$engine" "$1" "$3" -t "$2" --samples 1 --engine "$engine"
    done
}

# frame_lights: what lamps, mirrors and samples cost.
frame_lights() {
    for count in $LAMPS; do
        frame tests/bench/lamps.lua "$count" "$count" >>"$work/lights"
    done
    for engine in $ENGINES; do
        for depth in $DEPTHS; do
            timed "$engine" tests/bench/facing.lua "$depth" --samples 1 --depth "$depth" --engine "$engine" >>"$work/depth"
        done
    done
    for samples in $SAMPLES; do
        for sampling in full adaptive; do
            timed $sampling scenes/box.lua "$samples" --samples "$samples" --sampling $sampling --engine f32x8 >>"$work/samples"
        done
    done
}

# table: median, lowest and highest of the turns, and Mrays/s of the median.
table() {
    echo "# $machine"
    echo engine,count,ms,ms_lowest,ms_highest,rays,mrays_per_s,turns
    sort -k1,1 -k2,2n -k3,3g | awk '
        function flush() {
            if (n) { middle = (ms[int((n + 1) / 2)] + ms[int(n / 2) + 1]) / 2
                printf "%s,%d,%.4g,%.4g,%.4g,%d,%.4g,%d\n", engine, count, middle, ms[1], ms[n], rays, rays / middle / 1e3, n }
            n = 0 }
        $1 != engine || $2 != count { flush() }
        { engine = $1; count = $2; ms[++n] = $3; rays = $4 }
        END { flush() }'
}

for rows in $ROWS; do
    [ -s "$folder/ball-$rows.obj" ] || awk -v rows="$rows" -f tests/bench/ball.awk >"$folder/ball-$rows.obj"
done
cp tests/bench/ball-of-triangles.lua "$folder"
for round in $(seq "$ROUNDS"); do
    echo "turn $round of $ROUNDS" >&2
    for count in $SPHERES; do
        frame tests/bench/ball-of-spheres.lua "$count" "$count" >>"$work/spheres"
    done
    for rows in $ROWS; do
        frame "$folder/ball-of-triangles.lua" "$rows" $((4 * rows * (rows - 1))) >>"$work/triangles"
    done
    frame_lights
done
for name in spheres triangles lights depth samples; do
    table <"$work/$name" >"$folder/cost-$name.csv"
done
{
    echo "# $machine"
    echo engine,scene,count,ms_list,ms_tree,ratio,ratio_lowest,ratio_highest
    for name in spheres boxes mirrors; do
        "$BUILD/tests/bench/tree" f32x8 tests/bench/scattered-$name.lua $name
    done
} >"$folder/tree-pays.csv"

for name in spheres triangles; do
    gnuplot -c tests/bench/cost.gp "$folder/cost-$name.csv" doc/cost-$name.svg $name "$ENGINES" "$machine"
done
gnuplot -c tests/bench/few.gp "$folder/cost-lights.csv" doc/cost-lights.svg "lamps" "$ENGINES" "$machine"
gnuplot -c tests/bench/few.gp "$folder/cost-depth.csv" doc/cost-depth.svg "mirrorings of a ray" "$ENGINES" "$machine"
gnuplot -c tests/bench/few.gp "$folder/cost-samples.csv" doc/cost-samples.svg "samples per pixel" "full adaptive" "$machine"
gnuplot -c tests/bench/tree.gp "$folder/tree-pays.csv" doc/tree-pays.svg "$machine"

# Marching: steps, normals, and what is gained by skipping and left out by footprints.
for what in steps normals; do
    { echo "# $machine"; "$BUILD/tests/bench/march-steps" $what; } >"$folder/march-$what.csv"
done
{
    echo "# $machine"
    echo scene,what,value,ms,off_percent,worst_step
    "$BUILD/tests/bench/marching" f32x8 scenes/cube-frame.lua scenes/endless-frames.lua scenes/melting.lua \
        scenes/menger-sponge.lua tests/bench/frames-asked.lua
} >"$folder/marching.csv"
gnuplot -c tests/bench/marching.gp "$folder" "$machine"
# Its table is written into doc/marching.md by doc/figures.sh.
cp "$folder/marching.csv" doc/figures/march-settings.csv
