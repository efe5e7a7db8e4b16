-- The Utah teapot, blown of glass, on a polished table in a garden.
--
-- The model has an outer and an inner wall, and glass between the two. A ray that meets it splits in a
-- mirrored and a bent one, and each of these again where it meets a wall: up to 64 of them bring
-- back what one pixel shows. The dark rims are total reflections: there the glass shows the table.

camera { position = {0.9, 2.3, 8.8}, look_at = {0.15, 1.45, 0}, fov = 45 }
image { width = 800, height = 600, samples = 4, depth = 6 }

ambient { 0.34, 0.36, 0.36 }
light { position = {-14, 20, 10}, color = {1.00, 0.95, 0.86}, intensity = 0.8, radius = 2 }
sky { image = "pictures/garden.hdr", rotate = 20 }

plane { material = material { texture = "pictures/rosewood.jpg", reflectivity = 0.06 }, scale = 4 }
mesh {
  file = "models/teapot.obj", normals = "smooth", rotate = {0, -25, 0}, translate = {0, 0.002, 0},
  material = material { color = 0, transparency = {0.97, 0.98, 0.97}, ior = 1.5, specular = 0.5, shininess = 300 },
}

-- en: A teapot of glass on a polished table in a garden.
-- fr name: théière de verre
-- fr: Une théière de verre sur une table polie dans un jardin.
