-- The same as pictures.pov: a map on a sphere, a glass ball, and a panorama around them.
camera { position = {0.4, 0.9, 5.2}, look_at = {0.1, 0.1, 0}, fov = 46 }
image { width = 800, height = 600 }
ambient { 0.15, 0.15, 0.15 }
light { position = {-4, 6, 5}, color = {1, 1, 1}, intensity = 0.9 }
sky { image = "stars.jpg" }

sphere {
  center = {-1.1, 0, 0}, radius = 1.05,
  material = material { texture = "earth.jpg", specular = 0.4, shininess = 60 },
}
sphere { center = {1.3, 0, 0}, radius = 1, material = material { transparency = 1, ior = 1.5 } }
