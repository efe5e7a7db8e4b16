#!/bin/sh
# The rules of the house that a machine can check: which room uses which (doc/design.md), what each
# room must not know, and how the tracer is written.
. "$(dirname "$0")/check.sh"

# empty NAME FOUND: nothing must have been found.
empty() { [ -z "$2" ] && ok "$1" || fail "$1: $2"; }

# --- rooms -------------------------------------------------------------------------------------------
# The table of doc/design.md, as lines `ROOM ROOM...`: a room, then those that it may use.
sed -nE 's/^\| `src\/([a-z]+)\/` \|.*\| ([a-z, –]+) \|$/\1 \2/p' doc/design.md | tr -d ',–' >"$work/rooms"
rooms=$(awk '{ print $1 }' "$work/rooms")
sed 's/^\([a-z]*\)/\1 may use:/' "$work/rooms"
for folder in src/*/; do
    room=$(basename "$folder")
    find "$folder" -name '*.c' | grep -q . || continue
    grep -q "^$room\b" "$work/rooms" && ok "doc/design.md has the room $room" || fail "doc/design.md has no room $room"
done
# A room uses only those above it in the table, so arrows never run in a circle.
empty 'no arrow runs backwards' "$(awk '{ for (i = 2; i <= NF; i++) if (!($i in above)) print $1 " -> " $i; above[$1] = 1 }' "$work/rooms")"

# uses SYMBOLS: lines `ROOM USED WHAT`, without those that the table allows.
uses() {
    awk 'NR == FNR { for (i = 1; i <= NF; i++) allowed[$1, $i] = 1; next } !(($1, $2) in allowed)' "$work/rooms" "$1" | sort -u
}
# What a room's files include.
for room in $rooms; do
    grep -rhoE "#include \"($(echo "$rooms" | tr '\n' '|')none)/[^\"]*" "src/$room" |
        sed -E "s|#include \"(([a-z]+)/.*)|$room \2 \1|"
done >"$work/includes"
empty 'rooms include what they may' "$(uses "$work/includes")"
# What a room's objects call, whatever header declares it: each symbol belongs to the room that defines it.
for room in $rooms; do
    objects=$(objects_of "src/$room")
    case $room in
    trace) objects=$(ls "$BUILD"/obj/engine-*.o) ;;
    lab) objects="$objects $(ls "$BUILD"/obj/type-*.o)" ;;
    esac
    # shellcheck disable=SC2086 # a list of files
    [ -n "$objects" ] && nm $objects | awk -v room="$room" '$1 == "U" { print "uses", room, $2 } $2 ~ /^[TDRBVWC]$/ { print "has", room, $3 }'
done | sort -u >"$work/symbols"
[ "$(wc -l <"$work/symbols")" -gt 500 ] && ok 'the objects have their symbols' || fail 'there are no objects to look at'
awk '$1 == "has" { room[$3] = $2; next } ($3 in room) && room[$3] != $2 { print $2, room[$3], $3 }' "$work/symbols" >"$work/calls"
empty 'rooms call what they may' "$(uses "$work/calls")"
empty 'public headers include no other room than base' "$(grep -nE '#include "' include/dioptre/*.h | grep -vE '"(dioptre|base)/')"
# Each file is compiled: one file names them all for the compiler (Makefile).
for all in src/trace/all.c src/lab/methods/all.c; do
    find "$(dirname $all)" -name '*.c' ! -path $all | sed 's|^src/||' | sort >"$work/there"
    sed -nE 's/^#include "(.*\.c)"$/\1/p' $all | sort >"$work/listed"
    empty "$all lists every file once" "$(diff "$work/there" "$work/listed")"
done

# --- what rooms must not know --------------------------------------------------------------------------
# without LIBRARY ROOM...: rooms that must not include it; nor may what they offer.
without() {
    library=$1
    shift
    for room in "$@"; do
        empty "src/$room knows nothing of $library" "$(grep -rniE "#include [<\"]$library" "src/$room" include)"
    done
}
without SDL base scene trace render script assets lab cli
without 'l(ua|auxlib|ualib)' base scene trace render assets view lab cli
without pthread scene trace

# --- the tracer ----------------------------------------------------------------------------------------
empty 'no switch in the tracer' "$(grep -rnE '\b(switch|case)\b' src/trace --include='*.[ch]' | grep -vE ':[0-9]+: *(\*|//|/\*)')"
empty 'the tracer is written over real' "$(grep -nE '\b(float|double)\b' src/trace/shapes/*.c src/trace/lights/direct_lighting.c \
    src/trace/tracer/tracer.c src/trace/materials/material.c | grep -vE '^[^:]*:[0-9]+: *(\*|//|/\*)' |
    grep -vE '\(double\)|double (radius|r)( |;)|const double (parallel|low|high)')"
for object in "$BUILD"/obj/engine-*.o; do
    engine=$(basename "$object" .o | tr - _)
    empty "$engine shows one symbol" "$(nm -g --defined-only "$object" | grep -v " $engine$")"
done
finish
