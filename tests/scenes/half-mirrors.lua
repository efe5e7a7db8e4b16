-- 201 balls of glass that mirror a half and let the other half through: a ray becomes thousands.
camera { position = {0, 1.5, 9}, look_at = {0, 0, 0}, fov = 45 }
light { position = {4, 6, 5}, intensity = 1 }
ambient(0.3); sky { horizon = "#dfe9f2", zenith = "#402010" }
local half = material { transparency = 0.5, reflectivity = 0.5, ior = 1.5 }
for i = 0, 200 do
  local angle, height = i * 2.399963, 1 - i / 100 -- Spread evenly: the golden angle.
  local around = 2.4 * math.sqrt(math.max(0, 1 - height * height))
  sphere { center = {around * math.cos(angle), 2.4 * height, around * math.sin(angle)}, radius = 0.25,
           material = half }
end
