-- Report A, figure 7: its first picture. Two spheres, each in one flat colour.
--
-- No light is needed: a ray that meets a sphere brings back the sphere's colour, and nothing else.
-- So the material is black, with light of its own. The report's text does not say which colours
-- its figure has; these are those of its next figures.
--
-- The report looks along +z, we look along -z. Every z of the report is written with a minus
-- here; left stays left, and right stays right.

camera { position = {0, 0, 0}, direction = {0, 0, -1}, fov = 32 }
image { width = 800, height = 600 }

local function flat(color)
  return material { color = 0, emission = color }
end

-- "celle de gauche": the one on the left. The two run into each other: each pixel shows
-- the sphere that its ray meets first, which is what the report wanted to see.
sphere { center = {-5, 0, -32}, radius = 3, material = flat {0, 0, 1} }
sphere { center = { 0, 0, -32}, radius = 5, material = flat {1, 1, 1} }

-- en: Two spheres in flat colours: no light is computed yet.
-- en name: figure 7: flat colours
-- fr name: figure 7 : couleurs unies
-- fr: Deux sphères de couleur unie : la lumière n’est pas encore calculée.
