-- Built to fool the forecast: a lamp that is very bright, and a thousandth above the floor.
camera { position = {0, 1, 5}, look_at = {0, 0.6, 0}, fov = 50 }
image { width = 320, height = 240 }
ambient(0.02); sky { horizon = "#202830", zenith = "#101418" }
light { position = {0.9, 0.001, 1}, intensity = 40, radius = 0.0005, falloff = "inverse_square" }
plane { material = material { color = "#8a9a6b" } }
sphere { center = {0, 0.5, 0}, radius = 0.5, material = material { color = "#c03020" } }
