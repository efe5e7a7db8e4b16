-- Report A, what its author could not draw: a picture seen through glass. A lens, a
-- ball and a block stand before the Great Wave of Hokusai.
--
-- The picture knows nothing of the glass. A ray that has been bent asks the wall for its colour at the
-- place where it arrives, as any other ray does. The lens is a flat ball; it is near the wall and
-- enlarges. The ball turns the picture upside down. The block moves it aside.

camera { position = {0, 1.6, 5.8}, look_at = {0, 1.2, 0}, fov = 44 }
image { width = 800, height = 500, samples = 16, depth = 10 }

ambient(0.35)
light { position = {-3, 6, 6}, color = {1, 0.97, 0.9}, intensity = 0.7 }
sky { horizon = "#e8e4da", zenith = "#b9c4cc" }

plane { material = material { texture = "pictures/rosewood.jpg", reflectivity = 0.04 }, scale = 2.5 }
quad { corner = {-2.75, 0.15, -1.6}, u = {5.5, 0, 0}, v = {0, 3.05, 0},
       material = material { texture = "pictures/great-wave.jpg" } }
box { min = {-2.9, 0, -1.75}, max = {2.9, 3.35, -1.62}, material = material { color = "#2b1d14", specular = 0.4 } }

local glass = material { color = 0, transparency = 0.98, ior = 1.5, specular = 0.8, shininess = 400 }
-- The lens with its foot, the ball, the block.
sphere { scale = {0.62, 0.62, 0.09}, translate = {-1.15, 1.05, -0.35}, material = glass }
cylinder { base = {-1.15, 0, -0.35}, top = {-1.15, 0.42, -0.35}, radius = 0.05,
           material = material { color = "#b08d3f", reflectivity = 0.3, specular = 0.6 } }
sphere { center = {0.25, 0.62, 0.5}, radius = 0.6, material = glass }
box { min = {-0.45, -0.1, -0.3}, max = {0.45, 1.6, 0.3}, rotate = {0, 14, 0}, translate = {1.55, 0, -0.6}, material = glass }

-- en: A picture seen through a lens, a ball and a block of glass.
-- fr name: tableau à travers le verre
-- fr: Un tableau vu à travers une lentille, une boule et un bloc de verre.
