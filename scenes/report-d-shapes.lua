-- Report D, its result "divers objets": green disk, blue cylinder, rectangle, red triangle
-- and floor; and the sphere and the open cylinder that its program knows, too.
--
-- The report says which things its picture shows, and in which colours, but not where they are. Its
-- rectangle wears a photograph; ours is a mirror in a frame, and shows the others from behind.

camera { position = {0.4, 2.3, 7.6}, look_at = {0.1, 0.86, -0.4}, fov = 41 }
image { width = 800, height = 600, samples = 16, depth = 4 }

ambient { 0.20, 0.21, 0.24 }
light { position = {-4.5, 6.5, 5.0}, color = {1.00, 0.93, 0.82}, intensity = 0.85 }
light { position = { 6.0, 4.0, 2.5}, color = {0.60, 0.72, 1.00}, intensity = 0.28 }
sky { horizon = {0.72, 0.78, 0.84}, zenith = {0.20, 0.34, 0.58} }

local function matt(color) return material { color = color } end
local function gloss(color, mirror)
  return material { color = color, specular = 0.5, shininess = 80, reflectivity = mirror }
end

-- The floor: a plane without end, and disks that lie on it as a pattern of stones.
plane { material = matt {0.66, 0.60, 0.52} }
for ring = 1, 9 do
  local count = 7 * ring
  for i = 1, count do
    local angle = 2 * math.pi * (i + ring / 2) / count
    disk {
      center = {1.05 * ring * math.cos(angle), 0.001, 1.05 * ring * math.sin(angle) - 1},
      radius = 0.36, material = matt {0.78, 0.73, 0.65},
    }
  end
end

-- The rectangle: a mirror on four slats, which are one box each, turned and moved.
local mirror = material { color = 0.02, reflectivity = {0.86, 0.88, 0.88} }
local wood = gloss({0.30, 0.17, 0.08}, 0.04)
local function slat(size, place)
  box {
    min = {-0.5, -0.5, -0.5}, max = {0.5, 0.5, 0.5}, scale = size, translate = place,
    material = wood,
  }
end
quad { corner = {-3.1, 0.25, -2.6}, u = {6.2, 0, 0}, v = {0, 2.75, 0}, material = mirror }
slat({6.5, 0.16, 0.2}, { 0.00, 0.17, -2.6})
slat({6.5, 0.16, 0.2}, { 0.00, 3.08, -2.6})
slat({0.16, 3.06, 0.2}, {-3.18, 1.625, -2.6})
slat({0.16, 3.06, 0.2}, { 3.18, 1.625, -2.6})

-- The blue cylinder is full: the base stands on the floor, and the top is closed.
cylinder {
  base = {-1.75, 0, -0.7}, top = {-1.75, 1.75, -0.7}, radius = 0.55,
  material = gloss({0.05, 0.13, 0.72}, 0.10),
}

-- The other one is open, a pipe of copper that lies on the floor. You look through it.
cylinder {
  base = {1.35, 0.42, 1.55}, top = {2.15, 0.42, 0.15}, radius = 0.42, capped = false,
  material = gloss({0.85, 0.42, 0.20}, {0.22, 0.14, 0.08}),
}

-- The green disk leans on the edge of nothing: it is as thin as a plane.
disk {
  center = {0.05, 0.74, -0.9}, normal = {0.30, 0.34, 1}, radius = 0.78,
  material = gloss({0.06, 0.52, 0.14}, 0.06),
}

-- The red triangle stands on one corner.
triangle {
  a = {1.75, 0.02, -1.0}, b = {2.50, 1.95, -1.35}, c = {0.95, 1.75, -0.85},
  material = gloss({0.85, 0.06, 0.05}, 0.05),
}

-- The sphere, and beside it what a sphere can become: three eggs.
sphere { center = {-0.55, 0.45, 0.85}, radius = 0.45, material = gloss({0.95, 0.72, 0.10}, 0.18) }
for i, tint in ipairs { "#f4ede0", "#e9d3b4", "#cfa98a" } do
  sphere {
    scale = {0.16, 0.21, 0.16}, rotate = {0, 0, 25 * (i - 2)},
    translate = {0.15 + 0.42 * i, 0.19, 1.95 - 0.12 * i}, material = gloss(tint, 0.03),
  }
end

-- en: A disk, a cylinder, a rectangle, a triangle and a floor.
-- fr name: rapport D : formes
-- fr: Un disque, un cylindre, un rectangle, un triangle et un sol.
