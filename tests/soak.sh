#!/bin/bash
# Random keys, clicks, sizes and keyboards for a while: the window must neither end nor grow. `make
# soak` does it for half an hour with the sanitizers on.
#
# Environment: BUILD (folder of the program), SOAK_SECONDS (how long; 20), SOAK_SEED (which keys; 1),
# SOAK_SCENE (scenes/box.lua).
. "$(dirname "$0")/check.sh"
. tests/screen.sh
SOAK_SECONDS=${SOAK_SECONDS:-20}
RANDOM=${SOAK_SEED:-1}
# What waits to be given back is no growth.
# SDL 2.26 itself looks beyond a piece of memory when keyboards change.
echo interceptor_via_lib:libSDL2 >"$work/sdl"
export ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=1}:quarantine_size_mb=4:suppressions=$work/sdl

# Every key that does anything but Escape and Ctrl Q, which leave, and p, which fills the disk.
keys=(a b c d e f g h i j k l m n o q r s t u v w x y z 0 1 2 3 4 5 6 7 8 9
    Left Right Up Down Prior Next Home Tab space comma period minus plus bracketleft bracketright
    BackSpace Return slash backslash apostrophe semicolon F1 F2 F3 F4 F5 F6 F7 F8 F9 F10 F11)
modifiers=('' '' '' '' '' shift+ ctrl+ ctrl+shift+)
sizes=('1 1' '8000 4000' '37 211' '640 480' '801 601' '320 200' '320 200' '320 200')
layouts=(us fr ch)

# pick NAME: sets `picked` to any element of an array.
pick() {
    local -n from=$1
    picked=${from[RANDOM % ${#from[@]}]}
}

# disturb: does anything.
disturb() {
    case $((RANDOM % 40)) in
    0) pick sizes && xdotool windowsize "$window" $picked ;;
    1) pick layouts && setxkbmap "$picked" ;;
    2 | 3) xdotool mousemove --window "$window" $((RANDOM % 320)) $((RANDOM % 200)) click 1 ;;
    4 | 5)
        xdotool mousemove --window "$window" $((RANDOM % 320)) $((RANDOM % 200)) mousedown 1 \
            mousemove_relative -- $((RANDOM % 40 - 20)) $((RANDOM % 40 - 20)) mouseup 1
        ;;
    6) xdotool click $((4 + RANDOM % 2)) ;;
    7 | 8 | 9 | 10) pick keys && xdotool keydown "$picked" sleep 0.1 keyup "$picked" ;;
    *)
        pick modifiers && modifier=$picked && pick keys
        # a is q where the keyboard has just been changed to a French one, or back.
        [[ "$modifier$picked" =~ ^ctrl.*[aq]$ ]] || xdotool key "$modifier$picked"
        ;;
    esac 2>/dev/null
}

# measure: notes the memory in use, kB, in a window of the usual size that shows what it showed at
# first: one picture, no layer.
measure() {
    xdotool windowsize "$window" 320 200 key BackSpace key 1 2>/dev/null
    sleep 2
    awk '/VmRSS/ { print $2 }' /proc/$pid/status >>"$work/memory"
}

# least: the least of the numbers that come in: what lists, lessons and references of that moment take
# comes on top of it.
least() { sort -n | head -1; }

start_server
open "$root/${SOAK_SCENE:-scenes/box.lua}" -s 320x200
end=$((SECONDS + SOAK_SECONDS)) pause=$((SOAK_SECONDS / 24 + 2)) count=0
next=$((SECONDS + pause))
while [ $SECONDS -lt $end ] && kill -0 "$pid" 2>/dev/null; do
    disturb
    count=$((count + 1))
    [ $SECONDS -ge $next ] && measure && next=$((SECONDS + pause))
done
echo "# $count keys, clicks and sizes; memory, kB: $(tr '\n' ' ' <"$work/memory")"
if kill -0 "$pid" 2>/dev/null; then ok 'the window is still there'; else fail "the window has ended: $(head -20 "$work/errors")"; fi
# The first tenth fills caches: glyphs, trees, the largest picture.
half=$(($(wc -l <"$work/memory") / 2))
early=$(sed -n "3,${half}p" "$work/memory" | least) late=$(sed -n "$((half + 1)),\$p" "$work/memory" | least)
if [ "$SOAK_SECONDS" -ge 300 ]; then
    awk "BEGIN { exit !($late <= 1.1 * $early + 16384) }" && ok 'its memory does not grow' ||
        fail "its memory grows: from $early to $late kB"
else
    echo 'skipped: the growth of its memory, which shows from 300 s on (SOAK_SECONDS)'
fi
xdotool windowfocus "$window" 2>/dev/null
kill -INT "$pid" 2>/dev/null
closed 'Ctrl-C ends it without a leak' 130
[ -s "$work/errors" ] && grep -vE '^dioptre: ' "$work/errors" | head -20
finish
