-- Report B: a frame of a cube, a sphere and a cube, under a sun and a sky, by sphere tracing.
--
-- No equation is solved for these: each is only a rule that says how far a point is from the
-- surface. A ray walks as far as the rule allows, asks again, and stops when it is near enough.

camera { position = {2.6, 2.1, 5.2}, look_at = {0, 0.45, 0}, fov = 46 }
image { width = 800, height = 600 }
ambient(0.22)
sun { direction = {-1, -1.6, -0.8}, intensity = 0.9 }
sky { horizon = {0.75, 0.85, 0.95}, zenith = {0.2, 0.42, 0.8} }
plane { material = material { color = {0.45, 0.6, 0.4} } }

local frame = distance.box_frame { size = {1.2, 1.2, 1.2}, edge = 0.14 }
sdf { frame:translate{0, 0.6, 0}, material = material { color = "#e0582a" } }
sdf { distance.sphere { radius = 0.6 }:translate{-1.6, 0.6, -0.3}, material = material { color = "#4a8fd8" } }
sdf { distance.box { size = {1.1, 1.1, 1.1} }:translate{1.6, 0.55, -0.3}, material = material { color = "#e8c547" } }

-- en: The frame of a cube, a sphere and a cube, by sphere tracing.
-- fr name: armature de cube
-- fr: L’armature d’un cube, une sphère et un cube, par progression pas à pas.
