#!/bin/sh
# Limits of the system from absurd to plenty: whatever is short, the program ends by a status of its own
# (0 to 4, or 130) and says why, and leaves a whole file or none. Where not even `dioptre --version`
# starts, the kernel or the dynamic loader fails before main (statuses 126, 127, 137, 139): those rows are
# out of the program's hands, and named.
. "$(dirname "$0")/check.sh"
chmod 755 "$work"
mkdir -m 777 "$work/out"
cp scenes/pictures/die.png scenes/models/spot.obj "$work"
cp scenes/box.lua "$work/plain.lua"
echo 'camera { position = {0, 0, 4} } light {} sphere { material = material { texture = "die.png" } }' >"$work/picture.lua"
echo 'camera { position = {0, 0, 4} } light {} mesh { file = "spot.obj" }' >"$work/model.lua"
for name in a b; do "$dioptre" render "$work/plain.lua" -o "$work/$name.png" -s 24x16; done
chmod -R a+rX "$work"

# As nobody, if possible: root has no limit of processes.
[ "$(id -u)" = 0 ] && nobody='setpriv --reuid=65534 --regid=65534 --clear-groups' || nobody=

# run OPTION COMMAND...: runs the program within a limit of prlimit; its errors and its status in $work/err.
run() {
    option=$1
    shift
    # shellcheck disable=SC2086 # several words
    { timeout 60 $nobody prlimit $option -- "$dioptre" "$@" 2>&1 >/dev/null </dev/null; echo "status $?"; } |
        cat >"$work/err"
    status=$(sed -n 's/^status //p' "$work/err")
}

# commands: one a line, with its output below $work/out, or `-`.
commands() {
    echo "- info $work/plain.lua"
    echo "- compare $work/a.png $work/b.png"
    echo "o.bmp render $work/plain.lua -s 24x16 -o $work/out/o.bmp"
    echo "o.png render $work/plain.lua -s 24x16 -o $work/out/o.png"
    echo "p.bmp render $work/picture.lua -s 24x16 -o $work/out/p.bmp"
    echo "m.bmp render $work/model.lua -s 24x16 -o $work/out/m.bmp"
    echo "f1.bmp animate $work/plain.lua -s 24x16 --frames 0-1 -o $work/out/f%d.bmp"
}
mkdir "$work/good"
commands >"$work/commands"
while read -r output command; do
    # shellcheck disable=SC2086 # several words
    "$dioptre" $command >/dev/null 2>"$work/err" </dev/null || fail "without limits: $command: $(cat "$work/err")"
done <"$work/commands"
mv "$work"/out/* "$work/good"
[ "$(ls "$work/good" | tr '\n' ' ')" = 'f0.bmp f1.bmp m.bmp o.bmp o.png p.bmp ' ] && ok 'all commands work without limits' ||
    fail "without limits: $(ls "$work/good")"

# limit OPTION: all commands within it.
limit() {
    run "$1" --version
    if [ "$status" != 0 ]; then
        case $status in
        1) ok "$1: no start: $(head -1 "$work/err")" ;;
        126 | 127 | 137 | 139) echo "skipped: $1: not even --version starts ($status: $(head -1 "$work/err"))" ;;
        *) fail "$1: --version: status $status: $(head -2 "$work/err")" ;;
        esac
        return
    fi
    while read -r output command; do
        # shellcheck disable=SC2086 # several words
        run "$1" $command
        what="$1: ${command%% *} $output"
        case $status in
        0 | 1 | 2 | 3 | 4 | 130) ;;
        *) fail "$what: status $status: $(head -3 "$work/err")" ;;
        esac
        # Nothing is wrong with the files; only compare says that one is unreadable, as 1 means that pictures differ.
        [ "$status" != 3 ] || fail "$what: blames a file: $(head -3 "$work/err")"
        if [ "$status" = 0 ]; then
            for file in "$work"/out/*; do
                [ ! -e "$file" ] || cmp -s "$file" "$work/good/${file##*/}" || fail "$what: $file is not whole"
            done
            [ "$output" = - ] || [ -e "$work/out/$output" ] || fail "$what: status 0, and no file"
        else
            [ "$(wc -l <"$work/err")" -gt 1 ] || fail "$what: status $status without a word"
            # Frames before the one that failed are whole.
            for file in "$work"/out/*; do
                [ ! -e "$file" ] || cmp -s "$file" "$work/good/${file##*/}" || fail "$what: left $file"
            done
        fi
        echo "$what: $status $(head -1 "$work/err" | cut -c 1-90)"
        rm -rf "$work"/out/*
    done <"$work/commands"
    ok "$1"
}
for kib in 4000 40000 100000 160000 400000 2000000; do limit "--as=$((kib * 1024))"; done
for count in 0 1 2 4 6 64; do limit "--nproc=$count"; done
for count in 0 2 3 4 5 6 8 16 256; do limit "--nofile=$count"; done
for kib in 4 64 128 512 8192; do limit "--stack=$((kib * 1024))"; done
for bytes in 0 1 500 2000 1000000; do limit "--fsize=$bytes"; done

# The deepest rays need no stack of the shell's.
cat >"$work/deep.lua" <<'EOF'
camera { position = {0.3, 0.1, 3}, look_at = {0, 0, 0}, fov = 90 }
light { position = {1, 2, 1} }
sphere { radius = 9, material = material { color = 0.1, reflectivity = 1 } }
for i = -4, 4 do sphere { center = {1.1 * i, 0, 0}, radius = 0.5, material = material { color = 0, transparency = 1, ior = 1 } } end
EOF
for engine in f32x16 f32x8 f32x4 f32x1 f64x4 f64x1; do
    "$dioptre" info "$work/deep.lua" --engine "$engine" >/dev/null 2>&1 || continue
    run "--stack=$((512 * 1024))" render "$work/deep.lua" --engine "$engine" --depth 256 --cutoff 0 -s 16x12 -o "$work/out/deep.bmp"
    [ "$status" = 0 ] && ok "depth 256 of $engine on a stack of 512 KiB" || fail "depth 256 of $engine: $(cat "$work/err")"
done
finish
