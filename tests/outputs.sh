#!/bin/bash
# Nothing good is replaced by something worse, nothing half-written stays, and nothing that a stranger
# wrote reaches the terminal: closed descriptors, interruptions, killed processes, cut frames, names.
. "$(dirname "$0")/check.sh"
box=$PWD/scenes/box.lua orbits=$PWD/scenes/orbits.lua glass=$PWD/scenes/glass-sphere.lua
cp scenes/pictures/die.png "$work"
cd "$work" || exit 1

# in_background COMMAND...: starts it in a process group of its own, with the signals of a person's
# terminal; sets pid.
in_background() {
    : >err # The old words must be gone before anybody looks for new ones.
    setsid env --default-signal=INT,TERM,HUP "$@" >out 2>err </dev/null &
    pid=$!
}
# ends STATUS NAME: waits for it.
ends() {
    wait "$pid"
    got=$?
    [ "$got" = "$1" ] && ok "$2" || fail "$2: status $got, not $1: $(head -3 err)"
}
# only NAME FILE...: the folder here must hold these files and no others.
only() {
    name=$1 && shift
    [ "$(ls here)" = "$(printf '%s\n' "$@" | sort)" ] && ok "$name" || fail "$name: $(ls here | tr '\n' ' ')"
}

# --- descriptors 0, 1 and 2 closed -----------------------------------------------------------------
cat >talk.lua <<'END'
camera { position = {0, 0, 4} } light { position = {3, 4, 5} }
print(string.rep("words ", 200))
sphere { center = {t, 0, 0}, material = material { texture = "die.png" } }
END
"$dioptre" render talk.lua -s 32x24 -o open.png 2>/dev/null
"$dioptre" animate talk.lua -s 32x24 --frames 0-5 -o open.mp4 2>/dev/null
"$dioptre" info talk.lua >open.txt 2>/dev/null
# ran NAME STATUS ARGUMENT...: with the descriptors of `closed` closed; what it says is in `said`.
ran() {
    eval '"$dioptre" "${@:3}" >said 2>err </dev/null' "$closed"
    got=$?
    [ "$got" = "$2" ] && ok "$1 $closed" || fail "$1 $closed: status $got, not $2"
}
for closed in '<&-' '>&-' '2>&-' '<&- >&-' '<&- 2>&-' '>&- 2>&-' '<&- >&- 2>&-'; do
    rm -f closed.png closed.mp4
    ran render 0 render talk.lua -s 32x24 -o closed.png
    same closed.png open.png "render $closed: the same bits"
    ran animate 0 animate talk.lua -s 32x24 --frames 0-5 -o closed.mp4
    same closed.mp4 open.mp4 "animate $closed: the same bits"
    ran compare 0 compare open.png closed.png
    ran info 0 info talk.lua
    [[ $closed = *' >&-'* || $closed = '>&-'* ]] || same said open.txt "info $closed: the same words"
done

# --- interruptions -----------------------------------------------------------------------------------
mkdir here
cat >slow.lua <<'END'
camera { position = {0, 0, 6} }
light {}
sphere {}
END
# begun: whether the render in the background has drawn anything.
begun() { grep -q '"progress": 0\.0*[1-9]' err; }
# interrupted SIGNAL FILE: renders into it, and sends the signal to the whole group, as a terminal, a
# batch system and `timeout` do.
interrupted() {
    in_background "$dioptre" render slow.lua -s 640x480 --samples 16384 --sampling full --progress json -o "$2"
    within begun
    kill -"$1" -- -"$pid"
    ends 130 "SIG$1: status 130"
}
for signal in INT TERM HUP; do
    rm -f here/*
    interrupted $signal here/new.bmp
    only "SIG$signal: what there is lies under its name" new.bmp
    holds err '^dioptre: interrupted: here/new.bmp has [0-9]+ % of the picture$' 'and it says how much there is'
    [ "$(stat -c %s here/new.bmp)" = $((640 * 480 * 3 + 54)) ] && ok 'it is a picture' || fail 'it is no picture'
    cp open.png here/old.png
    rm here/new.bmp
    interrupted $signal here/old.png
    only "SIG$signal: the part lies beside the old picture" old.part.png old.png
    same here/old.png open.png 'which is whole'
    holds err 'interrupted: here/old.part.png has [0-9]+ % of the picture; here/old.png is the old one$' 'and it says where it is'
    [ "$(identify -format %wx%h here/old.part.png)" = 640x480 ] && ok 'the part is a picture' || fail 'the part is no picture'
done
ln -sf old.png here/link.png && rm here/old.part.png
interrupted TERM here/link.png
only 'a link to an old picture' link.part.png link.png old.png
same here/old.png open.png 'its target is whole'
long=$(printf '%0249d' 0)
cp open.png "here/$long.png"
interrupted TERM "here/$long.png"
same "here/$long.png" open.png 'a name of 253 bytes: the old picture is whole'
[ -s "here/${long:0:246}.part.png" ] && ok 'and the part has as much of the name as fits' || fail "$(ls here)"

# quiet_end SIGNAL STATUS NAME COMMAND...: the signal ends it in the middle; nothing stays in `here`.
quiet_end() {
    local signal=$1 status=$2 name=$3
    shift 3
    rm -rf here/* && in_background "$@"
    within "${ready[@]}"
    kill -"$signal" -- -"$pid"
    ends "$status" "$name, SIG$signal"
    [ -z "$(find here -name '*.*.*')" ] && ok "$name, SIG$signal: nothing half-written" || fail "$name: $(ls here)"
}
# is_busy: the program handles signals, and is likely to be in the middle of its work.
is_busy() {
    local caught name
    name=$(cat "/proc/$pid/comm" 2>/dev/null) || return 0 # It has ended.
    caught=$(awk '/^SigCgt/ { print $2 }' "/proc/$pid/status" 2>/dev/null) || return 0
    [ "$name" = dioptre ] && ((0x$caught >> 14 & 1)) && sleep 0.5
}
# has PATTERN: whether there is such a file here.
has() { [ -n "$(find here -name "$1" | head -1)" ]; }
for signal in HUP TERM; do
    ready=(has 'film.mp4.*')
    quiet_end $signal 130 'a film' "$dioptre" animate "$orbits" -s 320x180 --samples 64 --sampling full -o here/film.mp4
    only 'no film' ''
    ready=(has '1.bmp')
    quiet_end $signal 130 'frames' "$dioptre" animate "$orbits" -s 320x180 --samples 64 --sampling full -o here/%d.bmp
    ready=(is_busy)
    quiet_end $signal 130 'lab' "$dioptre" lab --out here
    quiet_end $signal 130 'chart' "$dioptre" chart "$box" -s 320x240 --out here
    quiet_end $signal 130 'bench' "$dioptre" bench "$box" -s 1600x1200 --samples 64 --sampling full --frames 1000
    quiet_end $signal 130 'needs' "$dioptre" needs "$glass" # Seconds: the box takes less than the wait.
    echo 'while true do end' >endless.lua
    for command in info 'probe 1 1' 'render -o here/o.bmp' 'animate -o here/%d.bmp'; do
        # shellcheck disable=SC2086 # a command and its options
        set -- $command
        quiet_end $signal 130 "$1 of an endless scene" "$dioptre" "$1" endless.lua "${@:2}"
    done
done
# A scene that nobody waits for any longer: its workers end with it.
[ -z "$(pgrep -g "$pid")" ] && ok 'no worker is left' || fail "processes are left: $(pgrep -ag "$pid")"
# Under nohup, neither the program nor its workers end with the terminal.
"$dioptre" animate "$orbits" -s 64x36 --samples 1 --frames 0-39 -o here/expected%d.png
setsid env --default-signal=INT nohup "$dioptre" animate "$orbits" -s 64x36 --samples 1 --frames 0-39 -o here/%d.png >out 2>err </dev/null &
pid=$!
within has 1.png
kill -HUP -- -"$pid"
ends 0 'nohup: the terminal goes away'
same here/39.png here/expected39.png 'and all frames are drawn'

# --- synced before they are renamed ------------------------------------------------------------------
cat >log.c <<'END'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
/* Notes each fsync and rename; fails every fsync of a file with the error FSYNC_ERROR. */
int fsync(int file) {
    struct stat info;
    fstat(file, &info);
    const char *fails = getenv("FSYNC_ERROR");
    fprintf(stderr, "fsync %s\n", S_ISDIR(info.st_mode) ? "folder" : "file");
    if (fails && S_ISREG(info.st_mode)) {
        errno = atoi(fails);
        return -1;
    }
    return 0;
}
int rename(const char *from, const char *to) {
    fprintf(stderr, "rename %s\n", to);
    return ((int (*)(const char *, const char *))dlsym(RTLD_NEXT, "rename"))(from, to);
}
END
${CC:-cc} -shared -fPIC -o log.so log.c -ldl || fail 'log.c does not compile'
logged() { env "$1" LD_PRELOAD="$work/log.so" "${@:2}"; }
# steps NAME STEP...: what the log must hold.
steps() {
    name=$1 && shift
    [ "$(grep -E '^(fsync|rename)' err)" = "$(printf '%s\n' "$@")" ] && ok "$name" || fail "$name: $(cat err)"
}
rm -rf here/*
expect 0 'fsync' 'a picture' logged A= "$dioptre" render "$box" -s 8x6 -o here/a.bmp
steps 'is on the disk before its name, and then its name' 'fsync file' 'rename here/a.bmp' 'fsync folder'
expect 0 'fsync' 'frames' logged A= "$dioptre" animate "$box" -s 8x6 --frames 0-1 -o here/%d.bmp
steps 'each of them' 'fsync file' 'rename here/0.bmp' 'fsync folder' 'fsync file' 'rename here/1.bmp' 'fsync folder'
expect 0 'rename' 'frames --no-sync' logged A= "$dioptre" animate "$box" -s 8x6 --frames 0-1 --no-sync -o here/%d.bmp
steps 'none' 'rename here/0.bmp' 'rename here/1.bmp'
expect 2 'no-sync is for numbered frames' '--no-sync of a film' "$dioptre" animate "$box" --no-sync -o here/film.mp4
cp here/a.bmp a.bmp
for reason in 5 28; do # EIO, ENOSPC
    expect 1 "cannot write 'here/a.bmp'" "a disk that fails late, error $reason" logged FSYNC_ERROR=$reason "$dioptre" render "$orbits" -s 8x6 -o here/a.bmp
    same a.bmp here/a.bmp 'the old picture is whole'
    only 'and nothing is left' 0.bmp 1.bmp a.bmp
done
expect 0 'rename' 'a file system that cannot sync' logged FSYNC_ERROR=22 "$dioptre" render "$box" -s 8x6 -o here/a.bmp

# --- what killed processes leave ---------------------------------------------------------------------
rm -rf here/*
dead=$(sh -c 'echo $$')
mine=here/a.bmp.dioptre
kept="$mine-$$-0 $mine-$dead $mine-$dead-10 $mine-$dead-00 $mine-0$dead-0 $mine-$dead-0x $mine-x$dead-0 here/b.bmp.dioptre-$dead-0 here/xa.bmp.dioptre-$dead-0 here/a.bmp-dioptre-$dead-0 $mine--$dead-0 $mine-99999999999999999999-0 here/a.bmp.$dead-0 here/a.bmp.Dioptre-$dead-0 $mine-$dead-3"
# shellcheck disable=SC2086 # a list
touch "$mine-$dead-0" "$mine-$dead-9" $kept
ln -s ../die.png "$mine-$dead-1"
mkdir "$mine-$dead-2"
flock "$mine-$dead-3" sleep 600 &
locker=$!
within sh -c "! flock -n $mine-$dead-3 true"
expect 0 '' 'a picture beside what others left' "$dioptre" render "$box" -s 8x6 -o here/a.bmp
[ ! -e "$mine-$dead-0" ] && [ ! -e "$mine-$dead-9" ] && ok 'files of a dead process go' || fail "$(ls here)"
# shellcheck disable=SC2086 # a list
ls $kept >/dev/null 2>err && [ -L "$mine-$dead-1" ] && [ -d "$mine-$dead-2" ] && [ -s die.png ] &&
    ok 'files of the living, locked ones, other names, links and folders stay' || fail "$(cat err)"
pkill -P $locker 2>/dev/null
kill $locker 2>/dev/null
wait $locker 2>/dev/null
for kind in film.mp4 %d.bmp; do
    rm -rf here/*
    in_background "$dioptre" animate "$orbits" -s 640x360 --samples 64 --sampling full -o here/$kind
    within has '*.dioptre-*-0'
    encoder=$(pgrep -P "$pid" -x ffmpeg)
    kill -KILL "$pid"
    wait "$pid" 2>/dev/null
    # An encoder that has just started creates its file.
    [ -z "$encoder" ] || within ended "$encoder"
    has '*.dioptre-*-0' && ok "$kind: SIGKILL leaves a file" || ok "$kind: SIGKILL came between two files"
    # The frame that was being written: its file alone is cleared away.
    frames=$(ls here | sed -n 's/^\([0-9]*\)\.bmp\.dioptre-.*/\1/p' | head -1)
    expect 0 '' "$kind once more" "$dioptre" animate "$orbits" -s 64x36 --samples 1 --frames "${frames:-0-3}" -o here/$kind
    has '*.dioptre-*-0' && fail "$kind: it is still there: $(ls here)" || ok "$kind: it is gone"
done

# --- frames that are there, but not whole ------------------------------------------------------------
frames() { "$dioptre" animate "$orbits" -s 64x36 --samples 1 --frames 0-5 -o "$@"; }
for ending in bmp png jpg exr tif hdr; do
    rm -rf here/* whole && mkdir whole
    frames here/%d.$ending && cp here/* whole
    size=$(stat -c %s whole/3.$ending)
    : >here/0.$ending
    head -c 100 whole/1.$ending >here/1.$ending
    head -c $((size / 2)) whole/2.$ending >here/2.$ending
    head -c -1 whole/3.$ending >here/3.$ending
    # What a disk without power may leave: the size, without the bytes.
    head -c 1 whole/4.$ending >here/4.$ending && truncate -s "$(stat -c %s whole/4.$ending)" here/4.$ending
    touch -d 2001-01-01 here/*
    expect 0 '' "frames that are cut, $ending" frames here/%d.$ending --skip-existing
    expect 0 '' "are drawn again, $ending" diff -r here whole
    [ "$(find here -newermt 2002-01-01 -type f | wc -l)" = 5 ] && ok "and the whole one is not, $ending" || fail "$(ls -l here)"
done

# --- info answers soon -------------------------------------------------------------------------------
# Half a minute where every ray is traced.
echo 'camera { position = {0, 0, 6} } sdf { distance.sphere{radius = 1e-10}:repeat_every{1e-9, 1e-9, 1e-9} }' >field.lua
expect 0 '' 'info of a field that takes long' "$dioptre" info field.lua
holds out '^sphere tracing +[0-9]+ of [0-9]+ camera rays reach the step limit; there was no time for the other [0-9]+$' 'says how many rays it traced'
expect 0 '' 'info --json of it' "$dioptre" info field.lua --json
holds out '"step_limit_count": [0-9]+, "step_limit_rays": [0-9]+,' 'says so, too'
# In quad, where a ray takes 60 ms here: 64 of them between two looks at the clock took 4 s.
cat >slow.lua <<'END'
camera { position = {0, 0, 6} }
local fields = {}
for i = 1, 160 do fields[i] = distance.sphere{radius = 1e-10}:translate{1e-12 * i, 0, 0} end
sdf { distance.union(table.unpack(fields)):repeat_every{1e-9, 1e-9, 1e-9} }
END
expect 0 '' 'info in quad within 3 s of processor time' prlimit --cpu=3 "$dioptre" info slow.lua --engine f128x1 -j 1
expect 0 '' 'info of a small picture of it' "$dioptre" info field.lua -s 31x9
holds out '^sphere tracing +279 of 279 camera rays reach the step limit$' 'traces all rays'

# --- names -------------------------------------------------------------------------------------------
# Not UTF-8, an escape of terminals, a control character of 8 bits, text from right to left, a new line.
odd=$(printf 'odd\377\033[31m\302\233\342\200\256"\\\n.lua')
cat >"$odd" <<'END'
camera { position = {0, 0, 4} } light {}
sphere { material = material { texture = "die.png" } }
sdf { function(x, y, z) return 3 * z + 9 end }
END
# clean FILE NAME: no control character but the end of a line may be in it.
clean() {
    if LC_ALL=C grep -qaP '[\x00-\x08\x0b-\x1f\x7f]|\xc2[\x80-\x9f]|\xe2\x80[\x8e\x8f\xaa-\xae]|\xe2\x81[\xa6-\xa9]|\xff' "$1"; then
        fail "$2: $(od -c "$1" | head -5)"
    else
        ok "$2"
    fi
}
for command in 'info' 'bench --frames 1' 'needs' 'probe 1 1' 'probe 1 1 --svg here/rays.svg' 'chart --out here'; do
    # shellcheck disable=SC2086 # a command and its options
    set -- $command
    "$dioptre" "$1" "$odd" "${@:2}" -s 8x6 >out 2>err
    got=$?
    cat out err >both
    [ $got = 0 ] && clean both "$command: no control character" || fail "$command: status $got: $(cat err)"
    case $1 in info | bench | needs | probe)
        "$dioptre" "$1" "$odd" "${@:2}" -s 8x6 --json >out 2>err
        python3 -c 'import json, sys; [json.loads(line) for line in open("out", encoding="utf-8")]' 2>why &&
            ok "$command --json is JSON" || fail "$command --json: $(cat why)"
        clean out "$command --json: no control character"
        ;;
    esac
done
python3 -c 'import xml.dom.minidom; xml.dom.minidom.parse("here/rays.svg")' 2>why && ok 'the drawing is XML' || fail "$(cat why)"
wrong() {
    expect "$@"
    cat out err >both
    clean both "$3: no control character"
}
wrong 3 'No such file' 'a scene that is missing' "$dioptre" info "x$odd"
wrong 2 'neither' 'a command that is none' "$dioptre" "x$(printf '\033[2J\302\233')"
wrong 2 'no option' 'an option that is none' "$dioptre" render "--$(printf '\033[2J')"
wrong 2 'no option' 'a letter that is none' "$dioptre" render "-$(printf '\033')"
wrong 2 'too many' 'one word too many' "$dioptre" render a "$odd"
wrong 2 'takes' 'a value that is none' "$dioptre" render a --samples "$odd"
wrong 2 'ending|end in' 'a picture of no format' "$dioptre" render "$box" -o "$odd"
wrong 1 'Not a directory' 'a folder that is none' "$dioptre" render "$box" -o "$odd/x.bmp"
wrong 4 'No such' 'pictures that are missing' "$dioptre" compare "$odd.bmp" b.bmp
printf 'camera {}\nprint("\\27[31m\\194\\155")\nerror("\\27[2J\\226\\128\\174")' >rude.lua
wrong 3 'rude.lua:3' 'a scene that says so' "$dioptre" info rude.lua
finish
