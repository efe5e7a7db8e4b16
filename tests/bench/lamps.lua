-- As many lamps as --time says, above spheres on a floor.
camera { position = {0, 3, 7}, look_at = {0, 0.5, 0} }
ambient(0.05)
local count = math.max(1, math.floor(t))
for i = 1, count do
  local angle = 2 * math.pi * i / count
  light { position = {4 * math.cos(angle), 5, 4 * math.sin(angle)}, intensity = 1 / count }
end
plane {}
for i = 0, 8 do
  sphere { center = {(i % 3 - 1) * 1.6, 0.6, (i // 3 - 1) * 1.6}, radius = 0.6 }
end
