-- Report A: objects moved by a script, as it wished for: a sun, planets that keep Kepler's
-- third law, and a moon. Space lets the time run; `dioptre animate` makes the film.

camera { position = {0, 4.2, 8.4}, look_at = {0, -0.2, 0}, fov = 46 }
image { width = 800, height = 450, samples = 16, depth = 3 }
ambient { 0.05, 0.05, 0.07 }
sky { horizon = "#0b1026", zenith = "#02030a" }

-- The sun is a light that is seen.
light { position = {0, 0, 0}, color = {1.0, 0.86, 0.6}, intensity = 1.6, radius = 0.55 }

-- orbit RADIUS PERIOD START HEIGHT: where a body is at the time t; a turn takes PERIOD seconds.
local function orbit(radius, period, start, height)
  local angle = 2 * math.pi * (t / period % 1 + start)
  return { radius * math.cos(angle), height * math.sin(angle), radius * math.sin(angle) }
end

-- Third law: the period grows with the radius to the power of 3/2. At radius 1 it is 2 seconds.
local function period(radius)
  return 2 * radius * math.sqrt(radius)
end

local function planet(radius, size, color, start, height, mirror)
  local center = orbit(radius, period(radius), start, height)
  sphere { center = center, radius = size,
           material = material { color = color, specular = 0.25, reflectivity = mirror } }
  return center
end

planet(1.1, 0.13, "#b9a48c", 0.10, 0.05, 0)
planet(1.7, 0.22, "#d9b36c", 0.55, 0.15, 0)
local earth = planet(2.5, 0.26, "#3f74c4", 0.30, 0, 0)
planet(3.4, 0.20, "#c1502e", 0.80, 0.20, 0)
planet(4.6, 0.55, "#caa77f", 0.62, 0.10, 0.25)

local moon = orbit(0.48, 0.9, 0, 0.1)
sphere { center = {earth[1] + moon[1], earth[2] + moon[2], earth[3] + moon[3]}, radius = 0.08,
         material = material { color = 0.8 } }

-- Below, a dark mirror that shows them once more.
plane { point = {0, -1.4, 0}, material = material { color = {0.02, 0.02, 0.04}, reflectivity = 0.35 } }

-- en: A sun, planets that keep Kepler's third law, and a moon: Space lets them move.
-- fr name: orbites
-- fr: Un soleil, des planètes qui suivent la troisième loi de Kepler, une lune : Espace les fait tourner.
