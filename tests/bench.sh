#!/bin/sh
# `make bench`: speed of every engine on the box, one thread and two, as ratios within one run: the
# variants take turns, and medians are compared.
set -eu
cd "$(dirname "$0")/.."
program=${BUILD:-build}/dioptre
rounds=5
out=$(mktemp)
trap 'rm -f "$out"' EXIT

measure() { # ENGINE THREADS FRAMES
    "$program" bench scenes/box.lua --json -s 800x600 --samples 1 --depth 5 --engine "$1" -j "$2" \
        --frames "$3" | sed "s/^/$1 $2 /" >>"$out"
}
round=0
while [ $round -lt $rounds ]; do
    ! grep -q avx512dq /proc/cpuinfo || measure f32x16 1 30
    measure f32x8 1 30
    measure f32x8 2 30
    measure f32x4 1 20
    measure f32x1 1 8
    measure f64x4 1 20
    measure f64x1 1 8
    round=$((round + 1))
done
measure f128x1 1 1

grep -m1 'model name' /proc/cpuinfo || true
awk '
    { key = $1 " " $2; match($0, /"ms_median": [0-9.e+]+/); ms = substr($0, RSTART + 13, RLENGTH - 13) + 0
      match($0, /"rays": [0-9]+/); rays[key] = substr($0, RSTART + 8, RLENGTH - 8) + 0
      n[key]++; all[key, n[key]] = ms; if (!(key in seen)) { seen[key] = 1; order[++keys] = key } }
    function median(key,   i, j, t, a, c) {
        c = n[key]; for (i = 1; i <= c; i++) a[i] = all[key, i]
        for (i = 2; i <= c; i++) for (j = i; j > 1 && a[j] < a[j-1]; j--) { t = a[j]; a[j] = a[j-1]; a[j-1] = t }
        return c % 2 ? a[(c + 1) / 2] : (a[c / 2] + a[c / 2 + 1]) / 2 }
    END { base = median("f32x1 1")
        printf "%-8s %7s %10s %10s %12s\n", "engine", "threads", "ms", "Mrays/s", "x f32x1"
        for (i = 1; i <= keys; i++) { split(order[i], part, " "); m = median(order[i])
            printf "%-8s %7d %10.2f %10.1f %12.2f\n", part[1], part[2], m, rays[order[i]] / m / 1e3, base / m }
        printf "two threads of f32x8: %.2f times one\n", median("f32x8 1") / median("f32x8 2") }' "$out"
