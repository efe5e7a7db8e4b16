#!/bin/bash
# The toolbar, the marks of the lights and the messages on the picture, by mouse alone.
. "$(dirname "$0")/check.sh"
. tests/screen.sh
box=$root/scenes/box.lua
with_bar=yes

# light: where the first light is.
light() { grep -o 'light { position = {[^}]*' <<<"$view" | sed '1!d; s/.*{//; s/,//g'; }

start_server
open "$box" --samples 1
settled
tall=$(height)
[ "$tall" -gt 600 ] && ok 'the bar does not take the picture its place' || fail "the window is $tall high"
"$dioptre" render "$box" --samples 1 -o "$work/render.bmp"
shoot
same "$shot" "$work/render.bmp" 'a snapshot under the bar equals render'

# --- marks of lights ---------------------------------------------------------------------------------
# drag_mark X: drags what is X pixels from the left, at the upper edge of the picture; sets was and now.
drag_mark() {
    shoot
    was=($(light))
    xdotool mousemove --window "$window" "$1" $((top + 16)) mousedown 1
    xdotool mousemove --window "$window" $((($1 + 300) / 2)) $((top + 60)) \
        mousemove --window "$window" 300 $((top + 150)) mouseup 1
    shoot
    now=($(light))
}
# The light of the box is at the top of the picture, in its middle.
top=$((tall - 600))
drag_mark 400
awk "BEGIN { exit !(${now[0]} < ${was[0]} - 0.1 && ${now[1]} < ${was[1]} - 0.1) }" &&
    ok 'a light is dragged by its mark' || fail "the light went from ${was[*]} to ${now[*]}"
awk "BEGIN { d = ${now[2]} - ${was[2]}; exit !(d < 1e-9 && d > -1e-9) }" &&
    ok 'in the plane that faces the camera' || fail "the light went from ${was[*]} to ${now[*]}"
xdotool keydown shift mousemove --window "$window" 300 $((top + 150)) mousedown 1 \
    mousemove --window "$window" 300 $((top + 140)) mousemove --window "$window" 300 $((top + 120)) mouseup 1 keyup shift
was=("${now[@]}")
shoot
now=($(light))
awk "BEGIN { exit !(${now[2]} < ${was[2]} - 0.1 && ${now[0]} - ${was[0]} < 0.01) }" &&
    ok 'with Shift along the direction of view' || fail "the light went from ${was[*]} to ${now[*]}"
xdotool key Home

# Without the bar the window is as high as the picture.
height_is() { [ "$(height)" -eq "$1" ]; }
top=0
xdotool key F5
within height_is 600 || fail "a presentation is $(height) high"
drag_mark 400
xdotool key Home
[ "${now[*]}" != "${was[*]}" ] && ok 'a light is dragged in a presentation' || fail "the light stays at ${was[*]}"
xdotool key F5
within height_is "$tall"
xdotool key F2
within height_is 600 || fail "without the bar the window is $(height) high"
drag_mark 400
xdotool key Home
[ "${now[*]}" = "${was[*]}" ] && ok 'without the toolbar, a light has no mark' || fail "the light went from ${was[*]} to ${now[*]}"
xdotool key F2
within height_is "$tall"
top=$((tall - 600))

# --- the screen as a picture -------------------------------------------------------------------------
xdotool key 3
shown 'distance.*finished'
before=$(wc -l <"$work/log")
xdotool key shift+p
within has_lines "$work/log" "$before"
seen=$work/shots/$(tail -1 "$work/log")
[ "$(identify -format '%wx%h %m' "$seen")" = '800x600 PNG' ] && ok 'Shift P saves the screen as PNG' ||
    fail "it is $(identify "$seen" 2>&1)"
identify -format '%[dioptre:view] %[*]' "$seen" 2>/dev/null | cat - <(strings "$seen") >"$work/words"
grep -q 'camera { position' "$work/words" && ok 'with the view in its metadata' || fail "$(head -c 300 "$work/words")"
shoot
"$dioptre" compare "$seen" "$shot" >/dev/null
status=$?
[ $status = 1 ] && ok 'the legend is in the picture' || fail "the legend is in the picture: status $status"
xdotool key 1
shown 'pass 1 px.*finished'

# --- a recorded drag ---------------------------------------------------------------------------------
xdotool key r
expect_shown 'recording' 'r records'
xdotool mousemove --window "$window" 400 $((top + 16)) mousedown 1 \
    mousemove --window "$window" 430 $((top + 90)) mousemove --window "$window" 470 $((top + 130)) mouseup 1
xdotool key n
shoot
kept=$shot
xdotool key r
has_lesson() { lesson=$(sed -n 's/.*\(box-lesson-[0-9]*\.lua\)$/\1/p' "$work/log" | tail -1) && [ -n "$lesson" ]; }
within has_lesson
grep -q '^drag(1, ' "$work/shots/$lesson" && ok 'a lesson records the drag' || fail "no drag in $lesson"
leave
mkdir -p "$work/replay"
expect 0 '' 'and is played without a viewer' \
    "$dioptre" view --lesson "$work/shots/$lesson" --lesson-snapshots "$work/replay"
same "$kept" "$(ls "$work"/replay/*.bmp | head -1)" 'to the bit'

# --- widgets -----------------------------------------------------------------------------------------
open "$box" --samples 1
settled
# The list of layers is wide, third in the first row; its second entry lies two rows below it.
xdotool mousemove --window "$window" 220 24 click 1
settled
xdotool mousemove --window "$window" 220 94 click 1
expect_shown 'normals.*finished' 'a list of the bar chooses a layer'
xdotool mousemove --window "$window" 220 24 click 1
settled
xdotool key Escape
settled
shown 'normals' && ok 'Esc closes the list, not the layer' || fail "the title says $(title)"
xdotool key Escape
expect_shown 'pass 1 px.*finished' 'Esc again: the light'
# The entry chosen lay over the button of the costs, whose tooltip would come below the bar.
# below_bar NAME: what is seen there.
below_bar() { import -window "$window" -crop "800x60+0+$((tall - 598))" "$work/$1.ppm"; }
xdotool mousemove --window "$window" 250 24 click 1
settled
xdotool mousemove --window "$window" 250 94 click 1
shown 'normals.*finished'
sleep 1 && settled && below_bar chosen
xdotool mousemove --window "$window" 400 500 && sleep 1 && settled && below_bar away
cmp -s "$work/chosen.ppm" "$work/away.ppm" && ok 'the button under an entry that was chosen keeps its tooltip to itself' ||
    fail 'a tooltip lies below the bar after a choice'
xdotool mousemove --window "$window" 256 98 && sleep 0.2 && below_bar soon
cmp -s "$work/soon.ppm" "$work/away.ppm" && ok 'a tooltip waits until the mouse rests' || fail 'it comes at once'
has_tooltip() { below_bar rest && ! cmp -s "$work/rest.ppm" "$work/away.ppm"; }
within has_tooltip && ok 'then it comes by itself' || fail 'no tooltip comes'
has_none() { below_bar rest && cmp -s "$work/rest.ppm" "$work/away.ppm"; }
xdotool key b shift+b
within has_none && sleep 1 && has_none && ok 'a key takes it away, until the mouse moves' || fail 'the tooltip stays'
xdotool mousemove --window "$window" 400 500 key Escape
expect_shown 'pass 1 px.*finished' 'Esc: the light once more'
# The list of scenes is opened and closed by its button, and closed by its own in the upper right corner.
xdotool mousemove --window "$window" 400 500
quiet
settled
cp "$work/a.ppm" "$work/picture.ppm"
for close in '110 24' '740 150'; do
    xdotool mousemove --window "$window" 110 24 click 1
    sleep 0.5
    differs picture list
    # shellcheck disable=SC2086 # Two numbers.
    xdotool mousemove --window "$window" $close click 1
    sleep 0.5
    xdotool mousemove --window "$window" 400 500
    restored picture "a click at $close closes the list of scenes"
done
# The slider of epsilon lies right of the middle of that row; while it is held, epsilon stays.
xdotool mousemove --window "$window" 500 24 mousedown 1 mousemove --window "$window" 535 24
epsilon() { title | sed -n 's/.*epsilon: \([0-9.e-]*\).*/\1/p'; }
expect_shown "finished — epsilon: .*, offset: fixed; the scene's own offset, bound, is off" 'what else the slider changes is told'
settled
held=$(epsilon)
sleep 1
[ "$(epsilon)" = "$held" ] && ok 'the slider of epsilon holds still' || fail "epsilon went from $held to $(epsilon)"
# A linear scale would have tenths there.
awk "BEGIN { exit !($held > 1e-10 && $held < 1e-4) }" && ok 'its scale is logarithmic' || fail "epsilon is $held"
# The same gesture goes on after a rest: one undo takes back all of it, with the offset.
xdotool mousemove --window "$window" 520 24
settled
[ "$(epsilon)" = "$held" ] && fail 'the slider goes on' || ok 'the slider goes on'
moved=$(epsilon)
xdotool mouseup 1 mousemove --window "$window" 400 500 key ctrl+z
expect_shown 'finished$' 'Ctrl+Z takes back the whole gesture of a slider'
xdotool key ctrl+y o shift+o bracketright
expect_shown 'finished — epsilon: ' 'the same settings once more'
awk "BEGIN { exit !($(epsilon) == 2 * $moved) }" && ok 'Ctrl+Y does it again' || fail "epsilon is $(epsilon), not twice $moved"
xdotool key ctrl+z BackSpace
settled
xdotool key F2
settled
[ "$(height)" -lt "$tall" ] && ok 'F2 folds the bar' || fail "the window is $(height) high"
xdotool mousemove --window "$window" 24 20 click 1
is_tall() { [ "$(height)" -ge "$tall" ]; }
within is_tall && ok 'its button unfolds it' || fail "the window is $(height) high"
leave

# --- the pixel that the bar names --------------------------------------------------------------------
open "$box" --samples 1
settled
tall=$(height)
top=$((tall - 600))
xdotool key r && sleep 0.3
xdotool mousemove --window "$window" 300 $((top + 250))
sleep 0.3
xdotool key v && sleep 0.5 && xdotool key Escape && sleep 0.3
# The magnifier goes on by keys, while the mouse stays; then the mouse lies on the bar.
xdotool key F4 && sleep 0.3 && xdotool key ctrl+Left ctrl+Left ctrl+Down && sleep 0.3
xdotool mousemove --window "$window" 110 24 && sleep 0.3
xdotool key v && sleep 0.5 && xdotool key Escape && sleep 0.3
xdotool key F4 && sleep 0.3
xdotool key v && sleep 0.5 && xdotool key Escape && sleep 0.3
xdotool key r
within has_lesson
sed -n 's/^pixel(\([0-9.]*\), \([0-9.]*\))$/\1 \2/p' "$work/shots/$lesson" |
    awk '{ printf "%d %d ", $1 * 800, $2 * 600 }' >"$work/pixels"
[ "$(cat "$work/pixels")" = '300 250 298 251 ' ] &&
    ok 'v shows the rays of the pixel under the mouse, and of the one in the magnifier' ||
    fail "v recorded $(cat "$work/pixels"): $(cat "$work/shots/$lesson")"
[ "$(grep -c '^press "rays"$' "$work/shots/$lesson")" = 4 ] &&
    ok 'where the bar names none, those of the last pixel' || fail "$(cat "$work/shots/$lesson")"
leave

# --- clicks while a list is open ---------------------------------------------------------------------
open "$box" --samples 1
settled
tall=$(height)
# The list of number types is the last of the first row; its second entry lies two rows below it.
xdotool mousemove --window "$window" 220 24 click 1
settled
xdotool mousemove --window "$window" 648 24 click 1
settled
xdotool mousemove --window "$window" 648 94 click 1
expect_shown 'finished — number type: double \(f64' 'a click on another list opens it, while one is open'
xdotool mousemove --window "$window" 220 24 click 1
settled
xdotool mousemove --window "$window" 24 24 click 1
settled
xdotool mousemove --window "$window" 60 66 click 1
within is_lower "$tall" && ok 'a click on a button while a list is open does what it does: a menu, which hides the bar' ||
    fail "the window is $(height) high"
xdotool key F2
within is_tall
[ "$(height)" = "$tall" ] && ok 'the window is as high again as it was' || fail "the window is $(height) high, not $tall"
# Compared with the mouse on the picture: over the bar a tooltip comes and goes by the clock.
xdotool mousemove --window "$window" 400 500 && quiet && settled && cp "$work/a.ppm" "$work/closed.ppm"
xdotool mousemove --window "$window" 220 24 click 1 && settled && xdotool click 1
xdotool mousemove --window "$window" 400 500
restored closed 'a click on the list itself closes it'
# The last entry of the menu ends the program; it asks first while a lesson is recorded.
xdotool key r
shown 'recording'
for time in first second; do
    xdotool mousemove --window "$window" 24 24 click 1
    settled
    xdotool mousemove --window "$window" 60 318 click 1
    [ $time = first ] && expect_shown 'leave again to save it' 'the menu asks before it ends the program'
done
closed 'then it ends it' 0

# --- the bar by keys ---------------------------------------------------------------------------------
open "$box" --samples 1
fold
xdotool mousemove --window "$window" 400 590
xdotool key shift+F2
expect_shown 'arrows: a button' 'Shift F2 unfolds the bar and gives it the keyboard'
xdotool key Right Right && sleep 0.3 && xdotool key Return && settled
xdotool key Down Return
expect_shown 'normals.*finished' 'arrows and Enter open a list and choose'
# On to the offset, epsilon, the number type; the next is in the second row: less depth, more depth.
for key in Tab Tab Tab Tab Tab; do xdotool key $key && sleep 0.2; done
xdotool key space
expect_shown 'finished — depth: 9$' 'Tab goes on to the next row, Space presses a button'
xdotool key shift+Tab && sleep 0.2 && xdotool key Return
expect_shown 'finished — depth: 8$' 'Shift Tab goes back'
xdotool key 3 && sleep 0.5
shown 'normals' && ok 'meanwhile digits are no commands' || fail "the title says $(title)"
xdotool key Escape && sleep 0.3 && xdotool key 3
expect_shown 'distance.*finished' 'Esc gives the keys back to the picture'
leave

# --- a light outside the picture ---------------------------------------------------------------------
# Both lights of this scene are: arrows show where, the first one at the upper edge, left of the middle.
open "$root/scenes/glass-sphere.lua" --samples 1
settled
top=$(($(height) - 600))
drag_mark 220
awk "BEGIN { exit !(${now[0]} > ${was[0]} + 0.1 && ${now[1]} < ${was[1]} - 0.1) }" &&
    ok 'a light outside the picture is dragged by its arrow' || fail "it went from ${was[*]} to ${now[*]}"
xdotool key Home
settled
xdotool mousemove --window "$window" 220 $((top + 16)) click 1
expect_shown 'light 1' 'a click on its arrow selects it'
leave

# --- formulas that scroll ----------------------------------------------------------------------------
open "$box" --samples 1
xdotool mousemove --window "$window" 300 430 && sleep 0.3
xdotool key v && quiet && settled && cp "$work/a.ppm" "$work/rays.ppm"
xdotool key Next
changed rays scrolled 'Page Down scrolls the formulas of the rays'
xdotool key Prior
restored rays 'Page Up scrolls them back'
xdotool key shift+Prior
changed rays nearer 'with Shift it goes nearer'
leave
exit $((failures > 0))
