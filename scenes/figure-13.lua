-- Report A, figure 13: a model with interpolated normals; beside it figure 12, with flat ones.
--
-- Both are the same 372 triangles. On the right each corner has a normal of its own, and
-- between the corners the normal turns little by little: n = nA + u (nB - nA) + v (nC - nA). The light
-- then shades the triangle as if it were round.
--
-- The report wonders how smooth so few triangles look, and that games do it so. But only the light
-- is deceived: look at the outline and at the shadows. They are as angular as before.

camera { position = {0, 1.25, 6.2}, look_at = {0, 0.02, 0}, fov = 40 }
image { width = 800, height = 600, samples = 16 }

ambient(0.12)
light { position = {-4, 4, 5}, color = {1.00, 0.94, 0.85}, intensity = 0.8 }
light { position = {5, 3, 1}, color = {0.50, 0.65, 1.00}, intensity = 0.35 }
sky { horizon = "#b9c4cf", zenith = "#46566a" }

local hide = material { color = "#efe6d8" }
local stone = material { color = "#8d99a6" }

-- The file of the model has no normals. For "smooth", the program computes those of the corners: the mean of
-- the triangles that meet there.
for i, normals in ipairs { "flat", "smooth" } do
  local x = 2.2 * i - 3.3
  mesh {
    file = "models/spot-low.obj", normals = normals,
    rotate = {0, 215, 0}, translate = {x, 0, 0}, material = hide,
  }
  cylinder { base = {x, -1, 0}, top = {x, -0.79, 0}, radius = 1, material = stone }
end
