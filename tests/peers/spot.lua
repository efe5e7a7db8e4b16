-- The same as spot.pov: Spot the cow twice, once flat and once smooth.
camera { position = {0.3, 1.4, 4.2}, look_at = {0, 0.75, 0}, fov = 46 }
image { width = 800, height = 600 }
ambient { 0.15, 0.15, 0.15 }
light { position = {-4, 6, 5}, color = {1, 1, 1}, intensity = 0.9 }
sky { horizon = {0.12, 0.17, 0.30}, zenith = {0.02, 0.04, 0.12} }

plane { material = material { color = {0.55, 0.52, 0.45} } }
mesh {
  file = "spot.obj", normals = "flat", rotate = {0, 150, 0}, translate = {-0.9, 0.74, 0},
  material = material { color = {0.2, 0.5, 0.8}, specular = 0.4, shininess = 60 },
}
mesh {
  file = "spot.obj", normals = "smooth", rotate = {0, 220, 0}, translate = {0.9, 0.74, 0},
  material = material { color = {0.8, 0.5, 0.3}, specular = 0.4, shininess = 60 },
}
