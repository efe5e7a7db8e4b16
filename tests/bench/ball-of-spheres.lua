-- A ball of as many spheres as --time says, spread evenly by the golden angle: whatever their number,
-- the same outline, and most rays meet one of them.
local count = math.max(1, math.floor(t))
local radius = math.min(0.6, 1.8 / math.sqrt(count))
camera { position = {0, 0, 3.6} }
light { position = {4, 6, 5} }; ambient(0.1)
for i = 0, count - 1 do
  local height, angle = 1 - (2 * i + 1) / count, i * math.pi * (3 - math.sqrt(5))
  local across = math.sqrt(1 - height * height) * (1 - radius)
  sphere { center = {across * math.cos(angle), height * (1 - radius), across * math.sin(angle)}, radius = radius }
end
