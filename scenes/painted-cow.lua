-- Spot, with the picture that Keenan Crane painted for her, before a mirror in a park.
--
-- Her model says for each corner where on the picture it lies. The park is a panorama with light of up
-- to 69 120 in its sun: the mirror and the polished floor show it, the camera cuts it at 1.

camera { position = {2.3, 1.25, 3.4}, look_at = {0.05, 0.72, 0}, fov = 40 }
image { width = 800, height = 600, samples = 16 }

ambient { 0.42, 0.45, 0.50 }
light { position = {500, 800, 500}, color = {1, 0.95, 0.85}, intensity = 0.7 }
sky { image = "pictures/park.hdr", rotate = 235 }

local polished = material { color = "#30343a", reflectivity = 0.25, specular = 0.5, shininess = 200 }
disk { radius = 1.7, material = polished }
plane { point = {0, -0.05, 0}, material = material { color = "#63704a" } }

mesh {
  file = "models/spot.obj", normals = "smooth", rotate = {0, 150, 0}, translate = {0.25, 0.737, 0.1},
  material = material { texture = "pictures/spot.png", specular = 0.15, shininess = 40 },
}
box {   -- the mirror
  min = {-0.9, 0, -0.03}, max = {0.9, 1.8, 0.03}, rotate = {0, 62, 0}, translate = {-1.05, 0, -0.35},
  material = material { color = 0.02, reflectivity = 0.9 },
}

-- en: A painted cow before a mirror in a park.
-- fr name: vache peinte
-- fr: Une vache peinte devant un miroir dans un parc.
