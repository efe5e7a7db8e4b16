#!/bin/bash
# Films and numbered frames: the same bits whoever draws them, nothing half-written, whatever goes
# wrong on the way. Needs ffmpeg.
. "$(dirname "$0")/check.sh"
orbits=$PWD/scenes/orbits.lua
small='-s 64x36 --samples 1'
cd "$work" || exit 1
film() { "$dioptre" animate "$orbits" $small "$@"; }
mkdir one two

# --- frames --------------------------------------------------------------------------------------
expect 0 '' 'numbered frames' film --seconds 0.2 -o one/%05d.bmp
[ "$(ls one)" = "$(printf '%05d.bmp\n' 0 1 2 3 4)" ] && ok '0.2 s at 25 a second are frames 0 to 4' || fail "frames: $(ls one)"
"$dioptre" render "$orbits" $small -t 0.12 -o render.bmp
same one/00003.bmp render.bmp 'a frame is what render draws at its time'
differing one/00000.bmp one/00003.bmp 'things move'
expect 0 '' 'frames by one thread, backwards' film --frames 4-0:-2 -j 1 -o two/%05d.bmp
expect 0 '' 'and the others, by two' film --frames 1-3:2 -j 2 -o two/%05d.bmp
expect 0 '' 'two sets of frames' diff -r one two
expect 0 '' 'a frame may begin late' film --frames 0 -t 0.12 -o late%d.bmp
same late0.bmp render.bmp 'at --time'
expect 0 '' 't of 1e300' film --frames 0-1 -t 1e300 -o 'far%3d.bmp'
[ -s 'far  1.bmp' ] && ok 'blanks fill a number up' || fail "there is no 'far  1.bmp'"
"$dioptre" animate - $small --frames 3 -o 'in%d.bmp' <"$orbits"
same in3.bmp render.bmp 'a scene from standard input'
for ending in png exr; do
    expect 0 '' "frames as $ending" film --frames 3 -o "f%d.$ending"
    "$dioptre" render "$orbits" $small -t 0.12 -o "render.$ending"
    same "f3.$ending" "render.$ending" "a frame is what render draws, $ending"
done

# --- going on where it was -----------------------------------------------------------------------
rm one/00001.bmp
# A picture that somebody else has drawn.
cp two/00004.bmp one/00002.bmp
expect 0 '"done": 1, "frames": 1, "progress": 1.0000' '--skip-existing, told as JSON' \
    film --seconds 0.2 --skip-existing --progress json -o one/%05d.bmp
same one/00001.bmp two/00001.bmp 'what lacks is drawn'
same one/00002.bmp two/00004.bmp 'what is there stays'
"$dioptre" animate "$orbits" -s 320x180 --samples 64 -j 1 --sampling full -o two/i%04d.bmp 2>err &
pid=$!
within [ -e two/i0001.bmp ]
kill -TERM $pid
wait $pid
[ $? = 130 ] && ok 'interrupted: status 130' || fail "interrupted: $(cat err)"
grep -qE '^dioptre: interrupted: [0-9]+ of 250 frames were done and are kept$' err && ok 'it says how far' || fail "$(cat err)"
[ -z "$(find two -name 'i*.bmp.*')" ] && ok 'nothing is left of the frame under way' || fail "$(ls two)"
[ "$(find two -name 'i*.bmp' -size -172854c)" = '' ] && ok 'the frames that are there are whole' || fail 'a frame is cut'

# --- wrong usage ---------------------------------------------------------------------------------
for pattern in f%d-%d.bmp f%.bmp f%s.bmp f%i.bmp f%5.bmp f%%.bmp f%d%%.bmp f%012d.bmp f%-5d.bmp f%n.bmp f%*d.bmp '%'; do
    expect 2 'must hold one %d' "pattern $pattern" film -o "$pattern"
done
expect 2 'animate needs -o' 'no output' film
expect 2 'animate needs -o' 'a picture is no film' film -o film.bmp
expect 2 'must end in' 'frames in a format that is none' film -o f%d.txt
for range in '' x 1- -1 5-1 1-5:0 1-5:-1 5-1:2 1-5:x 1-999999999 1.5 0-1: '1 -2'; do
    expect 2 '^dioptre: --frames ' "frames '$range'" film -o f%d.bmp --frames "$range"
done
expect 2 'end at 24' 'frames beyond the end' film -o f%d.bmp --seconds 1 --frames 20-25
for rate in 0 -1 nan inf x 1001; do
    expect 2 '^dioptre: --fps takes' "fps $rate" film -o f%d.bmp --fps "$rate"
done
expect 2 'not 1 to' 'no second' film -o f%d.bmp --seconds 0
expect 2 'not 1 to' 'too many seconds' film -o f%d.bmp --seconds 1e300
expect 2 'even numbers, not 63x36; try --size 64x36' 'an odd size' "$dioptre" animate "$orbits" -s 63x36 --frames 0 -o odd.mp4
expect 2 'numbered frames' '--skip-existing of a film' film -o film.mp4 --skip-existing
expect 1 'none/f1.bmp.*No such' 'no such folder' film --frames 1 -o none/f%d.bmp
echo 'camera {} if t > 0.1 then sphere { radius = -t } end' >late.lua
expect 3 '^late.lua:1: .*radius' 'a scene that goes wrong late' "$dioptre" animate late.lua -s 8x8 --seconds 1 -o late.mp4
echo 'camera {} image { width = 16, height = 16 + 2 * math.floor(20 * t) }' >grow.lua
expect 3 'a frame of 16x18 in a film of 16x16' 'a scene of other sizes' "$dioptre" animate grow.lua --seconds 1 -o grow.mp4

# --- films ---------------------------------------------------------------------------------------
export LC_ALL=C
for ending in mp4 webm; do
    expect 0 '' "a film, $ending" film --seconds 1 -j 1 -o "a.$ending"
    [ "$(ffprobe -v error -count_frames -select_streams v -show_entries stream=width,height,avg_frame_rate,nb_read_frames,pix_fmt -of csv=p=0 "a.$ending")" = 64,36,yuv420p,25/1,25 ] &&
        ok "25 frames per second, one second, $ending" || fail "$(ffprobe "a.$ending" 2>&1)"
    expect 0 '' "again, by two threads, $ending" film --seconds 1 -j 2 -o "b.$ending"
    same "a.$ending" "b.$ending" "the same film, byte for byte, $ending"
done
mkdir farm
film --frames 0-24:2 -j 1 -o farm/%05d.png &
film --frames 24-0:-1 -j 1 --skip-existing -o farm/%05d.png
wait
expect 0 '' 'a film of two processes'\'' frames' "$dioptre" animate farm/%05d.png --seconds 1 -o c.mp4
same a.mp4 c.mp4 'is the film of one, byte for byte'
rm farm/00007.png
expect 3 '00007.png.*No such' 'a frame that lacks' "$dioptre" animate farm/%05d.png --seconds 1 -o d.mp4
cp "$orbits" ./-q.lua
expect 0 '' 'strange names' "$dioptre" animate ./-q.lua $small --frames 0-1 -o './-y $(touch x) ;.mp4'
[ -s './-y $(touch x) ;.mp4' ] && [ ! -e x ] && ok 'no shell reads them' || fail "$(ls)"
echo 'camera {} sphere { center = {0, 0, -4} }' >still.lua
expect 0 '' 'a scene without t' "$dioptre" animate still.lua $small --frames 0-2 -o still%d.bmp
same still0.bmp still2.bmp 'is drawn, too'

# --- ffmpeg goes wrong ---------------------------------------------------------------------------
echo 'the old film' >old.mp4
# refused STATUS WORDS NAME COMMAND...: fails so, and leaves the old film and nothing else.
refused() {
    expect "$@"
    holds old.mp4 '^the old film$' "$3: the old film is whole"
    [ "$(echo old.mp4*)" = old.mp4 ] && ok "$3: nothing is left" || fail "$3: $(echo old.mp4*)"
}
mkdir bin
refused 1 'ffmpeg is missing: sudo apt-get install ffmpeg' 'no ffmpeg' env PATH="$work/bin" "$dioptre" animate "$orbits" -o old.mp4
# end_of PID: waits for a program that wrote its errors to a file of its own.
end_of() {
    wait "$1"
    local status=$?
    cat said >&2
    return $status
}
# fake LINES: an ffmpeg of our own.
fake() { { echo '#!/bin/sh' && cat; } >bin/ffmpeg && chmod +x bin/ffmpeg; }
faked() { PATH=$work/bin:$PATH film --seconds 2 -o old.mp4; }
echo 'head -c 9999 >/dev/null; echo "too tired" >&2; exit 7' | fake
refused 1 "old.mp4': ffmpeg gave up .status 7.: too tired" 'ffmpeg dies half-way' faked
echo 'head -c 9999 >/dev/null; kill -SEGV $$' | fake
refused 1 'ffmpeg died .Segmentation' 'ffmpeg crashes' faked
echo 'head -c 9999 >/dev/null' | fake
refused 1 'ffmpeg ended before the film did' 'ffmpeg ends early' faked
echo 'cat >/dev/null' | fake
refused 1 'ffmpeg wrote nothing' 'ffmpeg writes nothing' faked
echo 'cat >/dev/null; echo bad >&2; exit 1' | fake
refused 1 'ffmpeg gave up .status 1.: bad' 'ffmpeg fails at the end' faked
echo >bin/ffmpeg
refused 1 'ffmpeg' 'ffmpeg is no program' faked
echo 'exec sleep 60' | fake
(PATH=$work/bin:$PATH exec env --default-signal=INT "$dioptre" animate "$orbits" -s 640x360 --samples 1 -o old.mp4) 2>said &
pid=$!
within pgrep -P $pid -x sleep >/dev/null
kill -INT $pid
refused 130 'interrupted: 0 of 250 frames were done; there is no film' 'ffmpeg hangs, and Ctrl-C' end_of $pid
ln -s /dev/full device.mp4
refused 1 'needs a plain file' 'a film is no device' film --frames 0 -o device.mp4
ulimit -S -f 8
refused 1 "cannot write 'old.mp4': ffmpeg" 'a full disk' env -u LC_ALL "$dioptre" animate "$orbits" -s 320x180 --samples 1 --seconds 4 -o old.mp4
ulimit -S -f unlimited

# --- a full disk ---------------------------------------------------------------------------------
# What is written there is larger from frame to frame, until it is too large.
echo 'camera {} image { width = 16 + math.floor(1000 * t), height = 64 }' >larger.lua
ulimit -S -f 36
expect 1 "large5.bmp': .*File too large" 'a frame too large' "$dioptre" animate larger.lua --frames 0-9 -o large%d.bmp
ulimit -S -f unlimited
[ "$(find . -name 'large[0-9]*' | sort | tr '\n' ' ')" = './large0.bmp ./large1.bmp ./large2.bmp ./large3.bmp ./large4.bmp ' ] &&
    ok 'finished frames are kept, and nothing else' || fail "a frame too large: $(echo large*)"
# A disk of our own, where the system lets us have one. Three frames fit on it.
mkdir disk
on_small_disk() { unshare -rm sh -c 'mount -t tmpfs -o size=$0 none disk && "$@"; status=$?; ls disk >listed; exit $status' "$@"; }
if on_small_disk 600k true 2>/dev/null; then
    expect 1 "disk/3.bmp': No space left" 'a disk that is full half-way' on_small_disk 600k "$dioptre" animate "$orbits" -s 320x180 --samples 1 --frames 0-9 -o disk/%d.bmp
    [ "$(echo $(cat listed))" = '0.bmp 1.bmp 2.bmp' ] && ok 'finished frames are on it, and nothing else' || fail "a full disk: $(cat listed)"
    expect 1 "cannot write 'disk/a.mp4': ffmpeg" 'a disk too small for a film' on_small_disk 64k "$dioptre" animate "$orbits" -s 640x360 --samples 1 --seconds 8 -o disk/a.mp4
    [ ! -s listed ] && ok 'nothing of it is left' || fail "a disk too small for a film: $(cat listed)"
else
    echo 'skipped: a full disk: no file system can be mounted here'
fi

# --- killed --------------------------------------------------------------------------------------
mkdir killed whole
busy() { "$dioptre" animate "$orbits" -s 320x180 --samples 16 -j 1 --sampling full "$@"; }
(exec "$dioptre" animate "$orbits" -s 320x180 --samples 16 -j 1 --sampling full -o killed/%d.bmp) &
pid=$!
within [ -e killed/1.bmp ]
kill -KILL $pid
{ wait $pid; } 2>/dev/null
last=$(find killed -name '*.bmp' | sed 's/.*\/\([0-9]*\).bmp/\1/' | sort -n | tail -1)
expect 0 '' 'all frames of a killed film again' busy --frames "0-$((last + 2))" -o whole/%d.bmp
expect 0 '' 'those that lack' busy --frames "0-$((last + 2))" --skip-existing -o killed/%d.bmp
expect 0 '' 'SIGKILL costs the frame under way, and no other' diff -r killed whole
(exec "$dioptre" animate "$orbits" -s 320x180 --samples 1 -o old.mp4) &
pid=$!
# As soon as there is an encoder: a quiet machine finishes this film within a second.
started() { encoder=$(pgrep -P "$1" -x ffmpeg); }
within started $pid
kill -KILL $pid
{ wait $pid; } 2>/dev/null
holds old.mp4 '^the old film$' 'SIGKILL: the old film is whole'
[ -n "$encoder" ] && within ended "$encoder" && ok 'SIGKILL: the encoder ends, too' || fail "SIGKILL: the encoder $encoder"

# --- an interrupted film -------------------------------------------------------------------------
(exec env --default-signal=INT "$dioptre" animate "$orbits" -s 320x180 -o old.mp4) 2>said &
pid=$!
within started $pid
kill -INT $pid
refused 130 'interrupted: [0-9]+ of 250 frames were done; there is no film' 'an interrupted film' end_of $pid
finish
