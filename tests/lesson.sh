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
    case $2 in
    [0-9]*) place="^$work/wrong.lua" ;;
    *) place="^dioptre: $work/wrong.lua" ;; # It is no line that is wrong.
    esac
    expect 3 "$place:$2\$" "wrong: $1" "$dioptre" view --lesson "$work/wrong.lua"
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
choices='choices = {"a", "b"}'
wrong "$begin ask {}" '1: ask needs words: .*'
wrong "$begin ask \"x\"" '1: ask takes .*'
wrong "$begin ask { en = \"x\", rihgt = 1 }" '1: ask has no field `rihgt`; did you mean `right`\?'
wrong "$begin ask { en = \"x\" }" '1: choices must be a list, not nothing'
wrong "$begin ask { en = \"x\", choices = {\"a\"} }" '1: choices must be a list of 2 to 9 texts, not of 1'
wrong "$begin ask { en = \"x\", choices = {\"a\", {}} }" '1: choices needs words: .*'
wrong "$begin ask { en = \"x\", choices = {\"a\", {e = 1}} }" '1: choices has no field `e`.*'
wrong "$begin ask { en = \"x\", $choices }" '1: right must be .*'
wrong "$begin ask { en = \"x\", $choices, right = 3 }" '1: right must be at most 2, the number of choices, not 3'
wrong "$begin ask { en = \"x\", $choices, right = 0 }" '1: right must be at least 1 and at most 9, not 0'
wrong "$begin ask { en = \"x\", $choices, right = 1 }" '1: because must be text, not nothing'
wrong "$begin for i = 1, 65 do ask { en = \"x\", $choices, right = 1, because = \"y\" } end" \
    '1: a lesson may have at most 64 questions'
wrong "$begin explain()" '1: no question is open here: .*'
wrong "$begin ask { en = \"x\", $choices, right = 1, because = \"y\" } explain() explain()" '1: no question is open here: .*'
wrong "$begin explain(1)" '1: it is called so: explain\(\)'
wrong "lesson { scene = \"$box\", learnt = \"x\" }" '1: learnt must be a list, not a string'
wrong "lesson { scene = \"$box\", learnt = {1, 2, 3, 4, 5, 6, 7} }" '1: learnt must be a list of 0 to 6 texts, not of 7'
wrong "$begin wiat(1)" '1: unknown word `wiat`; did you mean `wait`\?'
wrong "$begin turn(1)" '1: it is called so: turn\(DEGREES_RIGHT, DEGREES_UP\)'
wrong "$begin orbit(1, 2)" '1: it is called so: orbit\(DEGREES_RIGHT, DEGREES_UP, X, Y, Z\)'
wrong "$begin pan(1)" '1: it is called so: pan\(RIGHT, UP\)'
wrong "lesson { scene = \"$box\", move_speed = 0 }" '1: move_speed must be .*'
wrong "$begin $begin" '1: a file holds one lesson, not two'
wrong "$begin for i = 1, 70000 do wait(0.001) press \"home\" end" '1: a lesson may have at most 65536 steps'
wrong "$begin pixel(0.5, 1.5)" '1: pixel must be at least 0 and at most 1, not 1.5'
wrong "$begin walk(1)" '1: it is called so: walk\(RIGHT, DOWN\)'
wrong "$begin bar(-1)" '1: bar must be at least 0 and at most 1, not -1'
wrong "$begin wait(t)" '1: unknown word `t`'
wrong "lesson { scene = \"$box\", offset = \"nne\" }" '1: offset must be .*; did you mean `none`\?'
wrong "$begin wait(2) set(\"light\", 9, \"intensity\", 1)" ' the step at 2 s names `light` number 9, which .*'
wrong "$begin select(\"sphere\", 7)" ' the step at 0 s names `sphere` number 7, which .*'
wrong "$begin drag(5, 1, 0, 0)" ' the step at 0 s names light number 5, which .*'
wrong "$begin torus(1)" '1: unknown word `torus`'
echo "$begin" >"$work/a.lua"
expect 3 "^dioptre: $work/a.lua: this lesson is for $box, not for scenes/chess.lua\$" 'a lesson for another scene' \
    "$dioptre" view scenes/chess.lua --lesson "$work/a.lua"
expect 3 'none.lua: No such file' 'a lesson that is not there' "$dioptre" view --lesson "$work/none.lua"
expect 2 '^dioptre: view needs a SCENE, or --lesson FILE' 'neither scene nor lesson' "$dioptre" view
expect 2 'lesson-snapshots needs --lesson' 'snapshots of no lesson' "$dioptre" view "$box" --lesson-snapshots "$work"

# --- without hands -------------------------------------------------------------------------------
start_server

# shots LESSON FOLDER OPTION...: what it shows at its captions; the views are in FOLDER/views.
shots() {
    mkdir "$2"
    expect 0 '' "$(basename "$1" .lua), without hands" timeout 120 "$dioptre" view --lesson "$1" --samples 1 --lesson-snapshots "$2" "${@:3}"
    cp "$work/out" "$2/views"
}
# as_rendered VIEW SCENE OPTION...: a snapshot must be what render draws of its view.
as_rendered() {
    local shot=${1##*-- }
    { echo "$1"; grep -vE '^ *(camera|light)' "$2"; } >"$work/seen.lua"
    "$dioptre" render "$work/seen.lua" --samples 1 -s 800x600 "${@:3}" -o "$work/seen.bmp"
    same "$shot" "$work/seen.bmp" "$(basename "$shot") equals render"
}
# Each of the nine plays to its end, with a picture at each caption and explanation; the first, the last and
# one in between are what render draws.
[ "$(ls scenes/lessons/0*.lua | wc -l)" = 9 ] && ok 'nine lessons' || fail "$(ls scenes/lessons)"
for file in scenes/lessons/0*.lua; do
    taught=$(basename "$file" .lua)
    shots "$file" "$work/$taught"
    count=$(($(grep -c '^caption' "$file") + $(grep -c '^ask' "$file")))
    [ "$(ls "$work/$taught" | grep -c bmp)" = "$count" ] && [ "$count" -ge 7 ] && ok "$taught: $count pictures" ||
        fail "$taught: $(ls "$work/$taught" | grep -c bmp) pictures of $count captions and questions"
    grep -c '^ask' "$file" >"$work/a" && [ "$(cat "$work/a")" -ge 4 ] && ok 'asks' || fail "$(cat "$work/a") questions"
    grep -oE '\ben =' "$file" | wc -l >"$work/a"
    grep -oE '\bfr =' "$file" | wc -l >"$work/b"
    same "$work/a" "$work/b" 'in both languages'
done
while read -r taught scene number options; do
    # shellcheck disable=SC2086 # Several words.
    as_rendered "$(sed -n "${number}p" "$work/$taught/views")" "scenes/$scene.lua" $options
done <<END
01-shadows figure-c4 1
01-shadows figure-c4 4
03-glass glass-sphere 1 --depth 0
03-glass glass-sphere 2 --depth 8
06-acne figure-c4 2 --offset none
07-depth facing-mirrors 3 --depth 2
END


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
with_bar=1 open "$box" --lesson "$work/lesson.lua"
expect_shown '^Try — 400×300.*finished' 'its own title and size'
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
leave
with_bar=1 open "$box" --lesson "$work/lesson.lua"
expect_shown '400×300' 'once more'
xdotool key space && sleep 0.2 && kill -INT "$pid"
closed 'SIGINT in the middle' 130

# --- questions -------------------------------------------------------------------------------------
cat >"$work/asks.lua" <<END
lesson { scene = "$box", size = {400, 300}, samples = 1, title = "Try", learnt = { "One." } }
local q = { en = "Where?", choices = { "a", "b", "c" }, right = 2, because = "So." }
END
cat >>"$work/asks.lua" <<'END'
ask(q)
hold("light left", 0.3)
caption { en = "Two", wait = true }
press "split" press "engine"
ask(q)
hold("light up", 0.2)
END
shots "$work/asks.lua" "$work/right" --answers "$work/right.csv"
[ "$(cut -d, -f2- "$work/right.csv" | tr '\n' ' ')" = 'lesson,question,choice,right "asks",1,2,1 "asks",2,2,1 ' ] &&
    ok 'without hands the right answers' || fail "$(cat "$work/right.csv")"
shots "$work/asks.lua" "$work/other" --answers "$work/right.csv" --predictions 3
[ "$(tail -2 "$work/right.csv" | cut -d, -f2- | tr '\n' ' ')" = '"asks",1,3,0 "asks",2,2,1 ' ] && ok 'or those of --predictions' ||
    fail "$(cat "$work/right.csv")"
[ "$(wc -l <"$work/right.csv")" = 5 ] && ok 'one head' || fail "$(cat "$work/right.csv")"
same "$work/right/asks-0003.bmp" "$work/other/asks-0003.bmp" 'whatever was predicted, the same is shown'
expect 2 "predictions takes digits from 1 to 9, not '0'" 'no choice 0' "$dioptre" view --lesson "$work/asks.lua" --predictions 0
expect 2 'predictions must be from 1 to 3 for question 1, not 9' 'no choice 9' timeout 60 \
    "$dioptre" view --lesson "$work/asks.lua" --lesson-snapshots "$work/nine" --predictions 9
expect 1 'No space left' 'answers on a full disk' timeout 60 \
    "$dioptre" view --lesson "$work/asks.lua" --lesson-snapshots "$work/full" --answers /dev/full
expect 1 'cannot write' 'answers into a folder' timeout 60 "$dioptre" view "$work/asks.lua" --answers "$work"
# Where `explain()` stands, the camera is still as the question had it moved; at the caption it is back.
cat >"$work/explained.lua" <<END
lesson { scene = "$box", size = {400, 300}, samples = 1, title = "Try" }
ask { en = "Where?", choices = { "a", "b" }, right = 2, because = "So." }
turn(20, 0)
explain()
press "home"
caption { en = "Back", wait = true }
END
shots "$work/explained.lua" "$work/explained"
differing "$work/explained/explained-0001.bmp" "$work/explained/explained-0002.bmp" 'explained before the view is reset'
last=$(view_of "$(tail -1 "$work/right/views")")
with_bar=1 open "$work/asks.lua" --answers "$work/by-hand.csv"
xdotool key space d && sleep 0.2 # Neither goes on, nor moves the light.
xdotool key 4 1
# answered LINES: whether the file has so many lines.
answered() { [ "$(wc -l <"$work/by-hand.csv")" = "$1" ]; }
within answered 2 && tail -1 "$work/by-hand.csv" | grep -q '"asks",1,1,0$' && ok 'a key answers' || fail "$(cat "$work/by-hand.csv")"
sleep 0.6 && xdotool key space && sleep 0.2 && xdotool key comma && sleep 0.3 && xdotool key comma && sleep 0.3
xdotool key 2 # A step back: the question once more.
within answered 3 && tail -1 "$work/by-hand.csv" | grep -q '"asks",1,2,1$' && ok 'a step back asks again' || fail "$(cat "$work/by-hand.csv")"
sleep 0.6 && xdotool key period && sleep 0.3 && xdotool key period && sleep 0.3
# click_answer ROW: clicks on the second answer, in the middle of the row of answers.
eval "$(xdotool getwindowgeometry --shell "$window" | sed 's/^/win_/')"
for y in 60 50 70 40 80; do
    answered 4 || { xdotool mousemove --window "$window" $((win_WIDTH / 2)) $((win_HEIGHT - y)) && sleep 0.3 && xdotool click 1 && sleep 0.5; }
done
within answered 4 && ok 'a click answers' || fail "$(cat "$work/by-hand.csv")"
expect_shown 'finished' 'what was asked about'
sleep 0.5 && xdotool key c && sleep 0.3
[ "$(tail -1 "$work/log")" = "$last" ] && ok 'after steps back and on the same view to the bit' || fail "$(tail -1 "$work/log") is not $last"
xdotool key space
expect_shown 'the lesson is over' 'the end card'
xdotool key 2 && sleep 0.5 && xdotool key 3
within answered 5 && ok 'again: from the beginning' || fail "$(cat "$work/by-hand.csv")"
xdotool key Escape && sleep 0.2
ended "$pid" && fail 'Esc asks' || ok 'Esc asks'
xdotool key Escape && sleep 0.3
expect_shown '^box' 'then the title is the name of the scene'
ended "$pid" && fail 'Esc again ends the lesson alone' || ok 'Esc again ends the lesson alone'
leave

# --- from one lesson to the next ----------------------------------------------------------------------
mkdir "$work/set"
echo "lesson { scene = \"$box\", size = {400, 300}, samples = 1 } caption { en = \"One\", wait = true }" >"$work/set/a.lua"
echo 'sphere {}' >"$work/set/b.lua" # A scene, and no lesson.
echo "lesson { scene = \"$root/scenes/figure-c4.lua\", size = {400, 300}, samples = 2, depth = 3 }
ask { en = \"Two?\", choices = { \"a\", \"b\" }, right = 1, because = \"So.\" } press \"deeper\"" >"$work/set/c.lua"
with_bar=1 open "$work/set/a.lua" --answers "$work/set.csv"
expect_shown '^box.*finished' 'the first lesson'
xdotool key space
expect_shown 'the lesson is over' 'it ends'
xdotool key space Return
expect_shown '^figure C4: shadow acne — .*finished' 'Enter opens the next lesson with its scene'
xdotool key 2
in_set() { [ "$(wc -l <"$work/set.csv")" = "$1" ]; }
within in_set 2 && sleep 0.5
[ "$(tail -1 "$work/set.csv" | cut -d, -f2-)" = '"c",1,2,0' ] && ok 'which asks' || fail "$(cat "$work/set.csv")"
xdotool key space
expect_shown 'the lesson is over' 'and ends'
xdotool key 1 f && sleep 0.5 && xdotool key Escape && sleep 0.3 # There is no next one; the list of scenes.
leave
expect 1 'cannot write' 'a folder that is not there' timeout 60 "$dioptre" view --lesson "$work/lesson.lua" --lesson-snapshots "$work/nowhere"

# --- recorded --------------------------------------------------------------------------------------
cp "$box" "$work" && open "$work/box.lua" --samples 1
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
xdotool key BackSpace && sleep 0.3
xdotool mousemove --window "$window" 420 330 mousedown 3 mousemove_relative 25 -10 mouseup 3 mousedown 2 mousemove_relative 12 8 mouseup 2
xdotool mousemove --window "$window" 410 320 click 1 && sleep 0.3
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
holds "$lesson" '^  scene = "\.\./.*box.lua",$' 'the scene as seen from the lesson'
holds "$lesson" '^snapshot\(\)$' 'a snapshot'
holds "$lesson" '^turn\([0-9.-]+, [0-9.-]+\)$' 'the mouse'
holds "$lesson" '^orbit\([0-9.-]+, [0-9.-]+, [0-9.e-]+, [0-9.e-]+, [0-9.e-]+\)$' 'the right button'
holds "$lesson" '^pan\([0-9.-]+, [0-9.-]+\)$' 'the middle button'
holds "$lesson" '^  move_speed = [0-9.]+,$' 'the speed of keys'
holds "$lesson" '^bar\(0.62[0-9]*\)$' 'the bar between two pictures'
holds "$lesson" '^select\("[a-z]*", [0-9]*, 0.51[0-9]*, 0.53[0-9]*\)$' 'a click on a thing'
holds "$lesson" '^walk\(1, 0\)$' 'a step to the pixel beside'
[ "$(grep -c '^pixel(0.51[0-9]*, 0.53[0-9]*)$' "$lesson")" = 1 ] && ok 'the pixel under the mouse, whose rays v shows' || fail "$(cat "$lesson")"
[ "$(grep -c '^press "rays"$' "$lesson")" = 1 ] && ok 'and Esc, which leaves the rays' || fail "$(grep rays "$lesson")"
holds "$lesson" '^speed\(4\)$' 'Shift'
holds "$work/shots/box-lesson-0003.lua" '^release "camera up"$' 'keeps what it has, with keys let go'
echo 'snapshot()' >>"$lesson"
shots "$lesson" "$work/again"
[ "$(view_of "$(tail -1 "$work/again/views")")" = "$recorded" ] && ok 'played, it ends where the recording ended, to the bit' ||
    fail "$(tail -1 "$work/again/views") is not $recorded"
finish
