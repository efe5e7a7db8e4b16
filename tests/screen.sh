# Shared by the scripts that open a window: an X server of their own, a window on it, and its keys.
# Sourced after check.sh, not run.
root=$PWD
server=0 pid=0
# Leaks of libdbus, which SDL asks for the screen saver, and of libfontconfig, whose cache hides its
# pointers, are not ours (build/asan).
printf 'leak:%s\n' libdbus libfontconfig >"$work/leaks"
export LSAN_OPTIONS="suppressions=$work/leaks:print_suppressions=0"

# --- screen, window, keys ------------------------------------------------------------------------
start_server() {
    # -noreset: the keyboard map stays when the last window closes.
    Xvfb -displayfd 3 -screen 0 1280x1024x24 -nolisten tcp -noreset 3>"$work/display" 2>/dev/null &
    server=$!
    within [ -s "$work/display" ]
    export DISPLAY=:$(cat "$work/display")
}
cleanup() {
    [ "$pid" != 0 ] && kill -9 "$pid" 2>/dev/null
    [ "$server" != 0 ] && kill "$server" 2>/dev/null
    wait 2>/dev/null
    rm -rf "$work"
}
trap cleanup EXIT

# has_window: whether there is a window, or the program has ended without one; sets window.
has_window() {
    window=$(xdotool search --onlyvisible --class '^dioptre$' 2>/dev/null | tail -1)
    [ -n "$window" ] || ended "$pid"
}
# open SCENE OPTION...: opens the window in a folder of its own and waits for its first picture.
open() {
    rm -rf "$work/shots" && mkdir "$work/shots" && cd "$work/shots" || exit 1
    # A script's children in the background ignore Ctrl-C; a person's do not.
    env --default-signal=INT "$dioptre" view "$@" >"$work/log" 2>"$work/errors" &
    pid=$!
    cd "$root" || exit 1
    window=
    within has_window
    xdotool windowfocus --sync "$window" 2>/dev/null
    shown 'pass'
    [ -n "${with_bar:-}" ] || fold
}
# height: of the window, pixels.
height() { xdotool getwindowgeometry --shell "$window" | sed -n 's/^HEIGHT=//p'; }
# fold: hides the toolbar, so that the window has the size of the picture. The bar is there when
# the title names a pass; a window that is too small for it has none.
fold() {
    local tall=0
    while [ "$(height)" -gt "$tall" ] 2>/dev/null; do
        tall=$(height)
        sleep 0.2
    done
    [ "$tall" -lt 300 ] && return
    xdotool key F2
    within is_lower "$tall"
}
is_lower() { [ "$(height)" -lt "$1" ]; }

# closed NAME STATUS: the program must end by itself, with that status.
closed() {
    if ! within ended "$pid"; then
        fail "$1: it is still there" && kill -9 "$pid"
    fi
    wait "$pid"
    local status=$?
    pid=0
    [ "$status" = "$2" ] && ok "$1" || fail "$1: status $status, not $2: $(cat "$work/errors")"
}
# leave [NAME]: closes one thing after the other, at last the program.
leave() {
    for _ in {1..6}; do
        kill -0 "$pid" 2>/dev/null && xdotool key Escape && sleep 0.3
    done
    closed "${1:-Esc leaves}" 0
}

title() { xdotool getwindowname "$window" 2>/dev/null; }
# shown WORDS: waits until the title holds WORDS (a pattern).
shown() { within titled "$1"; }
titled() { [[ $(title) =~ $1 ]]; }
expect_shown() { shown "$1" && ok "$2" || fail "$2: the title says $(title)"; }
# hold SECONDS KEY...: holds keys down.
hold() {
    local seconds=$1
    shift
    xdotool keydown "$@" && sleep "$seconds" && xdotool keyup "$@"
}
# screen FILE: what the window shows.
screen() { import -window "$window" "$work/$1.ppm"; }
# settled: waits until the program and its processes sleep, and the window shows the same twice.
settled() { within is_quiet; }
is_quiet() {
    is_asleep && screen a && sleep 0.3 && is_asleep && screen b && cmp -s "$work/a.ppm" "$work/b.ppm"
}
# is_asleep: whether no thread of the program or of the processes that it has started is running.
is_asleep() {
    local process
    for process in $pid $(pgrep -P "$pid"); do
        grep -qs ') R ' "/proc/$process"/task/*/stat && return 1
    done
    return 0
}
# shoot: takes a snapshot and sets `shot` to its path and `view` to its scene text.
shoot() {
    local before
    before=$(wc -l <"$work/log")
    xdotool key p
    within has_lines "$work/log" "$before"
    view=$(tail -1 "$work/log")
    shot=$work/shots/${view##*-- }
}
# quiet: waits until messages on the picture are gone; each is shown for 4 seconds.
quiet() { sleep 4.5; }
# differs OLD NEW: waits until the window shows something other than OLD, and keeps it as NEW.
differs() { within is_another "$@" && settled && cp "$work/a.ppm" "$work/$2.ppm"; }
is_another() { screen "$2" && ! cmp -s "$work/$1.ppm" "$work/$2.ppm"; }
# shows OLD: waits until the window shows OLD again.
shows() { within is_same "$1"; }
is_same() { screen a && cmp -s "$work/$1.ppm" "$work/a.ppm"; }
# changed OLD NEW NAME, restored OLD NAME: the same as tests.
changed() { differs "$1" "$2" && ok "$3" || fail "$3"; }
restored() { shows "$1" && ok "$2" || fail "$2"; }
