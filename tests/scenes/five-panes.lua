-- Built to fool a cutoff: light that five panes of glass mirror to and fro, share by small share.
camera { position = {0, 1, 5}, look_at = {0, 0.5, 0}, fov = 45 }
image { width = 320, height = 240 }
ambient(0.15); sky { horizon = "#dfe9f2", zenith = "#5b8fc7" }
light { position = {3, 4, 5} }
plane { material = material { color = "#8a9a6b" } }
local glass = material { color = 0.02, transparency = 0.95, ior = 1.5 }
for i = 1, 5 do
  box { min = {-1.5, 0.1, 2.2 - 0.8 * i}, max = {1.5, 1.4, 2.3 - 0.8 * i}, material = glass }
end
sphere { center = {0.4, 0.4, -3}, radius = 0.4, material = material { color = "#c03020" } }
