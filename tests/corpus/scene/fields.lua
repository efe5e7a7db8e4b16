camera { position = {0, 0, 9} }
local a = distance.sphere { radius = 1 }:translate{1, 0, 0}:turn{0, 1, 0, 30}
local b = distance.torus { major = 1, minor = 0.2 }:repeat_every{4, 0, 0, count = {1, 0, 0}}
sdf { distance.smooth_union(a, distance.difference(b, distance.box { size = {1, 1, 1} }), 0.1) }
sdf { function(x, y, z) return math.sin(x) * math.cos(y) + z * z - 1 end, tolerance = 1e-3 }
sdf { distance.field(function(x, y, z) return math.sqrt(x * x + y * y + z * z) - 1 end) }
