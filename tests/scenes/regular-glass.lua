-- Bodies of diamond in which light keeps to regular paths: a leaning cylinder, a turned box, an egg, a thin ring.
camera { position = {0.9, 1.1, 6.2}, look_at = {0, 0, 0}, fov = 34 }
image { width = 320, height = 240 }
ambient(0.25); sky { horizon = {0.6, 0.7, 0.8}, zenith = {0.1, 0.2, 0.5} }
light { position = {3, 5, 6} }
local diamond = material { color = 0, transparency = 1, ior = 2.42 }
plane { point = {0, -1.2, 0}, material = material { color = "#8a9a6b" } }
quad { corner = {-4, -1.2, -3}, u = {8, 0, 0}, v = {0, 1, 0}, material = material { color = "#c02020" } }
quad { corner = {-4, -0.2, -3}, u = {8, 0, 0}, v = {0, 2, 0}, material = material { color = "#2040c0" } }
cylinder { base = {-0.8, -0.9, 0.2}, top = {-1.2, 0.5, 0}, radius = 0.4, material = diamond }
box { min = {-0.4, -0.4, -0.3}, max = {0.4, 0.4, 0.3}, rotate = {10, 20, 30}, translate = {0.3, -0.6, 0.9}, material = diamond }
sphere { radius = 0.5, scale = {1, 0.6, 0.8}, rotate = {10, 20, 30}, translate = {1.4, -0.5, -0.6}, material = diamond }
sdf { distance.torus { major = 0.5, minor = 0.15 }:rotate{60, 0, 10}:translate{0.45, 0.8, -0.4}, material = diamond }
