-- A block of glass with bubbles, which scatter light in it like the pins of a pinball machine.
camera { position = {0, 1, 6}, look_at = {0, 0, 0}, fov = 40 }
image { width = 320, height = 240 }
ambient(0.3); sky { horizon = "#dfe9f2", zenith = "#402010" }
light { position = {3, 5, 5} }
local function glass(n) return material { color = 0, transparency = 1, ior = n } end
plane { point = {0, -1.2, 0}, material = material { color = "#8a9a6b" } }
quad { corner = {-4,-1,-3}, u = {8,0,0}, v={0,1,0}, material = material { color = "#c02020" } }
quad { corner = {-4,1,-3}, u = {8,0,0}, v={0,1,0}, material = material { color = "#2040c0" } }

box { min = {-1.2,-1,-1}, max = {1.2,1,1}, material = glass(1.5) }
local a = glass(1)
for i = -1, 1 do for j = -1, 1 do sphere { center = {0.8*i, 0.6*j, 0.75}, radius = 0.25, material = a } end end
