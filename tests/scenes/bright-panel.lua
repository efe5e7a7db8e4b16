-- Built to fool a cutoff: a panel of light 5000 in a floor that mirrors a ten-thousandth of it.
camera { position = {0, 1, 5}, look_at = {0, 0.5, 0}, fov = 45 }
image { width = 320, height = 240 }
ambient(0.15); sky { horizon = "#dfe9f2", zenith = "#5b8fc7" }
light { position = {3, 4, 5} }
plane { material = material { color = 0.3, reflectivity = 1e-4 } }
quad { corner = {-1, 0.3, -2}, u = {2, 0, 0}, v = {0, 1, 0}, material = material { color = 0, emission = 5000 } }
sphere { center = {1.5, 0.5, 0}, radius = 0.5, material = material { color = "#c03020", reflectivity = 5e-4 } }
