-- Report D, cylinders that glow: neon tubes over a counter, and a lamp that stands on the floor.
--
-- The wall of a tube gives light, most of it sideways; its ends only glow. Far away its light is that of a point, times the sine of
-- the angle to the axis. With `--samples 1` it shines from the middle of its axis.

camera { position = {0, 1.7, 5.4}, look_at = {0, 1.15, 0}, fov = 48 }
image { width = 800, height = 600, samples = 64, depth = 5 }
ambient { 0.015, 0.015, 0.02 }

local wall = material { color = {0.26, 0.25, 0.28} }
local counter = material { color = {0.16, 0.11, 0.08}, reflectivity = 0.22, specular = 0.4, shininess = 150 }
local glazed = material { color = {0.75, 0.72, 0.66}, specular = 0.5, shininess = 80, reflectivity = 0.05 }
local steel = material { color = {0.05, 0.05, 0.06}, reflectivity = 0.75, specular = 0.5, shininess = 200 }
local glass = material { color = 0, transparency = 1, ior = 1.5, specular = 0.4, shininess = 200 }

plane { point = {0, 0, 0}, normal = {0, 1, 0}, material = material { color = {0.26, 0.24, 0.25}, reflectivity = 0.10 } }
plane { point = {0, 0, -1.6}, normal = {0, 0, 1}, material = wall }

local function tube(from, to, color, intensity)
  cylinder_light { base = from, top = to, radius = 0.035, color = color, intensity = intensity, falloff = "inverse_square" }
end

-- A sign of three colours in front of the wall: each tube lights its own part of it.
local pink, cyan, amber = {1, 0.18, 0.45}, {0.12, 0.75, 1}, {1, 0.62, 0.15}
for i = 0, 2 do
  local a, b = math.rad(90 + 120 * i), math.rad(210 + 120 * i)
  local colors = { pink, cyan, amber }
  local r, x, y, z = 0.85, -1.15, 1.9, -1.15
  tube({x + r * math.cos(a) * 0.94, y + r * math.sin(a) * 0.94, z}, {x + r * math.cos(b) * 0.94, y + r * math.sin(b) * 0.94, z},
    colors[i + 1], 0.9)
end
tube({0.1, 2.45, -1.2}, {2.2, 2.45, -1.2}, cyan, 1.3)
tube({0.1, 2.2, -1.2}, {1.7, 2.2, -1.2}, pink, 1.0)

-- The counter with what stands on it.
box { min = {-2.2, 0, -0.5}, max = {1.5, 0.75, 0.5}, material = counter }
for i, x in ipairs { -1.8, -1.15, -0.5 } do
  cylinder { base = {x, 0.75, 0}, top = {x, 0.95 + 0.1 * i, 0}, radius = 0.18, material = i == 2 and steel or glazed }
end
sphere { center = {0.2, 1.03, 0.1}, radius = 0.28, material = glass }
sphere { center = {0.85, 0.95, -0.1}, radius = 0.2, material = steel }
sphere { center = {1.2, 0.88, 0.25}, radius = 0.13, material = glazed }

-- The standing lamp: a thick tube on a foot.
cylinder { base = {2.15, 0, 0.2}, top = {2.15, 0.08, 0.2}, radius = 0.28, material = steel }
cylinder_light { base = {2.15, 0.12, 0.2}, top = {2.15, 1.35, 0.2}, radius = 0.11, color = {1, 0.78, 0.5}, intensity = 1.3,
  falloff = "inverse_square" }

-- en: Cylinders that glow: neon tubes and a standing lamp.
-- fr name: tubes lumineux
-- fr: Des cylindres qui éclairent : des néons et un lampadaire.
