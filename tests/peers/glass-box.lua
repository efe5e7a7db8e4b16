-- The same scene as glass-box.pov and glass-box.tachyon: the box of scenes/box.lua with grey
-- mirrors, a ball of glass with a bubble of air in it, and a tinted pane.
camera { position = {0, 0, 6.5}, look_at = {0, 0, 0}, fov = 46 }
image { width = 800, height = 600 }
ambient { 0.15, 0.15, 0.15 }
light { position = {0, 1.75, 0.6}, color = {1, 1, 1}, intensity = 1.2 }
sky { horizon = {0.12, 0.17, 0.30}, zenith = {0.02, 0.04, 0.12} }

local function wall(color, corner, u, v)
  quad { corner = corner, u = u, v = v, material = material { color = color } }
end

wall({0.10, 0.36, 0.11}, {-2, -2, -2}, {4, 0, 0}, {0, 0, 4})   -- floor
wall({0.14, 0.44, 0.16}, {-2,  2, -2}, {4, 0, 0}, {0, 0, 4})   -- ceiling
wall({0.13, 0.46, 0.16}, {-2, -2, -2}, {4, 0, 0}, {0, 4, 0})   -- back
wall({0.07, 0.36, 0.13}, {-2, -2, -2}, {0, 0, 4}, {0, 4, 0})   -- left
wall({0.15, 0.40, 0.08}, { 2, -2, -2}, {0, 0, 4}, {0, 4, 0})   -- right

sphere {
  center = {-0.8, -1.15, -0.9}, radius = 0.85,
  material = material { color = {0.95, 0.05, 0.04}, reflectivity = 0.3, specular = 0.9, shininess = 150 },
}
box {
  min = {0.40, -2.0, -1.2}, max = {1.60, -0.8, 0.0},
  material = material { color = {0.05, 0.14, 0.80}, reflectivity = 0.4, specular = 0.6, shininess = 60 },
}
sphere { center = {0.45, -1.35, 0.9}, radius = 0.55, material = material { transparency = 1, ior = 1.5 } }
sphere { center = {0.55, -1.25, 1.0}, radius = 0.18, material = material { transparency = 1, ior = 1 } }
box {
  min = {-1.7, -1.99, 0.3}, max = {-1.0, -1.0, 0.35},
  material = material { color = {0, 0, 0}, transparency = {0.9, 0.6, 0.3}, ior = 1 },
}
