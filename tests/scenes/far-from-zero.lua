-- Built to fool the forecast: a small scene a million units from zero, where tracers count from its middle.
local x, y, z = 1e6, 2e6, -1e6
camera { position = {x, y + 1, z + 5}, look_at = {x, y + 0.6, z}, fov = 50 }
image { width = 320, height = 240 }
ambient(0.1); sky { horizon = "#dfe9f2", zenith = "#5b8fc7" }
light { position = {x + 3, y + 4, z + 5} }
plane { point = {x, y, z}, material = material { color = "#8a9a6b" } }
sphere { center = {x, y + 0.5, z}, radius = 0.5, material = material { color = "#c03020", reflectivity = 0.3 } }
