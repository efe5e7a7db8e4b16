-- The scene of the lesson `08-marching.lua`, the way of report B: first a drawing in the plane, then
-- the same idea in space, then light, shadow and sky.
--
-- The time counts the stages, 25 a second. From 0 to 9 the drawing: so many steps of one ray. From 10
-- on space: 10 shapes without light, 11 with a sun and its shadows, 12 with a sky.

local stage = math.floor(t * 25 + 0.5)
local spacial = 10
image { width = 800, height = 600, samples = 4 }

-- The drawing lies in the plane z = 0. Materials glow in one colour, so it is flat as on paper.
local function ink(color) return material { color = 0, ambient = 0, emission = color } end

local function line(x1, y1, x2, y2, thin, z, paint)
  local x, y = x2 - x1, y2 - y1
  local length = math.sqrt(x * x + y * y)
  local u, v = -y / length * thin, x / length * thin
  quad { corner = {x1 - u / 2, y1 - v / 2, z}, u = {x, y, 0}, v = {u, v, 0}, material = paint }
end

local function ring(x, y, radius, paint)
  local count = 72
  for i = 1, count do
    local a, b = 2 * math.pi * (i - 1) / count, 2 * math.pi * i / count
    line(x + radius * math.cos(a), y + radius * math.sin(a), x + radius * math.cos(b), y + radius * math.sin(b),
         0.03, 0.02, paint)
  end
end

local ball = { x = 3.1, y = 0.9, radius = 0.9 }
local box = { x = 0.2, y = -1.7, half = 0.75 }

-- How far a point of the plane is from the nearest thing.
local function distance_at(x, y)
  local to_ball = math.sqrt((x - ball.x) ^ 2 + (y - ball.y) ^ 2) - ball.radius
  local u, v = math.abs(x - box.x) - box.half, math.abs(y - box.y) - box.half
  local to_box = math.sqrt(math.max(u, 0) ^ 2 + math.max(v, 0) ^ 2) + math.min(math.max(u, v), 0)
  return math.min(to_ball, to_box)
end

local function drawing()
  camera { position = {0, 0, 40}, look_at = {0, 0, 0}, fov = 15 }
  sky { color = "#101820" }
  disk { center = {ball.x, ball.y, 0}, normal = {0, 0, 1}, radius = ball.radius, material = ink "#b03020" }
  quad { corner = {box.x - box.half, box.y - box.half, 0}, u = {2 * box.half, 0, 0}, v = {0, 2 * box.half, 0},
         material = ink "#2a6ab8" }
  local x, y, step = -4.4, -0.95, 0
  local dx, dy = 7, 1.35
  local length = math.sqrt(dx * dx + dy * dy)
  dx, dy = dx / length, dy / length
  line(x, y, x + 10 * dx, y + 10 * dy, 0.015, 0.01, ink "#506070")
  while true do
    local free = distance_at(x, y)
    disk { center = {x, y, 0.04}, normal = {0, 0, 1}, radius = 0.07, material = ink(step == 0 and "#ffffff" or "#ffcd5a") }
    if free < 0.01 or step == stage then break end
    ring(x, y, free, ink "#ffcd5a")
    line(x, y, x + free * dx, y + free * dy, 0.05, 0.03, ink "#ffcd5a")
    x, y, step = x + free * dx, y + free * dy, step + 1
  end
end

local function space()
  camera { position = {1.2, 2.2, 6.6}, look_at = {0.1, 0.5, 0}, fov = 42 }
  local has_sun, has_sky = stage >= spacial + 1, stage >= spacial + 2
  ambient(has_sun and 0.25 or 1)
  if has_sun then sun { direction = {-1, -1.5, -0.7}, intensity = 0.85 } end
  if has_sky then sky { horizon = {0.75, 0.85, 0.95}, zenith = {0.2, 0.42, 0.8} } else sky { color = "#101820" } end
  sdf { distance.box { size = {12, 0.2, 12} }:translate{0, -0.1, 0}, material = material { color = "#5a7a50" } }
  sdf { distance.sphere { radius = 0.8 }:translate{1.5, 0.8, 0}, material = material { color = "#b03020" } }
  sdf { distance.box_frame { size = {1.5, 1.5, 1.5}, edge = 0.2 }:rotate{0, 25, 0}:translate{-1.1, 0.76, 0},
        material = material { color = "#2a6ab8" } }
end

if stage < spacial then drawing() else space() end

-- fr name: avancer pas à pas
-- en: How a ray advances step by step: first in the plane, then in space.
-- fr: Comment un rayon avance pas à pas : d’abord dans le plan, puis dans l’espace.
