-- Report B: the frame of a cube, turned about all three axes.
--
-- Not the frame is turned but the point that is measured, the other way round: the rule stays as it was.

camera { position = {1.2, 1.6, 3.4}, look_at = {0, 0.85, 0}, fov = 46 }
image { width = 800, height = 600 }
ambient(0.22)
sun { direction = {-1, -1.6, -0.8}, intensity = 0.9 }
sky { horizon = {0.75, 0.85, 0.95}, zenith = {0.2, 0.42, 0.8} }
plane { material = material { color = {0.45, 0.6, 0.4} } }

local frame = distance.box_frame { size = {1.2, 1.2, 1.2}, edge = 0.14 }
sdf { frame:rotate{35, 25, 45}:translate{0, 0.95, 0}, material = material { color = "#e0582a" } }

-- en: The frame of a cube, turned about all three axes.
-- fr name: armature tournée
-- fr: L’armature d’un cube, tournée autour des trois axes.
