# What the comparisons with peers share; sourced by the scripts beside. Gives BUILD, ENGINES and BEST,
# an empty folder $work, and $failed, the exit status.
export LC_ALL=C # Decimal points, not commas.
BUILD=${BUILD:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

# need PROGRAM WHAT-TO-DO: says what to do when a program is missing.
need() {
    if ! command -v "$1" >/dev/null; then
        echo "peers: $1 is missing: $2" >&2
        exit 1
    fi
}

# bar WHAT TEXT CONDITION: prints whether a bar is reached; CONDITION is for awk.
bar() {
    if awk "BEGIN { exit !($3) }"; then
        echo "PASS  $1: $2"
    else
        echo "FAIL  $1: $2"
        failed=1
    fi
}

# number NAME FILE: the number that a JSON object in FILE gives under NAME.
number() {
    sed -n 's/.*"'"$1"'": *\([-+.0-9eE]*\).*/\1/p' "$2"
}

# median FILE: of the numbers in FILE, one a line.
median() {
    sort -g "$1" | awk '{ a[NR] = $1 } END { print (a[int((NR + 1) / 2)] + a[int(NR / 2) + 1]) / 2 }'
}

# user_time FILE COMMAND...: runs it, its words go to $work/log; FILE gets the milliseconds that the
# processor worked for it.
user_time() {
    output=$1
    shift
    if ! (
        "$@" >"$work/log" 2>&1 || exit 1
        times >"$work/times"
    ); then
        cat "$work/log" >&2
        exit 1
    fi
    # The second line is of what the shell has called: minutes, m, seconds.
    awk 'NR == 2 { split($1, part, /[ms]/); print 1000 * (60 * part[1] + part[2]) }' \
        "$work/times" >"$output"
}

# append_difference LONG SHORT DIVISOR FILE: appends (LONG - SHORT) / DIVISOR of two times.
append_difference() {
    paste "$1" "$2" | awk -v n="$3" '{ print ($1 - $2) / n }' >>"$4"
}

# make_edges: the tool that tells where pictures differ.
make_edges() {
    ${CC:-cc} -std=gnu11 -O2 -Iinclude -Isrc -D_GNU_SOURCE -o "$work/edges" tests/peers/edges.c \
        src/assets/images/bmp.c src/base/picture.c src/base/error.c
}

# The bars are for the widest engine that the processor runs.
ENGINES=f32x8
BEST=f32x8
if grep -q avx512dq /proc/cpuinfo; then
    ENGINES='f32x8 f32x16'
    BEST=f32x16
fi
