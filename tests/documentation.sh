#!/bin/sh
# The documentation is whole and true: Doxygen finds nothing undocumented, and would; the class
# picture, the scene reference, the manual page and the references say what the source says.
. "$(dirname "$0")/check.sh"
unset MAKEFLAGS MAKELEVEL MFLAGS

# agree A B NAME: two lists must be the same; says what only one of them has.
agree() {
    if diff "$1" "$2" >"$work/diff"; then ok "$3"; else fail "$3: $(cat "$work/diff")"; fi
}

# --- make doc, in a copy -------------------------------------------------------------------------
mkdir -p "$work/tree/tests"
cp -r .ci include src doc README.md README.fr.md SECURITY.md Makefile Doxyfile "$work/tree"
html=$work/tree/build/doc/html
if make -C "$work/tree" doc >"$work/log" 2>&1; then
    ok 'make doc finds nothing undocumented'
else
    fail "make doc: $(grep -E 'error|warning' "$work/log" | head -20)"
fi
[ -s "$html/index.html" ] && ok 'there is a first page' || fail 'there is no first page'
[ -s "$work/tree/build/doc/uml.svg" ] && ok 'there is the class picture' || fail 'there is no class picture'
missing=$(grep -rL '@file' include src tests --include='*.[ch]' --include='*.cpp')
[ -z "$missing" ] && ok 'every file says what it is' || fail "files without @file: $missing"

# The classes that say they extend Shape, as Doxygen draws them and as doc/uml.dot does.
classes=$(find src/trace -name '*.c' -exec sed -nE '/@extends Shape/ { n; s/^typedef struct (\w+) \{.*/\1/p }' {} +)
for class in Sphere Plane Quad Box Disk Cylinder Cone Triangle MeshShape SdfShape TransformedShape; do
    echo "$classes" | grep -qx $class && ok "$class says that it extends Shape" || fail "$class does not extend Shape"
done
for class in Shape $classes; do
    holds "$html/structShape__inherit__graph.svg" ">$class<" "Doxygen draws $class"
    holds doc/uml.dot "^ *$class +\[label" "doc/uml.dot has $class"
done
functions=$(find src/trace -name '*.[ch]' -exec awk '/@callgraph/ { f = 1 }
    f && /^[a-z].*\(/ { sub(/\(.*/, ""); print $NF; f = 0 }' {} + | tr -d '*')
[ "$(echo "$functions" | wc -l)" -ge 10 ] && ok 'functions ask for call graphs' || fail "only these ask for a call graph: $functions"
for function in $functions; do
    grep -lqE ">$function<" "$html"/*_cgraph.svg 2>/dev/null && ok "there is the call graph of $function" ||
        fail "there is no call graph of $function"
done
for class in $(sed -nE 's/^ *([A-Z][A-Za-z0-9]*) +\[label.*/\1/p' doc/uml.dot); do
    grep -rqE "struct $class \{" include src && ok "the class $class of the picture is a struct" ||
        fail "$class of doc/uml.dot is no struct of the source"
done

# What must not pass, all of it in one go: it is each line of the log that counts.
cat >>"$work/tree/src/render/engines.c" <<'END'
static int quite_undocumented(int value) { return value; }
/** @return It. @param other Not there. */
static int wrongly_documented(int value) { return value; }
END
echo 'static int in_a_silent_file(int value) { return value; }' >"$work/tree/src/render/silent.c"
printf 'HAVE_DOT = NO\nINPUT = src/render\n' >>"$work/tree/Doxyfile"
if make -C "$work/tree" doc >"$work/log" 2>&1; then fail 'make doc passes undocumented functions'; else ok 'make doc fails on them'; fi
for words in 'quite_undocumented\(int value\).* is not documented' "argument 'other' of command @param is not found" \
    'in_a_silent_file\(int value\).* is not documented'; do
    holds "$work/log" "$words" "make doc says: $words"
done

# --- the scene reference -------------------------------------------------------------------------
objects=$(objects_of src/scene src/base)
# shellcheck disable=SC2086 # a list of files
if ${CC:-cc} -std=gnu11 -Iinclude -Isrc -o "$work/print_keywords" tests/print_keywords.c $objects -lm -pthread 2>"$work/err"; then
    "$work/print_keywords" >"$work/tables"
    sed -n '/^<!-- table: /,/^<!-- end -->$/p' doc/scene-reference.md >"$work/documented"
    agree "$work/documented" "$work/tables" 'doc/scene-reference.md has the keywords as they are'
else
    fail "print_keywords: $(head -3 "$work/err")"
fi
# `ambient` has no table: its range is in its errors.
for value in -1 1e16; do
    printf 'camera {}\nambient(%s)' "$value" >"$work/s.lua"
    expect 3 'ambient must be at least 0 and at most 1e\+15' "ambient($value)" "$dioptre" info "$work/s.lua"
done
tr '\n' ' ' <doc/scene-reference.md >"$work/out"
holds "$work/out" 'each part from 0 to 1e\+15' 'doc/scene-reference.md has the range of ambient'
# The limits of functions of fields, and the note about one that is too steep.
while IFS='|' read -r words file source; do
    holds "$work/out" "$words" "doc/scene-reference.md: $words"
    holds "$file" "$source" "$file: $source"
done <<'END'
from -64 to 64|src/script/sdf_function.c|EXPONENT_MAXIMUM = 64 
at 64 points|src/script/sdf_function.c|CHECKS = 64 
at most 4095 operations|include/dioptre/sdf.h|SDF_NODES_MAXIMUM = 4096 
at most 256 results|include/dioptre/sdf_tape.h|SDF_TAPE_REGISTERS = 256 
finite and at most 1e\+30|include/dioptre/sdf_tape.h|SDF_TAPE_CONSTANT_MAXIMUM 1e30
at 1000 random places|src/scene/sdf_tape_slope.c|PAIRS = 1000,
grows by less than 0.5|include/dioptre/sdf_tape.h|SDF_TAPE_SLOPE_MINIMUM 0.5
divided by 1.05 times|include/dioptre/sdf_tape.h|SDF_TAPE_SLOPE_MARGIN 1.05
END
printf '\n\n\n\n\ncamera {}\nsdf { function(x, y, z) return 3 * math.sqrt(x * x + y * y + z * z) - 1 end }' >"$work/my.lua"
expect 0 '^.*/my.lua:7: ' 'a field that is too steep is noted' "$dioptre" info "$work/my.lua"
note=$(sed 's|.*/my.lua|my.lua|' "$work/err")
grep -qF "    $note" doc/scene-reference.md && ok 'doc/scene-reference.md shows its note' || fail "doc/scene-reference.md has no: $note"

# The actions of lessons: all commands that are recorded, but for `snapshot()` and those that go back.
awk '/^    \{"/{ name = $0; sub(/^ *\{"/, "", name); sub(/".*/, "", name) } /^    /{ rows[name] = rows[name] $0 }
    END { for (name in rows) if (rows[name] !~ /UNRECORDED/ && name !~ / back$/ && name != "snapshot") print name }' \
    src/view/commands/commands.c >"$work/actions"
[ "$(wc -l <"$work/actions")" -gt 50 ] || fail 'the actions of lessons are not found'
while read -r action; do
    grep -qF "\`$action\`" doc/scene-reference.md || fail "doc/scene-reference.md has no action $action"
done <"$work/actions"
ok 'doc/scene-reference.md has the actions of lessons'

# --- the manual page -----------------------------------------------------------------------------
if command -v groff >/dev/null; then
    groff -man -ww -Tutf8 doc/dioptre.1 >/dev/null 2>"$work/err"
    [ ! -s "$work/err" ] && ok 'groff has nothing to say of the manual page' || fail "groff: $(cat "$work/err")"
fi
version=$(sed -n 's/^VERSION *:= *//p' Makefile)
holds doc/dioptre.1 "^\.TH DIOPTRE 1 .*\"dioptre $version\"" 'the manual page is of this version'

# Options: `--name` or `-x --name`, then the commands whose help has it, in the order of the manual.
commands="view render animate probe info compare bench lab needs chart"
for command in $commands; do
    "$dioptre" $command --help | sed -nE 's/^ +(-. )?(--[a-z-]+).*/\1\2/p' >"$work/help-$command"
done
sort -u "$work"/help-* | while read -r option; do
    takers=
    for command in $commands; do
        grep -qxe "$option" "$work/help-$command" && takers="$takers $command"
    done
    case $option in *--help | *--version) takers= ;; esac # Every command takes them.
    echo "$option:$takers"
done | sort >"$work/options"
awk '/^\.SH/ { in_options = $2 == "OPTIONS" }
    !in_options { next }
    /^\.TP/ { if (name) print name ":" takers; name = ""; takers = ""; getline
        line = $0; gsub(/\\-/, "-", line)
        while (match(line, /--?[a-zA-Z][a-z-]*/)) {
            name = name (name ? " " : "") substr(line, RSTART, RLENGTH); line = substr(line, RSTART + RLENGTH) } }
    /^Taken by / { takers = $0; sub(/^Taken by/, "", takers); gsub(/[,.]/, "", takers) }
    END { print name ":" takers }' doc/dioptre.1 >"$work/manual"
sort -o "$work/manual" "$work/manual"
agree "$work/manual" "$work/options" 'the manual page has the options, and who takes them'

# --- the page of the four reports: its figures are those of the tables ------------------------------
doc/reports.sh "$work/reports.md" 2>"$work/err" || fail "doc/reports.sh: $(cat "$work/err")"
same doc/reports.md "$work/reports.md" 'doc/reports.md is what doc/reports.sh makes of the tables'

# --- figures of the READMEs and of the page: those of the tables -------------------------------------
doc/figures.sh "$work" 2>"$work/err" || fail "doc/figures.sh: $(cat "$work/err")"
for document in doc/web.md doc/marching.md; do
    same $document "$work/$document" "$document has the figures of doc/figures"
done
for document in README.md README.fr.md; do
    same $document "$work/$document" "$document has the figures of doc/figures"
    [ "$(grep -c '^<!-- figures: ' $document)" = 6 ] && ok "$document: all six tables" || fail "$document lacks tables"
done

# --- references and the tour ---------------------------------------------------------------------
sed -nE 's/^\| [A-Z][A-Za-z]+ [0-9-]+ \| ([^:]*):.*\| (`src.*) \|$/\1|\2/p' doc/references.md >"$work/papers"
[ "$(wc -l <"$work/papers")" -ge 9 ] && ok 'doc/references.md has its papers' || fail 'papers are not found in doc/references.md'
while IFS='|' read -r authors files; do
    author=$(echo "$authors" | sed 's/,.*//; s/.* //')
    [ "$author" = Commission ] && author=IEC
    for file in $(echo "$files" | tr -d '`,'); do
        holds "$file" "$author" "$file cites $author"
    done
done <"$work/papers"
# The other way round: a title in the source, which may go over two lines, stands in the references.
find src include -name '*.[ch]' -exec cat {} + | sed -E 's/^ \* ?//' | tr '\n' ' ' | tr -s ' ' |
    grep -oE '\([^()]{3,80}, \*[A-Z][^*]{10,90}\*,' | sed -E 's/.*, \*(.*)\*,/\1/' | sort -u >"$work/titles"
while read -r title; do
    holds doc/references.md "$title" "doc/references.md has: $title"
done <"$work/titles"
grep -rnE '\b[Rr]ows? [A-D][0-9]' src include scenes >"$work/out"
[ ! -s "$work/out" ] && ok 'no comment names a row of a table of doc/references.md' || fail "rows: $(cat "$work/out")"
for name in $(grep -ohE '`[a-z_0-9]+\(\)`' doc/tour.md | tr -d '`()' | sort -u); do
    grep -rqE "\b$name\)?\(" src include || fail "$name() of doc/tour.md is not in the source"
done
ok 'the functions of doc/tour.md were looked up'
grep -rnE 'numerics\.md|bvh\.md|research/|/[a-z]*ork/' README.md doc src include scenes >"$work/out"
[ ! -s "$work/out" ] && ok 'nothing refers to what is not here' || fail "dangling: $(cat "$work/out")"
finish
