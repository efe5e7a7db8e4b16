-- The same shapes as shapes.pov: cylinder, pipe, disk, triangle, a turned box and an egg.
camera { position = {0.5, 2.6, 7.5}, look_at = {0, 0.8, 0}, fov = 46 }
image { width = 800, height = 600 }
ambient { 0.15, 0.15, 0.15 }
light { position = {-4, 6, 5}, color = {1, 1, 1}, intensity = 0.9 }
sky { horizon = {0.12, 0.17, 0.30}, zenith = {0.02, 0.04, 0.12} }

local function matt(color) return material { color = color, specular = 0.4, shininess = 60 } end
plane { material = material { color = {0.55, 0.52, 0.45} } }
cylinder { base = {-2.2, 0, -0.5}, top = {-2.0, 1.8, -0.8}, radius = 0.6, material = matt {0.1, 0.2, 0.8} }
cylinder {
  base = {1.2, 0.45, 1.6}, top = {2.3, 0.5, 0.3}, radius = 0.42, capped = false,
  material = matt {0.8, 0.45, 0.2},
}
disk { center = {-0.5, 1.0, -1.6}, normal = {0.3, 0.4, 1}, radius = 0.9, material = matt {0.1, 0.6, 0.2} }
triangle { a = {1.1, 0.1, -1.2}, b = {2.6, 0.6, -1.6}, c = {1.5, 2.1, -1.9}, material = matt {0.8, 0.1, 0.1} }
box {
  min = {-0.5, -0.5, -0.5}, max = {0.5, 0.5, 0.5}, scale = {1, 0.7, 1.4}, rotate = {20, 35, -10},
  translate = {0.6, 0.9, 0.2}, material = matt {0.6, 0.3, 0.7},
}
sphere {
  scale = {0.4, 0.75, 0.4}, rotate = {0, 0, 30}, translate = {-0.9, 0.7, 1.4},
  material = matt {0.9, 0.8, 0.6},
}
