#!/bin/sh
# Writes doc/gallery.md from the words that the scenes begin with, and draws its pictures into doc/gallery:
# each as its scene wants it, then made 400 wide. With --page the page is printed instead, and nothing is drawn.
set -eu
cd "$(dirname "$0")/.."
program=${BUILD:-build}/dioptre

# words SCENE: its first paragraph, on one line.
words() { awk '/^-- / { sub(/^-- /, ""); printf "%s%s", gap, $0; gap = " "; next } { exit }' "$1"; }

# table REPORT: a row for each scene that begins with `Report REPORT`; without REPORT, for the others.
table() {
    printf '\n| picture | scene |\n|---|---|\n'
    for scene in scenes/*.lua; do
        name=$(basename "$scene" .lua) shows=$(words "$scene")
        case $shows in
        "Report $1"[,:\ ]*) ;;
        Report\ *) continue ;;
        *) [ -z "$1" ] || continue ;;
        esac
        echo "| ![$name](gallery/$name.jpg) | **$name.** $shows<br>\`build/dioptre view $scene\` |"
    done
}

page() {
    printf '# Gallery\n\nEvery scene of `scenes/`, and the words that it begins with. `make gallery` makes this page.\n'
    printf 'What the rows say stands in the [references](references.md).\n\n## On their own\n'
    table ''
    for report in A B C D; do
        printf '\n## Report %s\n' $report
        table $report
    done
}

if [ "${1:-}" = --page ]; then
    page
    exit
fi
large=$(mktemp --suffix=.png)
trap 'rm -f "$large"' EXIT
mkdir -p doc/gallery
for scene in scenes/*.lua; do
    "$program" render -q "$scene" -o "$large"
    convert "$large" -resize 400x -strip -quality 88 "doc/gallery/$(basename "$scene" .lua).jpg"
done
page >doc/gallery.md
