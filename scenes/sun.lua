-- Report B, its sun and its sky: standing stones in the last light of a day.
--
-- The sun's light is parallel, so all shadows point the same way, each as many times as long as what
-- throws it is tall. --time moves the sun, an hour each: at 0 it is low, at 4 it stands high.

local height = math.rad(9 + 14 * t)
local around = math.rad(-82 + 15 * t)

camera { position = {0, 2.6, 11}, look_at = {0, 1.3, 0}, fov = 50 }
image { width = 800, height = 600, samples = 16 }
sun {
  direction = {-math.cos(height) * math.sin(around), -math.sin(height), -math.cos(height) * math.cos(around)},
  color = {1, 0.55 + 0.09 * t, 0.28 + 0.14 * t},
  intensity = 1.5,
}
sky { horizon = {0.95, 0.62, 0.38}, zenith = {0.10, 0.20, 0.42} }
ambient { 0.10, 0.13, 0.20 }

plane { material = material { color = {0.30, 0.36, 0.14} } }
local stone = material { color = {0.52, 0.49, 0.45} }
for i = 0, 11 do
  local angle = math.rad(30 * i + 15)
  local x, z = 4.2 * math.cos(angle), 4.2 * math.sin(angle)
  local tall = 2.1 + 0.35 * math.sin(5 * i)
  box { min = {-0.45, 0, -0.28}, max = {0.45, tall, 0.28}, material = stone,
        rotate = {0, 90 - math.deg(angle) + 7 * math.sin(3 * i), 2.5 * math.sin(7 * i)}, translate = {x, 0, z} }
end
box { min = {-1.1, 0, -0.5}, max = {1.1, 0.55, 0.5}, material = stone, rotate = {0, 20, 0} }
sphere { center = {2.1, 0.42, 2.2}, radius = 0.42, material = stone }

-- en: Standing stones in the last light of a day: the sun and its sky.
-- fr name: soleil
-- fr: Des pierres levées aux dernières lueurs du jour : le soleil et son ciel.
