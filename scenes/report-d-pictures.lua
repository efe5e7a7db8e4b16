-- Report D, its result "textures": one on a rectangle, one on the floor, one on a sphere, and
-- a sky panorama, which a mirror shows too.

camera { position = {0.3, 1.45, 5.6}, look_at = {0, 1.0, 0}, fov = 52 }
image { width = 800, height = 500, samples = 16 }

ambient { 0.30, 0.33, 0.38 }
light { position = {450, 700, 500}, color = {1, 0.96, 0.88}, intensity = 0.8 }
sky { image = "pictures/park.hdr", rotate = 200 }

-- The floor: one plank a scene unit, again and again, without end.
plane { material = material { texture = "pictures/rosewood.jpg", reflectivity = 0.05 } }

-- The Great Wave off Kanagawa, in a frame. A quad shows all of its picture.
local wave = material { texture = "pictures/great-wave.jpg", ambient = 1.6 }
local frame = material { color = "#2b1d14", specular = 0.4 }
box { min = {-2.55, 0.32, -1.16}, max = {0.35, 1.98, -1.02}, material = frame }
quad { corner = {-2.45, 0.42, -1.01}, u = {2.7, 0, 0}, v = {0, 1.5, 0}, material = wave }

sphere {
  center = {1.75, 0.9, -0.5}, radius = 0.9,
  material = material { color = 0, reflectivity = 0.94 },
}
sphere {
  radius = 0.5, rotate = {0, 200, -23.4}, translate = {0.55, 0.5, 0.95},
  material = material { texture = "pictures/earth.jpg", ambient = 1.3 },
}
cylinder {
  base = {-1.15, 0, 0.75}, top = {-1.15, 0.75, 0.75}, radius = 0.38,
  material = material { texture = "pictures/rosewood.jpg", specular = 0.3 },
}

-- en: Pictures on a rectangle, on the floor, on a sphere and in the sky.
-- fr name: rapport D : images
-- fr: Des images sur un rectangle, sur le sol, sur une sphère et dans le ciel.
