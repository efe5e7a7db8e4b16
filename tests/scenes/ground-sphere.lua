-- Built to fool the forecast: the ground is a sphere of a million units, seen from one above it.
camera { position = {0, 1, 5}, look_at = {0, 0.6, 0}, fov = 50 }
image { width = 320, height = 240 }
ambient(0.1); sky { horizon = "#dfe9f2", zenith = "#5b8fc7" }
light { position = {3, 4, 5} }
sphere { center = {0, -1e6, 0}, radius = 1e6, material = material { color = "#8a9a6b" } }
sphere { center = {0, 0.5, 0}, radius = 0.5, material = material { color = "#c03020" } }
