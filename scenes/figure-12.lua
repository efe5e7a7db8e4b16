-- Report A, figure 12: a model with flat normals, the first of its two methods.
--
-- A model is nothing but triangles. The vector at right angles to two edges of a triangle, their
-- cross product, is the normal of all its points. So each triangle is evenly lit, like a facet
-- of a cut stone, and you can count them: Spot the cow has 372 here.
--
-- The report's text does not say which model its figures show. Figure 13 has the second method.

camera { position = {0, 1.1, 4.6}, look_at = {0, 0.05, 0}, fov = 36 }
image { width = 800, height = 600, samples = 16 }

ambient(0.12)
light { position = {-4, 4, 5}, color = {1.00, 0.94, 0.85}, intensity = 0.8 }
light { position = {5, 3, 1}, color = {0.50, 0.65, 1.00}, intensity = 0.35 }
sky { horizon = "#b9c4cf", zenith = "#46566a" }

-- Make "flat" into "smooth", and see what changes. And what does not?
mesh {
  file = "models/spot-low.obj", normals = "flat",
  rotate = {0, 215, 0}, material = material { color = "#efe6d8" },
}

-- It stands on a low round stage.
cylinder {
  base = {0, -1, 0}, top = {0, -0.79, 0}, radius = 1.5,
  material = material { color = "#8d99a6" },
}
