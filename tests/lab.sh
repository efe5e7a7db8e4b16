#!/bin/sh
# The laboratory, as a person uses it: tables, files, and what can go wrong.
. "$(dirname "$0")/check.sh"

expect 2 'needs --out' 'lab without a folder' "$dioptre" lab field-cells
expect 2 'did you mean .sphere-scale.\?; there are sphere-distance, ' 'a misspelt test' \
    "$dioptre" lab sphere-scael --out "$work/none"
expect 2 'there are ' 'an unknown test' "$dioptre" lab nonsense --out "$work/none"
[ ! -e "$work/none" ] && ok 'a misspelt test makes no folder' || fail 'a misspelt test makes a folder'
: >"$work/file"
expect 1 'cannot make the folder' 'a folder in a file' "$dioptre" lab field-cells --out "$work/file/inner"
expect 1 'is no folder' 'a file for a folder' "$dioptre" lab field-cells --out "$work/file"
if [ "$(id -u)" != 0 ]; then
    mkdir "$work/closed" && chmod a-w "$work/closed"
    expect 1 'cannot write into' 'a folder that is closed' "$dioptre" lab field-cells --out "$work/closed"
fi
expect 1 'cannot write' 'a folder that takes no files' "$dioptre" lab field-cells --out /proc

expect 0 '' 'one test' "$dioptre" lab fresnel-out --out "$work/a"
holds "$work/out" '^fresnel-out: ' 'the table has a title'
holds "$work/out" '^  error of the share that is mirrored: worst; against degrees before total reflection$' 'the table says what it has, with units'
holds "$work/out" '^exact  +float  +[0-9]' 'the table has rows'
csv=$work/a/fresnel-out.csv
for words in '^# dioptre [0-9.]+: ' '^# compiler: .*flags: .*-ffp-contract=off' '^# processor:.*LDBL_MANT_DIG [0-9]+; FLT_EVAL_METHOD' \
    '^method,type,stress,cases,error_median,error_p999,error_max,ulps_median,' '^Schlick,double,40,2000,[0-9]'; do
    holds "$csv" "$words" "the CSV has: $words"
done
columns=$(grep -v '^#' "$csv" | awk -F, '{ print NF }' | sort -u | tr '\n' ' ')
[ "$columns" = '17 ' ] && ok 'every row of the CSV has 17 cells' || fail "rows of $columns cells"
if command -v gnuplot >/dev/null; then
    for words in '<svg' '>Schlick<' '>degrees before total reflection<'; do
        holds "$work/a/fresnel-out.svg" "$words" "the chart has: $words"
    done
else
    ok 'skipped: charts, gnuplot is not here'
fi
expect 0 '' 'again, quietly, with one thread' "$dioptre" lab fresnel-out --out "$work/b" -q -j 1
[ ! -s "$work/out" ] && ok 'quiet prints nothing' || fail 'quiet prints something'
same "$csv" "$work/b/fresnel-out.csv" 'the same figures of every run'
[ ! -e "$work/a/fresnel-out.svg" ] || same "$work/a/fresnel-out.svg" "$work/b/fresnel-out.svg" 'the same chart'
expect 0 '' 'a folder with a quote and a line in its name' "$dioptre" lab fresnel-out --out "$work/it's
odd" -q

# --- without gnuplot ------------------------------------------------------------------------------
mkdir "$work/empty"
expect 1 'the CSV files are written; .*sudo apt-get install gnuplot' 'gnuplot is missing' \
    env PATH="$work/empty" "$dioptre" lab fresnel-out fresnel-into --out "$work/c" -q
same "$csv" "$work/c/fresnel-out.csv" 'the CSV is there without gnuplot'
[ -s "$work/c/fresnel-into.csv" ] && ok 'and the next one' || fail 'the second CSV is missing'
printf '#!/bin/sh\necho broken >&2\nexit 3\n' >"$work/empty/gnuplot"
chmod +x "$work/empty/gnuplot"
expect 1 'gnuplot gave up \(status 3\): broken' 'gnuplot fails' \
    env PATH="$work/empty:$PATH" "$dioptre" lab fresnel-out --out "$work/d" -q
# On a full disk it ends with status 0.
printf '#!/bin/sh\nfor last; do :; done\ncat >/dev/null\necho "<svg>" >"$last"\n' >"$work/empty/gnuplot"
expect 1 'gnuplot has not written all' 'gnuplot writes a part' \
    env PATH="$work/empty:$PATH" "$dioptre" lab fresnel-out --out "$work/d" -q
[ -s "$work/d/fresnel-out.csv" ] && ok 'the CSV is there all the same' || fail 'no CSV where gnuplot fails'
[ ! -e "$work/d/fresnel-out.svg" ] && ok 'and no half of a chart' || fail 'half of a chart'

# --- interruption: what is finished is kept ---------------------------------------------------------
"$dioptre" lab fresnel-out triangle-edges triangle-corners --out "$work/e" -q &
process=$!
within [ -s "$work/e/fresnel-out.csv" ]
kill -TERM $process # The shell has it ignore Ctrl-C.
wait $process
[ $? = 130 ] && ok 'interrupted: 130' || fail 'interrupted: not 130'
same "$csv" "$work/e/fresnel-out.csv" 'what was finished is kept'
[ ! -e "$work/e/triangle-corners.csv" ] && ok 'what was not is not there' || fail 'interrupted, and yet all is there'
finish
