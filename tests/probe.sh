#!/bin/sh
# The rays of one pixel on the command line: its colour is the picture's, the rays add up, in words, as
# JSON and as a drawing; what is no pixel is refused.
. "$(dirname "$0")/check.sh"
box=scenes/box.lua
size=160x120

# pixel FILE X Y: the steps of a pixel of a BMP file of that size, as JSON has them.
pixel() {
    od -An -tu1 -j $((54 + ((${size#*x} - 1 - $3) * ${size%x*} + $2) * 3)) -N 3 "$1" | awk '{ printf "[%d, %d, %d]", $3, $2, $1 }'
}
# ray_sums: reads rays as JSON, adds up own colours and children times their shares, and prints the worst
# difference to the colours that were told, and how many rays there are.
ray_sums() {
    sed 's/[][{}",:]/ /g; s/null/-1/g' | awk '
        function three(name, to, i) {
            for (i = 1; i <= NF && $i != name; i++);
            if (i + 3 > NF) wrong = 1
            to[id, 1] = $(i+1); to[id, 2] = $(i+2); to[id, 3] = $(i+3)
        }
        { for (i = 6; i <= NF; i++) if ($i ~ /nan|inf/) wrong = 1 }
        { id = $2; parent[id] = $4; kind[id] = $6; three("color", color); three("own", own); three("share", share) }
        id == 0 { three("merged", sum) }
        END {
            for (i = NR - 1; i >= 0; i--) for (c = 1; c <= 3; c++) {
                off = color[i, c] - own[i, c] - sum[i, c]
                worst = off > worst ? off : -off > worst ? -off : worst
                if (kind[i] != "shadow") sum[parent[i], c] += share[i, c] * color[i, c]
            }
            if (NR == 0 || wrong) worst = "no rays, or none with numbers"
            print worst < 1e-6 ? "adds up" : "off by " worst, NR
        }'
}

for scene in box glass-sphere lamps; do
    "$dioptre" render "scenes/$scene.lua" -o "$work/$scene.bmp" -s $size --samples 1
    for place in '0 0' '80 60' '41 83' '159 119'; do
        # shellcheck disable=SC2086 # two numbers
        expect 0 '' "probe $scene $place" "$dioptre" probe "scenes/$scene.lua" $place -s $size --json
        # shellcheck disable=SC2086
        steps=$(pixel "$work/$scene.bmp" $place)
        head -1 "$work/out" | grep -qF "\"steps\": $steps" && ok "$scene $place is the picture's" ||
            fail "$scene $place: the picture has $steps"
        ray_sums <"$work/out" >"$work/sums"
        holds "$work/sums" '^adds up' "$scene $place adds up"
    done
done
# Glass whose rays are too many for a tree: what is merged is told, too.
usual_size=$size size=24x16 deep=scenes/report-d-glass.lua
"$dioptre" render $deep -o "$work/deep.bmp" -s $size --samples 1 --offset none -q
expect 0 '' 'probe among rays without end' "$dioptre" probe $deep 13 9 -s $size --offset none --json
steps=$(pixel "$work/deep.bmp" 13 9)
head -1 "$work/out" | grep -qF "\"steps\": $steps" && ok 'with merged rays, too, it is the picture'"'"'s' ||
    fail "with merged rays: the picture has $steps"
grep -q '"merged": \[0, 0, 0\]' "$work/out" && fail 'no merged light is told' || ok 'merged light is told'
ray_sums <"$work/out" >"$work/sums"
holds "$work/sums" '^adds up' 'all rays but the first, which has the difference, add up'
expect 0 '' 'the same in words' "$dioptre" probe $deep 13 9 -s $size --offset none
holds "$work/out" '^  \+ merged rays' 'merged light in words'
expect 0 '' 'the first ray in full' "$dioptre" probe $deep 13 9 -s $size --offset none --ray 0
holds "$work/out" '\+ merged rays' 'merged light in its sum'
size=$usual_size
for engine in f32x1 f32x4 f64x1 f128x1; do
    "$dioptre" render $box -o "$work/e.bmp" -s $size --samples 1 --engine $engine
    expect 0 '' "probe by $engine" "$dioptre" probe $box 41 83 -s $size --json --engine $engine
    steps=$(pixel "$work/e.bmp" 41 83)
    head -1 "$work/out" | grep -qF "\"steps\": $steps" && ok "$engine: the picture's" || fail "$engine: not $steps"
done

# --- JSON: the names, in their order -----------------------------------------------------------------
"$dioptre" probe $box 250 430 --json >"$work/rays"
number='-?[0-9.e+-]+'
three="\[$number, $number, $number\]"
names="^\{\"id\": 0, \"parent\": null, \"kind\": \"camera\", \"depth\": 0, \"origin\": $three, \"direction\": $three"
names="$names, \"hit\": true, \"shape\": 5, \"distance\": $number, \"point\": $three, \"normal\": $three"
holds "$work/rays" "$names, \"weight\": 1, \"color\": $three" 'the camera'"'"'s ray has all names'
holds "$work/rays" '"parent": 0, "kind": "mirror", "depth": 1' 'a mirrored ray'
holds "$work/rays" '"parent": 2, "kind": "shadow", "depth": 2' 'a shadow ray of what it meets'
holds "$work/rays" '"keyword": "sphere", "line": 35' 'the shape'"'"'s line in the scene file'
[ "$(grep -c '^{.*}$' "$work/rays")" = "$(wc -l <"$work/rays")" ] && ok 'an object per line' || fail 'an object per line'
grep -qiE 'inf|nan' "$work/rays" && fail 'numbers that JSON has not' || ok 'only numbers that JSON has'
"$dioptre" probe - 250 430 --json <$box >"$work/again"
same "$work/rays" "$work/again" 'a scene from standard input'
LC_ALL=fr_FR.UTF-8 LANG=fr_FR.UTF-8 "$dioptre" probe $box 250 430 --json >"$work/again"
same "$work/rays" "$work/again" 'JSON is the same in French'

# --- words -------------------------------------------------------------------------------------------
expect 0 '' 'probe in words' "$dioptre" probe $box 250 430
holds "$work/out" '^0  camera ray meets the sphere of line 35$' 'words name the shape'
holds "$work/out" '^  = the pixel +0\.352948 +0\.0927295 +0\.0438313$' 'words end with the pixel'
holds "$work/out" '160 +86 +59  of 255' 'and with its steps'
expect 0 '' 'epsilon' "$dioptre" probe $box 250 430 --offset fixed --epsilon 0.015625
holds "$work/out" 'epsilon +0\.01562 = 1\.311e\+05 ulps' 'epsilon in ulps: 1/64 of 2^-23'
expect 0 '' 'depth 0' "$dioptre" probe $box 250 430 --depth 0
grep -q mirrored "$work/out" && fail 'depth 0 mirrors nothing' || ok 'depth 0 mirrors nothing'
expect 0 '' 'samples' "$dioptre" probe scenes/still-life.lua 100 100 --samples 16 -s $size
holds "$work/out" 'first sample of 16' 'the first of several samples says so'

# Glass: the part that is mirrored follows from the angle and the indices that are printed, by Fresnel's formulas.
expect 0 '' 'probe of glass' "$dioptre" probe scenes/glass-sphere.lua 48 36 -s 96x72 --engine f64x1
holds "$work/out" '^  index +1 before it, 1.5 behind it$' 'the indices of glass, from outside'
holds "$work/out" '^    index +1\.5 before it, 1 behind it$' 'and from inside'
awk '/angle/ && !a { a = $2 * atan2(0, -1) / 180 } /Fresnel/ && !r { r = $2 }
    END { c = cos(a); t = sqrt(1 - (sin(a) / 1.5) ^ 2); s = (c - 1.5 * t) / (c + 1.5 * t); p = (1.5 * c - t) / (1.5 * c + t)
        d = r - (s * s + p * p) / 2; exit !(r > 0 && d < 2e-6 && d > -2e-6) }' "$work/out" && ok 'Fresnel' ||
    fail "Fresnel: $(grep -m 1 Fresnel "$work/out")"

# Report A: the ray of the first of 4 x 3 pixels, through the centre and, without the half pixel, through the corner.
printf 'camera { fov = 90 }\nplane { point = {0, 0, -1}, normal = {0, 0, 1} }\n' >"$work/corner.lua"
expect 0 '' 'the centre' "$dioptre" probe "$work/corner.lua" 0 0 -s 4x3 --pixel center
holds "$work/out" '^  point +-0\.75 +0\.5 +-1$' 'the first ray goes through the centre of its pixel'
expect 0 '' 'the corner' "$dioptre" probe "$work/corner.lua" 0 0 -s 4x3 --pixel corner
holds "$work/out" '^  point +-1 +0\.75 +-1$' 'and with --pixel corner through its corner'
holds "$work/out" '^Rays go through the corners of pixels\.$' 'which it says'
# The lamp of report D: 5 cos / (2 + d), straight below it and at the side of the triangle 3, 4, 5.
printf 'camera {}\nlight { position = {%s}, intensity = 5, falloff = "inverse_linear" }\nplane { point = {0, 0, -4}, normal = {0, 0, 1} }\n' \
    '0, 0, 0' >"$work/below.lua"
sed 's/{0, 0, 0}/{3, 0, 0}/' "$work/below.lua" >"$work/side.lua"
for case in 'below 0.833333' 'side 0.571429'; do
    expect 0 '' "a lamp ${case% *}" "$dioptre" probe "$work/${case% *}.lua" 0 0 -s 1x1
    holds "$work/out" "^    adds +${case#* } +${case#* } +${case#* }$" "a lamp ${case% *} gives 5 cos / (2 + d) = ${case#* }"
done
for methods in own a b c d; do
    "$dioptre" render $box -o "$work/m.bmp" -s $size --samples 1 --methods $methods
    expect 0 '' "probe by $methods" "$dioptre" probe $box 41 83 -s $size --json --methods $methods
    steps=$(pixel "$work/m.bmp" 41 83)
    head -1 "$work/out" | grep -qF "\"steps\": $steps" && ok "$methods: the picture's" || fail "$methods: not $steps"
    holds "$work/out" "\"pixel\": \"center\", \"methods\": \"$methods\"" 'and says whose they are'
done

# --- the drawing -------------------------------------------------------------------------------------
expect 0 '' 'probe --svg' "$dioptre" probe scenes/glass-sphere.lua 80 60 -s $size --svg "$work/rays.svg" -q
[ -s "$work/out" ] && fail 'quiet' || ok 'quiet'
holds "$work/rays.svg" '^<svg xmlns' 'a drawing'
holds "$work/rays.svg" '^</svg>$' 'all of it'
holds "$work/rays.svg" 'refracted ray' 'its legend'
holds "$work/rays.svg" 'width="1500' 'a plan beside it'
expect 0 '' 'probe --ray' "$dioptre" probe scenes/glass-sphere.lua 80 60 -s $size --ray 4 --svg "$work/ray.svg"
holds "$work/out" '^Ray 4: refracted ray$' 'which ray'
holds "$work/out" '^  refraction +n1 sin a = n2 sin b: 1 × sin [0-9.]+° = 1.5 × sin [0-9.]+° = [0-9.]+$' 'Snell'"'"'s law with numbers'
holds "$work/out" '^  point +o \+ t d = \(.*\) \+ [0-9.]+ \(.*\) = \(.*\)$' 'its point'
holds "$work/out" '^  = ray 4 ' 'its sum'
[ "$(sed -n 's/.*height="\([0-9]*\).*/\1/p' "$work/ray.svg" | head -1)" = 1110 ] && ok 'formulas below it' || fail 'no formulas below it'
"$dioptre" probe scenes/glass-sphere.lua 80 60 -s $size --ray 4 --json >"$work/out"
[ "$(grep -c '^{"id": *4,' "$work/out")" = 1 ] && [ "$(wc -l <"$work/out")" = 1 ] && ok 'one ray as JSON' || fail 'not one ray as JSON'
# Exactly along a surface, where both cosines of Fresnel's formula are 0.
echo 'camera { position = {1, 0, 5}, look_at = {1, 0, 0} } sky { horizon = 0.5, zenith = 0.5 }
sphere { radius = 1, material = material { color = 0, transparency = 1, ior = 0.9999999 } }' >"$work/tangent.lua"
"$dioptre" probe "$work/tangent.lua" 40 30 -s 81x61 --engine f32x4 >"$work/out"
grep -q nan "$work/out" && fail 'a tangent ray gives no number' || ok 'a tangent ray gives a number'
holds "$work/out" '^ *brings back +0.5 +0.5 +0.5' 'and is reflected'
# A sum that is too long says how many terms it has not: with those shown, one per lamp.
for lamps in 46 47 48 60; do
    { echo 'camera { position = {0, 1, 4} } plane {}'
      for i in $(seq $lamps); do echo "light { position = {$i, 5, 3} }"; done; } >"$work/lamps.lua"
    "$dioptre" probe "$work/lamps.lua" 80 100 -s $size --ray 0 >"$work/out"
    terms=$(awk '/^  \+ ray/{ n++ } /^and [0-9]+ more$/{ n += $2 } END { print n }' "$work/out")
    [ "$terms" = $lamps ] && ok "$lamps lamps have as many terms" || fail "$lamps lamps have $terms terms"
done
"$dioptre" probe scenes/glass-sphere.lua 80 60 -s $size --ray 0 >"$work/out"
# Fresnel's formula again, from the angle that is told.
awk '/cos a = /{ sub(/.*cos a = −d·n = /, ""); sub(/,.*/, ""); c = $0 }
    /Fresnel/{ told = $10; s = sqrt(1 - c * c) / 1.5; t = sqrt(1 - s * s)
        a = (c - 1.5 * t) / (c + 1.5 * t); b = (1.5 * c - t) / (1.5 * c + t); r = (a * a + b * b) / 2
        off = told > r ? told - r : r - told; print off < 2e-4 ? "as computed" : "off by " off " from " r }' \
    "$work/out" >"$work/fresnel"
holds "$work/fresnel" '^as computed$' 'Fresnel'"'"'s share'
expect 0 '' 'a march' "$dioptre" probe scenes/menger-sponge.lua 80 60 -s $size --ray 0 --svg "$work/march.svg" -q
holds "$work/march.svg" '^</svg>$' 'the march as a drawing'
expect 2 'ray must be from 0 to' 'a ray that is not there' "$dioptre" probe $box 1 1 -s $size --ray 999
mkdir "$work/closed"
expect 1 'cannot write' 'svg into a folder that is not there' "$dioptre" probe $box 1 1 --svg "$work/none/rays.svg"
expect 1 'cannot write' 'svg over a folder' "$dioptre" probe $box 1 1 --svg "$work/closed"
[ "$(ls "$work/closed")" = '' ] && ok 'nothing half written' || fail 'nothing half written'

# --- what is no pixel --------------------------------------------------------------------------------
for place in '800 0' '0 600' '99999999999999999999 0' '0 4000000000'; do
    # shellcheck disable=SC2086
    expect 2 'must be from 0 to' "outside: $place" "$dioptre" probe $box $place
done
for place in 'x 0' '0 y' '1.5 0' '1e2 0' '0x10 0' '3, 4'; do
    # shellcheck disable=SC2086
    expect 2 'must be a whole number' "no number: $place" "$dioptre" probe $box $place
done
expect 2 'argument 2 of probe is empty' 'an empty X' "$dioptre" probe $box '' 0
expect 2 'must be from 0 to' 'a negative Y' "$dioptre" probe $box -- 0 -1
expect 2 'usage: dioptre probe SCENE X Y' 'no Y' "$dioptre" probe $box 1
expect 2 'too many' 'one number too many' "$dioptre" probe $box 1 2 3
expect 2 'does not take' 'an option of another command' "$dioptre" probe $box 1 2 -o x.bmp
expect 3 'none.lua' 'no scene' "$dioptre" probe none.lua 1 2
echo 'camera {} spere {}' >"$work/bad.lua"
expect 3 'bad.lua:1: ' 'a scene with a mistake' "$dioptre" probe "$work/bad.lua" 1 2
echo 'camera {}' >"$work/empty.lua"
expect 0 '' 'an empty scene' "$dioptre" probe "$work/empty.lua" 1 2
holds "$work/out" 'meets nothing but the sky' 'an empty scene has a sky'
finish
