#!/bin/sh
# `make bench`: speed of every engine on the box, one thread and two, as ratios within one run: the
# variants take turns, and medians are compared. How far each engine's picture is from that in quad.
# doc/figures/engines.csv keeps it.
set -eu
export LC_ALL=C # Decimal points, not commas.
cd "$(dirname "$0")/.."
. tests/peers/figures.sh
program=${BUILD:-build}/dioptre
rounds=5
work=$(mktemp -d)
out=$work/out
trap 'rm -rf "$work"' EXIT

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

# differences ENGINE: pixels with a channel that is off by one step of 8 bits, and by more, from the picture
# in quad. A pixel is three bytes of a BMP, behind a header that is the same in both.
differences() {
    "$program" render scenes/box.lua -q -s 800x600 --samples 1 --depth 5 --engine "$1" -o "$work/$1.bmp"
    # cmp ends with 1 where there are any, and with 2 where a picture is missing.
    cmp -l "$work/f128x1.bmp" "$work/$1.bmp" >"$work/bytes" || [ $? -eq 1 ]
    awk '
        function decimal(octal) { return int(octal / 100) * 64 + int(octal % 100 / 10) * 8 + octal % 10 }
        { pixel = int(($1 - 55) / 3); off = decimal($2) - decimal($3); off = off < 0 ? -off : off
          worst[pixel] = off > worst[pixel] ? off : worst[pixel] }
        END { for (pixel in worst) worst[pixel] > 1 ? more++ : one++
              print one + 0 "," more + 0 }' "$work/bytes"
}
begin_figures engines 'engine,threads,ms,mrays_per_s,times_f32x1,rays,off_by_one,off_by_more'
for engine in f128x1 $(cut -d' ' -f1 "$out" | sort -u | grep -v f128x1); do
    echo "$engine $(differences "$engine")" >>"$work/differences"
done

grep -m1 'model name' /proc/cpuinfo || true
awk '
    NR == FNR { off[$1] = $2; next }
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
            printf "%-8s %7d %10.2f %10.1f %12.2f\n", part[1], part[2], m, rays[order[i]] / m / 1e3, base / m
            printf "%s,%d,%.3g,%.3g,%.3g,%d,%s\n", part[1], part[2], m, rays[order[i]] / m / 1e3, base / m, rays[order[i]], off[part[1]] >kept }
        printf "two threads of f32x8: %.2f times one\n", median("f32x8 1") / median("f32x8 2") }' kept="$work/kept" "$work/differences" "$out"
while read -r row; do keep_figures engines "$row"; done <"$work/kept"
