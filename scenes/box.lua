-- Report C, its box: five matt green walls, a red sphere and a blue cube that mirror.
--
-- The walls stand 2 units from the middle, and the box is open towards the viewer. Distances are
-- in any unit you like; x runs to the right, y up, and z towards you.

camera { position = {0, 0, 6.5}, look_at = {0, 0, 0}, fov = 46 }

-- depth: a ray may be reflected 8 times, from sphere to cube and back. samples: 16 rays per pixel make
-- the edges smooth.
image { width = 800, height = 600, depth = 8, samples = 16 }

-- What is in the shadow still gets a little light from everywhere.
ambient { 0.15, 0.15, 0.15 }

-- The lamp hangs just under the ceiling, a little nearer to you than its middle.
light { position = {0, 1.75, 0.6}, color = {1, 1, 1}, intensity = 1.2 }

-- In front of the box there is only this: an evening that the mirrors show a little of.
sky { horizon = {0.12, 0.17, 0.30}, zenith = {0.02, 0.04, 0.12} }

-- The five walls: all are matt and green, each a little different, so that corners show.
-- A quad starts at a corner and goes along two edges, u and v. Its normal, u x v, points into the box.
local function wall(color, corner, u, v)
  quad { corner = corner, u = u, v = v, material = material { color = color } }
end

wall({0.10, 0.36, 0.11}, {-2, -2, -2}, {0, 0, 4}, {4, 0, 0})   -- floor
wall({0.14, 0.44, 0.16}, {-2,  2, -2}, {4, 0, 0}, {0, 0, 4})   -- ceiling
wall({0.13, 0.46, 0.16}, {-2, -2, -2}, {4, 0, 0}, {0, 4, 0})   -- back
wall({0.07, 0.36, 0.13}, {-2, -2, -2}, {0, 4, 0}, {0, 0, 4})   -- left
wall({0.15, 0.40, 0.08}, { 2, -2, -2}, {0, 0, 4}, {0, 4, 0})   -- right

-- The red sphere lies on the floor: its centre is as high above it as its radius.
-- It mirrors more of the red light than of the green and the blue, as copper does.
sphere {
  center = {-0.8, -1.15, -0.9}, radius = 0.85,
  material = material {
    color = {0.95, 0.05, 0.04},
    reflectivity = {0.42, 0.20, 0.20},
    specular = 0.9, shininess = 150,   -- the bright spot where the lamp is mirrored
  },
}

-- The blue cube; all its edges are 1.2 long.
box {
  min = {0.40, -2.0, -1.2}, max = {1.60, -0.8, 0.0},
  material = material {
    color = {0.05, 0.14, 0.80},
    reflectivity = {0.30, 0.36, 0.60},
    specular = 0.6, shininess = 60,
  },
}

-- The yellow quad: a matt panel that leans in the back. Look for it on the cube, and in the sphere.
quad {
  corner = {0.05, -1.2, -1.65}, u = {1.7, 0, 0.1}, v = {-0.1, 1.6, -0.3},
  material = material { color = {0.90, 0.62, 0.03} },
}

-- en: A box of green walls with a mirroring ball and a mirroring cube.
-- fr name: boîte
-- fr: Une boîte aux murs verts, une boule et un cube réfléchissants.
