-- Report A, figure 8: shadows, and two lights whose colours add up.
--
-- The report's program knew only two answers yet: a point sees a light, or it does not. How far
-- away the light is and at which angle its light arrives made no difference. Ours always counts the
-- angle; so the lights here are a thousand times too bright. As a photograph that was exposed
-- for too long, the picture cannot show more than full light: whatever sees a light gets all of its
-- colour, and what sees none stays black. Only where light arrives at less than a tenth of a
-- degree would the two differ, and that is less than a pixel.
--
-- The report looks along +z, we look along -z: every z of the report has a minus here.

camera { position = {0, 0, 0}, direction = {0, 0, -1}, fov = 32 }
image { width = 800, height = 600 }

local too_bright = 1000
light { position = {-6, 0, -12}, color = {1, 0, 0}, intensity = too_bright }
light { position = {10, 0, -17}, color = {0, 0, 1}, intensity = too_bright }

-- The small sphere throws its shadow on the large one: red is missing there.
-- It is blue, so the red light cannot be seen on it at all.
sphere { center = {-3, 0, -20}, radius = 1, material = material { color = {0, 0, 1} } }
sphere { center = { 0, 0, -32}, radius = 5, material = material { color = {1, 1, 1} } }

-- en: Shadows, and two lights whose colours add up.
-- en name: figure 8: shadows
-- fr name: figure 8 : ombres
-- fr: Des ombres, et deux lampes dont les couleurs s’ajoutent.
