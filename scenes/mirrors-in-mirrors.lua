-- Report D, its results "miroirs": mirrors in mirrors. Three mirrors stand in a triangle, and a
-- few balls become a field without end.
--
-- Each mirror shows the other two, and what they show: a kaleidoscope. A ray is reflected up to 24
-- times; each mirror keeps a little of the light, so what is far away grows dim. With `--depth 1` you
-- see what a single mirror image is, with `--depth 0` black walls.

camera { position = {0.3, 1.3, 1.05}, look_at = {0, 0.62, -0.6}, fov = 70 }
image { width = 800, height = 600, samples = 16, depth = 24 }

ambient(0.25)
light { position = {0, 5, 0.4}, color = {1, 0.95, 0.85}, intensity = 0.8 }
sky { horizon = "#101c30", zenith = "#2a4468" }

-- The mirrors: an equilateral triangle with its point ahead, in which the camera stands, too.
local mirror = material { color = 0, reflectivity = {0.93, 0.95, 0.96} }
local side, height = 4, 1.6
local x, near, far = side / 2, side / math.sqrt(12), -side / math.sqrt(3)
quad { corner = {-x, 0, near}, u = {x, 0, far - near}, v = {0, height, 0}, material = mirror }
quad { corner = { x, 0, near}, u = {-x, 0, far - near}, v = {0, height, 0}, material = mirror }
quad { corner = {-x, 0, near}, u = {2 * x, 0, 0}, v = {0, height, 0}, material = mirror }

plane { material = material { color = "#d8d0c0" } }
local colors = { "#e6332a", "#f39200", "#ffd500", "#3aaa35", "#1d71b8", "#662483" }
for i, color in ipairs(colors) do
  local angle, radius = math.rad(60 * i + 12), 0.14 + 0.03 * i
  sphere { center = {0.72 * math.cos(angle), radius, 0.72 * math.sin(angle)}, radius = radius,
           material = material { color = color, specular = 0.7, shininess = 90, reflectivity = 0.1 } }
end
cylinder { base = {0, 0, 0}, top = {0, 0.42, 0}, radius = 0.14, material = material { color = "#f4f0e6", specular = 0.4 } }

-- en: Three mirrors in a triangle make a few balls a field without end.
-- fr name: miroirs dans des miroirs
-- fr: Trois miroirs en triangle changent quelques boules en un champ sans fin.
