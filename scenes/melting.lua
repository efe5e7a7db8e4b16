-- Distance functions that blend into one another, and a mirror and a glass of them: such a surface is a
-- shape like any other.
--
-- What is in any of two solids, with the seam filled; what is in one and not in the other; edges rounded.

camera { position = {0.4, 2.2, 6}, look_at = {0, 0.65, 0}, fov = 44 }
image { width = 800, height = 600 }
ambient(0.22)
sun { direction = {-1, -1.8, -1.1}, intensity = 0.9 }
sky { horizon = {0.75, 0.85, 0.95}, zenith = {0.2, 0.42, 0.8} }
plane { material = material { color = {0.4, 0.5, 0.55} } }

local drop = distance.sphere { radius = 0.5 }
local two = distance.smooth_union(drop, drop:translate{0.75, 0.35 + 0.2 * math.sin(2 * t), 0}, 0.5)
sdf { two:translate{-0.4, 0.5, 0}, material = material { color = "#d04a3a", specular = 0.5 } }

local die = distance.box { size = {0.8, 0.8, 0.8} }:round(0.08)
local hollow = distance.difference(die, distance.sphere { radius = 0.55 })
sdf { hollow:rotate{0, 30, 0}:translate{-1.9, 0.48, 0.2}, material = material { color = "#e8c547" } }

local ring = distance.torus { major = 0.45, minor = 0.17 }
sdf { ring:rotate{70, 20, 0}:translate{1.75, 0.6, 0.3},
      material = material { color = 0.02, transparency = 0.95, ior = 1.5, specular = 0.6 } }
sdf { distance.intersection(drop:scale(1.3), distance.box { size = {1, 1, 1} }):translate{0.6, 0.5, -1.6},
      material = material { color = {0.1, 0.1, 0.12}, reflectivity = 0.8 } }

-- en: Distance functions that blend into one another, as mirror and glass.
-- fr name: fusion
-- fr: Des fonctions de distance qui fondent l’une dans l’autre, en miroir et en verre.
