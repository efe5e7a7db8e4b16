-- A bumpy ball in as many rows as --time says: ball.awk makes the model.
camera { position = {0, 0, 3.6} }
light { position = {4, 6, 5} }; ambient(0.1)
mesh { file = "ball-" .. math.floor(t) .. ".obj" }
