-- The Utah teapot (Martin Newell, 1975), which is to computer graphics what the fruit fly is to
-- biology.
--
-- It is 6320 triangles. All else on the tea table is made of shapes that you can write down: cups
-- are cylinders, saucers are flat spheres, sugar is boxes.

camera { position = {1.6, 5.4, 11}, look_at = {0.15, 1.05, 0.2}, fov = 45 }
image { width = 800, height = 600, samples = 16, depth = 5 }

ambient { 0.17, 0.17, 0.19 }
light { position = {-7, 9, 5}, color = {1.00, 0.90, 0.76}, intensity = 0.85 }
light { position = {8, 6, 4}, color = {0.55, 0.70, 1.00}, intensity = 0.28 }
sky { horizon = "#6f8791", zenith = "#f4f1ea" }   -- a dim room with a bright ceiling

local function glaze(color, mirror)
  return material { color = color, specular = 0.7, shininess = 150, reflectivity = mirror }
end
local blue, white = glaze("#1f4fa3", 0.14), glaze("#f2efe8", 0.08)
local tea = material { color = "#8a3a08", specular = 0.4, shininess = 200, reflectivity = 0.10 }

-- The table is round and polished, so that it mirrors a little.
cylinder { base = {0, -0.4, 0}, top = {0, 0, 0}, radius = 7, material = glaze("#6b3d20", 0.10) }

mesh {
  file = "models/teapot.obj", rotate = {0, -20, 0}, translate = {-0.6, 0.02, -0.6},
  material = blue,
}

-- A cup at x, z: the saucer, the cup's outside and inside, tea, and an ear.
local function cup(x, z)
  sphere { scale = {1.25, 0.09, 1.25}, translate = {x, 0.08, z}, material = white }
  local base, top = {x, 0.15, z}, {x, 1.1, z}
  cylinder { base = base, top = top, radius = 0.70, capped = false, material = blue }
  cylinder { base = base, top = top, radius = 0.66, capped = false, material = white }
  disk { center = {x, 0.9, z}, radius = 0.68, material = tea }
  cylinder {
    base = {x + 0.88, 0.63, z - 0.08}, top = {x + 0.88, 0.63, z + 0.08}, radius = 0.3,
    capped = false, material = blue,
  }
end
cup(3.1, 1.9)
cup(-2.3, 3.0)

-- Sugar, and one lump that has fallen beside the others.
local sugar = material { color = "#fbf8f2" }
local function lump(turn, place)
  box {
    min = {-0.2, 0, -0.2}, max = {0.2, 0.4, 0.2},
    rotate = {0, turn, 0}, translate = place, material = sugar,
  }
end
lump(20, {0.60, 0.0, 3.40})
lump(55, {1.15, 0.0, 3.20})
lump( 5, {0.88, 0.4, 3.28})
lump(70, {1.75, 0.0, 3.90})

-- en: The Utah teapot, the best known model of computer graphics.
-- fr name: théière
-- fr: La théière de l’Utah, le modèle le plus connu de l’image de synthèse.
