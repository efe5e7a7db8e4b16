#!/bin/bash
# French and English: every message has its French, the language is the one that was asked for, and no
# number depends on it. tests/window.sh asks the window.
. "$(dirname "$0")/check.sh"
box=scenes/box.lua

# in_french COMMAND...: runs a command as on a system that knows no French locale.
in_french() { env LC_ALL= LANG=fr_FR.UTF-8 "$@"; }
# empty FILE NAME: nothing must have been found.
empty() { [ ! -s "$1" ] && ok "$2" || fail "$2: $(head -5 "$1")"; }

# --- translations ------------------------------------------------------------------------------------
cp -r src/po "$work/po"
expect 0 '' 'make pot' make -s PO="$work/po" pot
same src/po/dioptre.pot "$work/po/dioptre.pot" 'src/po/dioptre.pot has the words of the source (make pot)'
for po in src/po/*.po; do
    expect 0 '' "$po has all of them (make pot, then translate)" msgcmp "$po" "$work/po/dioptre.pot"
    expect 0 '' "$po fits their formats" msgfmt --check -o /dev/null "$po"
    msgattrib --only-obsolete "$po" >"$work/out"
    empty "$work/out" "$po has nothing that is gone"
done
# A no-break space is shown as ~: it belongs before : ; ? ! % and within « ».
# Lines of one message are joined.
msgcat --no-wrap src/po/fr.po | sed -z 's/"\n"//g' | sed '1,/^$/d; s/\xC2\xA0/~/g; s/dioptre: //; s/%z*[sdu]: *//g' | grep '^msgstr' >"$work/french"
grep -E "( |^\")[;:?!]( |\"|\\\\n)|[^~ .][;?!]( |\"|\\\\n)|[a-z]:( |\")|'%[0-9]*s'|« | »" "$work/french" >"$work/out"
{ grep -E '%[0-9.]*[a-z]+ %%' "$work/french"; grep -nE '\bfr = ".*[0-9] %' scenes/*.lua scenes/lessons/*.lua; } >>"$work/out"
empty "$work/out" 'French signs have their no-break space'
{ grep "'" "$work/french"; grep -nE "\\bfr = \"[^\"]*'|^-- fr( name)?: .*'" scenes/*.lua scenes/lessons/*.lua; } >"$work/out"
empty "$work/out" "French apostrophes are typographic: ’"
for scene in scenes/*.lua scenes/lessons/*.lua; do
    grep -q '^lesson {' "$scene" || for language in en fr; do
        grep -q "^-- $language: " "$scene" || echo "$scene $language"
    done
done >"$work/out"
for scene in scenes/*.lua scenes/lessons/*.lua; do
    grep -q '^lesson {' "$scene" || grep -q '^-- fr name: ' "$scene" || echo "$scene"
done >>"$work/out"
empty "$work/out" 'scenes are described in both languages, and have a French name'

# --- help --------------------------------------------------------------------------------------------
for command in '' view render animate probe info compare bench needs chart lab; do
    # shellcheck disable=SC2086 # no command is no word
    "$dioptre" $command --help | sort -u >"$work/a"
    # shellcheck disable=SC2086
    in_french "$dioptre" $command --help | sort -u >"$work/b"
    [ "$(wc -l <"$work/a")" -gt 5 ] && [ "$(wc -l <"$work/b")" -gt 5 ] || fail "dioptre $command --help says nothing"
    comm -12 "$work/a" "$work/b" | grep -v '^$' >"$work/out"
    empty "$work/out" "dioptre $command --help has no line that is not French"
done

# --- which language ----------------------------------------------------------------------------------
# speaks WORDS NAME VARIABLE=VALUE...: what the program says of a file that is not there.
speaks() {
    words=$1 name=$2
    shift 2
    expect 3 "^dioptre: none.lua: $words\$" "$name" env -u LC_ALL -u LC_MESSAGES -u LANG -u LANGUAGE "$@" "$dioptre" info none.lua
}
english='No such file or directory' french='aucun fichier ni dossier de ce nom'
speaks "$english" 'nothing is asked for: English' X=
speaks "$french" 'LANG=fr_FR.UTF-8' LANG=fr_FR.UTF-8
speaks "$french" 'LANG=fr_CH' LANG=fr_CH
speaks "$french" 'LC_ALL=fr' LC_ALL=fr
speaks "$french" 'LANGUAGE=fr alone' LANGUAGE=fr
speaks "$french" 'LANGUAGE=fr where there is only C.UTF-8' LC_ALL=C.UTF-8 LANGUAGE=fr
speaks "$french" 'French after what the program does not speak' LANG=de_CH.UTF-8 LANGUAGE=de_CH:de:fr:en
speaks "$french" 'LC_MESSAGES before LANG' LANG=en_US.UTF-8 LC_MESSAGES=fr_FR.UTF-8
speaks "$english" 'LC_ALL before both' LANG=fr_FR.UTF-8 LC_MESSAGES=fr_FR.UTF-8 LC_ALL=en_US.UTF-8
speaks "$english" 'English before French' LANG=fr_FR.UTF-8 LANGUAGE=en_GB:fr
speaks "$english" 'LC_ALL=C is English, whatever else is set' LC_ALL=C LANG=fr_FR.UTF-8 LANGUAGE=fr
speaks "$english" 'a language that begins like French is none' LANG=fry_NL
speaks "$english" 'a language that the program does not speak' LANG=de_DE.UTF-8

# --- errors ------------------------------------------------------------------------------------------
# wrong SCENE ENGLISH FRENCH: what is said of a scene, in both.
wrong() {
    echo "$1" >"$work/wrong.lua"
    expect 3 "/wrong.lua:1: $2\$" "English: $1" "$dioptre" info "$work/wrong.lua"
    expect 3 "/wrong.lua:1: $3\$" "French: $1" in_french "$dioptre" info "$work/wrong.lua"
}
s=$(printf '\302\240')
wrong 'camera {} sphere { raduis = 1 }' 'sphere has no field `raduis`; did you mean `radius`\?' \
    "sphere n’a pas de champ \`raduis\`$s; vouliez-vous dire \`radius\`$s\\?"
wrong 'camera {} sphere { radius = -0.5 }' 'radius must be at least 1e-15 and at most 1e\+15, not -0.5' \
    "radius doit être d’au moins 1e-15 et d’au plus 1e\\+15, et non -0.5"
wrong 'camera {} sphere { radius = {} }' 'radius must be a number, not a table' \
    'radius doit être un nombre, et non une table'
wrong 'camera {} light { falloff = "x" }' 'falloff must be `none`, `inverse_square` or `inverse_linear`, not `x`' \
    'falloff doit être `none`, `inverse_square` ou `inverse_linear`, et non `x`'
wrong 'camera {} mesh { file = "x.doc" }' "x.doc: No such file in the scene's folder; .*" "x.doc: ce fichier n’est pas dans le dossier de la scène$s; .*"
expect 2 "attend un entier de 1 à 65536, et non «${s}0$s»" 'wrong usage' \
    in_french "$dioptre" render "$box" -o x.bmp --samples 0
expect 2 '^dioptre: ' 'which is told by the program' in_french "$dioptre" render "$box"
holds "$work/err" 'render demande -o FICHIER' 'in French'

# --- numbers -----------------------------------------------------------------------------------------
# A locale whose decimal sign is a comma, for this program alone.
if localedef -i fr_FR -f UTF-8 "$work/fr_FR.UTF-8" 2>"$work/err"; then
    comma() { env LOCPATH="$work" LANG=fr_FR.UTF-8 LC_ALL=fr_FR.UTF-8 "$@"; }
    [ "$(comma printf %.1f 0,5)" = 0,5 ] && ok 'there is a locale with a decimal comma' || fail 'no decimal comma'
else
    comma() { env LC_ALL=fr_FR.UTF-8 "$@"; }
    echo 'skipped: localedef makes no French locale here'
fi
for scene in earth twins cow; do
    "$dioptre" info "scenes/$scene.lua" --json >"$work/a"
    comma "$dioptre" info "scenes/$scene.lua" --json >"$work/b"
    same "$work/a" "$work/b" "$scene: JSON is the same"
    "$dioptre" render "scenes/$scene.lua" -s 40x30 -t 0.5 -o "$work/a.png"
    comma "$dioptre" render "scenes/$scene.lua" -s 40x30 -t 0.5 -o "$work/b.png"
    same "$work/a.png" "$work/b.png" "$scene: the picture and its notes are the same"
done
echo 'camera { fov = tonumber("45.5") } print(0.5, string.format("%.2f", 1.5), tonumber("0,5"), ("É"):upper())' >"$work/s.lua"
"$dioptre" info "$work/s.lua" >"$work/out" 2>"$work/a"
comma "$dioptre" info "$work/s.lua" >"$work/out" 2>"$work/b"
same "$work/a" "$work/b" 'Lua reads and writes the same numbers'
holds "$work/b" '^0.5	1.50	nil' 'with points'
holds "$work/out" '^formes  ' 'in French'
comma "$dioptre" bench "$box" -s 40x30 --frames 1 >"$work/out"
holds "$work/out" '[0-9]\.[0-9]{2}.*ms' 'messages have points, too'

# --- installed ---------------------------------------------------------------------------------------
there=$work/there/usr
expect 0 '' 'make install' make -s BUILD="$BUILD" PREFIX=/usr DESTDIR="$work/there" install
in_french "$there/bin/dioptre" --help >"$work/out"
holds "$work/out" 'lancer de rayons' 'the installed program finds its words'
cmp -s doc/dioptre.fr.1 "$there/share/man/fr/man1/dioptre.1" && ok 'the manual page in French' || fail 'no French manual page'

# --- documents ---------------------------------------------------------------------------------------
# The two languages must have the same options, signs, code and figures.
# options WORDS FILE: options of a manual page, with who takes them: the lines that begin with the words.
options() { sed -nE "s/\\\\-/-/g; s/^\.BR? (.*--.*)/\1/p; s/^$1 (.*)/taken \1/p" "$2" | grep -oE -- '--?[a-z]+(-[a-z]+)*|taken .*'; }
options 'Taken by' doc/dioptre.1 >"$work/a"
options 'Prise par' doc/dioptre.fr.1 >"$work/b"
diff "$work/a" "$work/b" >"$work/out"
empty "$work/out" 'the manual pages have the same options'
[ "$(wc -l <"$work/a")" -gt 40 ] && ok 'which were found' || fail 'no options found'
for macro in SH TP PP EX; do
    [ "$(grep -c "^\.$macro" doc/dioptre.1)" = "$(grep -c "^\.$macro" doc/dioptre.fr.1)" ] && ok "manual pages: as many $macro" ||
        fail "manual pages: another number of $macro"
done
version=$(sed -n 's/^VERSION *:= *//p' Makefile)
holds doc/dioptre.fr.1 "^\.TH DIOPTRE 1 .*\"dioptre $version\"" 'the French manual page is of this version'
if command -v groff >/dev/null; then
    groff -K utf8 -man -ww -Tutf8 doc/dioptre.fr.1 >/dev/null 2>"$work/err"
    empty "$work/err" 'groff has nothing to say of it'
fi
# code FILE: the blocks of code, without what is said of it. figures FILE: all numbers, in order of size.
code() { awk '/^```/ { f = !f } f' "$1" | sed 's/ *#.*//'; }
figures() { sed 's/\xC2\xA0/ /g' "$1" | tr ',' '.' | grep -oE '[0-9]+(\.[0-9]+)?' | sort; }
outline() { grep -oE '^(#+ |\| *`[^|]*|\||!\[|[0-9]\.)' "$1" | sed 's/ *$//'; }
for what in code figures outline; do
    $what README.md >"$work/a"
    $what README.fr.md >"$work/b"
    diff "$work/a" "$work/b" >"$work/out"
    empty "$work/out" "README.md and README.fr.md have the same $what"
done
finish
