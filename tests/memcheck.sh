#!/bin/sh
# Reads of memory that nobody has set, and other errors that the sanitizers do not see: valgrind with
# the release build. The picture is that without valgrind, to the bit. Workers run as they are: their
# filter of system calls refuses what valgrind asks for; the sanitizers and the fuzzers look at them.
. "$(dirname "$0")/check.sh"
small='-s 16x12 --samples 1 -j 2'

# checked NAME WORD...: a command under memcheck; it must end well, without an error.
checked() {
    name=$1
    shift
    # shellcheck disable=SC2086 # words
    if timeout 300 valgrind --quiet --error-exitcode=66 --trace-children=yes --trace-children-skip='*/ffmpeg,*/dioptre-worker' \
        --errors-for-leak-kinds=none "$dioptre" "$@" >"$work/out" 2>"$work/err" </dev/null; then
        grep -q '^==' "$work/err" && fail "$name: $(grep -m 20 '^==' "$work/err")" || ok "$name"
    else
        fail "$name: status $?: $(head -40 "$work/err")"
    fi
}

# Not f32x4: with SSE2 gcc selects lanes by exclusive or, of which valgrind does not see that what is
# not selected cancels out.
engines='f32x1 f64x1'
grep -qw avx2 /proc/cpuinfo && engines='f32x8 f64x1'
cat >"$work/glass.lua" <<'EOF'
camera { position = {0, 1, 5} }
rectangle_light {}
plane {}
sphere { center = {0, 1, 0}, material = material { transparency = 0.9, ior = 1.5 } }
EOF
# shellcheck disable=SC2086 # words
for engine in $engines; do
    "$dioptre" render scenes/box.lua $small --engine $engine -o "$work/plain.bmp"
    checked "a picture, $engine" render scenes/box.lua $small --engine $engine -o "$work/checked.bmp"
    same "$work/plain.bmp" "$work/checked.bmp" "$engine: the same bits under valgrind"
    checked "a Mandelbulb, $engine" render scenes/mandelbulb.lua $small --engine $engine -o "$work/bulb.bmp"
    checked "a repeated field, $engine" render scenes/endless-frames.lua $small --engine $engine -o "$work/field.bmp"
    for methods in own a c d; do
        checked "glass and a light with an area, methods $methods, $engine" render "$work/glass.lua" $small --samples 2 \
            --engine $engine --methods $methods -o "$work/glass.bmp"
    done
done
printf 'camera { position = {0, 0, 5} }\nlight {}\nmesh { file = "die.obj" }\n' >"$work/model.lua"
cp scenes/models/die.obj "$work/"
# shellcheck disable=SC2086 # words
checked 'a model' render "$work/model.lua" $small --engine f32x1 -o "$work/model.bmp"
# shellcheck disable=SC2086 # words
checked 'facts' info scenes/mandelbulb.lua -s 8x6 --samples 1 --engine f32x1 --json
checked 'a comparison' compare "$work/plain.bmp" "$work/checked.bmp"
finish
