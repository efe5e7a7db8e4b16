-- Report C, figures 4 and 5: with `--offset none` lit walls are strewn with black points,
-- where the shadow ray meets the wall that it leaves: shadow acne; as it is, there is none.

camera { position = {0, 0.6, 6.5}, look_at = {0, -0.2, 0}, fov = 38 }
image { width = 640, height = 480 }
ambient { 0.12, 0.12, 0.12 }
light { position = {1.4, 2.7, 2.9}, intensity = 1.1 }

local function matt(r, g, b)
  return material { color = {r, g, b} }
end
quad { corner = {-4.3, -1.1, -3.1}, u = {8.6, 0, 0}, v = {0, 0, 6.2}, material = matt(0.15, 0.5, 0.2) }
quad { corner = {-4.3, -1.1, -3.1}, u = {8.6, 0, 0}, v = {0, 4.4, 0.7}, material = matt(0.13, 0.45, 0.3) }
sphere { center = {-0.9, -0.1, 0.3}, radius = 1, material = matt(0.8, 0.15, 0.1) }
quad { corner = {0.5, -1.1, -0.7}, u = {1.3, 0, 0.6}, v = {0.2, 1.7, -0.3}, material = matt(0.85, 0.7, 0.1) }

-- en: Walls that would be strewn with shadow acne without an offset.
-- en name: figure C4: shadow acne
-- fr name: figure C4 : acné d’ombre
-- fr: Des murs qui seraient couverts d’acné d’ombre sans décalage.
