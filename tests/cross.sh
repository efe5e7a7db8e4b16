#!/bin/sh
# The program for ARM64 in an emulator: the same pictures as on this processor, to the bit, and the unit
# tests that need neither a worker nor a module. `make cross` builds what it needs. The emulator has no
# seccomp: that the filter's rules are right there is shown by test_worker_filter, which runs them.
. "$(dirname "$0")/check.sh"
cross=build/cross
emulator=$(command -v qemu-aarch64) || fail 'qemu-aarch64 is missing'
# The emulator starts no programs of its own processor: a script does.
printf '#!/bin/sh\nexec %s %s-emulated "$@"\n' "$emulator" "$PWD/$cross/dioptre-worker" >$cross/dioptre-worker
chmod +x $cross/dioptre-worker

# picture SCENE ENGINE OPTION...: a picture there and here.
picture() {
    scene=$1 engine=$2
    shift 2
    "$dioptre" render "scenes/$scene" -q --engine "$engine" "$@" -o "$work/here.bmp" 2>"$work/err" </dev/null &&
        "$emulator" $cross/dioptre-emulated render "scenes/$scene" -q --engine "$engine" "$@" -o "$work/there.bmp" 2>"$work/err" </dev/null ||
        fail "$scene in $engine: $(head -3 "$work/err")"
    same "$work/here.bmp" "$work/there.bmp" "$scene in $engine: the same bits as here"
    rm -f "$work/here.bmp" "$work/there.bmp"
}
for engine in f32x4 f64x1; do
    for scene in box.lua glass-sphere.lua glass-of-water.lua cow.lua teapot.lua melting.lua mandelbulb.lua \
        still-life.lua light-modes.lua cylinder-light.lua facing-mirrors.lua own-distances.lua twins.lua orbits.lua; do
        picture $scene $engine -s 64x48 --samples 2
    done
done
for scene in box.lua glass-sphere.lua; do
    picture $scene f128x1 -s 24x18 --samples 1
done
for test in $cross/emulated/test_*; do
    if timeout 300 "$emulator" "$test" >"$work/out" 2>&1; then
        ok "$(grep -c '^\[       OK' "$work/out") tests of ${test##*/}"
    else
        fail "${test##*/}: $(grep -v 'RUN\|OK' "$work/out" | head -20)"
    fi
done
finish
