-- Report C, figures 2 and 3: with `--offset none` the mirror is full of dark points, where
-- the reflected ray hits the sphere that it leaves; as it is, there are none.
--
-- The points stand in rings and not at random: the same places are rounded the same way each time.

camera { position = {0, 0, 6.5}, look_at = {0, 0, 0}, fov = 30 }
image { width = 640, height = 480, depth = 5 }
ambient { 0.15, 0.15, 0.15 }
light { position = {0, 1.75, 2}, intensity = 1.2 }

local green = material { color = {0.10, 0.42, 0.13} }
local function wall(corner, u, v)
  quad { corner = corner, u = u, v = v, material = green }
end
wall({-2, -2, -2}, {4, 0, 0}, {0, 0, 4}) -- floor
wall({-2,  2, -2}, {4, 0, 0}, {0, 0, 4}) -- ceiling
wall({-2, -2, -2}, {4, 0, 0}, {0, 4, 0}) -- back
wall({-2, -2, -2}, {0, 0, 4}, {0, 4, 0}) -- left
wall({ 2, -2, -2}, {0, 0, 4}, {0, 4, 0}) -- right

sphere { center = {0, -0.2, 0}, radius = 1.2, material = material { color = {0.8, 0.06, 0.05}, reflectivity = 0.6 } }

-- en: A mirror that would be full of dark points without an offset.
-- en name: figure C2: mirror
-- fr name: figure C2 : miroir
-- fr: Un miroir qui serait plein de points noirs sans décalage.
