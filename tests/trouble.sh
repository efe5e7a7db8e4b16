#!/bin/bash
# What goes wrong around a window: no font, a size that no screen has, two windows that want the same
# file. Starts an X server of its own.
. "$(dirname "$0")/check.sh"
. tests/screen.sh
box=$root/scenes/box.lua

# --- a size that no screen has -------------------------------------------------------------------
start_server
open "$box" --samples 1
xdotool windowsize --sync "$window" 8000 4000 2>/dev/null
expect_shown ' 5333×4000, pass' 'a window of 8000 by 4000 pixels shows a picture'
leave 'which Esc ends'

# --- two windows, one folder ---------------------------------------------------------------------
open "$box" -s 160x120 --samples 4
first=$window first_pid=$pid
(cd "$work/shots" && exec "$dioptre" view "$box" -s 160x120 --samples 4) >"$work/log2" 2>&1 &
second_pid=$!
has_second() {
    second=$(xdotool search --onlyvisible --class '^dioptre$' 2>/dev/null | grep -v "^$first\$")
    [ -n "$second" ]
}
within has_second
window=$second && shown finished
for _ in 1 2 3 4 5; do
    xdotool windowfocus --sync "$first" key p windowfocus --sync "$second" key p
    window=$first && shown saved && window=$second && shown saved
    xdotool windowfocus --sync "$first" key Home windowfocus --sync "$second" key Home
    window=$first && shown 'finished$' && window=$second && shown 'finished$'
done
"$dioptre" render "$box" -s 160x120 --samples 4 -o "$work/render.bmp"
for shot in "$work"/shots/*.bmp; do cmp -s "$shot" "$work/render.bmp" || echo "$shot"; done >"$work/torn"
[ "$(ls "$work/shots" | wc -l)" = 10 ] && [ ! -s "$work/torn" ] &&
    ok 'two windows that snap at once: ten whole pictures, none over another' ||
    fail "two windows that snap at once: $(ls "$work/shots" | tr '\n' ' '), torn: $(cat "$work/torn")"
xdotool windowfocus --sync "$second" key Escape
wait "$second_pid" && ok 'the second leaves' || fail 'the second leaves'
window=$first && xdotool windowfocus --sync "$first"
leave 'the first leaves'

# --- no font -------------------------------------------------------------------------------------
# Only where a process may have file systems of its own.
without_fonts() { unshare -rm sh -c 'mount -t tmpfs none /usr/share/fonts && exec "$@"' sh "$@"; }
if without_fonts true 2>/dev/null; then
    printf '#!/bin/bash\n%s\nwithout_fonts "%s" "$@"\n' "$(declare -f without_fonts)" "$dioptre" >"$work/fontless"
    chmod +x "$work/fontless"
    # Without a font there is no bar to fold.
    with_bar=none dioptre=$work/fontless open "$box" --samples 1
    xdotool key F1
    expect_shown 'no font found: the help is on standard output' 'without a font the title says where the help is'
    holds "$work/log" 'light' 'and it is there'
    xdotool key 2 3 9 0 1 plus minus l l F1
    leave 'and no key brings the window down'
else
    echo 'skipped: no font, as processes cannot have file systems of their own here'
fi
finish
