-- The scene of the lesson `02-mirrors.lua`: a mirror on a wall, a ball and a cube before it, and two
-- posts beside us, which only the mirror can show.

camera { position = {0, 2.1, 2}, look_at = {0, 0.95, -3}, fov = 60 }
image { width = 800, height = 600, depth = 8 }
ambient(0.3)
light { position = {-2.5, 4, 3}, intensity = 0.9 }
sky { horizon = {0.80, 0.86, 0.92}, zenith = {0.35, 0.50, 0.72} }

local dark, bright = material { color = {0.20, 0.24, 0.28} }, material { color = {0.78, 0.76, 0.70} }
for i = -7, 6 do
  for j = -4, 9 do
    quad { corner = {i, 0, j}, u = {0, 0, 1}, v = {1, 0, 0}, material = (i + j) % 2 == 0 and dark or bright }
  end
end

-- The wall, and the mirror on it, which keeps a tenth of the light. Its frame stands before it a little.
local wall = material { color = {0.62, 0.55, 0.44} }
local frame = material { color = {0.36, 0.20, 0.08}, specular = 0.3, shininess = 40 }
quad { corner = {-7, 0, -3.1}, u = {14, 0, 0}, v = {0, 5, 0}, material = wall }
quad { corner = {-1.7, 0.2, -3}, u = {3.4, 0, 0}, v = {0, 2.3, 0}, material = material { color = 0, reflectivity = 0.9 } }
box { min = {-1.9, 0, -3.1}, max = {-1.7, 2.7, -2.9}, material = frame }
box { min = {1.7, 0, -3.1}, max = {1.9, 2.7, -2.9}, material = frame }
box { min = {-1.7, 0, -3.1}, max = {1.7, 0.2, -2.9}, material = frame }
box { min = {-1.7, 2.5, -3.1}, max = {1.7, 2.7, -2.9}, material = frame }

-- Before the mirror a red ball and a yellow cube; beside us a blue post on the left, a green one on the right.
sphere { center = {-0.75, 0.4, -1.2}, radius = 0.4, material = material { color = {0.85, 0.12, 0.10}, specular = 0.4 } }
box { min = {0.35, 0, -1.55}, max = {1, 0.65, -0.9}, material = material { color = {0.95, 0.75, 0.12} } }
cylinder { base = {-3.45, 0, 1.2}, top = {-3.45, 2, 1.2}, radius = 0.25, material = material { color = {0.12, 0.25, 0.85} } }
cylinder { base = {3.45, 0, 1.2}, top = {3.45, 2, 1.2}, radius = 0.25, material = material { color = {0.15, 0.60, 0.20} } }

-- fr name: miroir et boule
-- en: A mirror on a wall, a ball and a cube before it, and posts that only the mirror shows.
-- fr: Un miroir au mur, une boule et un cube devant lui, et des poteaux que seul le miroir montre.
