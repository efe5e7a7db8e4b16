#!/bin/sh
# What size costs, and from how many shapes on a tree pays: CSV in $BUILD/bench, charts in doc. Called
# by `make bench`. All variants take turns, so that a busy moment of the machine meets all alike; one
# thread, 800x600, one ray a pixel and its shadow ray.
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

# frame SCENE TIME COUNT: adds a line with engine, count, ms of the fastest picture, rays for each engine.
frame() {
    for engine in $ENGINES; do
        "$BUILD/dioptre" bench "$1" -t "$2" --json -q -s 800x600 --samples 1 -j 1 --engine "$engine" --frames $FRAMES |
            sed -E "s/.*\"ms_min\": ([^,]*),.*\"rays\": ([^,]*),.*/$engine $3 \1 \2/"
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
done
for name in spheres triangles; do
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
gnuplot -c tests/bench/tree.gp "$folder/tree-pays.csv" doc/tree-pays.svg "$machine"
