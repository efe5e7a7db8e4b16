#!/bin/sh
# Workers that a stranger's file has got hold of: stand-ins for the picture and the model module try to
# reach the network, files, programs and the program that started them, and write over all memory that
# they have. The program, with sanitizers, must end by status 3 and a message, and nothing may come of it.
. "$(dirname "$0")/check.sh"
mkdir "$work/bin"
# The sanitizers watch the program; its worker is that of the release, as their memory is terabytes.
cp build/asan/dioptre "$work/bin" && cp build/dioptre-worker "$work/bin"
dioptre=$work/bin/dioptre
for module in meshes images; do
    "${CC:-cc}" -std=gnu11 -D_GNU_SOURCE -Wall -Wextra -Iinclude -Isrc -O1 -shared -fPIC -fvisibility=hidden \
        $([ $module = meshes ] && echo -DMESHES) -o "$work/bin/dioptre-$module.so" tests/hostile/module.c ||
        fail "the stand-in for the module of $module is not built"
done
export SECRET="$work/secret" OWNED="$work/owned"
echo secret >"$SECRET"
printf 'ply\nformat ascii 1.0\nelement vertex 0\nend_header\n' >"$work/a.ply"
cp scenes/pictures/die.png "$work/a.png"
echo 'camera { position = {0, 0, 9} } mesh { file = "a.ply" }' >"$work/mesh.lua"
echo 'camera {} sky { image = "a.png" }' >"$work/sky.lua"

# deed NAME STATUS WORDS: the modules do it, and the program ends like this.
deed() {
    for scene in mesh sky; do
        expect "$2" "$3" "$1 in a worker ($scene)" env HOSTILE="$1" timeout 60 \
            "$dioptre" render "$work/$scene.lua" -o "$work/o.bmp" -s 8x8
        [ -e "$work/o.bmp" ] && fail "$1 ($scene) left a picture"
        [ -e "$OWNED" ] && fail "$1 ($scene) wrote a file"
        rm -f "$work/o.bmp" "$OWNED"
    done
}
deed none 3 'nothing was tried'
deed ones 3 'crash|astray|ended|more than'
deed zeros 3 'crash|astray|ended|more than'
deed answer-ones 3 'astray'
deed answer-twos 3 'astray'
deed answer-much 3 'crash'
deed memory 3 'refused'
# What needs the filter of system calls.
if "$dioptre" info "$work/sky.lua" 2>&1 | grep -q seccomp; then
    echo 'skipped: this system does not filter system calls'
else
    deed open 3 'refused: Permission denied'
    deed create 3 'refused: Permission denied'
    deed connect 3 'Bad system call'
    deed exec 3 'Bad system call'
    deed shell 3 'Bad system call|refused'
    deed kill 3 'Bad system call'
fi
# Without that filter the program says so, once, and the limits hold.
without() { "$BUILD/tests/test_worker_process" --without-filter "$@"; }
for deed in ones answer-ones memory; do
    for scene in mesh sky; do
        HOSTILE=$deed without timeout 60 "$dioptre" render "$work/$scene.lua" -o "$work/o.bmp" -s 8x8 2>"$work/err" </dev/null
        got=$?
        [ "$got" = 3 ] && ok "$deed in a worker without a filter ($scene)" || fail "$deed without a filter ($scene): status $got: $(head -3 "$work/err")"
        [ "$(grep -c 'does not filter system calls' "$work/err")" = 1 ] && ok 'the program says once that there is no filter' || fail "no filter: $(cat "$work/err")"
    done
done
# Nor does a worker start a program there, as the limit of processes is 0; root's is not counted.
chmod -R a+rX "$work"
mkdir -m 777 "$work/public"
[ "$(id -u)" = 0 ] && nobody='setpriv --reuid=65534 --regid=65534 --clear-groups' || nobody=
for scene in mesh sky; do
    # shellcheck disable=SC2086 # several words
    expect 3 'refused: Resource temporarily unavailable' "a shell in a worker without a filter ($scene)" \
        env HOSTILE=shell OWNED="$work/public/owned" "$BUILD/tests/test_worker_process" --without-filter $nobody \
        timeout 60 "$dioptre" render "$work/$scene.lua" -o "$work/public/o.bmp" -s 8x8
    [ -e "$work/public/owned" ] && fail "a shell in a worker without a filter ($scene) wrote a file"
done
finish
