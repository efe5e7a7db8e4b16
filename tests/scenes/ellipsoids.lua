-- Two ellipsoids of glass with one centre, turned against each other: light between them is chaotic.
camera { position = {0, 1, 6}, look_at = {0, 0.2, 0}, fov = 40 }
image { width = 320, height = 240 }
ambient(0.3); sky { horizon = "#dfe9f2", zenith = "#402010" }
light { position = {3, 5, 5} }
local function glass(n) return material { color = 0, transparency = 1, ior = n } end
plane { point = {0, -1, 0}, material = material { color = "#8a9a6b" } }
quad { corner = {-4,-1,-3}, u = {8,0,0}, v={0,1,0}, material = material { color = "#c02020" } }
quad { corner = {-4,0,-3}, u = {8,0,0}, v={0,2,0}, material = material { color = "#2040c0" } }
sphere { radius = 1, scale = {1.4,0.3,0.8}, rotate = {20,30,0}, material = glass(1.6) }
sphere { radius = 1, scale = {0.2,0.9,0.5}, rotate = {0,10,30}, material = glass(1.2) }
