#!/bin/sh
# Data races: commands of the build with the thread sanitizer, with more threads than this machine has.
# The window's part is tests/soak.sh with that build (tests/run.sh).
. "$(dirname "$0")/check.sh"
dioptre=$PWD/build/tsan/dioptre
# Only our own races: the libraries of pictures are not built with the sanitizer.
printf '%s\n' 'called_from_lib:libOpenImageIO.so' 'called_from_lib:libtbb.so' >"$work/suppressions"
export TSAN_OPTIONS="halt_on_error=1:exitcode=66:suppressions=$work/suppressions"
small='-s 48x36 --samples 4 -j 7'

# clean NAME WORD...: a command that must end well, without a race.
clean() {
    name=$1
    shift
    # shellcheck disable=SC2086 # words
    if timeout 120 "$dioptre" "$@" >"$work/out" 2>"$work/err" </dev/null; then
        ok "$name"
    else
        fail "$name: status $?: $(grep -v '^$' "$work/err" | head -40)"
    fi
}

# shellcheck disable=SC2086 # words
{
    clean 'a picture' render scenes/box.lua $small -o "$work/a.bmp"
    clean 'a picture of glass, all samples' render scenes/glass-sphere.lua $small --sampling full -o "$work/b.bmp"
    clean 'a picture with models and textures' render scenes/still-life.lua $small -o "$work/c.png"
    clean 'a picture in quad' render scenes/box.lua -s 8x6 --samples 1 -j 7 --engine f128x1 -o "$work/d.bmp"
    clean 'frames' animate scenes/melting.lua $small --frames 0-2 -o "$work/f-%d.bmp"
    clean 'facts' info scenes/box.lua $small
    clean 'times' bench scenes/box.lua $small --frames 2
    clean 'settings' needs scenes/box.lua -s 24x18 -j 7
}
finish
