-- Built to fool the forecast: four mirroring spheres that touch; every turn makes rays go apart.
camera { position = {0, 0.6, 6}, look_at = {0, 0.3, 0}, fov = 40 }
image { width = 320, height = 240, depth = 24 }
ambient(0.1); sky { horizon = "#dfe9f2", zenith = "#402010" }
light { position = {3, 4, 5} }
local mirror = material { color = 0.02, reflectivity = 0.97 }
for _, p in ipairs { {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1} } do
  sphere { center = p, radius = 1.3, material = mirror }
end
