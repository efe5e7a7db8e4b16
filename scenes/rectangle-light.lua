-- Report D, rectangles that glow: a gallery at night, with panels in the ceiling, a window, and a screen that lights both ways.
--
-- A rectangle glows on the side of u × v, and is not there from behind, unless it is `two_sided`. Far away its light is that of a
-- point, times the cosine at the rectangle; near, it fills the room softly. With `--samples 1` it shines from its middle.

camera { position = {0.2, 1.55, 5.1}, look_at = {0, 1.05, -0.6}, fov = 52 }
image { width = 800, height = 600, samples = 64, depth = 4 }
ambient { 0.02, 0.02, 0.025 }

local white = material { color = {0.78, 0.76, 0.72} }
local floor = material { color = {0.30, 0.27, 0.25}, reflectivity = 0.12 }
local red = material { color = {0.72, 0.13, 0.09}, specular = 0.4, shininess = 60, reflectivity = 0.04 }
local blue = material { color = {0.08, 0.22, 0.55}, specular = 0.4, shininess = 60, reflectivity = 0.04 }
local gold = material { color = {0.40, 0.28, 0.08}, reflectivity = {0.55, 0.42, 0.18}, specular = 0.3, shininess = 120 }

-- The room.
plane { point = {0, 0, 0}, normal = {0, 1, 0}, material = floor }
plane { point = {0, 3, 0}, normal = {0, -1, 0}, material = white }
plane { point = {0, 0, -3}, normal = {0, 0, 1}, material = white }
plane { point = {-3, 0, 0}, normal = {1, 0, 0}, material = material { color = {0.55, 0.60, 0.62} } }
plane { point = {3, 0, 0}, normal = {-1, 0, 0}, material = white }

-- Two panels of warm light, just below the ceiling: u × v points down.
for x = -1.2, 1.2, 2.4 do
  rectangle_light { corner = {x - 0.55, 2.98, -1.1}, u = {1.1, 0, 0}, v = {0, 0, 1.1},
    color = {1, 0.84, 0.62}, intensity = 3.2, falloff = "inverse_square" }
end

-- A window on the left, through which the evening comes in.
rectangle_light { corner = {-2.98, 0.8, -1.6}, u = {0, 1.4, 0}, v = {0, 0, 1.8},
  color = {0.35, 0.55, 1}, intensity = 2.2, falloff = "inverse_square" }
for _, z in ipairs { -1.6, -0.7, 0.2 } do
  box { min = {-3, 0.75, z - 0.03}, max = {-2.93, 2.25, z + 0.03}, material = white }
end

-- A leaning screen that lights the wall behind it as well as what stands before it.
rectangle_light { corner = {1.25, 0.25, -1.75}, u = {0.9, 0, -0.5}, v = {0, 1.35, -0.25},
  color = {1, 0.25, 0.55}, intensity = 0.9, falloff = "inverse_square", two_sided = true }

-- What they shine on.
box { min = {-0.45, 0, -0.45}, max = {0.45, 0.7, 0.45}, rotate = {0, 28, 0}, translate = {-0.9, 0, -0.9}, material = white }
sphere { center = {-0.9, 1.12, -0.9}, radius = 0.42, material = red }
cylinder { base = {0.55, 0, -0.2}, top = {0.55, 0.9, -0.2}, radius = 0.3, material = white }
sphere { center = {0.55, 1.2, -0.2}, radius = 0.3, material = gold }
sphere { center = {-0.2, 0.32, 0.75}, radius = 0.32, material = blue }
sphere { center = {1.45, 0.26, 0.65}, radius = 0.26, material = gold }

-- en: Rectangles that glow: a gallery at night.
-- fr name: rectangles lumineux
-- fr: Des rectangles qui éclairent : une galerie la nuit.
