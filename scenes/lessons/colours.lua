-- The scene of the lesson `04-colours.lua`: pure colours of things under pure colours of light.
--
-- The time counts the stages, 25 a second: 0 is a white lamp, 1 a red one, 2 a red and a green one,
-- 3 a red, a green and a blue one. There is no other light, so that nothing washes the colours out.

camera { position = {0, 1.5, 9}, look_at = {0, 1.15, 0}, fov = 40 }
image { width = 800, height = 600, samples = 4 }
ambient(0)

local stage = math.floor(t * 25 + 0.5)
local function lamp(x, y, color)
  light { position = {x, y, 6}, color = color, intensity = 0.85 }
end
if stage <= 0 then
  lamp(-3, 4.6, {1, 1, 1})
else
  lamp(-3, 4.6, {1, 0, 0})
end
if stage >= 2 then lamp(3, 4.6, {0, 1, 0}) end
if stage >= 3 then lamp(0, 5.6, {0, 0, 1}) end

-- White wall and white floor: they give back all the light that they get.
local white = material { color = {1, 1, 1} }
quad { corner = {-6.71758, 0.36904, -1.6148}, u = {12, 0, 0}, v = {0, 6, 0}, material = white }
quad { corner = {-6, 0, -1.6}, u = {0, 0, 10}, v = {12, 0, 0}, material = white }

-- Each ball gives back what its colour says, and nothing else.
for i, color in ipairs { {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, 1} } do
  sphere { center = {1.3 * (i - 3), 0.5, 0.4}, radius = 0.5, material = material { color = color } }
end

-- A white ball in the air: its shadows lie on the wall.
sphere { center = {0, 2.9, 0.4}, radius = 0.4, material = white }

-- fr name: couleurs pures
-- en: Five balls of pure colours, under one to three lamps of pure colours.
-- fr: Cinq boules de couleurs pures, sous une à trois lampes de couleurs pures.
