#!/bin/sh
# Bad input from outside: broken scenes, full disks, interruptions. Run with the sanitizer build, each
# within a limit of time and memory.
. "$(dirname "$0")/check.sh"
dioptre=$PWD/build/asan/dioptre
limited() { timeout 20 "$@"; }

# scene TEXT: a scene file of this text.
scene() { printf '%b' "$1" >"$work/s.lua"; }
# bad LINE WORDS NAME: rendering that scene must fail on this line, with these words.
bad() {
    expect 3 "^$work/s.lua:$1: .*$2" "$3" limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 8x8
    [ -e "$work/o.bmp" ] && fail "$3 wrote a picture"
}

scene ''; bad 1 'camera' 'empty scene'
scene 'this is not Lua'; bad 1 'syntax' 'not Lua'
scene '\033Lua...'; bad 1 '' 'bytecode'
scene 'camera {}\nspere {}'; bad 2 'sphere' 'unknown word, with the nearest'
scene 'camera {}\nsphere { radus = 1 }'; bad 2 'radius' 'unknown field, with the nearest'
scene 'camera {}\ncube {}'; bad 2 'unknown word `cube`; did you mean `box`' 'a word for a word of the language'
scene 'camera {}\ntore {}'; bad 2 'did you mean `distance.torus`' 'the same in French, of another table'
scene 'camera {}\nsphere { color = {1, 0, 0} }'; bad 2 'did you mean `material = material { color = ... }`' 'field of the material'
scene 'camera {}\nsphere { reflectivty = 1 }'; bad 2 'did you mean `material = material { reflectivity = ... }`' 'the same, misspelt'
scene 'camera {}\nsphere { radius = 1,5 }'; bad 2 'one has none; a decimal number has a point' 'decimal comma'
scene 'camera {}\nsphere { center = {0,5, 1, 2} }'; bad 2 'braces; a decimal number has a point' 'decimal comma in a list'
scene 'camera {}\nsphere { radius = -1 }'; bad 2 'radius must be' 'out of range'
scene 'camera {}\nsphere { radius = 0/0 }'; bad 2 'finite' 'not a number'
scene 'camera {}\nsphere { radius = "big" }'; bad 2 'number' 'wrong type'
scene 'camera {}\nbox { min = {1, 0, 0}, max = {0, 1, 1} }'; bad 2 'min below max' 'box inside out'
scene 'camera {}\nquad { u = {1, 0, 0}, v = {2, 0, 0} }'; bad 2 'no area' 'quad without area'
scene 'camera {}\ncylinder { top = {0, 0, 0} }'; bad 2 'no length' 'cylinder without length'
scene 'camera {}\ntriangle { c = {2, 0, 0} }'; bad 2 'no area' 'triangle without area'
scene 'camera {}\ntriangle { na = {0, 0, 1} }'; bad 2 'na, nb and nc' 'triangle with one normal'
scene 'camera {}\ntriangle { ta = {0, 0}, tb = {1, 0} }'; bad 2 'ta, tb and tc' 'triangle with two places'
cp scenes/pictures/die.png "$work/die.png"
scene 'camera {}\nsdf { distance.sphere {}, material = material { texture = "die.png" } }'; bad 2 'takes no picture' 'picture on a distance field'
scene 'camera {}\nsdf {}'; bad 2 'needs a field' 'surface of no field'
scene 'camera {}\nsdf { 1 }'; bad 2 'field must be a distance field, not a number' 'surface of a number'
scene 'camera {}\nerror(setmetatable({}, {__tostring = function() while true do end end}))'; bad 2 'called with a table' 'an error whose words never end'
scene 'camera {}\nlocal function h() return xpcall(error, h) end xpcall(error, h) h() error("end")'; bad 2 'end' 'a handler of errors that fails'
scene 'camera {}\nlocal t = {}\nt.radius = t\nsphere(t)'; bad 4 'not a table' 'a field that is its own table'
scene 'camera {}\nsdf { distance.union(table.unpack(setmetatable({}, {__len = function() return 1e9 end}))) }'; bad 2 'too many results' 'a list that lies about its length'
scene 'camera {}\nlocal f = distance.sphere {}\nfor i = 1, 60 do f = distance.union(f, f) end\nsdf { f }'; bad 3 'at most' 'a field of 2^60 fields'
scene 'camera {}\nlocal _ENV = {}\nsphere {}'; bad 3 'nil value' 'an environment without words'
scene 'camera {}\nlocal f = distance.sphere {}\nsdf { f, f }'; bad 3 'one has none' 'surface of two fields'
scene 'camera {}\nlocal f = distance.sphere {}\nsdf { f, field = f }'; bad 3 'takes one field' 'the same, one of them named'
scene 'camera {}\nsdf { distance.sphere {}, tolerance = 0 }'; bad 2 'tolerance must be' 'tolerance 0'
scene 'camera {}\nsdf { distance.sphere {}, tolerance = 1e15 }'; bad 2 'at most 1/16 of the longest edge of the field, 0.125, not 1e\+15' 'tolerance larger than the field'
scene 'camera {}\nsdf { distance.sphere {}, tolerance = 0.126 }'; bad 2 'at most 1/16' 'tolerance that makes a surface of all'
scene 'camera {}\nsdf { distance.sphere {}:repeat_every{4, 4, 4}, tolerance = 0.26 }'; bad 2 'at most 1/16 of .*, 0.25,' 'tolerance larger than a cell'
scene 'camera {}\nsdf { function(x, y, z) return math.sin(x) * math.sin(y) * math.sin(z) end, tolerance = 1.01 }'; bad 2 'at most 1/16 of .*, 1, not 1.01' 'tolerance of a field without end'
scene 'camera {}\nsdf { distance.sphere {}, max_steps = 0 }'; bad 2 'max_steps must be' 'no steps'
scene 'camera {}\ndistance.box { size = {1, 0, 1} }'; bad 2 'size must be' 'field without size'
scene 'camera {}\ndistance.box_frame { edge = -0.1 }'; bad 2 'edge must be' 'frame with a negative edge'
scene 'camera {}\ndistance.box_frame { edge = 2 }'; bad 2 'edge must not be thicker' 'frame thicker than itself'
scene 'camera {}\ndistance.torus { major = 1, minor = 2 }'; bad 2 'minor must not be larger' 'ring without a hole'
scene 'camera {}\ndistance.menger { iterations = 99 }'; bad 2 'iterations must be' 'sponge of too many holes'
scene 'camera {}\ndistance.union()'; bad 2 'union of nothing' 'union of nothing'
scene 'camera {}\ndistance.union(1)'; bad 2 'takes distance fields, not a number' 'union of a number'
scene 'camera {}\ndistance.difference(distance.sphere {})'; bad 2 'takes two' 'difference of one'
scene 'camera {}\nlocal s = distance.sphere {}\ndistance.intersection(s, s:translate{9, 0, 0})'; bad 3 'lie apart' 'intersection of nothing'
scene 'camera {}\ndistance.sphere {}:repeat_every{1.5, 0.5, 0}'; bad 2 'overlap more' 'copies on top of one another'
scene 'camera {}\ndistance.sphere {}:repeat_every{2, 2, 2, count = {1.5, 0, 0}}'; bad 2 'whole' 'one and a half copies'
scene 'camera {}\ndistance.sphere {}:translate{0/0, 0, 0}'; bad 2 'finite' 'field moved to no number'
scene 'camera {}\ndistance.sphere {}:scale(0)'; bad 2 'scale must be' 'field scaled to nothing'
scene 'camera {}\ndistance.sphere {}:turn{0, 0, 0}'; bad 2 'unknown word `field:turn`' 'field that cannot turn'
scene 'camera {}\ndistance.spere {}'; bad 2 'distance.sphere' 'unknown field, with the nearest'
scene 'camera {}\nlocal f = distance.sphere {}\nfor i = 1, 14 do\nf = distance.union(f, f)\nend\nsdf { f }'; bad 4 'made of at most 4096 fields' 'ten thousand fields'
scene 'camera {}\nlocal f = distance.sphere {}\nfor i = 1, 99 do\nf = f:translate{1, 0, 0}\nend\nsdf { f }'; bad 4 '64 deep' 'a hundred fields in one another'
scene 'camera {}\ndistance.sphere { radius = 0 }'; bad 2 'radius must be' 'ball of no size'
scene 'camera {}\ndistance.torus { minor = 0 }'; bad 2 'minor must be' 'ring of no thickness'
scene 'camera {}\ndistance.menger { size = 0 }'; bad 2 'size must be' 'sponge of no size'
scene 'camera {}\ndistance.box_frame { edge = 0 }'; bad 2 'edge must be' 'frame of no thickness'
scene 'camera {}\ndistance.sphere {}:round(-2)'; bad 2 'round must be' 'ball rounded to nothing'
scene 'camera {}\ndistance.sphere {}:round(0/0)'; bad 2 'finite' 'ball rounded by no number'
scene 'camera {}\ndistance.sphere { radius = t / 0 * 0 }'; bad 2 'finite' 'field of a time that is no number'
scene 'camera {}\nlocal s = distance.sphere {}\ndistance.smooth_union(s, s, 0/0)'; bad 3 'finite' 'fields melted by no number'
scene 'camera {}\nsdf { distance.sphere {}, tolerance = 0/0 }'; bad 2 'finite' 'tolerance that is no number'
scene 'camera {}\ndistance.sphere {}:repeat_every{0/0, 1, 1}'; bad 2 'finite' 'copies every no number'
scene 'camera {}\ndistance.sphere {}:repeat_every{3, 3, 3}:repeat_every{2, 2, 2}'; bad 2 'reaches inf' 'copies without end of copies without end'
scene 'camera {}\nlocal f = distance.sphere {}\nfor i = 1, 60 do\nf = f:scale(1e-5)\nend'; bad 4 'becomes 2e-20 long' 'ball scaled to nothing, bit by bit'
scene 'camera {}\nlocal f = distance.sphere {}\nfor i = 1, 60 do\nf = f:scale(1e5)\nend'; bad 4 'reaches 1e\+20' 'ball scaled beyond all numbers'
scene 'camera {}\nlocal f = distance.sphere {}\nlocal all = {}\nfor i = 1, 10000 do all[i] = f end\nsdf { distance.union(table.unpack(all)) }'; bad 5 'made of at most 4096 fields' 'union of ten thousand'
scene 'camera {}\nlocal f = distance.sphere {}\nlocal g = f\nfor i = 1, 10000 do\nf = distance.union(g, f)\nend'; bad 5 'made of at most 4096 fields' 'ten thousand unions in one another'
scene 'camera {}\nlocal f = distance.sphere {}\nfor i = 1, 10000 do\nf = f:round(1e-6)\nend'; bad 4 'made of at most 4096 fields' 'a ball rounded ten thousand times'
scene 'camera {}\nsdf { function(x, y, z)\nif x > 0 then return y end return z end }'; bad 3 'cannot compare' 'function that compares'
scene 'camera {}\nsdf { function(x, y, z)\nreturn math.log(x) end }'; bad 3 'math.log cannot be part' 'function with a logarithm'
scene 'camera {}\nsdf { function(x, y, z) end }'; bad 2 'must return a number' 'function of nothing'
scene 'camera {}\nsdf { function(x, y, z)\nfor i = 1, 1e9 do x = x + i * y end return x end }'; bad 3 'more than 4095 operations' 'function without end'
scene 'camera {}\nsdf { function(x, y, z) return x * 1e300 end }'; bad 2 'at most 1e\+30' 'function beyond float'
scene 'camera {}\ndistance.field(1)'; bad 2 'takes a function' 'field of a number'
scene 'camera {}\nsphere { scale = {1, 0, 1} }'; bad 2 'nearer to zero' 'sphere scaled to nothing'
scene 'camera {}\nsun { direction = {0, 0, 0} }'; bad 2 'direction must not be zero' 'sun that shines nowhere'
scene 'camera {}\nsun { direction = {0, 0/0, 0} }'; bad 2 'finite' 'sun that shines to no number'
scene 'camera {}\nsun { position = {0, 1, 0} }'; bad 2 'no field `position`' 'sun with a place'
scene 'camera {}\nlight { radius = -1 }'; bad 2 'radius must be' 'lamp with a negative radius'
scene 'camera {}\nlight { radius = 1e-20 }'; bad 2 'radius must be 0 or at least' 'lamp too small to be seen'
scene 'camera {}\nlight { radius = 1e16 }'; bad 2 'radius must be' 'lamp larger than any scene'
scene 'camera {}\nmaterial { transparency = 1.5 }'; bad 2 'transparency must be' 'more let through than there is'
scene 'camera {}\nmaterial { transparency = {0, -1, 0} }'; bad 2 'transparency must be' 'less than nothing let through'
scene 'camera {}\nmaterial { transparency = "much" }'; bad 2 'transparency' 'transparency that is no number'
scene 'camera {}\nmaterial { reflectivity = 0.5, transparency = 0.6 }'; bad 2 'are 1.1 together' 'more mirrored and let through than there is'
scene 'camera {}\nmaterial { reflectivity = {0, 0, 0.5}, transparency = {1, 1, 0.75} }'; bad 2 'are 1.25 together' 'the same in blue only'
scene 'camera {}\nmaterial { ior = 0 }'; bad 2 'ior must be' 'index of refraction 0'
scene 'camera {}\nmaterial { ior = -1.5 }'; bad 2 'ior must be' 'index of refraction below 0'
scene 'camera {}\nmaterial { ior = 0/0 }'; bad 2 'finite' 'index of refraction that is no number'
scene 'camera {}\nmaterial { ior = 1e9 }'; bad 2 'ior must be' 'index of refraction beyond all matter'
scene 'camera { look_at = {0, 0, 0} }'; bad 1 'own position' 'camera that looks at itself'
scene 'camera { fov = 180 }'; bad 1 'fov must be' 'field of view of 180 degrees'
scene 'camera { position = {0, 0, 1e300} }'; bad 1 'position must be' 'camera too far away'
scene 'camera {}\nimage { width = 20000, height = 20000 }'; bad 2 'width must be' 'picture too large'
scene 'camera {}\nimage { width = 0 }'; bad 2 'width must be' 'picture without width'
scene 'camera {}\nwhile true do end'; bad 2 '10 s' 'endless loop'
scene 'camera {}\nlocal s = string.rep("x", 1e9)'; bad 2 'memory|256' 'a gigabyte in one call'
scene 'camera {}\nerror({})'; bad 2 '' 'an error that is no text'
expect 3 'No such file' 'missing scene' "$dioptre" render "$work/none.lua" -o "$work/o.bmp"
expect 3 'folder' 'a folder as scene' "$dioptre" render "$work" -o "$work/o.bmp"

scene 'camera { direction = {0, -1, 0} }\nsphere { center = {0, -3, 0} }\nlight { position = {0, 0, 0} }'
expect 0 '' 'straight down' "$dioptre" render "$work/s.lua" -o "$work/down.bmp" -s 9x9
scene 'camera { position = {0, 0, 9} } light {}\nfor i = 1, 10000 do sdf { distance.sphere { radius = 0.1 }, translate = {i % 10, i // 10 % 10, -i / 100} } end'
expect 0 '' 'ten thousand fields' limited "$dioptre" render "$work/s.lua" -o "$work/many.bmp" -s 8x8
scene 'camera { position = {0, 0, 9} } light {}\nlocal s = distance.sphere {}\nsdf { distance.difference(s, s) }'
expect 0 '' 'a field of nothing' limited "$dioptre" render "$work/s.lua" -o "$work/none.bmp" -s 8x8
for time in inf -inf nan 1e309 '' 1x; do
    expect 2 "time takes a number, not '$time'" "time '$time'" "$dioptre" render scenes/melting.lua -t "$time" -o "$work/o.bmp"
done
for time in 1e300 -1e300 1e-320; do
    expect 0 '' "time $time" limited "$dioptre" render scenes/melting.lua -t $time -o "$work/o.bmp" -s 8x8
done
expect 3 'endless-frames.lua:9: position must be' 'time 1e300 that takes the camera along' "$dioptre" render scenes/endless-frames.lua -t 1e300 -o "$work/far.bmp"
expect 0 '' 'a field that turns all night' limited "$dioptre" render scenes/mandelbulb.lua -t 36000 -o "$work/o.bmp" -s 8x8
rm -f "$work/o.bmp"
scene 'camera { position = {0, 0, 9} }\nsdf { distance.sphere {}, tolerance = 0.125 }\nsdf { distance.sphere { radius = 1e-6 } }'
expect 0 '' 'the largest tolerance, and a field smaller than the usual one' limited "$dioptre" render "$work/s.lua" -o "$work/o.bmp" -s 8x8
rm -f "$work/o.bmp"
scene 'camera {}'
expect 0 '' 'an empty world' "$dioptre" render "$work/s.lua" -o "$work/empty.bmp" -s 9x9

# Output that cannot be written: the old picture stays, nothing half-written is left.
scene 'camera {}\nsky { color = 1 }'
cp "$work/down.bmp" "$work/old.bmp"
cp "$work/down.bmp" "$work/kept.bmp"
(ulimit -f 8; exec "$dioptre" render "$work/s.lua" -o "$work/old.bmp" -s 400x300) 2>"$work/err"
[ $? = 1 ] && ok 'full disk: status 1' || fail "full disk: status, $(cat "$work/err")"
holds "$work/err" 'old.bmp' 'full disk: says which file'
same "$work/old.bmp" "$work/kept.bmp" 'full disk: the old picture is whole'
[ "$(find "$work" -name 'old.bmp*' | wc -l)" = 1 ] && ok 'full disk: nothing left over' || fail 'full disk: something is left over'
expect 1 'none/o.bmp' 'no such folder' "$dioptre" render "$work/s.lua" -o "$work/none/o.bmp"
expect 2 'bmp' 'unknown ending' "$dioptre" render "$work/s.lua" -o "$work/o.xyz"
expect 1 'standard output' 'full disk behind standard output' sh -c "exec $dioptre info $work/s.lua >/dev/full"
expect 1 'standard output' 'full disk behind the help' sh -c "exec $dioptre --help >/dev/full"
expect 1 'No space left on device' 'full disk under a drawing' "$dioptre" probe "$work/s.lua" 0 0 --svg /dev/full

# SIGINT: what is finished is kept, status 130. The picture is large enough to be caught at.
scene 'camera { position = {0, 0, 6} }\nimage { width = 1600, height = 1200, samples = 64 }\nlight {}\nsphere {}'
"$dioptre" render "$work/s.lua" -o "$work/cut.bmp" -j 1 --sampling full --progress json 2>"$work/err" &
pid=$!
within grep -q '^{' "$work/err"
kill -INT $pid
wait $pid
status=$?
tail -2 "$work/err" | grep -q '"progress": 1' && fail 'SIGINT: the progress is whole' || ok 'SIGINT: the progress is that of a part'
[ "$status" = 130 ] && ok 'SIGINT: status 130' || fail "SIGINT: status: $(cat "$work/err")"
holds "$work/err" 'interrupted: .*cut.bmp has [0-9]+ %' 'SIGINT: says how much there is'
[ "$(wc -c <"$work/cut.bmp")" = $((1600 * 1200 * 3 + 54)) ] && ok 'SIGINT: the picture is kept' || fail 'SIGINT: the picture is kept'
without_display() { env -u DISPLAY -u WAYLAND_DISPLAY "$@" timeout 20 "$dioptre" view "$work/s.lua"; }
expect 1 'no display' 'no display' without_display -u SDL_VIDEODRIVER
expect 1 'no display' 'no display, and an empty name of a driver' without_display SDL_VIDEODRIVER=
finish
