#!/bin/bash
# The list of scenes in the window: opened, gone through, chosen from by keys and by mouse, and closed
# while it is still being filled.
. "$(dirname "$0")/check.sh"
. tests/screen.sh
passed=0
start_server
mkdir "$work/few"
cp scenes/box.lua scenes/figure-08.lua scenes/glass-sphere.lua "$work/few"
echo 'camera {} sphere { raduis = 3 }' >"$work/few/bad.lua"
echo '-- A small scene. Nothing in it.' >"$work/few/empty.lua"
echo 'camera {}' >>"$work/few/empty.lua"
echo 'no scene' >"$work/few/words.txt"

# A program that is far from its own scenes: the list has those of the folder alone.
mkdir "$work/alone"
cp -r "$BUILD"/dioptre "$BUILD"/dioptre-* "$BUILD"/locale "$work/alone"
whole=$dioptre
dioptre=$work/alone/dioptre

open "$work/few/box.lua" --samples 1
shown finished
settled
cp "$work/a.ppm" "$work/plain.ppm"
xdotool key f
settled
differing "$work/plain.ppm" "$work/a.ppm" 'f opens a list'
cp "$work/a.ppm" "$work/list.ppm"
xdotool key Escape
settled
cmp -s "$work/plain.ppm" "$work/a.ppm" && ok 'Esc closes it' || fail 'Esc closes it'
xdotool key f
settled
cmp -s "$work/list.ppm" "$work/a.ppm" && ok 'the list is the same again' || fail 'another list'
xdotool key Escape
settled
cmp -s "$work/plain.ppm" "$work/a.ppm" && ok 'Esc closes it, and not the window' || fail 'Esc closes it'
# In alphabetical order: bad box empty figure-08 glass-sphere; the one that is shown is chosen first.
xdotool key f && settled
xdotool key Right Right Return
expect_shown '^figure 8: shadows — .*finished' 'arrows and Enter show another scene'
xdotool key f && settled
xdotool key Home Return
expect_shown '^figure 8: shadows — .*bad.lua:1: sphere has no field' 'a bad scene is told of, and the one before stays'
xdotool key l
expect_shown "bad.lua:1: sphere n’a pas de champ" 'and told again in the other language'
xdotool key l
expect_shown 'bad.lua:1: sphere has no field' 'and in the first'
xdotool key f && settled
# The first of two lines of three thumbnails is bad, box, empty; the second begins with figure-08.
xdotool type 'figure nothing'
settled
cp "$work/a.ppm" "$work/none.ppm"
xdotool key ctrl+z ctrl+BackSpace
differs none words && ok 'Ctrl and Backspace take a word away' || fail 'Ctrl and Backspace do nothing'
xdotool key ctrl+BackSpace ctrl+BackSpace
xdotool type glass
settled
xdotool mousemove --window "$window" 120 220 click 1
expect_shown '^glass-sphere — .*finished' 'a search leaves one, and a click shows it'
[[ $(title) =~ settings ]] && fail "it changed the settings: $(title)" || ok 'and the scene keeps its settings'
xdotool key r && sleep 0.2
xdotool key f
expect_shown 'a lesson keeps to its scene' 'not while a lesson is recorded'
xdotool key r
leave

# --- lessons ---------------------------------------------------------------------------------------
dioptre=$whole
open "$work/few/box.lua" --samples 1 # The program's lessons are in each list.
shown finished
xdotool key shift+f && settled
xdotool key Return
expect_shown '^Shadows' 'Shift F and Enter play the first lesson'
# The second Esc ends the lesson, and f comes at once: the list of the scene that it has left opens.
xdotool key Escape Escape f
shown '^figure C4' && settled
xdotool key Tab && settled
xdotool key Return
expect_shown '^Shadows' 'Tab in the list goes to the lessons'
# All keys at once: none waits for the list.
xdotool key Escape Escape f Tab Return
expect_shown '^Shadows' 'also where the keys come before the list'
leave
dioptre=$work/alone/dioptre
# What is slow: a scene for ever, with others before and after it, and keys meanwhile.
echo 'while true do end' >"$work/few/ever.lua"
open "$work/few/box.lua" --samples 1
shown finished
xdotool key f && sleep 0.8
xdotool key Escape f Escape f
began=${EPOCHREALTIME/[.,]/}
xdotool key Escape key Right
shown 'finished'
# The limit of a scene that runs for ever is ten seconds.
[ $(((${EPOCHREALTIME/[.,]/} - began) / 1000)) -lt 5000 ] && ok 'the window does not wait for it' || fail 'it waits'
xdotool key f && sleep 0.3 && xdotool key Escape
began=${EPOCHREALTIME/[.,]/}
leave 'Esc leaves while the list is filled'
[ $(((${EPOCHREALTIME/[.,]/} - began) / 1000)) -lt 5000 ] && ok 'at once' || fail 'not at once'
none_left() { ! ps -eo args= | grep -q "$work/[f]ew"; }
within none_left && ok 'no process is left' || fail 'a process is left'
open "$work/few/box.lua" --samples 1
xdotool key f && sleep 0.3
kill -INT "$pid"
closed 'SIGINT while the list is filled' 130
[ ! -s "$work/errors" ] && ok 'without a word' || fail "$(head -5 "$work/errors")"
finish
