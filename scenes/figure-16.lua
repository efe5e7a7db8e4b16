-- Report A, figure 16: mirrors between meshes and spheres.
--
-- A ray that meets a mirror goes on in the reflected direction, whatever it meets next: the teapot
-- sees itself in the ball, and in that image the ball again. The program needs to know the point
-- and the normal only, not which shape it was. The report says neither which meshs its figure
-- shows nor where they are.

camera { position = {0, 2.6, 7.2}, look_at = {0, 0.85, 0}, fov = 44 }
image { width = 800, height = 600, samples = 16, depth = 8 }

ambient(0.16)
light { position = {-4, 7, 5}, color = {1.00, 0.95, 0.86}, intensity = 0.8 }
light { position = {6, 5, 2}, color = {0.60, 0.72, 1.00}, intensity = 0.3 }
sky { horizon = "#c9d3dc", zenith = "#3c5f92" }

local function mirror(color, share)
  return material { color = color, reflectivity = share, specular = 0.8, shininess = 200 }
end

-- The floor: a slab, and the dark fields of a chess board on it.
local dark = mirror("#3b4048", 0.10)
box { min = {-5, -0.2, -5}, max = {5, 0, 5}, material = mirror("#cfc8ba", 0.06) }
for i = -5, 4 do
  for k = -5, 4 do
    if (i + k) % 2 == 0 then
      quad { corner = {i, 0.001, k}, u = {1, 0, 0}, v = {0, 0, 1}, material = dark }
    end
  end
end

-- Two meshes, and a sphere between them.
mesh {
  file = "models/teapot.obj", scale = 0.5, rotate = {0, -30, 0}, translate = {-1.9, 0.002, -0.3},
  material = mirror("#20160a", {0.80, 0.62, 0.34}),
}
mesh {
  file = "models/spot.obj", scale = 1.15, rotate = {0, 145, 0}, translate = {2.05, 0.85, -0.1},
  material = mirror({0.45, 0.06, 0.05}, 0.35),
}
sphere { center = {0.2, 1, -1.2}, radius = 1, material = mirror(0.02, 0.9) }

for i, color in ipairs { "#e6332a", "#ffd500", "#3aaa35", "#1d71b8", "#8a3fa0" } do
  sphere {
    center = {0.9 * i - 2.7, 0.3, 2.3 - 0.15 * (i - 3) ^ 2}, radius = 0.3,
    material = mirror(color, 0.25),
  }
end

-- en: Mirrors between meshes and spheres.
-- en name: figure 16: mirrors
-- fr name: figure 16 : miroirs
-- fr: Des miroirs entre maillages et sphères.
