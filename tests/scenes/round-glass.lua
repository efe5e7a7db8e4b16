-- A box of glass with round edges, and a ball of glass with dents, written as a function: light that is totally
-- reflected in them takes chaotic paths.
camera { position = {0.9, 1.1, 4.6}, look_at = {0, 0, 0}, fov = 40 }
image { width = 320, height = 240 }
ambient(0.2); sky { horizon = {0.6, 0.7, 0.8}, zenith = {0.1, 0.2, 0.5} }
light { position = {3, 5, 6}, intensity = 0.8 }
local glass = material { color = 0, transparency = 1, ior = 1.5 }
plane { point = {0, -1.2, 0}, material = material { color = "#8a9a6b" } }
quad { corner = {-4, -1.2, -3}, u = {8, 0, 0}, v = {0, 1, 0}, material = material { color = "#c02020" } }
quad { corner = {-4, -0.2, -3}, u = {8, 0, 0}, v = {0, 2, 0}, material = material { color = "#2040c0" } }
sdf { distance.box { size = {0.9, 0.9, 0.9} }:round(0.1):rotate{10, 20, 30}:translate{-0.8, -0.3, 0}, material = glass }
local dented = distance.field(function(x, y, z)
  return (math.sqrt(x * x + y * y + z * z) - 0.6 - 0.06 * math.sin(5 * x) * math.sin(5 * y) * math.sin(5 * z)) / 1.35
end)
sdf { dented:translate{0.8, -0.3, 0}, material = glass }
