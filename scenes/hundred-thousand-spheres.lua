-- A hundred thousand spheres, from one loop: a drop has fallen into a pond of pearls.
--
-- Sphere i lies on a spiral, at the angle i times the golden angle and at a distance that
-- grows as the root of i. So do the seeds of a sunflower, and it leaves no gap anywhere.
-- The waves are a cosine of the distance from the middle, and weaker further out.
--
-- The program puts a tree over the spheres: boxes in boxes. A ray that misses a box has missed
-- all that is in it. That is why you can walk around in here, and why ten times as many spheres
-- take about twice as long, not ten times. Try it: change count.

local count = 100000

camera { position = {0, 26, 62}, look_at = {0, -3, 4}, fov = 56 }
image { width = 800, height = 600, samples = 16, depth = 3 }

ambient { 0.16, 0.17, 0.20 }
light { position = {-90, 80, 30}, color = {1.00, 0.92, 0.80}, intensity = 0.85 }
light { position = {80, 30, 60}, color = {0.40, 0.55, 1.00}, intensity = 0.25 }
sky { horizon = "#e6bd94", zenith = "#26406e" }

-- Sixty-four materials, from deep water to foam.
local water = {}
for i = 0, 63 do
  local s = i / 63
  water[i] = material {
    color = {0.02 + 0.85 * s ^ 3, 0.12 + 0.75 * s ^ 1.5, 0.40 + 0.55 * s},
    specular = 0.5, shininess = 60,
  }
end

local golden_angle = math.pi * (3 - math.sqrt(5))
for i = 1, count do
  local angle, distance = golden_angle * i, 0.25 * math.sqrt(i)
  local wave = math.cos(0.55 * distance - 3 * t) * math.exp(-distance / 45)
  sphere {
    center = {distance * math.cos(angle), 2.4 * wave, distance * math.sin(angle)},
    radius = 0.25, material = water[math.floor(63 * (0.5 + 0.5 * wave))],
  }
end

-- The bottom of the pond, and the drop that leaps back, and mirrors all of them.
disk {
  center = {0, -2.8, 0}, radius = 0.25 * math.sqrt(count),
  material = material { color = "#06203f" },
}
sphere { center = {0, 9, 0}, radius = 4, material = material { color = 0.02, reflectivity = 0.92 } }

-- en: A hundred thousand spheres: a drop has fallen into a pond of pearls.
-- fr name: cent mille sphères
-- fr: Cent mille sphères : une goutte est tombée dans un étang de perles.
