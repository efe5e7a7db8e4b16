-- Built to fool the forecast: a sphere ten thousand of its radii away, seen by a telescope.
camera { position = {6e3, 5e3, 6.2e3}, look_at = {0, 0, 0}, fov = 0.015 }
image { width = 320, height = 240, depth = 4 }
ambient(0.1); sky { horizon = "#dfe9f2", zenith = "#5b8fc7" }
light { position = {3, 4, 5} }
sphere { radius = 1, material = material { color = "#c03020" } }
sphere { center = {0.8, 0.6, 0.9}, radius = 0.2, material = material { color = "#f0d060" } }
plane { point = {0, -1, 0}, material = material { color = "#8a9a6b" } }
