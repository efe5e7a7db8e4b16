#!/bin/sh
# The house rules that a machine can check: rooms and arrows, names, sizes of files and functions.
. "$(dirname "$0")/check.sh"

# arrow FROM TO...: headers of other rooms that a room may name.
arrow() {
    room=$1
    shift
    allowed=$(echo "$room $*" | tr ' ' '|')
    found=$(grep -rnE '#include "(scene|trace|render|script|assets|view|cli)/' "src/$room" |
        grep -vE "#include \"($allowed)/")
    [ -z "$found" ] && ok "arrows of src/$room" || fail "arrows of src/$room: $found"
}
arrow scene
arrow trace scene
arrow render trace scene
arrow script assets scene
arrow assets scene
arrow view render
arrow worker script assets
arrow lab render trace assets
arrow cli view render script

# without ROOM WORD: a room that must not know a library.
without() {
    found=$(grep -rniE "#include [<\"]$2" "src/$1" "include" | grep -v images_module)
    [ -z "$found" ] && ok "src/$1 knows nothing of $2" || fail "src/$1 knows $2: $found"
}
for room in scene trace render script assets lab cli; do without $room SDL; done
for room in scene trace render assets view lab cli; do without $room 'l(ua|auxlib|ualib)'; done
for room in scene trace; do without $room pthread; done

found=$(grep -rnE '\b(switch|case)\b' src/trace/*.c src/trace/shapes | grep -v '^ *\*')
[ -z "$found" ] && ok 'no switch in the tracer' || fail "a switch in the tracer: $found"
found=$(grep -rnE '\b(float|double)\b' src/trace/shapes/*.c src/trace/lights/direct_lighting.c src/trace/tracer/tracer.c \
    src/trace/materials/material.c | grep -vE '^[^:]*:[0-9]+: *(\*|//|/\*)' | grep -vE '\(double\)|double (radius|r)( |;)|const double (parallel|low)')
[ -z "$found" ] && ok 'the tracer is written over real' || fail "a bare number type in the tracer: $found"
found=$(nm -g --defined-only "$BUILD/obj/engine-f32x4.o" | grep -v ' engine_f32x4$')
[ -z "$found" ] && ok 'an engine shows one symbol' || fail "an engine shows more: $found"
found=$(find src include tests -name '*.[ch]' -exec wc -l {} + | awk '$2 != "total" && $1 > 950')
[ -z "$found" ] && ok 'no file is longer than 950 lines' || fail "long files: $found"
found=$(find src include -name '*.[ch]' -exec wc -l {} + | awk '$2 != "total" && $1 > 420')
[ -z "$found" ] && ok 'no source file is longer than 420 lines' || fail "long files: $found"
finish
