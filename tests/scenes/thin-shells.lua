-- Built to fool the forecast: bubbles whose walls are a millionth of their radius.
camera { position = {0, 0.6, 6}, look_at = {0, 0.3, 0}, fov = 40 }
image { width = 320, height = 240, depth = 12 }
ambient(0.4); sky { horizon = "#dfe9f2", zenith = "#402010" }
light { position = {3, 4, 5} }
local glass = material { color = 0, transparency = 0.97, ior = 1.5 }
local air = material { color = 0, transparency = 1, ior = 1 }
for i = -1, 1 do
  sphere { center = {1.5 * i, 0.3, 0}, radius = 0.7, material = glass }
  sphere { center = {1.5 * i, 0.3, 0}, radius = 0.7 * (1 - 1e-6), material = air }
end
plane { point = {0, -0.5, 0}, material = material { color = "#8a9a6b" } }
