-- The same scene as glass.pov: mirrors and clear glass, eight deep.
camera { position = {0.4, 2.4, 7.6}, look_at = {0, 0.85, 0}, fov = 46 }
image { width = 800, height = 600 }
ambient { 0.15, 0.15, 0.15 }
light { position = {-4, 6, 5}, color = {1, 1, 1}, intensity = 0.6 }
light { position = {5, 7, 2}, color = {1, 0.9, 0.75}, intensity = 0.35 }
sky { horizon = {0.45, 0.55, 0.70}, zenith = {0.10, 0.20, 0.45} }

local function matt(color) return material { color = color, specular = 0.4, shininess = 60 } end
local function mirror(color, share)
  return material { color = color, reflectivity = share, specular = 0.5, shininess = 120 }
end
local function clear(ior) return material { transparency = 1, ior = ior } end

plane { material = mirror({0.50, 0.48, 0.42}, 0.2) }
sphere { center = {-2.3, 0.9, -1.6}, radius = 0.9, material = mirror({0.9, 0.2, 0.1}, 0.6) }
sphere { center = {2.2, 0.8, -1.9}, radius = 0.8, material = mirror({0.2, 0.3, 0.9}, 0.75) }
quad { corner = {-1.2, 0.05, -3.6}, u = {2.6, 0, 0.3}, v = {0, 2.2, -0.4}, material = mirror({0.1, 0.1, 0.1}, 0.85) }
cylinder { base = {0.1, 0, -1.4}, top = {0.1, 1.5, -1.4}, radius = 0.3, material = matt {0.95, 0.75, 0.10} }
box { min = {-3.2, 0, 0.4}, max = {-2.4, 0.8, 1.2}, material = matt {0.15, 0.60, 0.25} }
sphere { center = {3.0, 0.45, 0.6}, radius = 0.45, material = matt {0.85, 0.15, 0.55} }

sphere { center = {-0.9, 0.801, 0.6}, radius = 0.8, material = clear(1.5) }
sphere { center = {-0.75, 0.9, 0.7}, radius = 0.25, material = clear(1) }
sphere { center = {0.85, 0.551, 1.6}, radius = 0.55, material = clear(1.33) }
sphere { center = {-0.2, 0.301, 2.6}, radius = 0.3, material = clear(2.42) }
box {
  min = {-0.45, -0.45, -0.45}, max = {0.45, 0.45, 0.45}, rotate = {0, 35, 0},
  translate = {1.75, 0.451, 0.1}, material = clear(1.5),
}
