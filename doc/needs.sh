#!/bin/sh
# Writes doc/needs.md: what scenes need, forecast, tried on a sample of pixels and on all of them.
# `make charts` calls it.
set -eu
cd "$(dirname "$0")/.."
BUILD=${BUILD:-build}
# rows SCENE...: a row for each; what takes longer than two minutes is left out, and said.
rows() {
    for scene in "$@"; do
        timeout 120 "$BUILD/bench-needs" "$scene" || echo "| ${scene##*/} | | took longer than two minutes | | | | | |"
    done >>"$BUILD/needs.md"
}
# summary: what the rows so far say together, in a sentence.
summary() {
    rows=$(grep -E '^\| [^|]*\.lua \| [^ |]' "$BUILD/needs.md")
    double=$(echo "$rows" | grep -cE '^\|[^|]*\|[^|]*\| f64' || true)
    echo "$rows" | sed -E 's/.*\| ([0-9.]+) \|$/\1/' | sort -n | awk -v double="$double" '
        { times[NR] = $1 }
        END {
            printf "\nOver these %d scenes double takes %s to %s times as long as float, in half of them at most %s times. ",
                NR, times[1], times[NR], times[int((NR + 1) / 2)]
            printf "Float is enough for %d of them; %d need double.\n", NR - double, double
        }' | fold -s -w 110 | sed 's/ *$//'
}

cat >"$BUILD/needs.md" <<'END'
# What scenes need

`make charts` writes this page: each scene 320 pixels wide, one ray a pixel against the reference.

*Forecast*: the engine that `--engine auto` takes by the scene's numbers alone, and by how many 8-bit steps float
may be off. *Needed*: what `dioptre needs` finds on a sample of one pixel in 64, and more where shapes end. *Pilot*: by how many
steps that is off at most, and how many rays by half a step or more. *Float, whole picture*: the
same of float, for all pixels: more than 0.01 % off means that double is needed. *Times*: how many times
as long double takes with all rays followed 128 turns deep. Rays that passed an edge on its other side are not
counted, unless the edge is moved by more than 1/64 pixel. The [glossary](glossary.md) explains the terms.

*Enough* has one meaning for each setting. A depth is enough if deeper rays change no
pixel of the sample by half a step. A number type is enough if at most one ray in 10,000 is off by half a step or more,
or goes astray.

The pilot is stricter: its reference also follows rays whose weight is below 0.00015. dioptre ends them there, and no
setting changes that. Some scenes with very bright light and much glass therefore keep rays that are off in the
pilot, although their settings are enough. `dioptre needs` says so in words, and counts these rays.

| scene | forecast | needed | pilot: worst | off | float, whole picture: worst | off | times |
|---|---|---|---|---|---|---|---|
END
rows scenes/*.lua
summary >>"$BUILD/needs.md"
cat >>"$BUILD/needs.md" <<'END'

Built to fool the forecast (`tests/scenes/`):

| scene | forecast | needed | pilot: worst | off | float, whole picture: worst | off | times |
|---|---|---|---|---|---|---|---|
END
rows tests/scenes/*.lua
cat >>"$BUILD/needs.md" <<'END'

In words, `dioptre needs scenes/box.lua`:

```
END
"$BUILD/dioptre" needs scenes/box.lua >>"$BUILD/needs.md"
cat >>"$BUILD/needs.md" <<'END'
```

## What each setting costs

`dioptre chart` changes one setting at a time. Left, the error that the setting is for; right, all errors of the
picture together, and the front: settings that nothing beats in both time and error.

END
for scene in box glass-sphere mandelbulb figure-16; do
    printf '![%s](charts/%s.svg)\n\n' "$scene" "$scene" >>"$BUILD/needs.md"
done
mv "$BUILD/needs.md" doc/needs.md
