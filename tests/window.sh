#!/bin/bash
# The real window on a real (if invisible) screen: every key, every promise of the window.
# Starts an X server of its own and types on its keyboard. Ends with `N passed, N failed`.
cd "$(dirname "$0")/.." || exit 1
. tests/check.sh
. tests/screen.sh
passed=0
ok() {
    echo "ok $1"
    passed=$((passed + 1))
}
box=$root/scenes/box.lua
[[ $BUILD = /* ]] && dioptre=$BUILD/dioptre
probe=$root/$BUILD/tests/picture_probe
[[ $BUILD = /* ]] && probe=$BUILD/tests/picture_probe

# --- measuring -----------------------------------------------------------------------------------
# numbers PART: position of the camera or of the first or second light in `view`.
numbers() {
    case $1 in
    camera) sed 's/^camera { position = {\([^}]*\)}.*/\1/' <<<"$view" ;;
    light) sed 's/^[^}]*}[^}]*}[^}]*}[^}]*}  light { position = {\([^}]*\)}.*/\1/' <<<"$view" ;;
    second) sed 's/.*light { position = {\([^}]*\)}.*/\1/' <<<"$view" ;;
    esac | tr -d ','
}
# beyond SIGN A B LIMIT: whether B - A, with the sign, is at least LIMIT.
beyond() { awk "BEGIN { exit !($1($3 - $2) >= $4) }"; }

# moves NAME PART AXIS SIGN COLOR COLUMN PICTURE_SIGN COMMAND...: from the scene's own view, COMMAND
# must move PART along AXIS (1 2 3) only, the way SIGN, and in the picture the pixels of COLOR the
# way PICTURE_SIGN (COLUMN of the probe: 1 right, 2 down, 3 larger).
moves() {
    local name=$1 part=$2 axis=$3 sign=$4 color=$5 column=$6 picture_sign=$7
    shift 7
    xdotool key Home
    shoot
    local was now old new
    was=($(numbers "$part"))
    old=($("$probe" "$shot" "$color"))
    "$@"
    shoot
    now=($(numbers "$part"))
    new=($("$probe" "$shot" "$color"))
    local other
    for other in 1 2 3; do
        if [ "$other" = "$axis" ]; then
            beyond "$sign" "${was[other - 1]}" "${now[other - 1]}" 0.02
        else
            [ "${was[other - 1]}" = "${now[other - 1]}" ]
        fi || { fail "$name: from ${was[*]} to ${now[*]}" && return; }
    done
    beyond "$picture_sign" "${old[column - 1]}" "${new[column - 1]}" 0.4 && ok "$name" ||
        fail "$name: in the picture from ${old[*]} to ${new[*]}"
}
# lights KEYBOARD UP DOWN LEFT RIGHT AWAY NEARER: the six light keys. Taps, as short as they get.
lights() {
    moves "$1: $2 light up" light 2 + white 2 - xdotool key "$2" "$2" "$2"
    moves "$1: $3 light down" light 2 - white 2 + hold 0.2 "$3"
    moves "$1: $4 light left" light 1 - white 1 - hold 0.2 "$4"
    moves "$1: $5 light right" light 1 + white 1 + hold 0.2 "$5"
    moves "$1: $6 light away" light 3 - white 2 - hold 0.2 "$6"
    moves "$1: $7 light nearer" light 3 + white 2 + hold 0.2 "$7"
}
# differ A B NAME: two of them must not be the same.
differ() { differing "$work/$1.ppm" "$work/$2.ppm" "$3"; }
# ticks: processor time of the program so far, in hundredths of a second.
ticks() { awk '{ print $14 + $15 }' "/proc/$pid/stat"; }
# still SECONDS NAME: the program must use no processor time.
still() {
    local before
    before=$(ticks)
    sleep "$1"
    local used=$(($(ticks) - before))
    [ "$used" -lt 2 ] && ok "$2" || fail "$2: $used hundredths of a second in $1 s"
}

# --- without a display ---------------------------------------------------------------------------
expect 1 'no display to open a window on .*render' 'no display' \
    env -u DISPLAY -u WAYLAND_DISPLAY "$dioptre" view "$box"
expect 1 'no display' 'a display that is not there' env DISPLAY=:987 "$dioptre" view "$box"
start_server

# --- the picture ---------------------------------------------------------------------------------
open "$box"
expect_shown '^box — 800×600, pass 1 px, 16 samples, [0-9.]+ ms, [0-9]+ Mrays/s, finished$' \
    'the title says pass, milliseconds, Mrays/s'
"$dioptre" render "$box" -o "$work/render.bmp"
echo 'not yours' >"$work/shots/box-0002.bmp"
shoot
first=$shot
[ "${shot##*/}" = box-0001.bmp ] && ok 'the first snapshot is 0001' || fail "it is $shot"
same "$shot" "$work/render.bmp" 'a snapshot equals render, byte for byte'
shoot
[ "${shot##*/}" = box-0003.bmp ] && ok 'the next snapshot is the next free one' || fail "it is $shot"
grep -q 'not yours' "$work/shots/box-0002.bmp" && ok 'never over another file' ||
    fail 'never over another file'
still 2 'no processor time once the picture is finished'

hold 0.2 Right
hold 0.2 d
xdotool mousemove --window "$window" 400 300 mousedown 1 mousemove_relative 37 -21 mouseup 1
shoot
{
    echo "$view"
    grep -vE '^(camera|light)' "$box"
} >"$work/pasted.lua"
expect 0 '' 'the printed view is scene text' "$dioptre" render "$work/pasted.lua" -o "$work/pasted.bmp"
expect 0 '' 'a snapshot equals render of the printed view' \
    "$dioptre" compare "$shot" "$work/pasted.bmp" --threshold 0
differing "$shot" "$first" 'moving shows in the snapshot'
xdotool key Home
shoot
same "$shot" "$first" 'Home goes back to the very first picture'

# --- window --------------------------------------------------------------------------------------
xdotool windowsize --sync "$window" 500 360
expect_shown '480×360.*finished' 'another size is drawn anew, with the same ratio'
"$dioptre" render "$box" -s 480x360 -o "$work/render.bmp"
shoot
same "$shot" "$work/render.bmp" 'a snapshot of another size equals render'
quiet
screen plain
xdotool key F1
changed plain help-us 'F1 shows the help'
setxkbmap fr
changed help-us help-fr 'the help shows the keys of the keyboard in use'
setxkbmap us && sleep 0.3
xdotool key h
restored plain 'h takes the help away'
xdotool key F1 && differs plain usual
xdotool key minus minus minus minus minus
changed usual small '- makes the letters smaller'
xdotool key plus plus plus plus plus
restored usual '+ makes them larger'
xdotool key F1
before=$(wc -l <"$work/log")
xdotool key c
expect_shown 'can be pasted' 'c copies camera and light'
within has_lines "$work/log" "$before"
[ "$(tail -1 "$work/log")" = "${view%%  -- *}" ] && ok 'and prints what a snapshot prints' ||
    fail "c prints $(tail -1 "$work/log"), not ${view%%  -- *}"
xdotool windowsize --sync "$window" 1 1
expect_shown ' 1×1,.*finished' 'a window of one pixel'
rm -rf "$work/shots"
xdotool key F12
expect_shown 'finished — .*No such' 'a snapshot that fails is told in the title'
grep -q '^dioptre: ' "$work/errors" && ok 'and on standard error' || fail "$(cat "$work/errors")"
leave

# --- the rays of one pixel -----------------------------------------------------------------------
open "$box" --samples 1
shoot
before=$view
quiet
screen plain
xdotool key v
changed plain rays 'v shows the rays of a pixel'
xdotool key k
changed rays next 'k shows the numbers of the next ray'
xdotool key j
restored rays 'j those of the ray before'
xdotool key ctrl+shift+Down
changed rays walked 'Ctrl and arrows walk to another pixel'
hold 0.3 Right
changed walked turned 'arrows go around the rays'
xdotool mousemove --window "$window" 200 450 mousedown 1 mousemove_relative 60 20 mouseup 1
changed turned dragged 'so does the mouse'
shoot
[ "${view%%  -- *}" = "${before%%  -- *}" ] && ok 'and the camera stays' || fail "the camera moved: $view"
hold 0.2 d
changed dragged lit 'the rays follow the light'
xdotool windowsize --sync "$window" 500 360 && sleep 0.7
xdotool windowsize --sync "$window" 1 1 && sleep 0.3
xdotool windowsize --sync "$window" 800 600 && sleep 0.5
xdotool key Escape Home
restored plain 'Esc takes them away'
xdotool mousemove --window "$window" 300 430 click 1
changed plain clicked 'a click selects what is there: its inspector opens'
xdotool key v
changed clicked looked 'v shows the rays of that pixel'
xdotool key Escape
restored clicked 'Esc takes them away'
xdotool key Escape
restored plain 'and then the inspector'
leave 'Esc leaves when no rays are shown'

# --- every key -----------------------------------------------------------------------------------
open "$box" --samples 1
lights 'us places' w s a d e z
moves 'Right: camera right' camera 1 + yellow 1 - hold 0.1 Right
moves 'Left: camera left' camera 1 - yellow 1 + hold 0.1 Left
moves 'Up: camera up' camera 2 + yellow 2 + hold 0.1 Up
moves 'Down: camera down' camera 2 - yellow 2 - hold 0.1 Down
moves 'Page Up: camera forward' camera 3 - yellow 3 + hold 0.1 Prior
moves 'Page Down: camera back' camera 3 + yellow 3 - hold 0.1 Next
drag() { xdotool mousemove --window "$window" 400 300 mousedown 1 mousemove_relative -- "$@" mouseup 1; }
moves 'drag right: looks right' camera 0 + yellow 1 - drag 40 0
moves 'drag left: looks left' camera 0 + yellow 1 + drag -40 0
moves 'drag down: looks down' camera 0 + yellow 2 - drag 0 40
moves 'drag up: looks up' camera 0 + yellow 2 + drag 0 -40
moves 'wheel up: narrower' camera 0 + yellow 3 + xdotool click 4
moves 'wheel down: wider' camera 0 + yellow 3 - xdotool click 5
for _ in 1 2 3 4 5; do # A busy machine holds it longer: the best of a few tries counts.
    xdotool key Home
    hold 0.5 Right
    shoot
    held=$(numbers camera | cut -d' ' -f1)
    awk "BEGIN { exit !($held > 0.45 && $held < 0.75) }" && break
done
awk "BEGIN { exit !($held > 0.45 && $held < 0.75) }" && ok 'a key held moves by the time it is held' ||
    fail "half a second moved the camera by $held, not 0.55"
# A tap lasts longer on a busy machine: the shortest of a few counts.
tap() { # KEY: how far the camera moves
    local shortest=9 moved
    for _ in 1 2 3 4; do
        xdotool key Home key "$1"
        shoot
        moved=$(numbers camera | cut -d' ' -f1)
        shortest=$(awk "BEGIN { print $moved < $shortest ? $moved : $shortest }")
    done
    echo "$shortest"
}
fast=$(tap shift+Right)
fine=$(tap ctrl+Right)
awk "BEGIN { exit !($fast > 10 * $fine && $fine > 0) }" && ok 'Shift is fast, Ctrl is fine' ||
    fail "Shift moved by $fast, Ctrl by $fine"
# On a busy machine two keys do not go down at one moment: the best of a few tries counts.
for _ in 1 2 3 4 5; do
    xdotool key Home
    hold 0.3 Left Right
    shoot
    x=$(numbers camera | cut -d' ' -f1)
    awk "BEGIN { exit !($x * $x < 0.01) }" && break
done
awk "BEGIN { exit !($x * $x < 0.01) }" && ok 'opposite keys cancel' || fail "opposite keys: $(numbers camera)"
setxkbmap fr && sleep 0.3
lights 'azerty letters' z s q d e w
setxkbmap ch fr && sleep 0.3
moves 'swiss: y, at the place of w, light nearer' light 3 + white 2 + hold 0.2 y
setxkbmap us && sleep 0.3
leave 'Esc leaves, after all this'
open "$box" --samples 1 --keys letters
lights 'us letters' z s q d e w
leave

{
    cat "$box"
    echo 'light { position = {-1, 1, 1}, intensity = 0.2 }'
} >"$work/two.lua"
open "$work/two.lua" --samples 1
expect_shown 'light 1 of 2' 'the title says which light'
xdotool key Tab
expect_shown 'light 2 of 2' 'Tab takes the next light'
hold 0.1 d
shoot
awk "BEGIN { split(\"$(numbers second)\", p, \" \"); exit !(p[1] > -0.9) }" &&
    ok 'and the keys move it' || fail "the second light is at $(numbers second)"
[ "$(numbers light)" = "0 1.75 0.6" ] && ok 'and not the other' || fail "$(numbers light)"
leave

# --- layers, settings, two pictures --------------------------------------------------------------
open "$box" --samples 1
screen light
names=(normals distance shapes 'places on pictures' 'rays spent' 'marching steps' 'time spent' error rounding 'operations spent' 'acne and leaks')
keys=(2 3 4 5 6 7 8 9 y Y 0)
for i in "${!keys[@]}"; do
    key=${keys[i]} name=${names[i]}
    xdotool key "$key"
    # Quad takes its time.
    [ "$key" = 9 ] && state='' || state='1 px, .*finished'
    expect_shown "^box — 800×600, $name, pass $state" "$key shows $name"
    sleep 0.1
    screen "layer-$key"
    differ light "layer-$key" 'which is no light'
done
hold 0.1 Right
expect_shown 'acne and leaks, pass 1 px, .*finished' 'a layer follows the camera'
screen moved
differ layer-0 moved 'and shows it'
xdotool key Home 1
expect_shown '^box — 800×600, pass 1 px, .*finished' '1 shows the light again'
shoot
"$dioptre" render "$box" --samples 1 -o "$work/render.bmp"
same "$shot" "$work/render.bmp" 'as render draws it'
setxkbmap fr && sleep 0.3
xdotool key ampersand quotedbl
expect_shown '800×600, distance, ' 'azerty: digits without Shift'
# Swiss French: y lies where the light is moved, and the keys of epsilon are a letter and a dead key.
setxkbmap ch fr && sleep 0.3
xdotool key ISO_Level3_Shift+y
expect_shown '800×600, rounding, ' 'qwertz: AltGr y is y'
xdotool key dead_diaeresis
expect_shown 'finished — epsilon: 0.0002' 'qwertz: a dead key doubles epsilon'
xdotool key egrave
expect_shown 'finished — epsilon: 0.0001' 'qwertz: è halves it'
setxkbmap be && sleep 0.3
xdotool key 35 # The key of $.
expect_shown 'finished — epsilon: 0.0002' 'Belgian: $ doubles epsilon'
xdotool key dead_circumflex
expect_shown 'finished — epsilon: 0.0001' 'Belgian: a dead key halves it'
setxkbmap us && sleep 0.3
xdotool key BackSpace 1

# as_set KEY STATUS OPTION...: the key says what it has changed, and nothing else, and gives the picture that
# render draws with the options.
as_set() {
    local key=$1 status=$2
    shift 2
    xdotool key "$key"
    expect_shown "pass 1 px, .*finished — $status\$" "$key says: $status"
    "$dioptre" render "$box" "$@" -o "$work/render.bmp"
    shoot
    same "$shot" "$work/render.bmp" "$key is $*"
}
as_set o 'offset: none' --samples 1 --offset none
as_set o 'offset: fixed' --samples 1 --offset fixed
as_set bracketright 'epsilon: 0.0002, offset: fixed; the scene.s own offset, bound, is off' --samples 1 --offset fixed --epsilon 2e-4
as_set shift+bracketright 'epsilon: 0.002, offset: fixed; .*' --samples 1 --offset fixed --epsilon 2e-3
as_set shift+bracketleft 'epsilon: 0.0002, offset: fixed; .*' --samples 1 --offset fixed --epsilon 2e-4
as_set g 'number type: double \(f64x[0-9]*\)' --samples 1 --offset fixed --epsilon 2e-4 --engine f64x1
as_set shift+g 'number type: float \(f32x[0-9]*\)' --samples 1 --offset fixed --epsilon 2e-4
as_set b 'depth: 9' --samples 1 --offset fixed --epsilon 2e-4 --depth 9
as_set n 'samples: 2' --samples 2 --offset fixed --epsilon 2e-4 --depth 9
as_set BackSpace 'settings as at first' --samples 1
sed -e 's/^ambient.*/ambient(0)/' -e 's/^sky.*/sky { color = 0 }/' "$box" >"$work/dark.lua"
xdotool key m
expect_shown 'light: light alone' 'm takes ambient light and sky away'
"$dioptre" render "$work/dark.lua" --samples 1 -o "$work/render.bmp"
shoot
same "$shot" "$work/render.bmp" 'as render does without it'
xdotool key m
expect_shown 'light: none' 'and then all light'
xdotool key BackSpace


# The reports' methods and pixel corners: what render draws with the same options.
# as_said KEY STATUS OPTION...: a key that says in the title what it sets.
as_said() {
    local key=$1 status=$2
    shift 2
    xdotool key "$key"
    expect_shown "finished — $status" "$key says: $status"
    "$dioptre" render "$box" --samples 1 "$@" -o "$work/render.bmp"
    shoot
    same "$shot" "$work/render.bmp" "$key is $*"
}
as_said u 'as report A \(mirrors fade' --methods a
as_said u 'as report B \(' --methods b
as_said u 'as report C \(ambient' --methods c
as_set o 'offset: bound' --samples 1 --methods c --offset bound
as_said u 'as report D \(light is added' --methods d
as_said F8 'rays go through the corners' --methods d --pixel corner
as_said shift+u 'as report C' --methods c --pixel corner
as_said F8 'rays go through the centres' --methods c
xdotool key i && sleep 0.3
screen methods
xdotool key i BackSpace && shown 'finished — settings as at first'
shoot
"$dioptre" render "$box" --samples 1 -o "$work/render.bmp"
same "$shot" "$work/render.bmp" 'Backspace: our own methods'

xdotool key i && sleep 0.2
screen plain
xdotool key x o
expect_shown 'offset: none' 'x, and keys change the right side'
shown 'finished' && sleep 0.3
screen beside
differ plain beside 'a picture without offset beside one with it'
"$dioptre" render "$box" --samples 1 --offset none -o "$work/right.bmp"
"$dioptre" render "$box" --samples 1 -o "$work/left.bmp"
convert "$work/left.bmp" \( "$work/right.bmp" -crop 400x600+400+0 +repage \) -geometry +400+0 -composite -type truecolor \
    "$work/both.bmp"
shoot
expect 0 '' 'a snapshot has both' "$dioptre" compare "$shot" "$work/both.bmp" --threshold 0
xdotool key F6 F6
changed beside barred 'F6 moves the bar'
xdotool mousemove --window "$window" 368 300 mousedown 1 mousemove --window "$window" 600 300 mouseup 1
changed barred dragged 'and so does the mouse'
shoot
[[ $view = *'position = {0, 0, 6.5}'* ]] && ok 'which leaves the camera' || fail "$view"
xdotool key t 3 && shown 'finished'
changed dragged sides 't: the left side has a layer'
xdotool key 1 x && shown finished
changed sides difference 'x again: the difference'
xdotool key 3 t 3 && shown "distance.*finished" && sleep 1
screen distances
[ "$(convert "$work/distances.ppm" -crop 4x4+390+250 +repage -unique-colors -format %w info:)" = 1 ] &&
    ok 'layers differ in values: distances are equal with and without offset' || fail 'distances differ'
xdotool key 1 t 1 && shown finished
xdotool key x && sleep 0.3
shoot
same "$shot" "$work/left.bmp" 'and again: the left one alone'
quiet
screen plain
xdotool key F4
changed plain magnified 'F4 magnifies pixels'
xdotool key ctrl+Right ctrl+Right ctrl+Down
changed magnified stepped 'Ctrl and arrows move the magnifier'
shoot
same "$shot" "$work/left.bmp" 'and not the camera'
xdotool key Escape
restored plain 'Esc takes the magnifier away'
xdotool key F9
sleep 5
changed plain charted 'F9 shows the chart of this setting'
xdotool key n && shown '2 samples.*finished' && sleep 5
changed charted twice 'another setting adds its point'
xdotool key Escape N && shown '1 sample,.*finished' && sleep 0.5
leave

# --- walking -------------------------------------------------------------------------------------
# A camera at the height 2 that looks down: who flies forward sinks, who walks does not.
cat >"$work/walk.lua" <<'END'
camera { position = {0, 2, 8}, look_at = {0, 0, 0} }
image { width = 320, height = 240 }
light { position = {3, 4, 5} }
plane {}
END
open "$work/walk.lua"
shown finished
hold 0.2 Prior
shoot
flown=($(numbers camera))
beyond - 2 "${flown[1]}" 0.05 && beyond - 8 "${flown[2]}" 0.2 && ok 'flying forward, it sinks' || fail "${flown[*]}"
xdotool key Home r End
expect_shown 'walking: forward stays at one height' 'End: walking'
hold 0.2 Prior
hold 0.2 Right
shoot
walked=($(numbers camera))
[ "${walked[1]}" = 2 ] && beyond - 8 "${walked[2]}" 0.2 && beyond + 0 "${walked[0]}" 0.2 &&
    ok 'walking forward and to the right, it stays at its height' || fail "${walked[*]}"
hold 0.2 Up
shoot
lifted=($(numbers camera))
[ "${lifted[0]} ${lifted[2]}" = "${walked[0]} ${walked[2]}" ] && beyond + 2 "${lifted[1]}" 0.05 &&
    ok 'up is straight up' || fail "${lifted[*]}"
recorded=${view%%  -- *}
xdotool key End
expect_shown 'flying: forward is where the camera looks' 'End again: flying'
xdotool key End r
expect_shown 'the lesson is in walk-lesson-0001.lua' 'a lesson of it'
leave
lesson=$work/shots/walk-lesson-0001.lua
[ "$(grep -c '^press "walk"$' "$lesson")" = 3 ] && ok 'has the key' || fail "$(cat "$lesson")"
mkdir "$work/played"
expect 0 '' 'plays' timeout 60 "$dioptre" view --lesson "$lesson" --lesson-snapshots "$work/played"
played=$(tail -1 "$work/out")
[ "${played%%  -- *}" = "$recorded" ] && ok 'and walks the same way, to the bit' || fail "$played is not $recorded"

# --- what was left out of files ------------------------------------------------------------------
printf 'foo\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$work/odd.obj"
echo 'camera { position = {0, 0, 3} } light {} mesh { file = "odd.obj" }' >"$work/odd.lua"
open "$work/odd.lua"
words='odd.lua:1: odd.obj:1: 1 statement is not understood and left out'
expect_shown "finished — .*$words" 'the title says what was left out of a model'
holds "$work/errors" "$words" 'and standard error'
screen noted
xdotool key Right
differs noted moved
[[ $(title) =~ $words ]] && fail 'the note stays' || ok 'until the view changes'
sed -i 's/{} mesh/{}  mesh/' "$work/odd.lua"
expect_shown "finished — .*$words" 'a changed scene says it again'
leave

# --- time ----------------------------------------------------------------------------------------
cat >"$work/time.lua" <<'END'
camera { position = {0, 0, 8} }
image { width = 320, height = 240 }
light { position = {3, 4, 5} }
sphere { center = {3 * math.sin(t), 0, 0} }
END
# seconds: the time that the title says.
seconds() { title | sed -nE 's/.* t ([0-9.e+-]+) s.*/\1/p'; }
# as_rendered NAME: the snapshot must be what render draws at the title's time.
as_rendered() {
    "$dioptre" render "$work/time.lua" -t "$(seconds)" -o "$work/render.bmp"
    same "$shot" "$work/render.bmp" "$1"
}
open "$work/time.lua"
expect_shown 'finished — t 0 s$' 'the title says the time, which is held at first'
still 1 'no processor time while it is held'
xdotool key period
expect_shown 'finished — t 0.04 s$' 'the period steps it'
shoot
as_rendered 'a snapshot of another time equals render'
[[ $view = *'-- t = 0.040000000000000001 '* ]] && ok 'and says its time' || fail "it says $view"
xdotool key comma key comma
expect_shown 'finished — t -0.04 s$' 'the comma steps it back'
setxkbmap fr && sleep 0.3
xdotool key colon
expect_shown 't 0 s$' 'azerty: the same places'
setxkbmap us && sleep 0.3
began=${EPOCHREALTIME/[.,]/}
xdotool key space
expect_shown 't [2-9]\.[0-9]* s, running$' 'Space lets it run'
ran=$(seconds) took=$(((${EPOCHREALTIME/[.,]/} - began) / 1000))
# It never runs ahead. A busy machine shows late what time it is: twice as long and two seconds.
awk "BEGIN { exit !(1000 * $ran < $took && $took < 2000 * $ran + 2000) }" && ok 'in real time' || fail "$ran s took $took ms"
shoot
expect_shown 'finished — t [0-9.]* s — saved' 'a snapshot holds it'
as_rendered 'a snapshot of time that ran equals render'
hold 0.2 Right
xdotool key period key period
shoot
read -r x _ < <(numbers camera)
beyond + 0 "$x" 0.1 && ok 'what was moved stays at other times' || fail "the camera is at $x"
xdotool key Home
shoot
as_rendered 'Home gives it back to the scene'
xdotool key space && sleep 0.2 && hold 0.3 Left
xdotool key space
shoot
read -r x _ < <(numbers camera)
beyond - 0 "$x" 0.1 && ok 'keys move things while time runs' || fail "the camera is at $x"
leave
open "$work/time.lua" -t 1e300
xdotool key space && sleep 0.2 && xdotool key space key period
expect_shown 'finished — t 1e.300 s$' 'a time beyond all steps'
leave
open "$work/time.lua" -s 640x480 --samples 60000 --engine f64x1
xdotool key space
expect_shown 't [1-9][0-9.]* s, running$' 'slow pictures do not slow it'
leave 'Esc leaves while time runs'
sed 's/^light/if t > 0.06 then error("no more") end light/' "$work/time.lua" >"$work/late.lua"
open "$work/late.lua"
xdotool key period key period
expect_shown 't 0.04 s — .*late.lua:3: no more' 'a scene that goes wrong holds the time before'
grep -q 'late.lua:3: no more' "$work/errors" && ok 'and says so' || fail "$(cat "$work/errors")"
leave
sed 's/^light/while t > 0 do end light/' "$work/time.lua" >"$work/late.lua"
open "$work/late.lua"
xdotool key period && sleep 0.3
hold 0.2 Right
shoot
began=${EPOCHREALTIME/[.,]/}
leave 'Esc leaves a scene that runs for ever'
# The scene's own limit ends it after ten.
[ $(((${EPOCHREALTIME/[.,]/} - began) / 1000)) -lt 5000 ] && ok 'at once' || fail 'not at once'
open "$box" --samples 1
xdotool key space
expect_shown 'finished — this scene does not ask for the time t$' 'a scene without time says so'
leave

# A model keeps its tree from one time to the next; the window may close in between.
cp scenes/models/spot.obj "$work"
sed 's/^sphere.*/mesh { file = "spot.obj", rotate = {0, 90 * t, 0} }/' "$work/time.lua" >"$work/turn.lua"
mv "$work/turn.lua" "$work/time.lua"
open "$work/time.lua"
xdotool key space && sleep 0.5
xdotool key space
shoot
as_rendered 'a snapshot of a model that has turned equals render'
xdotool key space && sleep 0.2
leave 'Esc leaves while a model turns'

# --- a scene that is being written ---------------------------------------------------------------
cp "$box" "$work/edited.lua"
open "$work/edited.lua" --samples 1
hold 0.1 Right
shoot
was=$(numbers camera)
old=($("$probe" "$shot" yellow))
screen before
sed -i 's/^sphere {/sphere { radios = 2,/' "$work/edited.lua"
expect_shown 'edited.lua:[0-9]+: sphere has no field .radios.; did you mean .radius.' 'a mistake is told'
changed before mistaken 'over the picture, too'
hold 0.1 Right
xdotool key Home
changed mistaken moved 'and the scene before can be moved meanwhile'
hold 0.1 Right
cp "$box" "$work/next.lua" && sed -i 's/radius = 0.85/radius = 0.5/' "$work/next.lua"
mv "$work/next.lua" "$work/edited.lua" # As editors do.
shown 'finished$'
shoot
{
    echo "$view"
    grep -vE '^(camera|light)' "$work/edited.lua"
} >"$work/pasted.lua"
"$dioptre" render "$work/pasted.lua" --samples 1 -o "$work/pasted.bmp"
same "$shot" "$work/pasted.bmp" 'the mended scene is shown, from where it was seen'
[ "$(numbers camera)" != '0 0 6.5' ] && ok 'and not from its own place' || fail "it is seen from $(numbers camera)"
leave

# --- French --------------------------------------------------------------------------------------
# help KEYBOARD... LANGUAGE: opens the help on a keyboard, keeps it as a picture, and closes it.
help() {
    setxkbmap "${@:1:$#-1}" && sleep 0.3
    xdotool key F1
    differs quiet "help-${*: -1}-$1"
    xdotool key F1
    shows quiet
}
LC_ALL=C.UTF-8 LANGUAGE=fr open "$box" --samples 1
expect_shown '^boîte — 800×600, passe de 1.*px, 1 échantillon, .*Mrayons/s, terminé$' 'the title is French'
settled # The bar goes, and the hint with it.
screen quiet
for keyboard in us fr ch; do help $keyboard french; done
differ quiet help-french-us 'F1 shows the help in French'
differ help-french-us help-french-fr 'with the keys of AZERTY'
differ help-french-us help-french-ch 'with the keys of Swiss QWERTZ'
setxkbmap us && sleep 0.3
xdotool key Tab
expect_shown "terminé — il n’y a qu’une lampe$" 'notes are French'
xdotool key F1 && differs quiet open
xdotool key l
expect_shown 'pass 1 px, 1 sample, .*finished — messages are in English$' 'l speaks English'
changed help-french-us live 'in the help that is open, too'
xdotool key l
expect_shown 'terminé — les messages sont en français$' 'and French again'
restored help-french-us 'as it was'
xdotool key F1 l
shows quiet
for keyboard in us fr ch; do help $keyboard english; done
setxkbmap us && sleep 0.3
for keyboard in us fr ch; do differ help-english-$keyboard help-french-$keyboard "the help on $keyboard is in two languages"; done
shoot
grep -q '^camera { position = {0, 0, 6.5}' <<<"$view" && ok 'a view has points in its numbers' || fail "$view"
leave 'Échap quitte'
sed 's/^sphere {/sphere { radios = 2,/' "$box" >"$work/next.lua"
cp "$box" "$work/edited.lua"
LC_ALL=C.UTF-8 LANGUAGE=fr open "$work/edited.lua" --samples 1
mv "$work/next.lua" "$work/edited.lua"
expect_shown "edited.lua:[0-9]+: sphere n’a pas de champ .radios." 'a mistake is told in French'
screen faulty
xdotool key l
expect_shown 'edited.lua:[0-9]+: sphere has no field .radios.; did you mean .radius.' 'and in English after l'
changed faulty mistaken 'over the picture, too'
leave

# --- slow pictures -------------------------------------------------------------------------------
open "$box" --samples 60000 --engine f64x1
sleep 0.3
xdotool windowunmap --sync "$window" && sleep 0.3
still 1 'no processor time while the window is hidden'
before=$(ticks)
xdotool windowmap --sync "$window"
# has_worked TICKS: whether it has used a tenth of a second since then.
has_worked() { [ $(($(ticks) - $1)) -gt 10 ]; }
within has_worked "$before" && ok 'shown again it draws on' || fail 'shown again it draws on'
xdotool windowfocus "$window"
xdotool key p key Escape
closed 'Esc leaves in the middle of a drawing' 0
grep -q 'no snapshot' "$work/errors" && ok 'and says that a snapshot is lost' || fail 'no word of it'
open "$box" -s 300x200 --samples 600
shoot
"$dioptre" render "$box" -s 300x200 --samples 600 -o "$work/render.bmp"
same "$shot" "$work/render.bmp" 'a snapshot waits for the last pass'
leave

# --- with a window manager -----------------------------------------------------------------------
if command -v openbox >/dev/null; then
    # A manager that starts while a window opens takes the focus away from it.
    openbox --startup "touch $work/managed" >/dev/null 2>&1 &
    manager=$!
    within [ -e "$work/managed" ]
    open "$box"
    xdotool key F11
    expect_shown '1280×960.*finished' 'F11 fills the screen, with the ratio of the picture'
    xdotool key F11
    expect_shown '800×600.*finished' 'F11 again gives the window back'
    leave
    open "$box" --samples 60000
    xdotool windowminimize --sync "$window" && sleep 0.3
    still 1 'no processor time while the window is an icon'
    xdotool windowactivate "$window" && sleep 0.3 && xdotool key alt+F4
    closed 'the window manager closes the window' 0
    kill "$manager"
else
    echo 'skipped: F11, icon and close button, for want of a window manager (openbox)'
fi

# --- ends ----------------------------------------------------------------------------------------
for signal in INT TERM HUP; do
    open "$box" && shown finished
    kill -"$signal" "$pid"
    closed "SIG$signal, asleep" 130
    open "$box" --samples 60000
    kill -"$signal" "$pid"
    closed "SIG$signal in the middle" 130
done
[ -s "$work/errors" ] && fail "words at SIGTERM: $(cat "$work/errors")" || ok 'without a word'
open "$box" --samples 60000
kill "$server" && wait "$server" 2>/dev/null
closed 'the display goes away' 1
server=0
holds "$work/errors" '^dioptre: the display went away$' 'and it says so'

echo "$passed passed, $failures failed"
finish
