-- Report D, its result "réfraction": balls of water, glass and diamond, a glass cylinder, and the
-- pictures behind them. Each surface reflects one fraction of the light and refracts the other (Fresnel).
--
-- From left to right the balls have the ior 1.33, 1.5 and 2.42: the more
-- they bend, the more they mirror. Seen at a flat angle, all of them are mirrors: look at the rims.

camera { position = {0, 1.5, 6.2}, look_at = {0, 1.0, 0}, fov = 50 }
image { width = 800, height = 500, samples = 16, depth = 12 }

ambient { 0.34, 0.36, 0.40 }
light { position = {450, 700, 500}, color = {1, 0.96, 0.88}, intensity = 0.75 }
sky { image = "pictures/garden.hdr", rotate = 20 }

plane { material = material { texture = "pictures/rosewood.jpg", reflectivity = 0 }, scale = 2 }
quad { corner = {-1.5, 0.35, -3}, u = {3.6, 0, 0}, v = {0, 2, 0},
       material = material { texture = "pictures/great-wave.jpg", ambient = 1.4 } }
box { min = {-1.62, 0.2, -3.15}, max = {2.22, 2.47, -3.02}, material = material { color = "#2b1d14", specular = 0.4 } }
sphere { radius = 0.8, rotate = {0, 160, -23.4}, translate = {-2.9, 0.8, -2.2},
         material = material { texture = "pictures/earth.jpg", ambient = 1.4 } }

local function clear(ior)
  return material { color = 0, transparency = 0.98, ior = ior, specular = 0.8, shininess = 400 }
end
for i, ior in ipairs { 1.33, 1.5, 2.42 } do
  sphere { center = {1.45 * i - 3.35, 0.66, 0}, radius = 0.66, material = clear(ior) }
end
cylinder { base = {2.35, 0.003, -0.3}, top = {2.35, 1.9, -0.3}, radius = 0.5, material = clear(1.5) }

-- en: Balls of water, glass and diamond, and the pictures behind them.
-- fr name: rapport D : verre
-- fr: Des boules d’eau, de verre et de diamant, et les images derrière elles.
