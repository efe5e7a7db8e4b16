#!/bin/sh
# Writes doc/reports.md: doc/reports.in, with figures from the tables of the laboratory in place of @...@:
# @TABLE;METHOD;TYPE;STRESS;COLUMN@. STRESS * is the last row of the method; `all` is the worst of all its rows.
# `make charts` calls it, with --pictures: then what the page shows is drawn anew.
#   doc/reports.sh [--pictures] [FILE]
set -eu
cd "$(dirname "$0")/.."
BUILD=${BUILD:-build}

# draw NAME SCENE OPTION...: a small picture, and how much of it is off from the same without options.
draw() {
    name=$1 scene=$2
    shift 2
    "$BUILD/dioptre" render "scenes/$scene.lua" -o "$BUILD/as-it-is.png" -s 320x240 --samples 1 -q
    "$BUILD/dioptre" render "scenes/$scene.lua" -o "doc/reports/$name.png" -s 320x240 --samples 1 -q "$@"
    off=$("$BUILD/dioptre" compare "$BUILD/as-it-is.png" "doc/reports/$name.png" --json --threshold 255 |
        sed 's/.*"share_off": \([^,}]*\).*/\1/')
    echo "$name,$scene,1,$off"
}

if [ "${1:-}" = --pictures ]; then
    shift
    mkdir -p doc/reports
    {
        echo 'method,type,stress,wrong'
        draw mirror-none figure-c2 --offset none
        draw shadow-none figure-c4 --offset none
        draw glass-shallow report-d-glass --depth 1
        draw as-a figure-16 --methods a
        draw as-c box --methods c
        draw as-d report-d-glass --methods d
    } >doc/reports/pictures.csv
fi
out=${1:-doc/reports.md}

awk '
# two(x): two digits that count. power(x): the same with a power of ten, as people write it.
function two(x) { return x >= 9.95 ? sprintf("%.0f", x) : sprintf("%.2g", x) }
function power(x,  text) {
    if (x >= 1e-3 && x < 1e4) return two(x)
    text = sprintf("%.1e", x)
    sub(/e-0/, "e-", text); sub(/e\+0/, "e", text)
    return text
}
# figure(column, x): a figure as the page has it.
function figure(column, x) {
    if (column ~ /^error/) return x == 0 ? "0" : power(x)
    if (column ~ /^(false_|leaks|double_hits|wrong|nan|failures)/) return two(100 * x) " %"
    return two(x)
}
# rotation(): how far the matrix that report B prints is from a rotation: M times itself turned, less 1.
function rotation(  i, j, k, a, b, c, m, sum, worst) {
    for (a = 0; a < 6.3; a += 0.2) for (b = 0; b < 6.3; b += 0.2) for (c = 0; c < 6.3; c += 0.2) {
        m[0] = cos(b) * cos(c); m[1] = sin(a) * sin(b) * cos(c); m[2] = cos(a) * sin(b) * cos(c) + sin(a) * sin(c)
        m[3] = cos(b) * sin(c); m[4] = sin(a) * sin(b) * sin(c) + cos(a) * cos(c)
        m[5] = cos(a) * sin(b) * sin(c) - sin(a) * cos(c)
        m[6] = -sin(b); m[7] = sin(a) * cos(b); m[8] = cos(a) * cos(b)
        for (i = 0; i < 3; i++) for (j = 0; j < 3; j++) {
            sum = i == j ? -1 : 0
            for (k = 0; k < 3; k++) sum += m[3 * i + k] * m[3 * j + k]
            if (sum < 0) sum = -sum
            if (sum > worst) worst = sum
        }
    }
    return two(worst)
}
# energy(): what report D says that glass mirrors and lets through together, at most.
function energy(  height, c, ct, r, t, worst) {
    for (height = 90; height > 0; height--) {
        c = sin(height * 3.14159265358979 / 180); ct = sqrt(1 - (1 - c * c) / 2.25)
        r = (1.5 * c - ct) / (1.5 * c + ct); t = 4 * 1.5 * c * ct / (1.5 * c + ct)
        if (r * r + t > worst) worst = r * r + t
    }
    return sprintf("%.2f", worst)
}
# stretch(): how far a row of a map is from its place, of the map, where latitude is the cosine.
function stretch(  angle, off, worst) {
    for (angle = 0; angle <= 3.1416; angle += 0.001) {
        off = angle / 3.14159265358979 - (1 - cos(angle)) / 2
        if (off > worst) worst = off
    }
    return two(100 * worst) " %"
}
# value(words): what stands in place of @words@.
function value(words,  parts, key) {
    if (words == "rotation") return rotation()
    if (words == "energy") return energy()
    if (words == "stretch") return stretch()
    split(words, parts, ";")
    if (!((words) in table)) {
        print "doc/reports.in: no table has " words > "/dev/stderr"
        failed = 1
        return "?"
    }
    return figure(parts[5], table[words])
}
FILENAME ~ /\.csv$/ {
    if (FNR == 1) { split("", heads); name = FILENAME; sub(/.*\//, "", name); sub(/\.csv$/, "", name) }
    if ($0 ~ /^#/) next
    count = split($0, cells, ",")
    if (!(1 in heads)) { for (i = 1; i <= count; i++) heads[i] = cells[i]; next }
    for (i = 4; i <= count; i++) if (cells[i] != "") {
        table[name ";" cells[1] ";" cells[2] ";" cells[3] ";" heads[i]] = cells[i]
        table[name ";" cells[1] ";" cells[2] ";*;" heads[i]] = cells[i]
        worst = name ";" cells[1] ";" cells[2] ";all;" heads[i]
        if (!(worst in table) || cells[i] + 0 > table[worst] + 0) table[worst] = cells[i]
    }
    next
}
{
    while (match($0, /@[^@ ][^@]*@/)) {
        $0 = substr($0, 1, RSTART - 1) value(substr($0, RSTART + 1, RLENGTH - 2)) substr($0, RSTART + RLENGTH)
    }
    print
}
END { exit failed }
' doc/lab/*.csv doc/reports/pictures.csv doc/reports.in >"$out.new"
mv "$out.new" "$out"
