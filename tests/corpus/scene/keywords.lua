local g = material { color = {1, 0.5, 0}, transparency = 0.9, ior = 1.5 }
camera { position = {0, 0, 9}, look_at = {0, 0, 0}, fov = 40 }
image { width = 9, height = 9, samples = 4, depth = 3 }
light { position = {1, 2, 3}, radius = 0.5 }
sun { direction = {0, -1, 0} }
sky { horizon = 1, zenith = {0, 0, 1} }
for i = 1, 3 do sphere { center = {i, 0, t}, material = g } end
box { min = {0, 0, 0}, max = {1, 1, 1}, rotate = {1, 2, 3} }
mesh { file = "models/die.obj", material = material { texture = "pictures/die.png" } }
local ok, why = pcall(error, { "x" }) print(tostring(ok), why)
for k, v in pairs({ a = 1, [g] = 2, 3 }) do print(k, v) end
