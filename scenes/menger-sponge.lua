-- Report B: a Menger sponge. A cube loses its middle along all three axes, each of the 20 cubes that
-- are left loses its own, and so on: --time takes the steps, from 0 to 6.

camera { position = {1.5, 1.25, 2.2}, look_at = {0, 0.42, 0}, fov = 40 }
image { width = 800, height = 600 }
ambient(0.25)
sun { direction = {-1, -1.4, -0.55}, intensity = 0.9 }
sky { horizon = {0.75, 0.85, 0.95}, zenith = {0.2, 0.42, 0.8} }
plane { material = material { color = {0.45, 0.6, 0.4} } }

local steps = t > 0 and math.min(math.floor(t), 6) or 4
sdf { distance.menger { size = 1, iterations = steps }:translate{0, 0.5, 0},
      material = material { color = "#e8c98a" } }

-- en: A Menger sponge; the time takes the steps, from 0 to 6.
-- fr name: éponge de Menger
-- fr: Une éponge de Menger ; le temps fait avancer les étapes, de 0 à 6.
