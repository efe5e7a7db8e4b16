#!/bin/sh
# Random input for all that reads strangers' bytes: the targets of tests/fuzz, with libFuzzer and the
# sanitizers. First every input that is kept in tests/corpus/TARGET, then new ones, a minute in all
# (FUZZ_SECONDS). A finding is kept, and its path is printed: it belongs into tests/corpus/TARGET.
. "$(dirname "$0")/check.sh"
seconds=${FUZZ_SECONDS:-60}
fuzzers=build/fuzz/fuzzers
findings=build/fuzz/findings
# Longest new input, bytes: the rules of all formats fit in.
longest=4096
# A small quarantine of freed memory, for speed. Slowest input, seconds; most memory, MiB.
export ASAN_OPTIONS="${ASAN_OPTIONS:-detect_leaks=1}:quarantine_size_mb=4"
limits='-timeout=20 -rss_limit_mb=2048'
# The library's reader has a limit of its own, 8 s of processor time, which a busy machine makes longer.
patience() { [ "$1" != library ] || echo '-timeout=200'; }
mkdir -p "$findings"
# The target of the library's formats starts workers as the program does.
ln -sfr "$BUILD/dioptre-worker" $fuzzers/

# seeds TARGET: files of the project from which its new inputs begin, beside the corpus.
seeds() {
    case $1 in
    scene) ls scenes/*.lua tests/scenes/*.lua ;;
    lesson) ls scenes/lessons/*.lua ;;
    bmp) ls tests/pictures/*.bmp ;;
    obj) ls tests/meshes/*.obj ;;
    library) ls tests/meshes/*.ply ;;
    esac
}

# run TARGET NAME ARGUMENT...: runs a target; prints the end of its words if it fails.
run() {
    target=$1 name=$2
    shift 2
    # shellcheck disable=SC2086 # options
    if "$fuzzers/$target" $limits $(patience "$target") -artifact_prefix="$findings/$target-" "$@" >/dev/null 2>"$work/log"; then
        ok "$name$(sed -n 's/^stat::number_of_executed_units: */: /p' "$work/log")"
    else
        fail "$name"
        grep -v '^#[0-9]*[[:space:]]' "$work/log" | tail -n 60
        sed -n "s|.*Test unit written to \(.*\)|the input is \1; keep it: cp \1 tests/corpus/$target/|p" "$work/log"
    fi
}

targets=$(ls tests/fuzz/*.c | sed 's|.*/||; s|\.c$||')
start=$(date +%s)
for target in $targets; do
    if [ -n "$(ls tests/corpus/"$target" 2>/dev/null)" ]; then
        run "$target" "$target: the corpus" tests/corpus/"$target"/*
    else
        fail "$target has no corpus"
    fi
done
count=$(echo "$targets" | wc -w)
for target in $targets; do
    left=$(((seconds - $(date +%s) + start) / count))
    count=$((count - 1))
    mkdir -p "$work/new/$target" "$work/seeds/$target"
    for seed in $(seeds "$target"); do
        [ "$(wc -c <"$seed")" -le $longest ] && cp "$seed" "$work/seeds/$target/"
    done
    # libFuzzer takes 0 for no limit at all.
    [ $left -gt 0 ] || left=1
    run "$target" "$target: $left s of new input" -max_total_time=$left -max_len=$longest \
        -print_final_stats=1 -close_fd_mask=1 "$work/new/$target" tests/corpus/"$target" "$work/seeds/$target"
    rm -rf "$work/new/$target"
done
finish
