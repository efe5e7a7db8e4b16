-- A still life by the light of one paper lantern: soft shadows.
--
-- Near what throws it a shadow is sharp, far away it is blurred; a point in the penumbra sees a part of the lantern only. With `--samples 1`
-- the lantern shines from its centre, and shadows are hard.

camera { position = {0.3, 2.5, 5.6}, look_at = {0.1, 0.62, 0}, fov = 36 }
image { width = 800, height = 600, samples = 64, depth = 4 }
ambient { 0.05, 0.05, 0.06 }
light { position = {-2.6, 3.1, 1.4}, color = {1.00, 0.86, 0.66}, intensity = 19, falloff = "inverse_square", radius = 0.55 }

local function matt(color)
  return material { color = color }
end
local function glazed(color, share)
  return material { color = color, reflectivity = share, specular = 0.5, shininess = 90 }
end

-- The table and the wall behind it.
plane { material = matt({0.46, 0.30, 0.19}) }
plane { point = {0, 0, -2.6}, normal = {0, 0, 1}, material = matt({0.36, 0.40, 0.42}) }

-- A jug and a bowl of cylinders and spheres, a plate, fruit, a candle that is out.
local blue = glazed({0.10, 0.18, 0.38}, 0.08)
cylinder { base = {-0.75, 0, -0.5}, top = {-0.75, 0.1, -0.5}, radius = 0.30, material = blue }
sphere { scale = {1, 1.15, 1}, translate = {-0.75, 0.62, -0.5}, radius = 0.55, material = blue }
cylinder { base = {-0.75, 1.05, -0.5}, top = {-0.75, 1.62, -0.5}, radius = 0.21, capped = false, material = blue }
cylinder { base = {0.75, 0, 0.15}, top = {0.75, 0.05, 0.15}, radius = 0.85, material = glazed({0.80, 0.78, 0.72}, 0.10) }
sphere { center = {0.55, 0.37, 0.0}, radius = 0.32, material = glazed({0.75, 0.10, 0.06}, 0.04) }
sphere { center = {1.05, 0.33, 0.3}, radius = 0.28, material = glazed({0.90, 0.48, 0.05}, 0.03) }
sphere { center = {0.62, 0.30, 0.55}, radius = 0.25, material = glazed({0.45, 0.62, 0.10}, 0.04) }
sphere { center = {-0.35, 0.24, 0.85}, radius = 0.24, material = glazed({0.75, 0.10, 0.06}, 0.04) }
cylinder { base = {1.75, 0, -1.1}, top = {1.75, 1.5, -1.1}, radius = 0.10, material = matt({0.88, 0.85, 0.76}) }
cylinder { base = {1.75, 0, -1.1}, top = {1.75, 0.06, -1.1}, radius = 0.36, material = glazed({0.70, 0.55, 0.22}, 0.35) }
box { min = {-0.5, 0, -0.4}, max = {0.5, 0.12, 0.4}, rotate = {0, 24, 0}, translate = {-1.3, 0, 1.25}, material = matt({0.42, 0.10, 0.12}) }
box { min = {-0.42, 0.12, -0.34}, max = {0.42, 0.22, 0.34}, rotate = {0, 12, 0}, translate = {-1.3, 0, 1.25}, material = matt({0.16, 0.28, 0.22}) }

-- en: A still life by the light of one paper lantern: soft shadows.
-- fr name: nature morte
-- fr: Une nature morte à la lumière d’un lampion : des ombres douces.
