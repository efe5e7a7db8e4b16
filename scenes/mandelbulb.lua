-- Report B: a Mandelbulb, the points of space that stay near zero when they are raised to the 8th power
-- and added to, again and again. Its distance is only estimated, so its steps are small.

camera { position = {0.9, 1.1, 2.6}, look_at = {0, 0, 0}, fov = 48 }
image { width = 800, height = 600 }
ambient(0.25)
sun { direction = {-1, -1.2, -0.9}, intensity = 0.95 }
sky { horizon = {0.75, 0.85, 0.95}, zenith = {0.2, 0.42, 0.8} }

sdf { distance.mandelbulb { power = 8, iterations = 8 }:rotate{20, 30 * t % 360, 0}, tolerance = 3e-4,
      material = material { color = "#e0a070" } }

-- en: A Mandelbulb: a fractal in space, by sphere tracing.
-- fr name: Mandelbulb
-- fr: Un Mandelbulb : une fractale dans l’espace, par progression pas à pas.
