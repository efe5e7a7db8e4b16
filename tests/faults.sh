#!/bin/bash
# Each call to the system fails once: memory, files, threads, processes, renames (tests/faults/faults.c).
# Afterwards the old file is whole or the new one is, the status is one that the manual knows, nothing
# is left over, and no process. FAULTS=N tries the first N calls of each kind; 0: all (make faults).
. "$(dirname "$0")/check.sh"
first=${FAULTS:-2}
kinds=$(sed -n 's/^    \(X(malloc).*\)/\1/p' tests/faults/faults.c | tr -d X | tr '()' '  ')
# Seconds after which a run counts as hanging: many times what the slowest takes.
patience=30
library=$PWD/$BUILD/tests/faults.so
worker=$PWD/$BUILD/dioptre-worker
folder=$work/folder
tried=0

cat >"$work/scene.lua" <<'SCENE'
camera { position = {0, 0, 5}, look_at = {0, 0, 0} }
light { position = {1, 2, 3} }
sphere {}
SCENE
mkdir -p "$work/models"
cp scenes/pictures/die.png scenes/models/die.obj "$work/"
head -c 2000 tests/meshes/hand-negative.obj >"$work/small.obj"
sed 's|^sphere {}|sphere { material = material { texture = "die.png" } }|' "$work/scene.lua" >"$work/picture.lua"
sed 's|^sphere {}|mesh { file = "small.obj" }|' "$work/scene.lua" >"$work/model.lua"
cat >"$work/scene.nff" <<'SCENE'
v
from 0 0 5
at 0 0 0
up 0 1 0
angle 40
hither 1
resolution 16 12
l 1 2 3
f 1 1 1 1 0 0 0 1
s 0 0 0 1
SCENE
small='-s 16x12 --samples 1 -j 2'

# The commands: a name, the file that it writes or - for standard output, and its words.
commands() {
    cat <<WORDS
bmp out.bmp render $work/scene.lua $small -o out.bmp
png out.png render $work/scene.lua $small -o out.png
picture out.bmp render $work/picture.lua $small -o out.bmp
model out.bmp render $work/model.lua $small -o out.bmp
nff out.bmp render $work/scene.nff $small -o out.bmp
frames out-1.bmp animate $work/scene.lua $small --frames 0-1 -o out-%d.bmp
film out.mp4 animate $work/scene.lua $small --frames 0-1 -o out.mp4
compare - compare $work/a.bmp $work/b.png --threshold 255
info - info $work/model.lua $small
WORDS
}

# prepare FILE: a folder that holds this file only, an old one.
prepare() {
    rm -rf "$folder"
    mkdir "$folder"
    [ "$1" = - ] || echo 'the old file' >"$folder/$1"
}

# left_over: processes that still run, by a word of their environment. They have a second to end.
left_over() {
    for _ in {1..20}; do
        found=$(grep -lza "^FAULT_MARK=$work/mark$" /proc/[0-9]*/environ 2>/dev/null)
        [ -n "$found" ] || return 1
        sleep 0.05
    done
}

# judge NAME FILE: looks at what a run has left; prints what is wrong.
judge() {
    case $status in
    0 | 1 | 2 | 3 | 4 | 130) ;;
    *) echo "status $status" ;;
    esac
    if [ "$2" != - ]; then
        if cmp -s "$folder/$2" "$work/good/$1"; then
            # What it says may be lost behind a picture that is whole.
            [ "$status" = 0 ] || grep -q 'cannot write to standard output' "$work/err" ||
                echo "the new file with status $status"
        elif [ "$(cat "$folder/$2" 2>/dev/null)" = 'the old file' ]; then
            [ "$status" != 0 ] || echo 'the old file with status 0'
        else
            echo 'neither the old file nor the new one'
        fi
        # Frames that are whole stay.
        extra=$(ls "$folder" | grep -vxF -e "$2" -e out-0.bmp)
        [ -z "$extra" ] || echo "left over: $extra"
    fi
    [ "$status" = 0 ] || [ -s "$work/err" ] || echo 'no word about it'
    grep -qaE 'Segmentation|terminate called|Assertion|double free' "$work/err" && echo 'an abort'
    left_over && echo "still running: $found"
}

# fault NAME FILE PROGRAM KIND NUMBER WORD...: a run in which one call fails. False: there is no such call.
fault() {
    local name=$1 file=$2 program=$3 kind=$4 number=$5 wrong
    shift 5
    echo 0 >"$work/mark"
    prepare "$file"
    (cd "$folder" && FAULT_PROGRAM=$program FAULT_KIND=$kind FAULT_NUMBER=$number FAULT_MARK=$work/mark \
        LD_PRELOAD=$library timeout $patience "$dioptre" "$@") >"$work/out" 2>"$work/err" </dev/null
    status=$?
    [ "$(cat "$work/mark")" = 1 ] || return 1
    tried=$((tried + 1))
    wrong=$(judge "$name" "$file")
    # Nothing is wrong with the files, unless they cannot be read.
    if [ "$status" = 3 ] && [ "$kind" != read ] && [ "$program" = "$(basename "$dioptre")" ]; then
        wrong="$wrong a file is blamed"
    fi
    if [ -n "$wrong" ]; then
        fail "$name: $kind $number of $program fails: $(echo "$wrong" | tr '\n' ';') $(head -c 300 "$work/err" | head -2)"
    fi
}

# limit NAME PROGRAM KIND: how many calls of a kind fail. All memory of a film does: an encoder that is
# started without its pipe leaves a film without a frame.
limit() {
    if [ "$1 $2 $3" = "film $(basename "$dioptre") malloc" ]; then echo 0; else echo "$first"; fi
}

"$dioptre" render "$work/scene.lua" $small -o "$work/a.bmp" && "$dioptre" render "$work/scene.lua" $small -o "$work/b.png" ||
    fail 'the pictures to compare'
mkdir "$work/good"
while read -r name file words; do
    # A run without a fault makes the good file.
    prepare "$file"
    # shellcheck disable=SC2086 # words
    (cd "$folder" && "$dioptre" $words) >"$work/out" 2>"$work/err" </dev/null || fail "$name without a fault: $(head -2 "$work/err")"
    [ "$file" = - ] || cp "$folder/$file" "$work/good/$name"
    [ -z "${FAULTS_ONLY:-}" ] || [ "${FAULTS_ONLY:-}" = "$name" ] || continue
    before=$failures tried_before=$tried
    for program in "$(basename "$dioptre")" "$(basename "$worker")"; do
        for kind in $kinds; do
            number=1
            # shellcheck disable=SC2086 # words
            while fault "$name" "$file" "$program" "$kind" $number $words; do
                [ $number != "$(limit "$name" "$program" "$kind")" ] || break
                number=$((number + 1))
            done
        done
    done
    [ $failures = $before ] && ok "$name: $((tried - tried_before)) calls failed, one at a time"
done < <(commands)
[ $tried -gt 100 ] && ok "$tried faults in all" || fail "only $tried faults were tried"
finish
