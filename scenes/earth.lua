-- The earth before the stars, as from a spaceship. --time turns it: 24 seconds a day.
--
-- The stars are a panorama of the whole sky; the earth's night side is dark but for a little light of
-- theirs.

camera { position = {0, 0.6, 4.9}, look_at = {0.45, 0, 0}, fov = 46 }
image { width = 800, height = 500, samples = 16 }

ambient(0.015)
light { position = {-900, 250, 500}, color = {1, 0.97, 0.92}, intensity = 1.5 }
sky { image = "pictures/stars.jpg", rotate = 40 }

sphere {
  radius = 1.2, rotate = {0, 15 * t - 20, -23.4},
  material = material { texture = "pictures/earth.jpg" },
}
sphere {   -- the moon, far too near
  center = {2.1, 0.95, -0.4}, radius = 0.24, material = material { color = "#9a948c" },
}
