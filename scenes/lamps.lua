-- Report D, its result "lumière": lights that are seen. Three glowing balls hang in a room whose
-- back wall is a mirror, and edges are smooth.
--
-- Each lights what is around it and stands in no other's light; the keys move them like any light.

camera { position = {0, 1.5, 6.5}, look_at = {0, 1.15, 0}, fov = 48 }
image { width = 800, height = 600, samples = 64, depth = 5 }
ambient { 0.03, 0.03, 0.04 }

light { position = {-1.9, 0.9, -0.2}, color = {1.00, 0.35, 0.15}, intensity = 1.3, falloff = "inverse_square", radius = 0.26 }
light { position = { 0.1, 2.3, -0.9}, color = {1.00, 0.90, 0.70}, intensity = 2.2, falloff = "inverse_square", radius = 0.34 }
light { position = { 1.9, 0.7,  0.5}, color = {0.25, 0.55, 1.00}, intensity = 1.3, falloff = "inverse_square", radius = 0.22 }

local plaster = material { color = {0.75, 0.73, 0.70} }
local mirror = material { color = {0.02, 0.02, 0.02}, reflectivity = 0.85 }
plane { material = plaster }
plane { point = {0, 3.2, 0}, normal = {0, -1, 0}, material = plaster }
plane { point = {-3.2, 0, 0}, normal = {1, 0, 0}, material = material { color = {0.7, 0.35, 0.25} } }
plane { point = {3.2, 0, 0}, normal = {-1, 0, 0}, material = material { color = {0.3, 0.4, 0.65} } }
plane { point = {0, 0, 7.5}, normal = {0, 0, -1}, material = plaster }
plane { point = {0, 0, -2.6}, normal = {0, 0, 1}, material = plaster }
quad { corner = {-2.5, 0.3, -2.59}, u = {5, 0, 0}, v = {0, 2.5, 0}, material = mirror }

sphere { center = {-0.5, 0.55, 0.4}, radius = 0.55, material = material { color = {0.1, 0.1, 0.1}, reflectivity = 0.7, specular = 0.3 } }
cylinder { base = {0.75, 0, -0.5}, top = {0.75, 1.1, -0.5}, radius = 0.32, material = plaster }
box { min = {-1.5, 0, 1.0}, max = {-1.0, 0.5, 1.5}, material = plaster }

-- en: Three glowing balls in a room with a mirror.
-- fr name: boules lumineuses
-- fr: Trois boules lumineuses dans une pièce avec un miroir.
