#!/bin/bash
# Objects of the scene: clicked, changed, undone, written into the file, recorded and replayed.
. "$(dirname "$0")/check.sh"
. tests/screen.sh
start_server

# A room with one ball in the middle of the picture; its inspector is at the right.
cat >"$work/ball.lua" <<'END'
camera { position = {0, 0, 6} }
image { width = 800, height = 600 }
light { position = {3, 4, 5} }
sphere { center = {0, 0, 0}, radius = 1, -- the ball
  material = material { color = {1, 0, 0} } }
for i = 1, 2 do sphere { center = {-4 + i, 2, 0}, radius = 0.25 } end
END
cp "$work/ball.lua" "$work/first.lua"
click() { xdotool mousemove --window "$window" "$@" click 1; }
# drag_widget: drags the second row of numbers of the inspector, the radius, to the right.
drag_widget() { xdotool mousemove --window "$window" 520 306 mousedown 1 mousemove_relative 20 0 sleep 0.2 mousemove_relative 20 0 sleep 0.2 mousemove_relative 20 0 sleep 0.2 mouseup 1; }


open "$work/ball.lua" --samples 1
settled && cp "$work/a.ppm" "$work/plain.ppm"
click 400 300
changed plain selected 'a click opens the inspector'
xdotool key Escape
restored plain 'Esc closes it'
click 400 300 && settled
click 20 580
restored plain 'so does a click on nothing'
click 400 300 && settled && cp "$work/a.ppm" "$work/selected.ppm"
xdotool key r && sleep 0.5
click 400 300 && sleep 0.3
drag_widget
changed selected wide 'a number is dragged: the scene changes'
xdotool key ctrl+z && quiet && settled
xdotool key ctrl+y && quiet && settled
xdotool key p && sleep 1 && xdotool key r && sleep 1
lesson=$(ls "$work"/shots/*-lesson-*.lua)
grep -qE '^set\("sphere", 1, "radius", [0-9.]+\)$' "$lesson" && ok 'changes are recorded' || fail "$(cat "$lesson")"
[ "$(grep -cE '^set\(.*, true\)$' "$lesson")" -ge 1 ] && ok 'a drag is one change' || fail "$(cat "$lesson")"
grep -qx 'press "undo"' "$lesson" && ok 'undo is recorded' || fail "$(cat "$lesson")"
radius=$(grep -E '^set' "$lesson" | tail -1 | sed 's/.*"radius", \([0-9.]*\).*/\1/')
xdotool key ctrl+c && sleep 0.5
grep -q "^sphere { radius = $radius, material = material { color = {1, 0, 0} } }$" "$work/log" &&
    ok 'Ctrl C gives its text' || fail "$(tail -1 "$work/log")"
xdotool key ctrl+s && sleep 1
sed "s/radius = 1,/radius = $radius,/" "$work/first.lua" >"$work/wanted.lua"
same "$work/ball.lua" "$work/wanted.lua" 'Ctrl S writes the value at its line'
xdotool key ctrl+z && sleep 1 && xdotool key p && sleep 1.5
undone=$(ls "$work"/shots/*.bmp | tail -1)
"$dioptre" render "$work/first.lua" --samples 1 -o "$work/first.bmp"
same "$undone" "$work/first.bmp" 'undo leads back to the value before, after writing too'
xdotool mousemove --window "$window" 380 320 mousedown 1
for _ in 1 2 3; do xdotool mousemove_relative -- -20 20 && sleep 0.2; done
xdotool mouseup 1 key ctrl+c && sleep 0.5
tail -1 "$work/log" | grep -qE '^sphere \{ center = \{-0\.[0-9]{1,6}, -0\.[0-9]{1,6}, 0\}' && ok 'a shape is dragged in the plane that faces you' ||
    fail "$(tail -1 "$work/log")"
xdotool key ctrl+z && sleep 0.5 && xdotool key ctrl+c && sleep 0.5
tail -1 "$work/log" | grep -q 'center' && fail "$(tail -1 "$work/log")" || ok 'and undo takes the whole drag back'
click 145 90 && settled
drag_widget && sleep 0.5
xdotool key ctrl+s && sleep 0.5
same "$work/ball.lua" "$work/wanted.lua" 'a value of a loop is not written'
leave
cp "$work/first.lua" "$work/ball.lua"
mkdir "$work/replayed"
timeout 100 "$dioptre" view --lesson "$lesson" --lesson-snapshots "$work/replayed" >"$work/log" 2>&1
recorded=$(ls "$work"/shots/*.bmp | head -1)
same "$(ls "$work"/replayed/*.bmp | head -1)" "$recorded" 'the lesson replays it, to the bit'
"$dioptre" render "$work/wanted.lua" --samples 1 -o "$work/wanted.bmp"
same "$recorded" "$work/wanted.bmp" 'and the picture is that of the written file'

# --- keys alone, and moves of lights and camera --------------------------------------------------
cp "$work/first.lua" "$work/ball.lua"
open "$work/ball.lua" --samples 1
settled
shoot && at_first=${view%%--*}
hold 0.3 d && shoot && light_moved=${view%%--*}
hold 0.3 Up && shoot && camera_moved=${view%%--*}
[ "$at_first" != "$light_moved" ] && [ "$light_moved" != "$camera_moved" ] || fail 'nothing has moved'
xdotool key ctrl+z && shoot
[ "${view%%--*}" = "$light_moved" ] && ok 'undo takes a move of the camera back' || fail "$view, not $light_moved"
xdotool key ctrl+z && shoot
[ "${view%%--*}" = "$at_first" ] && ok 'and one of a light' || fail "$view, not $at_first"
xdotool key ctrl+y && shoot
[ "${view%%--*}" = "$light_moved" ] && ok 'redo moves it again' || fail "$view, not $light_moved"
xdotool key ctrl+z && settled
# In the middle of the picture is the ball; below four rows of buttons is its centre, then its radius.
xdotool key F3 && settled
xdotool key F10 && shown 'arrows: a field' && settled
for _ in 1 2 3 4 5; do xdotool key Down && sleep 0.2; done
xdotool key Return && sleep 0.3 && xdotool key ctrl+a && sleep 0.2 && xdotool type 0.5 && sleep 0.3 && xdotool key Return
settled
xdotool key Escape && settled
xdotool key ctrl+c && sleep 0.5
grep -q '^sphere { radius = 0.5, ' "$work/log" && ok 'F3 and F10: a number is typed by keys alone' || fail "$(tail -1 "$work/log")"
# On a French keyboard the row of digits gives & é " ... without Shift, and numbers have commas.
setxkbmap fr && sleep 0.3
xdotool key F10 && settled
for _ in 1 2 3 4 5; do xdotool key Down && sleep 0.2; done
# The number is chosen when it opens; behind its end, only Ctrl+A chooses it again.
xdotool key Return && sleep 0.3 && xdotool key End && sleep 0.2 && xdotool key ctrl+a && sleep 0.2
for key in ampersand comma eacute agrave quotedbl; do xdotool key "$key" && sleep 0.1; done
xdotool key Return && settled && xdotool key Escape && settled
setxkbmap us && sleep 0.5
xdotool key ctrl+c && sleep 0.5
tail -1 "$work/log" | grep -q '^sphere { radius = 1.203, ' && ok 'AZERTY: Ctrl+A by what is printed on the key, digits without Shift, and a comma' || fail "$(tail -1 "$work/log")"
# Below the radius are the transform, the material, its colour; right of the brightness is its square.
xdotool key F10 && settled
for key in Down Down Down Down Down Down Down Down Right Return; do xdotool key $key && sleep 0.2; done
xdotool key Return && sleep 0.3 && xdotool key ctrl+a && sleep 0.2 && xdotool type 0,25 && sleep 0.3 && xdotool key Return && sleep 0.3
for key in Down space Right Right Right space Down Down Return; do xdotool key $key && sleep 0.2; done
settled && xdotool key Escape && settled
xdotool key ctrl+c && sleep 0.5
tail -1 "$work/log" | grep -qE '^sphere \{ radius = 1.203, material = material \{ color = \{0\.25, 0\.0[1-9][0-9]*, 0\} \} \}' &&
    ok 'the picker of colours by keys alone: Enter opens it, types a number, presses OK; arrows change another' || fail "$(tail -1 "$work/log")"
xdotool key ctrl+z && sleep 0.3 && xdotool key ctrl+z && sleep 0.3
xdotool key ctrl+c && sleep 0.5
tail -1 "$work/log" | grep -q '^sphere { radius = 1.203, material = material { color = {1, 0, 0} } }' && ok 'each is one change' || fail "$(tail -1 "$work/log")"
# Above red, green and blue are value, saturation and, first, the hue: 120 degrees are green.
xdotool key F10 && settled
for key in Down Down Down Down Down Down Down Down Right Return Up Up Up; do xdotool key $key && sleep 0.2; done
xdotool key Return && sleep 0.3 && xdotool key ctrl+a && sleep 0.2 && xdotool type 120 && sleep 0.3 && xdotool key Return && sleep 0.3
for key in Down space Left Left space Down Down Down Down Down Return; do xdotool key $key && sleep 0.2; done
settled && xdotool key Escape && settled
xdotool key ctrl+c && sleep 0.5
tail -1 "$work/log" | grep -qE '^sphere \{ radius = 1.203, material = material \{ color = \{(0\.0[0-9]*), 1, \1\} \} \}' &&
    ok 'hue and saturation by keys alone: a pale green' || fail "$(tail -1 "$work/log")"
# The change before these is that of the radius. A machine that is busy may take the keys of a
# picker as one change: one step back at a time, until its value is back.
is_undone() { xdotool key ctrl+c && sleep 0.5 && tail -1 "$work/log" | grep -q '^sphere { radius = 0.5, '; }
for _ in 1 2 3; do
    is_undone || { xdotool key ctrl+z && sleep 0.5; }
done
within is_undone
xdotool key ctrl+shift+s
has_copy() { [ -s "$work/shots/ball-copy-0001.lua" ]; }
within has_copy
sed 's/radius = 1,/radius = 0.5,/' "$work/first.lua" >"$work/wanted-copy.lua"
same "$work/shots/ball-copy-0001.lua" "$work/wanted-copy.lua" 'Ctrl Shift S saves a copy with the changes'
same "$work/ball.lua" "$work/first.lua" 'and leaves the file alone'
xdotool key shift+F3 && settled && xdotool key ctrl+c && sleep 0.5
tail -1 "$work/log" | grep -q '^light' && ok 'Shift F3: the thing before, which is the last, a light' || fail "$(tail -1 "$work/log")"
# The list of all things, by keys: camera, lamp, ball, two small ones.
xdotool key Escape && settled
xdotool key shift+F10 && shown 'arrows: a thing' && settled
for key in Down Down Down Return; do xdotool key $key && sleep 0.2; done
settled && xdotool key ctrl+c && sleep 0.5
tail -1 "$work/log" | grep -q '^sphere { center = {-3, 2, 0}, radius = 0.25' && ok 'Shift F10: a thing is chosen from the list of all' || fail "$(tail -1 "$work/log")"
xdotool key Escape && settled && cp "$work/a.ppm" "$work/chosen.ppm"
xdotool key Escape
changed chosen list 'Esc leads back to the list'
xdotool key Escape
changed list closed 'and then closes it'
# By mouse: its third row is the ball.
xdotool key shift+F10 && settled && click 560 160 && settled
xdotool key ctrl+c && sleep 0.5
tail -1 "$work/log" | grep -q '^sphere { radius = 0.5' && ok 'a row is clicked' || fail "$(tail -1 "$work/log")"
at_first=${view%%--*}
hold 0.3 d && shoot
[ "${view%%--*}" != "$at_first" ] && ok 'and the keys are those of the picture again' || fail "$view"
leave
finish
