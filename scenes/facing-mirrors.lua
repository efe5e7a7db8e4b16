-- Report C, its counter: two mirrors that face each other. The ray goes to and fro until it is
-- stopped.
--
-- Each time a ray is reflected, the mirror keeps a little of its light, so the tunnel gets darker
-- and greener towards its end, as between two real mirrors. Make depth smaller to see what
-- the counter of the report does: each step shows one room more.

local depth = 24

camera { position = {1.1, 0.55, 3.3}, look_at = {-0.35, -0.25, -4}, fov = 62 }
image { width = 800, height = 600, depth = depth, samples = 4 }

ambient(0.18)
light { position = {-1.5, 2.6, 1.0}, color = {1.00, 0.95, 0.88}, intensity = 0.9 }
light { position = { 2.4, 1.8, -1.5}, color = {0.55, 0.65, 0.85}, intensity = 0.35 }
sky { horizon = {0.30, 0.40, 0.55}, zenith = {0.05, 0.10, 0.25} }

-- The mirrors, one at each end: they keep least of the green. Behind the glass there is no light.
local glass = material { color = 0, reflectivity = {0.90, 0.94, 0.91} }
local frame = material { color = {0.45, 0.28, 0.12}, specular = 0.3, shininess = 40 }

local function mirror(z)
  quad { corner = {-2, -1, z}, u = {4, 0, 0}, v = {0, 2.6, 0}, material = glass }
  -- Four slats around it.
  local near, far = z - 0.06, z + 0.06
  box { min = {-2.15, -1.0, near}, max = {-2.00, 1.75, far}, material = frame }
  box { min = { 2.00, -1.0, near}, max = { 2.15, 1.75, far}, material = frame }
  box { min = {-2.00,  1.6, near}, max = { 2.00, 1.75, far}, material = frame }
  box { min = {-2.00, -1.0, near}, max = { 2.00, -0.9, far}, material = frame }
end

mirror(-4)
mirror(4)

-- The floor, and what stands on it between the mirrors: coloured balls in a spiral.
plane { point = {0, -1, 0}, normal = {0, 1, 0}, material = material { color = {0.62, 0.58, 0.52} } }

local colors = { "#e6332a", "#f39200", "#ffd500", "#3aaa35", "#1d71b8", "#662483" }
for i, color in ipairs(colors) do
  local angle = math.rad(60 * i)
  local radius = 0.22 + 0.03 * i
  sphere {
    center = {1.2 * math.cos(angle) - 0.2, radius - 1, 1.2 * math.sin(angle) - 1.0},
    radius = radius,
    material = material { color = color, specular = 0.6, shininess = 80, reflectivity = 0.08 },
  }
end

-- In the middle a cube, to see left and right change places from room to room.
box {
  min = {-0.55, -1, -1.35}, max = {0.15, -0.3, -0.65},
  material = material { color = {0.90, 0.88, 0.84}, specular = 0.2, shininess = 30 },
}

-- en: Two mirrors that face each other.
-- fr name: miroirs face à face
-- fr: Deux miroirs face à face.
