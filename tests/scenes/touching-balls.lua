-- Balls of glass that only touch: light leaves them on regular paths.
camera { position = {0, 1, 6}, look_at = {0, 0, 0}, fov = 40 }
image { width = 320, height = 240 }
ambient(0.3); sky { horizon = "#dfe9f2", zenith = "#402010" }
light { position = {3, 5, 5} }
local function glass(n) return material { color = 0, transparency = 1, ior = n } end
plane { point = {0, -1.2, 0}, material = material { color = "#8a9a6b" } }
quad { corner = {-4,-1,-3}, u = {8,0,0}, v={0,1,0}, material = material { color = "#c02020" } }
quad { corner = {-4,1,-3}, u = {8,0,0}, v={0,1,0}, material = material { color = "#2040c0" } }

local g = glass(1.5)
sphere { center = {-1,0,0}, radius = 1, material = g }
sphere { center = {1,0,0}, radius = 1, material = g }
sphere { center = {0,1.7320508075688772,0}, radius = 1, material = g }
sphere { center = {0,0.5773502691896258,1.632993161855452}, radius = 1, material = g }
