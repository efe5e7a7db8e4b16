-- Report A, figure 13: a mesh with interpolated normals; beside it figure 12, with flat ones.
--
-- Both are the same 372 triangles. On the right each corner has a normal of its own, and between
-- the corners the normal turns little by little: n = nA + u (nB - nA) + v (nC - nA). The light then
-- shades the triangle as if it were round.
--
-- The report wonders how smooth so few triangles look, and that games do it so. But only the light
-- is deceived: look at the outline and at the shadows. They are as angular as before.

camera { position = {0, 1.2, 6}, look_at = {0, 0.02, 0}, fov = 40 }
image { width = 800, height = 600, samples = 16 }

ambient(0.10)
light { position = {-3, 5, 5}, color = {1.00, 0.94, 0.85}, intensity = 0.75 }
light { position = {6, 4, 7}, color = {0.60, 0.75, 1.00}, intensity = 0.28 }
sky { color = "#5f7386" }

local hide = material { color = "#efe6d8" }
local stone = material { color = "#a9b4bd" }

-- The mesh file has no normals. The program computes those of the corners: the mean over the
-- triangles that meet there, of which the one with the widest angle there counts most.
for i, normals in ipairs { "flat", "smooth" } do
  local x = 2.3 * i - 3.45
  mesh {
    file = "models/spot-low.obj", normals = normals,
    rotate = {0, 222, 0}, translate = {x, 0, 0}, material = hide,
  }
  cylinder { base = {x, -1, 0}, top = {x, -0.756, 0}, radius = 1, material = stone }
end

-- en: The same mesh with flat and with interpolated normals.
-- en name: figure 13: normals
-- fr name: figure 13 : normales
-- fr: Le même maillage, avec une normale par facette, ou interpolée.
