-- A cone of glass and a diamond cut as a frustum: light that is totally reflected in them takes chaotic paths.
camera { position = {0.3, 2.0, 6.5}, look_at = {0, 0.3, 0}, fov = 42 }
image { width = 320, height = 240 }
ambient(0.2); sky { horizon = {0.5, 0.6, 0.8}, zenith = {0.1, 0.1, 0.4} }
light { position = {-4, 6, 5}, intensity = 0.9 }
local function glass(n) return material { color = 0, transparency = 1, ior = n } end
plane { point = {0, -0.8, 0}, material = material { color = "#8a9a6b" } }
quad { corner = {-4, -0.8, -3}, u = {8, 0, 0}, v = {0, 1, 0}, material = material { color = "#c02020" } }
quad { corner = {-4, 0.2, -3}, u = {8, 0, 0}, v = {0, 2, 0}, material = material { color = "#2040c0" } }
cone { base = {-0.9, -0.799, 0.4}, top = {-0.8, 1.3, 0.3}, radius = 0.8, material = glass(1.5) }
cone { base = {0.9, 0.6, 0.6}, top = {0.95, -0.75, 0.5}, radius = 0.8, top_radius = 0.15, material = glass(2.42) }
