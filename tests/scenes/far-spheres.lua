-- Spheres so far from the camera that the formulas of the reports have hits beside them, and so many
-- that they are in a tree.
camera { position = {0, 0, 5000}, fov = 0.3 }
ambient(0.5)
light { position = {0, 40, 60} }
plane { point = {0, -14, 0} }
for i = -8, 8 do
    for j = -6, 6 do
        sphere { center = {1.5 * i, 2 * j, i + j}, radius = 0.8 }
    end
end
