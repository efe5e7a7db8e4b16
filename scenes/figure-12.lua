-- Report A, figure 12: a mesh with flat normals, the first of its two methods.
--
-- A mesh is nothing but triangles. The vector at right angles to two edges of a triangle, their
-- cross product, is the normal of all its points. So each triangle is evenly lit, like a facet
-- of a cut stone, and you can count them: Spot the cow has 372 here.
--
-- The report's text does not say which mesh its figures show. Figure 13 has the second method.

camera { position = {0, 1.1, 4.6}, look_at = {0, -0.02, 0}, fov = 37 }
image { width = 800, height = 600, samples = 16 }

ambient(0.10)
light { position = {-3, 5, 5}, color = {1.00, 0.94, 0.85}, intensity = 0.75 }
light { position = {6, 4, 7}, color = {0.60, 0.75, 1.00}, intensity = 0.28 }
sky { color = "#5f7386" }

-- Make "flat" into "smooth", and see what changes. And what does not?
mesh {
  file = "models/spot-low.obj", normals = "flat",
  rotate = {0, 222, 0}, material = material { color = "#efe6d8" },
}

-- It stands on a low round stage.
cylinder {
  base = {0, -1, 0}, top = {0, -0.756, 0}, radius = 1.2,
  material = material { color = "#a9b4bd" },
}

-- en: A mesh of flat triangles.
-- en name: figure 12: facets
-- fr name: figure 12 : facettes
-- fr: Un maillage de triangles, avec une normale par facette.
