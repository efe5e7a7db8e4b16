-- A sphere so far from the camera that the formulas of the reports have hits beside it.
camera { position = {0, 0, 5000}, fov = 0.05 }
ambient(1)
sphere {}
