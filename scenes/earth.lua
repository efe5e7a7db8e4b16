-- Report D, its pictures `earth` and `galaxy`: the earth and the moon before the Milky Way. --time
-- turns the earth, 24 seconds a day.
--
-- The stars are a panorama of the whole sky; the earth's night side is dark but for a little light of
-- theirs. The camera looks down to where the Milky Way is.

camera { position = {0, 4.2, 2.9}, look_at = {0.3, 0, 0.1}, up = {0.35, 1, 0}, fov = 48 }
image { width = 800, height = 500, samples = 16 }

ambient(0.015)
light { position = {-900, 250, 500}, color = {1, 0.97, 0.92}, intensity = 1.5 }
sky { image = "pictures/stars.jpg" }

sphere {
  radius = 1.2, rotate = {0, 15 * t - 20, -23.4},
  material = material { texture = "pictures/earth.jpg" },
}
sphere {   -- the moon, far too near
  center = {1.75, 0.7, 0.75}, radius = 0.2, material = material { color = "#9a948c" },
}

-- en: The earth and the moon before the Milky Way; Space turns the earth.
-- fr name: Terre et Lune
-- fr: La Terre et la Lune devant la Voie lactée ; Espace fait tourner la Terre.
