#!/bin/bash
# Lessons, end to end: read, played without hands and by hand, recorded and played again. What they
# show equals render, bit for bit.
. "$(dirname "$0")/check.sh"
. tests/screen.sh
box=$root/scenes/box.lua

# --- bad lessons, before any window --------------------------------------------------------------
# wrong LESSON WORDS: what is said of it, with file and line.
wrong() {
    printf '%s\n' "$1" >"$work/wrong.lua"
    expect 3 "^$work/wrong.lua:$2\$" "wrong: $1" "$dioptre" view --lesson "$work/wrong.lua"
}
begin="lesson { scene = \"$box\" }"
wrong '' '1: a lesson begins with lesson \{ scene = "FILE.lua" \}'
wrong 'caption "x"' '1: a lesson begins with lesson \{ scene = "FILE.lua" \}'
wrong 'lesson {' '2: unexpected symbol near <eof>'
wrong 'lesson { scen = "x" }' '1: lesson has no field `scen`; did you mean `scene`\?'
wrong 'lesson { scene = "none.lua" }' '1: scene `none.lua`: No such file or directory'
wrong "$begin"$'\npress "lihgt up"' '2: there is no action `lihgt up`; did you mean `light up`\?'
wrong "$begin hold(\"help\", 1)" '1: there is no move `help`'
wrong "$begin caption {}" '1: caption needs words: .*'
wrong "$begin caption { en = 3 }" '1: en must be text, not a number'
wrong "$begin caption { de = \"x\" }" '1: caption has no field `de`'
wrong "$begin wait(-1)" '1: seconds must be at least 0 and at most 3600, not -1'
wrong "$begin wiat(1)" '1: unknown word `wiat`; did you mean `wait`\?'
wrong "$begin turn(1)" '1: it is called so: turn\(DEGREES_RIGHT, DEGREES_UP\)'
wrong "$begin $begin" '1: a file holds one lesson, not two'
wrong "$begin for i = 1, 70000 do wait(0.001) press \"home\" end" '1: a lesson may have at most 65536 steps'
wrong "$begin pixel(0.5, 1.5)" '1: pixel must be at least 0 and at most 1, not 1.5'
wrong "$begin walk(1)" '1: it is called so: walk\(RIGHT, DOWN\)'
wrong "$begin bar(-1)" '1: bar must be at least 0 and at most 1, not -1'
wrong "$begin wait(t)" '1: unknown word `t`'
wrong "lesson { scene = \"$box\", offset = \"nne\" }" '1: offset must be .*; did you mean `none`\?'
echo "$begin" >"$work/a.lua"
expect 3 "^$work/a.lua: this lesson is for $box, not for scenes/chess.lua\$" 'a lesson for another scene' \
    "$dioptre" view scenes/chess.lua --lesson "$work/a.lua"
expect 3 'none.lua: No such file' 'a lesson that is not there' "$dioptre" view --lesson "$work/none.lua"
expect 2 '^dioptre: view needs a SCENE, or --lesson FILE' 'neither scene nor lesson' "$dioptre" view
expect 2 'lesson-snapshots needs --lesson' 'snapshots of no lesson' "$dioptre" view "$box" --lesson-snapshots "$work"

# --- without hands -------------------------------------------------------------------------------
start_server

# shots LESSON FOLDER: what it shows at its captions; the views are in FOLDER/views.
shots() {
    mkdir "$2"
    expect 0 '' "$(basename "$1" .lua), without hands" timeout 120 "$dioptre" view --lesson "$1" --samples 1 --lesson-snapshots "$2"
    cp "$work/out" "$2/views"
}
# as_rendered VIEW SCENE: a snapshot must be what render draws of its view.
as_rendered() {
    local shot=${1##*-- }
    { echo "$1"; grep -vE '^ *(camera|light)' "$2"; } >"$work/seen.lua"
    "$dioptre" render "$work/seen.lua" --samples 1 -s 800x600 -o "$work/seen.bmp"
    same "$shot" "$work/seen.bmp" "$(basename "$shot") equals render"
}
for lesson in shadows-and-acne:figure-c4 mirrors-and-glass:lessons/mirror-and-ball speed-and-accuracy:box; do
    taught=${lesson%:*} scene=scenes/${lesson#*:}.lua
    shots "scenes/lessons/$taught.lua" "$work/$taught"
    count=$(grep -c '^caption' "scenes/lessons/$taught.lua")
    [ "$(ls "$work/$taught" | grep -c bmp)" = "$count" ] && [ "$count" -ge 8 ] && ok "a picture at each of $count captions" ||
        fail "$taught: $(ls "$work/$taught" | grep -c bmp) pictures of $count captions"
    grep -cE 'en =' "scenes/lessons/$taught.lua" >"$work/a"
    grep -cE 'fr =' "scenes/lessons/$taught.lua" >"$work/b"
    same "$work/a" "$work/b" 'in both languages'
    # The first, the last and one in between.
    for number in 1 $((count / 2)) "$count"; do
        as_rendered "$(sed -n "${number}p" "$work/$taught/views")" "$scene"
    done
done

# --- by hand: in real time, held and let go on, with the viewer's own moves in between --------------
cat >"$work/lesson.lua" <<END
lesson { scene = "$box", size = {400, 300}, samples = 1, title = "Try" }
caption { en = "One", fr = "Un", wait = true }
END
cat >>"$work/lesson.lua" <<'END'
hold("light left", 0.41)
speed(4)
press "light up"
wait(0.1)
press "camera right"
wait(0.3)
release "light up"
speed(1)
wait(0.11)
release "camera right"
turn(10, 5)
zoom(2)
caption { en = "Two", wait = true }
press "home"
hold("camera forward", 0.2)
snapshot()
END
shots "$work/lesson.lua" "$work/quick"
[ "$(wc -l <"$work/quick/views")" = 3 ] && ok 'captions and the step snapshot' || fail "$(cat "$work/quick/views")"
view_of() { sed 's/  -- .*//' <<<"$1"; }
second=$(view_of "$(sed -n 2p "$work/quick/views")")
open "$box" --lesson "$work/lesson.lua"
expect_shown '400×300.*finished' 'its own size'
xdotool key p
expect_shown saved 'a snapshot of the first caption'
same "$work/shots/box-0001.bmp" "$work/quick/lesson-0001.bmp" 'is that without hands'
xdotool keydown d && sleep 0.2 && xdotool keyup d # While it is held, the view is the viewer's.
xdotool mousemove --window "$window" 200 150 click 1 # But rays would take the keys that follow.
xdotool key space && sleep 0.3
xdotool key space && sleep 0.2 # In the middle.
xdotool keydown Right && sleep 0.3 && xdotool keyup Right
xdotool key w F5 space
# says_second: whether it prints the second view: it is held again.
says_second() { xdotool key c && sleep 0.2 && [ "$(tail -1 "$work/log")" = "$second" ]; }
within says_second && ok 'the same view to the bit, held and disturbed' ||
    fail "$(tail -1 "$work/log") is not $second"
xdotool key d
expect_shown 'finished' 'after its last caption'
xdotool key space
expect_shown 'the lesson is over' 'it ends'
xdotool key Escape
closed 'Esc leaves' 0
open "$box" --lesson "$work/lesson.lua"
expect_shown '400×300' 'once more'
xdotool key space && sleep 0.2 && kill -INT "$pid"
closed 'SIGINT in the middle' 130
expect 1 'cannot write' 'a folder that is not there' timeout 60 "$dioptre" view --lesson "$work/lesson.lua" --lesson-snapshots "$work/nowhere"

# --- recorded --------------------------------------------------------------------------------------
open "$box" --samples 1
echo 'not yours' >"$work/shots/box-lesson-0001.lua"
shown finished 'a window to record in'
xdotool keydown Left && sleep 0.1 && xdotool keyup Left # Before it begins: not in the lesson.
xdotool key r
expect_shown 'recording a lesson' 'r records'
xdotool keydown Right && sleep 0.2 && xdotool keydown d && sleep 0.1 && xdotool keyup Right keyup d
xdotool key Return && sleep 0.2 && xdotool type 'The "end" a' && sleep 0.2 && xdotool key BackSpace BackSpace Return
xdotool key shift+Up && sleep 0.1
xdotool mousemove --window "$window" 400 300 mousedown 1 mousemove_relative 37 -21 mouseup 1 click 4
xdotool key x && sleep 0.3
xdotool mousemove --window "$window" 400 300 mousedown 1 mousemove --window "$window" 500 300 mouseup 1
xdotool key BackSpace mousemove --window "$window" 410 320 click 1 && sleep 0.3
xdotool key v && sleep 0.3
xdotool key ctrl+Right && sleep 0.1 && xdotool key Escape
xdotool key p && sleep 0.5 && xdotool key r
expect_shown 'the lesson is in box-lesson-0002.lua' 'r again writes the next free file'
grep -q 'not yours' "$work/shots/box-lesson-0001.lua" && ok 'never over another' || fail 'over another'
xdotool key c && sleep 0.3
recorded=$(tail -1 "$work/log")
xdotool key r && sleep 0.2 && xdotool keydown Up && sleep 0.1 && xdotool key Escape && sleep 0.3
ended "$pid" && fail 'Esc asks while a lesson is recorded' || ok 'Esc asks while a lesson is recorded'
xdotool key Escape
closed 'closed while it records, when asked twice' 0
lesson=$work/shots/box-lesson-0002.lua
holds "$lesson" '^caption \{ en = "The \\"end\\"", wait = true \}$' 'a caption that was typed'
holds "$lesson" '^snapshot\(\)$' 'a snapshot'
holds "$lesson" '^turn\([0-9.-]+, [0-9.-]+\)$' 'the mouse'
holds "$lesson" '^bar\(0.62[0-9]*\)$' 'the bar between two pictures'
holds "$lesson" '^select\("[a-z]*", [0-9]*, 0.51[0-9]*, 0.53[0-9]*\)$' 'a click on a thing'
holds "$lesson" '^walk\(1, 0\)$' 'a step to the pixel beside'
[ "$(grep -c '^press "rays"$' "$lesson")" = 2 ] && ok 'and Esc, which leaves the rays' || fail "$(grep rays "$lesson")"
holds "$lesson" '^speed\(4\)$' 'Shift'
holds "$work/shots/box-lesson-0003.lua" '^release "camera up"$' 'keeps what it has, with keys let go'
echo 'snapshot()' >>"$lesson"
shots "$lesson" "$work/again"
[ "$(view_of "$(tail -1 "$work/again/views")")" = "$recorded" ] && ok 'played, it ends where the recording ended, to the bit' ||
    fail "$(tail -1 "$work/again/views") is not $recorded"
finish
