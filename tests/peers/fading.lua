-- The same as fading.pov: two lamps that weaken with the square of the distance.
camera { position = {0.5, 2.6, 7.5}, look_at = {0, 0.8, 0}, fov = 46 }
image { width = 800, height = 600 }
ambient { 0.15, 0.15, 0.15 }
light { position = {-0.5, 2.4, 2.5}, color = {1, 0.9, 0.7}, intensity = 3, falloff = "inverse_square" }
light { position = {3.4, 0.7, 0.4}, color = {0.5, 0.6, 1}, intensity = 1.5, falloff = "inverse_square" }

local function matt(color) return material { color = color, specular = 0.4, shininess = 60 } end

plane { material = material { color = {0.55, 0.52, 0.45} } }
sphere { center = {-1.2, 0.9, 0.2}, radius = 0.6, material = matt {0.9, 0.3, 0.2} }
box { min = {0.4, 0, -0.8}, max = {1.2, 1.6, 0.0}, material = matt {0.2, 0.5, 0.8} }
cylinder { base = {1.9, 0.3, 1.4}, top = {0.2, 0.9, 1.6}, radius = 0.15, material = matt {0.8, 0.7, 0.2} }
quad { corner = {-3, 0, -3}, u = {6, 0, 0}, v = {0, 2.5, 0}, material = matt {0.5, 0.5, 0.5} }
