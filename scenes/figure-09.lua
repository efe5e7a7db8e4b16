-- Report A, figure 9: figure 8 with light that weakens with the distance and with the angle.
--
-- At twice the distance a light gives a quarter of its light ("inverse_square"), and a
-- surface gets the less of it the more it is turned away. Both lights have intensity 200, as in
-- the report. Its program wrote numbers of light into the picture as they were: "linear".
--
-- The report looks along +z, we look along -z: every z of the report has a minus here.

camera { position = {0, 0, 0}, direction = {0, 0, -1}, fov = 32 }
image { width = 800, height = 600, encoding = "linear" }

local function lamp(position, color)
  light { position = position, color = color, intensity = 200, falloff = "inverse_square" }
end

lamp({-6, 0, -12}, {1, 0, 0})
lamp({10, 0, -17}, {0, 0, 1})

sphere { center = {-3, 0, -20}, radius = 1, material = material { color = {0, 0, 1} } }
sphere { center = { 0, 0, -32}, radius = 5, material = material { color = {1, 1, 1} } }

-- en: Light that weakens with the distance and with the angle.
-- en name: figure 9: falloff
-- fr name: figure 9 : atténuation
-- fr: Une lumière qui faiblit avec la distance et avec l’angle.
