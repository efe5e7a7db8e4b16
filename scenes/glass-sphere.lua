-- Report A, what its author could not draw: a glass ball. It turns what is behind it upside
-- down.
--
-- Light is bent twice, where it enters and where it leaves, and the rays that come from far behind
-- meet half a radius beyond the ball. Move nearer and look: past that point the picture stands
-- upright again. At the rim the ball mirrors, for glass does so at a flat angle (Fresnel). Make ior
-- 1 and the ball is not there; 1.33 is water, 2.42 is diamond.

local ior = 1.5

camera { position = {0, 1.25, 5.2}, look_at = {0, 0.95, 0}, fov = 42 }
image { width = 800, height = 600, samples = 16, depth = 8 }

ambient(0.22)
light { position = {-3, 6, 4}, intensity = 0.75 }
light { position = {4, 3, 3}, color = {1, 0.85, 0.7}, intensity = 0.25 }
sky { horizon = {0.72, 0.82, 0.92}, zenith = {0.16, 0.34, 0.66} }

-- The floor: a chessboard.
local dark = material { color = {0.16, 0.20, 0.24} }
local bright = material { color = {0.80, 0.78, 0.72} }
for i = -5, 4 do
  for j = -8, 3 do
    quad { corner = {i, 0, j}, u = {0, 0, 1}, v = {1, 0, 0},
           material = (i + j) % 2 == 0 and dark or bright }
  end
end

-- Behind the ball, from left to right: red, yellow, green, blue. In the ball it is the other way.
local colors = { {0.85, 0.12, 0.10}, {0.95, 0.72, 0.10}, {0.15, 0.60, 0.20}, {0.12, 0.25, 0.80} }
for i, color in ipairs(colors) do
  cylinder { base = {1.5 * i - 3.75, 0, -4}, top = {1.5 * i - 3.75, 1.5 + 0.3 * i, -4}, radius = 0.32,
             material = material { color = color, specular = 0.3 } }
end

-- The ball. Its lamp-light goes through, so its shadow is a faint one: each surface keeps 4 %.
sphere { center = {0, 1, 0}, radius = 1, material = material { transparency = 0.96, ior = ior, specular = 1, shininess = 400 } }

-- en: A glass ball, which turns what is behind it upside down.
-- fr name: sphère de verre
-- fr: Une boule de verre, qui renverse ce qui est derrière elle.
