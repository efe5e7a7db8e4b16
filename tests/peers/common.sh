# What the comparisons with peers share; sourced by run.sh and embree.sh. Gives BUILD, ENGINES and
# BEST, an empty folder $work, and $failed, the exit status.
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

# The bars are for the widest engine that the processor runs.
ENGINES=f32x8
BEST=f32x8
if grep -q avx512dq /proc/cpuinfo; then
    ENGINES='f32x8 f32x16'
    BEST=f32x16
fi
