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
for command in 'make run' 'make test' 'build/dioptre view' 'build/dioptre render' 'build/dioptre animate' \
    'build/dioptre probe' 'build/dioptre info' 'build/dioptre compare' 'build/dioptre bench' 'build/dioptre needs' \
    'build/dioptre chart'; do
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
    'mkdir '*) (cd "$work/tree" && $command) ;;
    'make web' | 'make test-web' | 'make cross')
        # What they compile is fetched first: the makes that they start are left out.
        ${command} -n MAKE=true >"$work/out" 2>"$work/err" </dev/null && ok "there is $command" ||
            fail "$command: $(tail -1 "$work/err")"
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
for document in README.md README.fr.md doc/*.md; do
    folder=$(dirname $document)
    missing=
    for path in $(grep -oE '`(src|include|doc|tests|scenes)/[^` ]*`' $document | grep -vE 'NAME|QUESTION' | tr -d '`' | sort -u); do
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
done

# Every scene is in the gallery, in its own words, and is what the gallery shows. One ray per pixel gives
# rough edges and hard shadows; 40 wide, 34 decibels are left in the worst scene. A sun of another colour
# leaves 31. Lights as large as walls want soft shadows before they look alike.
doc/gallery.sh --page >"$work/gallery.md"
same doc/gallery.md "$work/gallery.md" 'doc/gallery.md is what make gallery would write'
for scene in scenes/*.lua; do
    shown=doc/gallery/$(basename "$scene" .lua).jpg
    holds doc/gallery.md "\]\(gallery/${shown##*/}\)" "the gallery has $scene"
    size=$(identify -format '%wx%h' "$shown")
    case $scene in
    */rectangle-light.lua | */cylinder-light.lua) samples=16 ;;
    *) samples=1 ;;
    esac
    # -q: pixels of the glass of water may lack light, and the program says so.
    expect 0 '' "$scene is drawn" "$dioptre" render "$scene" -q -o "$work/o.bmp" -s "$size" --samples $samples
    convert "$work/o.bmp" -resize 40x "$work/now.bmp"
    convert "$shown" -resize 40x "$work/then.bmp"
    "$dioptre" compare "$work/then.bmp" "$work/now.bmp" --threshold 255 --json >"$work/out"
    awk -F'"psnr": ' '{ exit !($2 + 0 >= 33) }' "$work/out" && ok "$shown shows $scene" || fail "$shown: $(cat "$work/out")"
done
for shown in doc/gallery/*; do
    [ -f "scenes/$(basename "$shown" .jpg).lua" ] && ok "$shown has its scene" || fail "$shown has no scene"
done

# Every still figure of the reports has a scene that says so in its first line.
head -qn 1 scenes/*.lua >"$work/out"
for figure in 7 8 9 12 13 16 18 19; do
    holds "$work/out" "^-- Report A, figure $figure: " "report A's figure $figure has a scene"
done
for words in 'C, figures 2 and 3' 'C, figures 4 and 5' 'D, its result "divers objets"' 'D, its result "textures"' \
    'D, its result "réfraction"' 'D, its results "miroirs"' 'D, its result "lumière"' 'D, its light modes'; do
    holds "$work/out" "^-- Report $words" "report $words: there is a scene"
done

# README's picture of the box is the box.
expect 0 '' 'the box is drawn' "$dioptre" render scenes/box.lua -o "$work/box.png" -s 640x480
expect 0 '' 'doc/box.png is the box' "$dioptre" compare doc/box.png "$work/box.png" --threshold 1

holds README.md '^MIT' 'README names the licence'
if grep -q '@[A-Z]*@' README.md; then fail 'README has a placeholder'; else ok 'README has no placeholder'; fi
finish
