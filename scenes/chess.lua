-- A game of chess in a garden: glass plays against steel.
--
-- All pieces are turned on a lathe, that is, they are balls, eggs and cylinders one above the other. The
-- garden is a panorama, which the glass turns upside down and the steel bends around itself; the lamp has a
-- size, so the shadows are soft, and glass throws a lighter one than steel.

camera { position = {-3.2, 2.5, 7.6}, look_at = {0.1, 0.85, -0.3}, fov = 37 }
image { width = 800, height = 600, samples = 8, depth = 6 }

ambient { 0.34, 0.36, 0.36 }
light { position = {-14, 22, 6}, color = {1.00, 0.95, 0.86}, intensity = 0.85, radius = 2.5 }
sky { image = "pictures/garden.hdr", rotate = 25 }

-- The board: fields of wood and of horn in a frame, on a table of stone.
local dark = material { texture = "pictures/rosewood.jpg", reflectivity = 0.05 }
local bright = material { color = "#e6d5b0", reflectivity = 0.05 }
for i = -4, 3 do
  for k = -4, 3 do
    box { min = {i, -0.3, k}, max = {i + 1, 0, k + 1}, material = (i + k) % 2 == 0 and dark or bright }
  end
end
box { min = {-4.4, -0.35, -4.4}, max = {4.4, -0.02, 4.4}, material = material { color = "#3a2216", specular = 0.4, reflectivity = 0.06 } }
disk { center = {0, -0.35, 0}, radius = 7.5, material = material { color = "#8f9088" } }

local glass = material { color = 0, transparency = {0.98, 0.99, 0.98}, ior = 1.5, specular = 0.5, shininess = 300 }
local steel = material { color = 0.03, reflectivity = {0.62, 0.64, 0.68}, specular = 0.5, shininess = 120 }

-- A ring or a plate, from one height to another; an egg by its middle, its radius and its height.
local function plate(x, z, from, to, radius, stuff)
  cylinder { base = {x, from, z}, top = {x, to, z}, radius = radius, material = stuff }
end
local function egg(x, z, y, radius, height, stuff)
  sphere { scale = {radius, height, radius}, translate = {x, y, z}, material = stuff }
end
-- What all pieces have: a foot, a body with a neck, a collar.
local function body(x, z, height, stuff)
  plate(x, z, -0.1, 0.09, 0.38, stuff)
  egg(x, z, 0.10, 0.34, 0.16, stuff)
  egg(x, z, 0.24, 0.22, 0.45 * height, stuff)
  plate(x, z, 0.2, height, 0.115, stuff)
  egg(x, z, height - 0.07, 0.23, 0.06, stuff)
end
local pieces = {
  pawn = function(x, z, stuff)
    body(x, z, 0.72, stuff)
    egg(x, z, 0.87, 0.22, 0.22, stuff)
  end,
  bishop = function(x, z, stuff)
    body(x, z, 1.15, stuff)
    egg(x, z, 1.30, 0.20, 0.30, stuff)
    egg(x, z, 1.64, 0.07, 0.07, stuff)
  end,
  rook = function(x, z, stuff)
    body(x, z, 0.95, stuff)
    plate(x, z, 0.85, 1.15, 0.28, stuff)
    for i = 0, 5 do
      local angle = math.rad(60 * i)
      box { min = {-0.06, 0, -0.06}, max = {0.06, 0.12, 0.06}, rotate = {0, -60 * i, 0},
            translate = {x + 0.21 * math.cos(angle), 1.14, z + 0.21 * math.sin(angle)}, material = stuff }
    end
  end,
  queen = function(x, z, stuff)
    body(x, z, 1.45, stuff)
    egg(x, z, 1.55, 0.29, 0.15, stuff)
    for i = 0, 7 do
      local angle = math.rad(45 * i)
      egg(x + 0.22 * math.cos(angle), z + 0.22 * math.sin(angle), 1.68, 0.06, 0.06, stuff)
    end
    egg(x, z, 1.74, 0.10, 0.10, stuff)
  end,
  king = function(x, z, stuff)
    body(x, z, 1.60, stuff)
    egg(x, z, 1.72, 0.28, 0.17, stuff)
    plate(x, z, 1.85, 2.28, 0.045, stuff)
    cylinder { base = {x - 0.15, 2.10, z}, top = {x + 0.15, 2.10, z}, radius = 0.045, material = stuff }
  end,
}
-- place: a piece by name, in the middle of a field.
local function place(name, column, row, stuff)
  pieces[name](column - 0.5, row - 0.5, stuff)
end
place("king",    0,  2, glass)
place("bishop",  2,  2, glass)
place("rook",   -1, -2, glass)
place("pawn",    2,  4, glass)
place("pawn",   -1,  3, glass)
place("king",    3, -2, steel)
place("queen",   0, -2, steel)
place("bishop",  0,  0, steel)
place("rook",    4, -2, steel)
place("pawn",    1,  1, steel)
place("pawn",    3,  0, steel)
place("pawn",   -2,  0, steel)

-- en: A game of chess in a garden: glass plays against steel.
-- fr name: échecs
-- fr: Une partie d’échecs dans un jardin : le verre joue contre l’acier.
