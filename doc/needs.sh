#!/bin/sh
# Writes doc/needs.md: what scenes need, forecast, tried, and checked on a whole picture.
# `make charts` calls it.
set -eu
cd "$(dirname "$0")/.."
BUILD=${BUILD:-build}
# rows SCENE...: a row for each; what takes longer than four minutes of the processor is left out, and said.
rows() {
    for scene in "$@"; do
        (ulimit -t 240 && "$BUILD/bench-needs" "$scene") ||
            echo "| ${scene##*/} | | took longer than four minutes of the processor | | | | | | | |"
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

`make charts` writes this page: each scene 320 pixels wide, one ray per pixel.

*Forecast*: the engine that `--engine auto` takes by the scene's numbers alone, and by how many 8-bit steps float
may be off. *Needed*: what `dioptre needs` finds. *Checked against*: the engine and the size of the picture that all
settings together are compared with: everything on, which is 256 turns of rays, a cutoff of a sixty-fourth of a step or
less, and the finest tolerances. *Worst* and *off*: by how many steps a pixel of that picture differs most, and the share
of its pixels that differ by half a step or more. *Float: worst*, *off*: the same of float against double, all else equal.
*Corrected*: how often the check refuted a setting, which was then made finer. *Double*: its time over that of float. The
[glossary](glossary.md) explains the terms.

*Enough* has one meaning for all settings: at most one pixel in 10,000 is off by half a step or more. Why it is off does
not matter: another shade counts, another thing that a ray meets, and an edge that has moved. Each setting is found by
itself, on a whole picture 160 pixels wide at most. Then all of them are checked together on a larger one. Where that
refutes them, one setting after the other is put back to its finest, and the one with which the fewest pixels are off is
made finer. So the cause that is named is found by experiment.

Pictures of 320 by 240 have 76,800 pixels: seven may be off. What is off in a picture that is not drawn here is not known;
more pixels find rarer faults.

| scene | forecast | needed | checked against | worst | off | float: worst | off | corrected | double |
|---|---|---|---|---|---|---|---|---|---|
END
rows scenes/*.lua
summary >>"$BUILD/needs.md"
cat >>"$BUILD/needs.md" <<'END'

Built to fool the forecast (`tests/scenes/`):

| scene | forecast | needed | checked against | worst | off | float: worst | off | corrected | double |
|---|---|---|---|---|---|---|---|---|---|
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
