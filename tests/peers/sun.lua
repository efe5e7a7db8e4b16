-- The same as sun.pov: shapes in the sun.
camera { position = {0.5, 2.6, 7.5}, look_at = {0, 0.8, 0}, fov = 46 }
image { width = 800, height = 600 }
ambient { 0.15, 0.15, 0.15 }
sun { direction = {-1, -1.5, -1.2}, color = {1, 0.95, 0.85}, intensity = 0.8 }
sky { horizon = {0.45, 0.55, 0.70}, zenith = {0.10, 0.20, 0.45} }

local function matt(color) return material { color = color, specular = 0.4, shininess = 60 } end

plane { material = material { color = {0.55, 0.52, 0.45} } }
sphere { center = {-1.2, 0.9, 0.2}, radius = 0.6, material = matt {0.9, 0.3, 0.2} }
box { min = {0.4, 0, -0.8}, max = {1.2, 1.6, 0.0}, material = matt {0.2, 0.5, 0.8} }
cylinder { base = {1.9, 0.3, 1.4}, top = {0.2, 0.9, 1.6}, radius = 0.15, material = matt {0.8, 0.7, 0.2} }
quad { corner = {-3, 0, -3}, u = {6, 0, 0}, v = {0, 2.5, 0}, material = matt {0.5, 0.5, 0.5} }
