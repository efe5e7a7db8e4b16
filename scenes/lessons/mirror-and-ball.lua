-- The scene of the lesson `02-mirrors.lua`: a mirror on the wall, a ball of glass, and things to
-- see in both.

camera { position = {0, 1.5, 6}, look_at = {0, 1, 0}, fov = 46 }
image { width = 800, height = 600, depth = 8 }
ambient(0.2)
light { position = {-2.5, 4, 4}, intensity = 0.9 }
sky { horizon = {0.80, 0.86, 0.92}, zenith = {0.35, 0.50, 0.72} }

local dark, bright = material { color = {0.20, 0.24, 0.28} }, material { color = {0.78, 0.76, 0.70} }
for i = -6, 5 do
  for j = -4, 7 do
    quad { corner = {i, 0, j}, u = {0, 0, 1}, v = {1, 0, 0}, material = (i + j) % 2 == 0 and dark or bright }
  end
end

-- The mirror keeps a tenth of the light. Its frame stands before it a little.
local frame = material { color = {0.45, 0.28, 0.12}, specular = 0.3, shininess = 40 }
quad { corner = {-2.6, 0.2, -3}, u = {2.6, 0, 0}, v = {0, 2.4, 0}, material = material { color = 0, reflectivity = 0.9 } }
box { min = {-2.8, 0, -3.1}, max = {-2.6, 2.8, -2.9}, material = frame }
box { min = {0, 0, -3.1}, max = {0.2, 2.8, -2.9}, material = frame }
box { min = {-2.6, 0, -3.1}, max = {0, 0.2, -2.9}, material = frame }
box { min = {-2.6, 2.6, -3.1}, max = {0, 2.8, -2.9}, material = frame }

-- Before the mirror a red ball and a yellow cube; behind the glass, four columns.
sphere { center = {-1.7, 0.45, -1}, radius = 0.45, material = material { color = {0.85, 0.12, 0.10}, specular = 0.4 } }
box { min = {-1, 0, -2}, max = {-0.3, 0.7, -1.3}, material = material { color = {0.95, 0.75, 0.12} } }
for i, color in ipairs { {0.85, 0.12, 0.10}, {0.95, 0.72, 0.10}, {0.15, 0.60, 0.20}, {0.12, 0.25, 0.80} } do
  cylinder { base = {0.5 + 0.7 * i, 0, -3.5}, top = {0.5 + 0.7 * i, 1.2 + 0.3 * i, -3.5}, radius = 0.2,
             material = material { color = color, specular = 0.3 } }
end
sphere { center = {1.5, 0.9, 0.6}, radius = 0.9,
         material = material { transparency = 0.96, ior = 1.5, specular = 1, shininess = 400 } }

-- fr name: miroir et boule
-- en: A mirror on the wall, a ball of glass, and things to see in both.
-- fr: Un miroir au mur, une boule de verre, et des objets à y voir.
