-- A ball of mirror in a block of glass: light between the two takes chaotic paths, and little of it is lost.
camera { position = {0.9, 1.1, 4.2}, look_at = {0, 0, 0}, fov = 34 }
image { width = 320, height = 240 }
ambient(0.25); sky { horizon = {0.6, 0.7, 0.8}, zenith = {0.1, 0.2, 0.5} }
light { position = {3, 5, 6} }
plane { point = {0, -1.2, 0}, material = material { color = "#8a9a6b" } }
quad { corner = {-4, -1.2, -3}, u = {8, 0, 0}, v = {0, 1, 0}, material = material { color = "#c02020" } }
quad { corner = {-4, -0.2, -3}, u = {8, 0, 0}, v = {0, 2, 0}, material = material { color = "#2040c0" } }
box { min = {-0.7, -0.6, -0.5}, max = {0.7, 0.6, 0.5}, rotate = {10, 20, 30},
      material = material { color = 0, transparency = 1, ior = 1.5 } }
sphere { center = {0.1, 0.1, 0.05}, radius = 0.3, material = material { color = 0.1, reflectivity = 0.95 } }
