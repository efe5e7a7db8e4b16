-- Two mirrors that face each other, and one between them: --depth says how often rays are mirrored.
camera { position = {0.3, 0.4, 1.6}, look_at = {0, 0, -2}, fov = 60 }
light { position = {1, 1.5, 0} }; ambient(0.1)
local mirror = material { color = 0.05, reflectivity = 0.95 }
plane { point = {0, 0, -2}, normal = {0, 0, 1}, material = mirror }
plane { point = {0, 0, 2}, normal = {0, 0, 1}, material = mirror }
sphere { center = {0, 0, -0.5}, radius = 0.5, material = material { color = "#c04030" } }
