#!/bin/sh
# README.md is true: its commands work, its scene is drawn, its files and targets exist, its picture
# is what the program draws.
. "$(dirname "$0")/check.sh"
unset MAKEFLAGS MAKELEVEL MFLAGS

# blocks LANGUAGE FILE: the lines of a document's blocks of code in a language.
blocks() { awk -v fence="^\`\`\`$1\$" '$0 ~ fence { f = 1; next } /^```/ { f = 0 } f' "$2"; }

# The commands run in a copy of what they read, where the program is called as README calls it.
mkdir -p "$work/tree/build"
cp -r scenes doc "$work/tree"
ln -s "$dioptre" "$work/tree/build/dioptre"

blocks sh README.md | sed 's/ *#.*//' | sort | uniq -d >"$work/out"
[ ! -s "$work/out" ] && ok 'no command stands there twice' || fail "twice: $(cat "$work/out")"
blocks sh README.md >"$work/commands"
for command in 'make run' 'make test' 'build/dioptre view' 'build/dioptre render' \
    'build/dioptre info' 'build/dioptre compare' 'build/dioptre bench'; do
    holds "$work/commands" "^$command" "README has $command"
done
while read -r line; do
    command=$(echo "${line%%#*}" | sed 's/ *$//')
    case $command in
    'build/dioptre view '*)
        scene=$(echo "$command" | awk '{ print $3 }')
        [ -f "$scene" ] && ok "the scene of: $command" || fail "no scene: $command"
        ;;
    'build/dioptre '*)
        expect 0 '' "$command" sh -c "cd '$work/tree' && exec $command"
        ;;
    make | 'make '*)
        # shellcheck disable=SC2086 # a command and its arguments
        ${command} -n >"$work/out" 2>"$work/err" </dev/null && ok "there is $command" ||
            fail "$command: $(tail -1 "$work/err")"
        ;;
    '') ;;
    *) fail "neither make nor build/dioptre: $command" ;;
    esac
done <"$work/commands"

# Scenes in documents: each block is a scene of its own.
for document in README.md doc/scene-reference.md; do
    rm -f "$work"/block-*.lua
    awk -v base="$work/block-" '/^```lua$/ { f = 1; n++; next } /^```/ { f = 0 }
        f { print > (base n ".lua") }' $document
    for scene in "$work"/block-*.lua; do
        expect 0 '' "a scene of $document is drawn" "$dioptre" render "$scene" -o "$work/o.bmp" -s 40x30
    done
done

# What documents name in backticks or link to must be there.
for document in README.md doc/*.md; do
    folder=$(dirname $document)
    missing=
    for path in $(grep -oE '`(src|include|doc|tests|scenes)/[^` ]*`' $document | tr -d '`' | sort -u); do
        [ -e "$path" ] || missing="$missing $path"
    done
    for path in $(grep -oE '\]\([^):]*\)' $document | sed 's/^](//; s/[)#].*//' | sort -u); do
        [ -e "$folder/$path" ] || missing="$missing $path"
    done
    [ -z "$missing" ] && ok "the files that $document names are there" || fail "$document names$missing"
done

# Every scene is named, and drawn.
for scene in scenes/*.lua; do
    holds README.md "^\|.*\`${scene##*/}\`" "README names $scene"
    expect 0 '' "$scene is drawn" "$dioptre" render "$scene" -o "$work/o.bmp" -s 80x60 --samples 1
done

# README's picture of the box is the box.
expect 0 '' 'the box is drawn' "$dioptre" render scenes/box.lua -o "$work/box.png" -s 640x480
expect 0 '' 'doc/box.png is the box' "$dioptre" compare doc/box.png "$work/box.png" --threshold 1

holds README.md '^MIT' 'README names the licence'
if grep -q '@[A-Z]*@' README.md; then fail 'README has a placeholder'; else ok 'README has no placeholder'; fi
finish
