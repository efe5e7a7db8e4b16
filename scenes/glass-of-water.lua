-- A glass of water: three media that touch one another.
--
-- Where shapes overlap, the one that comes later in the file is there. So the tumbler is a cylinder
-- of glass, then one of air that hollows it out, then one of water that fills the air: the
-- water's wall is the glass's, in the very same place, and no gap is left between them. Then come the
-- bubbles, balls of air in the water, and a hollow ball of glass beside it. The straw is opaque: it is
-- seen wherever it is. Where it enters the water it looks broken, and so does what is behind.

local glass = material { transparency = 1, ior = 1.5 }
local water = material { transparency = {0.96, 0.98, 1.0}, ior = 1.33 }
local air = material { transparency = 1, ior = 1 }

camera { position = {0.3, 2.2, 6.4}, look_at = {0.15, 0.98, 0}, fov = 38 }
-- depth: from the air into glass, into water and out again are four surfaces, and some light goes to and fro.
image { width = 800, height = 600, samples = 4, depth = 12 }

ambient(0.25)
light { position = {-4, 7, 3}, intensity = 0.8 }
light { position = {5, 4, 4}, color = {1.0, 0.9, 0.8}, intensity = 0.25 }
sky { horizon = {0.82, 0.86, 0.90}, zenith = {0.30, 0.45, 0.70} }

-- The table: planks.
for i = -8, 7 do
  local shade = 0.85 + 0.15 * math.sin(5.3 * i)
  quad { corner = {-6, 0, 0.5 * i - 1}, u = {0, 0, 0.47}, v = {12, 0, 0},
         material = material { color = {0.50 * shade, 0.30 * shade, 0.16 * shade}, specular = 0.15, shininess = 30 } }
end
plane { point = {0, -0.02, 0}, material = material { color = {0.20, 0.13, 0.08} } }
-- A wall behind, with stripes to look at through the glass.
for i = -9, 8 do
  local tone = i % 2 == 0 and {0.55, 0.62, 0.60} or {0.46, 0.54, 0.53}
  quad { corner = {0.5 * i, 0, -4}, u = {0.5, 0, 0}, v = {0, 6, 0}, material = material { color = tone } }
end

-- The tumbler, its hollow, the water up to 1.45, and the bubbles in it.
cylinder { base = {0, 0.002, 0}, top = {0, 2, 0}, radius = 0.75, material = glass }
cylinder { base = {0, 0.15, 0}, top = {0, 2.1, 0}, radius = 0.68, material = air }
cylinder { base = {0, 0.15, 0}, top = {0, 1.45, 0}, radius = 0.68, material = water }
for i = 1, 9 do
  sphere { center = {0.5 * math.cos(2.4 * i), 0.2 + 0.13 * i, 0.5 * math.sin(2.4 * i)},
           radius = 0.02 + 0.004 * (i % 4), material = air }
end

-- The straw.
cylinder { base = {-0.45, 0.17, 0}, top = {0.75, 2.7, -0.1}, radius = 0.055,
           material = material { color = {0.85, 0.10, 0.12}, specular = 0.4 } }

-- A hollow ball, as for a Christmas tree, and a full one of the same size.
sphere { center = {1.75, 0.452, 0.6}, radius = 0.45, material = glass }
sphere { center = {1.75, 0.452, 0.6}, radius = 0.42, material = air }
sphere { center = {-1.6, 0.452, 0.7}, radius = 0.45, material = glass }

-- A lemon and an orange behind.
sphere { center = {-1.3, 0.55, -2.2}, radius = 0.55, material = material { color = {0.95, 0.50, 0.06}, specular = 0.2 } }
sphere { radius = 0.42, scale = {1.35, 1, 1}, rotate = {0, 25, 0}, translate = {1.5, 0.42, -1.8},
         material = material { color = {0.93, 0.82, 0.12}, specular = 0.2 } }

-- en: A glass of water: three media that touch one another.
-- fr name: verre d’eau
-- fr: Un verre d’eau : trois milieux qui se touchent.
