-- A telescope, 1000 units away, along an axis: directions are exact across the ray.
camera { position = {0, 0, 1000}, look_at = {0, 0, 0}, fov = 0.02 }
image { width = 320, height = 240 }
ambient(0.3); sky { horizon = "#dfe9f2", zenith = "#402010" }
light { position = {3, 5, 5} }
sphere { center = {0, 0, 0}, radius = 0.1, material = material { color = "#c02020" } }
sphere { center = {0.05, 0.05, 0.2}, radius = 0.03, material = material { color = "#2040c0" } }
box { min = {-0.1,-0.1,-0.1}, max = {-0.02, -0.03, 0.14}, material = material { color = "#20c040" } }
plane { point = {0, -0.12, 0}, material = material { color = "#8a9a6b" } }
