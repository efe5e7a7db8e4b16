camera { position = {0, 0.5, 3.2}, look_at = {0, 0, 0}, fov = 50 }
light { position = {3, 5, 4} }
ambient { 0.15, 0.15, 0.15 }
sky { horizon = {0.5, 0.6, 0.8}, zenith = {0.1, 0.2, 0.5} }
mesh { file = "models/spot.obj", normals = "smooth", material = material { color = {0.9, 0.8, 0.7} } }
plane { point = {0, -0.75, 0}, normal = {0, 1, 0}, material = material { color = {0.4, 0.6, 0.4}, reflectivity = 0.2 } }
