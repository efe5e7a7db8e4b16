#!/bin/bash
# Draws the pictures of the window that the READMEs show, in English and French: doc/rays.jpg, doc/layers.jpg, and
# the same with `.fr` before the ending.
. "$(dirname "$0")/../tests/check.sh"
. tests/screen.sh
with_bar=yes

# keep NAME: what the window shows, once it is still and its messages are gone.
keep() {
    quiet
    settled
    local ending=.jpg
    [ "$LANGUAGE" = fr ] && ending=.fr.jpg
    convert "$work/a.ppm" -quality 88 "doc/$1$ending" && echo "doc/$1$ending"
}

# rays: of a pixel of the glass ball; the refracted ray is chosen.
rays() {
    open "$root/scenes/glass-sphere.lua" -s 1000x750 -j 2
    local bar=$(($(height) - 750))
    xdotool mousemove --window "$window" 520 $((bar + 390))
    settled
    xdotool key v
    settled
    for _ in {1..4}; do xdotool key k && sleep 0.2; done
    for _ in {1..5}; do xdotool key shift+Prior && sleep 0.2; done
    keep rays
    leave >/dev/null
}

# layers: the light beside acne, drawn without offset.
layers() {
    open "$root/scenes/box.lua" -s 1000x750 -j 2
    local bar=$(($(height) - 750))
    xdotool key x && sleep 0.2 && xdotool key 0 && sleep 0.2 && xdotool key o && sleep 0.2
    xdotool key i && sleep 0.2 && xdotool key i # The settings, which show what `o` did, go.
    xdotool mousemove --window "$window" 789 $((bar + 395))
    keep layers
    leave >/dev/null
}

start_server
for LANGUAGE in en fr; do
    export LANGUAGE
    [ "$LANGUAGE" = fr ] && export LC_ALL=C.UTF-8
    rays
    layers
done
exit "$failures"
