-- Report A, figure 18: a glass cube, and the image of a sphere that it refracts.
--
-- Light is bent where it enters the cube and where it leaves. Through two faces that are opposite, it
-- goes on as it came, only moved aside. Through two that stand at right angles it cannot leave: it
-- meets the second so flat that all of it is mirrored (total reflection), unless ior is below 1.41.
-- The sphere is seen whole beside the cube, and in pieces in it.

camera { position = {0.4, 2.3, 5.4}, look_at = {0.15, 0.6, -0.1}, fov = 36 }
image { width = 800, height = 600, samples = 16, depth = 12 }

ambient(0.2)
light { position = {-4, 6, 4}, color = {1, 0.96, 0.9}, intensity = 0.8 }
light { position = {5, 4, 2}, color = {0.6, 0.75, 1}, intensity = 0.25 }
sky { horizon = "#d8e2ea", zenith = "#4f7fb5" }

-- A floor of fields, whose lines show how far the light is moved aside.
plane { material = material { color = "#c9bfae" } }
for i = -6, 5 do
  for k = -9, 4 do
    if (i + k) % 2 == 0 then
      quad { corner = {0.6 * i, 0.001, 0.6 * k}, u = {0, 0, 0.6}, v = {0.6, 0, 0},
             material = material { color = "#8c98a3" } }
    end
  end
end

sphere { center = {0.55, 0.75, -1.3}, radius = 0.75,
         material = material { color = "#d8381e", specular = 0.5, shininess = 80 } }

box { min = {-0.7, -0.2, -0.7}, max = {0.7, 1.4, 0.7}, rotate = {0, 20, 0}, translate = {-0.15, 0, 0.4},
      material = material { color = 0, transparency = {0.93, 0.98, 0.97}, ior = 1.5, specular = 0.6, shininess = 300 } }

-- en: A glass cube, and the image of a sphere that it refracts.
-- en name: figure 18: glass cube
-- fr name: figure 18 : cube de verre
-- fr: Un cube de verre, et l’image d’une sphère qu’il réfracte.
