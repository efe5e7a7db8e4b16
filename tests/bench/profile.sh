#!/bin/sh
# Where the time goes: doc/performance.md, by phase of the work, for five scenes. Called by `make bench`.
# Instructions are counted by valgrind, which does not know AVX-512, so in the engine of AVX2; times are
# sampled by perf, where it is at hand. What else the machine does changes only the total time.
#
# Environment: BUILD (folder of the program; build), ROUNDS (turns; 5), MADE_WITH (compiler and flags, for
# the page), OUT (the page; doc/performance.md).
set -eu
export LC_ALL=C # Decimal points, not commas.
cd "$(dirname "$0")/../.."
. tests/peers/common.sh
OUT=${OUT:-doc/performance.md}
ENGINE=f32x8
LANES=8
SIZE=400x300
ROUNDS=${ROUNDS:-5}
program=$BUILD/dioptre

# bench SCENE ENGINE FRAMES: one thread, one ray per pixel.
bench() {
    "$program" bench "$1" --json -q -s $SIZE --samples 1 -j 1 --engine "$2" --frames "$3"
}

# measure SCENE ENGINE FRAMES FILE: appends the milliseconds of the processor that a picture takes; $work/log
# has the rays.
measure() {
    user_time "$work/short" bench "$1" "$2" 1
    user_time "$work/long" bench "$1" "$2" $(($3 + 1))
    append_difference "$work/long" "$work/short" "$3" "$4"
}

# sample_time SCENE FRAMES: the share of time of each function, if perf works here.
sample_time() {
    : >"$work/perf"
    if command -v perf >/dev/null &&
        perf record -q -e cpu-clock -F 5000 -o "$work/perf.data" "$program" bench "$1" --json -q -s $SIZE --samples 1 -j 1 \
            --engine $ENGINE --frames "$2" >/dev/null 2>&1; then
        perf report -i "$work/perf.data" --stdio --no-children -F overhead,symbol 2>/dev/null |
            grep -E '^ *[0-9.]+%' >"$work/perf" || true
    fi
}

# profile SCENE FRAMES WORDS: the table of a scene.
profile() {
    valgrind --tool=callgrind --dump-instr=yes --compress-pos=no --compress-strings=no \
        --callgrind-out-file="$work/counts" "$program" render "$1" -q -s $SIZE --samples 1 -j 1 --engine $ENGINE \
        -o "$work/picture.bmp" >/dev/null 2>&1
    rm -f "$work/ms"
    for round in $(seq $ROUNDS); do measure "$1" $ENGINE "$2" "$work/ms"; done
    rays=$(number rays "$work/log")
    ns=$(awk "BEGIN { print $(median "$work/ms") * 1e6 / $rays }")
    sample_time "$1" "$2"
    printf '\n### %s: %s\n\n' "$1" "$3"
    if [ -s "$work/perf" ]; then
        printf '| phase | instructions | of them arithmetic | ns |\n|---|--:|--:|--:|\n'
    else
        printf '| phase | instructions | of them arithmetic |\n|---|--:|--:|\n'
    fi
    awk -v rays="$rays" -v ns="$ns" -v lanes=$LANES -f tests/bench/phases.awk "$work/code" "$work/counts" "$work/perf"
}

# engine_times: each engine on the box, in turn.
engine_times() {
    printf '\n## Engines on the box\n\n| engine | ms | Mrays/s |\n|---|--:|--:|\n'
    engines="$ENGINES f32x4 f32x1 f64x4 f64x1"
    for round in $(seq $ROUNDS); do
        for engine in $engines; do
            case $engine in
            *[2468]x1) frames=20 ;; # One ray at a time; the system counts hundredths of a second.
            *) frames=100 ;;
            esac
            measure scenes/box.lua "$engine" $frames "$work/$engine"
            number rays "$work/log" >"$work/$engine.rays"
        done
    done
    for engine in $engines; do
        awk -v e="$engine" -v ms="$(median "$work/$engine")" -v rays="$(cat "$work/$engine.rays")" \
            'BEGIN { printf "| `%s` | %.2f | %.1f |\n", e, ms, rays / ms / 1e3 }'
    done
}

# thread_times: how much faster many threads are, simulated.
thread_times() {
    echo
    echo '## Many threads'
    echo
    echo 'This machine has few, so they are simulated (`tests/bench/schedule.c`): each task of a picture is timed, and given to the first'
    echo 'thread that is free, in the order of the program. What one thread does alone is in it; what real threads lose by shared'
    echo 'caches and memory is not. Each scene in its own size and samples, in the engine that this processor prefers: how many times'
    echo 'as fast as one thread, medians.'
    echo
    printf '| scene | 2 | 4 | 8 | 16 |\n|---|--:|--:|--:|--:|\n'
    "$BUILD/bench-schedule" scenes/box.lua scenes/figure-09.lua scenes/report-d-glass.lua scenes/glass-sphere.lua \
        scenes/cow.lua scenes/melting.lua scenes/facing-mirrors.lua >"$work/schedule"
    awk -F, '{ printf "| %s | %s | %s | %s | %s |\n", $1, $2, $3, $4, $5 }' "$work/schedule"
}

objdump -d --no-show-raw-insn "$program" | grep -E '^ +[0-9a-f]+:' >"$work/code"
{
    echo '# Where the time goes'
    echo
    echo "\`make bench\` writes this page (\`tests/bench/profile.sh\`). Numbers are per vector of $LANES rays of any kind, camera, shadow"
    echo "and secondary ones alike; $SIZE, one ray per pixel, one thread, engine \`$ENGINE\`. *Arithmetic* are the instructions that add,"
    echo 'multiply, divide, compare, or take a minimum or a root: the least that these formulas need; all others load, store, select'
    echo 'and decide. Nanoseconds are shares of samples, times the time of a picture; encoding belongs to pictures that are shown or'
    echo 'written, and is not timed. Small functions are counted where they are inlined. Times are of the processor, medians of'
    echo "$ROUNDS in turn."
    echo
    echo "Machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1), $(date -u +%Y-%m-%d). ${MADE_WITH:-}"
    profile scenes/box.lua 200 'mirrors, one lamp'
    profile scenes/figure-09.lua 200 'two spheres, two lamps'
    profile scenes/report-d-glass.lua 5 'glass'
    profile scenes/cow.lua 40 'a mesh'
    profile scenes/melting.lua 10 'marching'
    engine_times
    thread_times
} >"$work/page"
cp "$work/page" "$OUT"
