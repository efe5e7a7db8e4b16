-- Report A, figure 19: a die with a texture on its faces, and the earth.
--
-- The die is a mesh whose file says which part of the picture goes where; the earth is a sphere, which
-- takes its texture by longitude and latitude. Africa is in front, as the map's middle is; the die's
-- opposite faces make seven.

camera { position = {0, 1.1, 8.2}, look_at = {0, 0, 0}, fov = 40 }
image { width = 800, height = 450, samples = 16 }

ambient(0.25)
light { position = {-4, 6, 7}, intensity = 0.85 }
sky { horizon = "#20242c", zenith = "#0c0e14" }

mesh {
  file = "models/die.obj", normals = "flat", scale = 1.5,
  rotate = {18, 38, 0}, translate = {-1.35, 0, 0},
  material = material { texture = "pictures/die.png", specular = 0.2, shininess = 60 },
}
sphere {   -- tilted as the earth is, and turned with the hours
  radius = 1.15, rotate = {0, 15 * t - 20, -23.4}, translate = {1.35, 0, 0},
  material = material { texture = "pictures/earth.jpg" },
}

-- en: A die and the earth, with textures.
-- en name: figure 19: textures
-- fr name: figure 19 : textures
-- fr: Un dé et la Terre, avec des textures.
