-- Twins: in front each shape is sphere traced, behind it is solved by its equation. Find the difference!
--
-- There is one of a ten thousandth, as the traced ones stop that far before the surface; then they are put
-- onto it by the gradient of their distance.

camera { position = {0, 2.4, 5.2}, look_at = {0, 0.35, -0.2}, fov = 44 }
image { width = 800, height = 600 }
ambient(0.22)
sun { direction = {-1, -1.6, -0.8}, intensity = 0.9 }
sky { horizon = {0.75, 0.85, 0.95}, zenith = {0.2, 0.42, 0.8} }
plane { material = material { color = {0.45, 0.6, 0.4} } }

local blue = material { color = "#4a8fd8", specular = 0.4 }
local yellow = material { color = "#e8c547" }
local mirror = material { color = 0.05, reflectivity = 0.85 }
sdf { distance.sphere { radius = 0.5 }:translate{-1.4, 0.5, 0.7}, material = blue }
sphere { center = {-1.4, 0.5, -0.9}, radius = 0.5, material = blue }
sdf { distance.box { size = {0.9, 0.9, 0.9} }:rotate{0, 30, 0}:translate{0, 0.45, 0.7}, material = yellow }
box { min = {-0.45, -0.45, -0.45}, max = {0.45, 0.45, 0.45}, rotate = {0, 30, 0},
      translate = {0, 0.45, -0.9}, material = yellow }
sdf { distance.sphere { radius = 0.5 }:translate{1.4, 0.5, 0.7}, material = mirror }
sphere { center = {1.4, 0.5, -0.9}, radius = 0.5, material = mirror }

-- en: Each shape twice: solved by its equation, and marched.
-- fr name: formes jumelles
-- fr: Chaque forme deux fois : par son équation, et par progression pas à pas.
