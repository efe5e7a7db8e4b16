-- A ball of glass and a mirroring one in a room of mirrors, which sends rays back to them again and again.
camera { position = {0.3, 0.2, 1.6}, look_at = {0, 0, -1}, fov = 60 }
image { width = 320, height = 240 }
ambient(0.2); light { position = {0.5, 1, 0.5}, intensity = 0.7 }
local m = material { color = 0.1, reflectivity = 0.9 }
box { min = {-2,-1.5,-2}, max = {2,1.5,2}, material = m }
sphere { center = {0.4,-0.3,-0.6}, radius = 0.5, material = material { color = "#c05020", reflectivity = 0.3 } }
sphere { center = {-0.7,0.2,-0.8}, radius = 0.4, material = material { color = 0, transparency = 0.95, ior = 1.5 } }
