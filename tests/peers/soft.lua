-- The same as soft.pov: the soft shadows that a ball of light throws. Nothing else is in the picture:
-- with many rays per pixel, the outlines of shapes would be smooth, and POV-Ray's are not.
camera { position = {0, 3, 0.6}, look_at = {0, 0, 0}, fov = 46 }
image { width = 200, height = 150, samples = 4096 }
ambient { 0.15, 0.15, 0.15 }
light { position = {-4, 6, 5}, color = {1, 1, 1}, intensity = 0.8, radius = 0.5 }

plane { material = material { color = {0.8, 0.75, 0.65}, specular = 0.4, shininess = 60 } }
sphere { center = {-1.9, 2, 1.3}, radius = 0.35 }
box { min = {-1.3, 1.8, 1.9}, max = {-0.8, 2.2, 2.4} }
cylinder { base = {-1.5, 1.9, 0.8}, top = {-0.9, 1.1, 0.9}, radius = 0.15 }
cylinder { base = {-1.1, 0.7, 1.6}, top = {-0.7, 0.9, 1.9}, radius = 0.08 }
