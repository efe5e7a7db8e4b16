-- A pond at sunset: balls that float, half above the water and half below.
--
-- The water is one plane (ior 1.33) that both mirrors and lets through. Far away, where you look at it
-- flat, it is a mirror of the sky; at your feet you look down to the bottom. Between the two lies
-- Fresnel's law. What is below the water looks higher up and nearer than it is.

camera { position = {0, 1.7, 7.4}, look_at = {0, 0.5, 0}, fov = 50 }
image { width = 800, height = 500, samples = 16, depth = 8 }

-- The sun is a glowing ball far away, so that it is seen, in the water too.
light { position = {-250, 62, -900}, color = {1, 0.62, 0.30}, intensity = 1.35, radius = 26 }
light { position = {300, 400, 500}, color = {0.45, 0.60, 1.00}, intensity = 0.22 }
ambient { 0.20, 0.17, 0.22 }
sky { horizon = {0.95, 0.36, 0.10}, zenith = {0.02, 0.07, 0.55} }

-- The bottom, with pebbles; the water above it.
plane { point = {0, -1.1, 0}, material = material { color = {0.26, 0.24, 0.17} } }
for i = 1, 260 do
  local angle, distance = 2.39996 * i, 0.42 * math.sqrt(i)
  local tone = 0.35 + 0.3 * math.sin(7.1 * i)
  sphere {
    scale = {0.20 + 0.07 * math.sin(3 * i), 0.10, 0.16}, rotate = {0, 50 * i, 0},
    translate = {distance * math.cos(angle), -1.08, 1.5 + distance * math.sin(angle)},
    material = material { color = {0.5 * tone + 0.2, 0.45 * tone + 0.18, 0.4 * tone + 0.15} },
  }
end
plane { material = material { color = 0, transparency = {0.82, 0.93, 0.92}, ior = 1.33, specular = 0.4, shininess = 600 } }

-- The balls.
local function ball(x, z, radius, color, mirror)
  sphere { center = {x, 0.08 * radius, z}, radius = radius,
           material = material { color = color, reflectivity = mirror, specular = 0.7, shininess = 120 } }
end
ball(-1.5, 0.4, 0.80, "#c62a1c", 0.08)
ball( 0.5, -1.4, 1.00, 0.02, 0.90)
ball( 1.6, 1.5, 0.55, "#f0b41c", 0.08)
ball( 0.0, 2.4, 0.34, "#e9e2d4", 0.06)
ball( 3.3, -1.6, 0.70, "#1d6f8a", 0.10)
ball(-3.6, -2.6, 0.60, "#efe6da", 0.06)
ball(-0.8, -6.5, 0.70, "#7a2f86", 0.10)

-- Lily leaves, and reeds.
local leaf = material { color = "#3f7a34", specular = 0.2 }
for i = 1, 9 do
  local angle = 2.39996 * i
  disk { center = {2.9 + 0.34 * math.sqrt(i) * math.cos(angle), 0.012, 0.55 + 0.34 * math.sqrt(i) * math.sin(angle)},
         radius = 0.22 + 0.04 * math.sin(5 * i), material = leaf }
end
local reed = material { color = "#4a5a26" }
for i = 1, 24 do
  local x, z = -3.3 + 0.55 * math.sin(11 * i), 0.8 + 0.5 * math.cos(17 * i)
  local lean, tall = 0.25 * math.sin(5 * i), 1.2 + 0.5 * math.sin(3 * i)
  cylinder { base = {x, -1.1, z}, top = {x + lean, tall, z + 0.3 * lean}, radius = 0.016, material = reed }
end

-- en: A pond at sunset: balls that float, half under water.
-- fr name: étang
-- fr: Un étang au coucher du soleil : des boules flottent à moitié sous l’eau.
