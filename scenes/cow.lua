-- Spot, the cow of Keenan Crane, on a pasture, with calves and neighbours.
--
-- Spot is 5856 triangles. They are read once and kept once, whatever the number of cows: each
-- cow only says how large it is, which way it turns and where it stands.

camera { position = {0.2, 1.5, 6.4}, look_at = {0.1, 0.85, 0}, fov = 40 }
image { width = 800, height = 600, samples = 16 }

ambient { 0.22, 0.25, 0.30 }
-- A lamp as far away as this is as good as the sun: all its shadows are parallel.
light { position = {-450, 750, 900}, color = {1.00, 0.95, 0.84}, intensity = 0.85 }
sky { horizon = "#d5e6f3", zenith = "#3f7fc4" }

local function matt(color) return material { color = color } end

-- Hills are large balls, of which only the tops look out of the ground.
local grass = matt "#6f9a3c"
plane { material = grass }
local function hill(x, z, radius, color)
  sphere { center = {x, 4.5 - radius, z}, radius = radius, material = matt(color) }
end
hill(-30, -70, 60, "#7fa94a")
hill(38, -80, 60, "#6d9c46")
hill(5, -120, 80, "#86b062")

local eye = material { color = "#14100e", specular = 0.9, shininess = 120 }

-- A cow: her feet are 0.737 below the middle of the model.
local function cow(x, z, size, turn, color)
  mesh {
    file = "models/spot.obj", normals = "smooth", scale = size, rotate = {0, turn, 0},
    translate = {x, 0.737 * size, z}, material = matt(color),
  }
  for _, side in ipairs { -1, 1 } do   -- her eyes go where she goes
    sphere {
      center = {side * 0.125, 0.64, -0.455}, radius = 0.065, scale = size, rotate = {0, turn, 0},
      translate = {x, 0.737 * size, z}, material = eye,
    }
  end
end
cow(0.0, 0.0, 1.0, 208, "#f3ece0")
cow(1.65, 0.9, 0.5, 120, "#8a5a3a")
cow(-1.55, 0.5, 0.5, 230, "#3b3431")
cow(-2.9, -5, 1, 255, "#8a5a3a")
cow(3.3, -6.5, 1, 60, "#f3ece0")

-- Clouds are white balls, pressed flat, with a little light of their own.
local cloud = material { color = "#ffffff", emission = 0.25 }
local function puff(x, y, size)
  sphere { scale = {size, 0.35 * size, size}, translate = {x, y, -200}, material = cloud }
end
puff(-42, 27, 8) puff(-33, 28.5, 11) puff(-22, 27, 7)
puff(20, 23, 7)  puff(30, 24, 10)    puff(39, 23, 6)

-- The fence at the end of the pasture.
local wood = matt "#a5835c"
for x = -14, 14, 2 do
  cylinder { base = {x, 0, -10}, top = {x, 1.3, -10}, radius = 0.09, material = wood }
end
for _, y in ipairs { 0.5, 1.05 } do
  cylinder { base = {-15, y, -10}, top = {15, y, -10}, radius = 0.05, material = wood }
end

-- Daisies, strewn as evenly as seeds in a sunflower.
local white, yellow = matt "#ffffff", matt "#ffd21f"
for i = 1, 400 do
  local angle, distance = i * 2.39996, 0.55 * math.sqrt(i)
  local x, z = distance * math.cos(angle), distance * math.sin(angle)
  disk { center = {x, 0.05, z}, normal = {0, 1, 0.5}, radius = 0.035, material = white }
  sphere { center = {x, 0.055, z}, radius = 0.014, material = yellow }
end

-- en: A cow of 5856 triangles on a pasture, with calves and neighbours.
-- fr name: vache
-- fr: Une vache de 5856 triangles dans son pré, avec veaux et voisines.
