#!/bin/sh
# needs and chart, as a person uses them: words, JSON, files, and what can go wrong.
. "$(dirname "$0")/check.sh"
small='-s 192x144 --samples 2'

# shellcheck disable=SC2086 # several words
{
    expect 0 '' 'needs of the box' "$dioptre" needs scenes/box.lua $small
    holds "$work/out" '^engine +f32' 'the box needs float'
    holds "$work/out" 'Float is enough' 'needs explains itself'
    expect 0 '' 'needs as JSON' "$dioptre" needs scenes/box.lua $small --json
    holds "$work/out" '"engine": "f32.*"depth": [0-9]+.*"worst_step": .*"explanation": "Float' 'the JSON has its names'
    expect 0 '' 'needs of a ground of a million units' "$dioptre" needs tests/scenes/ground-sphere.lua $small
    holds "$work/out" '^engine +f64' 'it needs double'
    expect 0 '' 'auto draws it so' "$dioptre" info tests/scenes/ground-sphere.lua --engine auto
    holds "$work/out" '^engine +f64' 'auto takes double'
    expect 0 '' 'an engine that is asked for is taken' "$dioptre" info tests/scenes/ground-sphere.lua --engine f32x4
    holds "$work/out" '^engine +f32x4' 'f32x4 was asked for'
    # Of figure-16 and teapot float has 0.02 and 0.014 % wrong; painted-cow is near the bound by its numbers.
    for scene in chess report-d-pictures glass-teapot figure-16 teapot painted-cow; do
        case $scene in
        glass-teapot) words=':15: glass with smooth normals' ;;
        *) words='' ;;
        esac
        expect 0 "$words" "forecast of $scene" "$dioptre" info "scenes/$scene.lua"
        holds "$work/out" '^engine +f64' "$scene is drawn in double"
    done
    for scene in cow figure-12 figure-13 glass-of-water earth; do
        expect 0 '' "forecast of $scene" "$dioptre" info "scenes/$scene.lua"
        holds "$work/out" '^engine +f32' "$scene is drawn in float"
    done
    expect 0 '' 'needs of a sponge' "$dioptre" needs scenes/menger-sponge.lua -s 96x72 --json
    # Its coarser tolerances move edges: they are neither proposed nor called worth 0 steps.
    holds "$work/out" '"tolerance": (1|0\.[0-9]+),' 'the sponge keeps its tolerance'
    holds "$work/out" 'times as coarse, [1-9][0-9]* would be off' 'the sponge says what coarser ones do'
    # unfold: the report in one line, wherever its lines broke.
    unfold() { tr '\n' ' ' <"$work/out" >"$work/line" && mv "$work/line" "$work/out"; }
    expect 0 '' 'needs of few rays' "$dioptre" needs scenes/box.lua -s 96x72 --samples 4
    unfold
    holds "$work/out" 'can be told from a better one by its noise' 'noise that is seen is said'
    grep -qE 'nothing that can be seen|fewer than 1 in' "$work/out" && fail 'it says that nothing is seen' || ok 'it does not say that nothing is seen'
    expect 0 '' 'needs for a large error' "$dioptre" needs scenes/box.lua -s 96x72 --samples 1 --error 64
    holds "$work/out" 'off by 64 steps or more' 'the error is the one asked for'
    holds "$work/out" '^samples +(4|16)$' 'more rays are proposed where they are enough'
    expect 0 '' 'the best picture within a time' "$dioptre" needs scenes/box.lua -s 96x72 --budget 10000
    holds "$work/out" '^samples +(8|12|16|24|32|48|64)$' 'it has many rays per pixel'
    holds "$work/out" '^error +[0-9].*root mean square' 'its error is said'
    expect 0 '' 'a time that nothing meets' "$dioptre" needs scenes/box.lua -s 96x72 --budget 0.0001
    holds "$work/out" 'No settings draw this picture within 0.0001 ms: these are the fastest' 'it says so'
    expect 0 '' 'a budget as JSON' "$dioptre" needs scenes/box.lua -s 96x72 --budget 0.0001 --json
    holds "$work/out" '"budget": \{"milliseconds": 0.0001, "is_met": false, "engine": ' 'the JSON says so'
    expect 2 'error.*or --budget, not both' 'both directions at once' "$dioptre" needs scenes/box.lua --error 1 --budget 5
    for value in 0 -1 nan 1e9 x; do
        expect 2 'number above 0, at most 8.64e\+07' "a budget of $value" "$dioptre" needs scenes/box.lua --budget "$value"
        expect 2 'number above 0, at most 255' "an error of $value" "$dioptre" needs scenes/box.lua --error "$value"
    done
    expect 3 'nowhere.lua' 'needs without its scene' "$dioptre" needs nowhere.lua
    expect 2 'usage' 'needs of nothing' "$dioptre" needs

    expect 0 '' 'a chart' "$dioptre" chart scenes/figure-08.lua --out "$work/charts" $small
    for column in group setting seconds own_rms total_rms; do
        holds "$work/charts/figure-08.csv" "(^|,)$column(,|\$)" "the CSV has $column"
    done
    holds "$work/charts/figure-08.csv" '^# .*(gcc|clang|GCC)' 'the CSV says how it was made'
    holds "$work/charts/figure-08.csv" '^engine,all,f64x1,' 'the CSV has the engines'
    holds "$work/charts/figure-08.csv" '^front,' 'the CSV has the front'
    expect 0 '' 'a chart of chess' "$dioptre" chart scenes/chess.lua --out "$work/charts" -s 192x144 --samples 1
    awk -F, '$1 == "group" { for (i = 1; i <= NF; i++) if ($i == "rounding") column = i }
        $3 == "f32x8" || $3 == "f32x4" { single = $column } $3 == "f64x1" { twofold = $column }
        END { exit !(single > 0.001 && single < 0.01 && twofold == 0) }' "$work/charts/chess.csv" &&
        ok 'the CSV says what hangs on the last bit' || fail 'what hangs on the last bit'
    holds "$work/charts/figure-08.svg" '</svg>' 'there is the SVG'
    mkdir -p "$work/same" && cp scenes/box.lua "$work/same/figure-08.lua"
    expect 2 'would have the same figure-08.csv' 'two scenes of one name' "$dioptre" chart scenes/figure-08.lua "$work/same/figure-08.lua" --out "$work/charts"
    expect 2 'chart needs --out' 'chart without a folder' "$dioptre" chart scenes/box.lua
    touch "$work/file"
    expect 1 'no folder|cannot make' 'a file for a folder' "$dioptre" chart scenes/box.lua --out "$work/file"
    expect 3 'nowhere.lua' 'a scene that is not there' "$dioptre" chart scenes/figure-08.lua nowhere.lua --out "$work/kept" $small
    [ -s "$work/kept/figure-08.csv" ] && ok 'what is finished is kept' || fail 'what is finished is kept'
    mkdir "$work/bin"
    expect 1 'gnuplot-nox' 'a chart without gnuplot' env PATH="$work/bin" "$dioptre" chart scenes/figure-08.lua --out "$work/bare" $small
    [ -s "$work/bare/figure-08.csv" ] && ok 'its CSV is written' || fail 'its CSV is written'
    # Without mirrors the ball is a step of dozens off: a chart of few pixels must meet it.
    expect 0 '' 'a chart of 16 x 12 pixels' "$dioptre" chart scenes/box.lua --out "$work/few" -s 16x12 -q
    awk -F, '$3 == "depth 0" { seen = $8 > 10 } END { exit !seen }' "$work/few/box.csv" &&
        ok 'few pixels show that a mirror is missing' || fail 'few pixels hide that a mirror is missing'
    expect 2 'too few pixels' 'a picture of one pixel' "$dioptre" chart scenes/figure-08.lua --out "$work/one" -s 1x1

    expect 0 '' 'a chart of methods' "$dioptre" chart --kernels fresnel-into --out "$work/kernels"
    csv=$work/kernels/kernel-fresnel-into.csv
    holds "$work/out" '^Schlick +float +[0-9]' 'its table has a row for each method and number type'
    for words in '^# compiler: .*flags: .*-ffp-contract=off' '^# processor:' \
        '^method,type,stress,ns,ns_low,ns_high,error_p999,error_max,failures,double_hits,front$' \
        '^(exact|exact by both shares|dioptre),double,5,[0-9].*,(1|0[.]5)$' '^exact,quad,5,[0-9]'; do
        holds "$csv" "$words" "its CSV has: $words"
    done
    awk -F, '/^#/ || /^method/ { next } { rows++; if (!($5 > 0 && $5 <= $4 && $4 <= $6)) bad = 1 } END { exit bad || rows < 12 }' "$csv" &&
        ok 'times are above 0, quartiles around them' || fail 'times of methods'
    # Whatever the clock says, a method that is less exact than another is of the front only if it is faster, by
    # more than the quartiles of both.
    awk -F, '/^#/ || /^method/ || $2 == "quad" { next } { n++; t[n] = $4; low[n] = $5; high[n] = $6; e[n] = $7; f[n] = $11 }
        END { for (i = 1; i <= n; i++) { best = 1
            for (k = 1; k <= n; k++) { alike = low[k] <= high[i] && low[i] <= high[k]
                beats = (t[k] < t[i] && e[k] <= e[i]) || (t[k] <= t[i] && e[k] < e[i])
                if (alike && e[k] < e[i] || !alike && beats) best = 0
                if (alike && e[k] == e[i] && beats && best) best = 0.5 }
            if (best != f[i]) exit 1 } }' "$csv" && ok 'the front is what nothing beats' || fail 'the front'
    if command -v gnuplot >/dev/null; then
        for words in '</svg>' 'nanoseconds per test' '>front: '; do
            holds "$work/kernels/kernel-fresnel-into.svg" "$words" "its chart has: $words"
        done
    fi
    expect 2 'there is no test .nonsense.; there are ' 'a chart of an unknown method' "$dioptre" chart --kernels nonsense --out "$work/none"
    expect 2 'timed in another test' 'a test that is not timed' "$dioptre" chart --kernels sphere-world --out "$work/none"
    [ ! -e "$work/none" ] && ok 'neither makes a folder' || fail 'a wrong name makes a folder'
    expect 2 'needs a scene, or --kernels' 'a chart of nothing' "$dioptre" chart --out "$work/none"
    expect 1 'gnuplot-nox' 'methods without gnuplot' env PATH="$work/bin" "$dioptre" chart --kernels fresnel-into --out "$work/bare" -q
    [ -s "$work/bare/kernel-fresnel-into.csv" ] && ok 'their CSV is written' || fail 'their CSV is written'
    # With --preserve-status, what counts is how the program ended, not that it was told to.
    timeout --preserve-status -s INT 2 "$dioptre" chart scenes/figure-08.lua scenes/chess.lua --out "$work/stopped" $small >/dev/null 2>"$work/err"
    status=$?
    [ $status = 130 ] && ok 'an interrupted chart says so' || fail "interrupted: status $status"
    [ ! -e "$work/stopped/chess.csv" ] && ok 'and leaves nothing half-written' || fail 'half a chart is left'
}
finish
