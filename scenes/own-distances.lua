-- Report B, in one's own words: its ball, box, melted pair, turned frame and row of balls, each a function.
--
-- A function says how far the point (x, y, z) is from a surface, negative inside. It is read once and then
-- computed for every step of every ray, so it may use + - * / % ^, math.abs, min, max, sqrt, sin and cos, and
-- loops, but no `if x > 0`.

camera { position = {0.6, 2.2, 6.6}, look_at = {0.1, 0.5, -0.3}, fov = 50 }
image { width = 800, height = 600 }
ambient(0.22)
sun { direction = {-1, -1.6, -0.8}, intensity = 0.9 }
sky { horizon = {0.75, 0.85, 0.95}, zenith = {0.2, 0.42, 0.8} }
plane { material = material { color = {0.45, 0.6, 0.4} } }

local abs, min, max, sqrt, sin, cos = math.abs, math.min, math.max, math.sqrt, math.sin, math.cos

local function length(x, y, z) return sqrt(x * x + y * y + z * z) end

-- The ball: as far as its centre, less the radius.
local function ball(x, y, z, radius) return length(x, y, z) - radius end

-- How far a point is from the corner {x < 0, y < 0, z < 0}; a box is that corner, mirrored by abs.
local function corner(x, y, z) return length(max(x, 0), max(y, 0), max(z, 0)) + min(max(x, y, z), 0) end
local function box(x, y, z, half) return corner(abs(x) - half, abs(y) - half, abs(z) - half) end

-- The frame: three kinds of bars.
local function frame(x, y, z, half, thin)
  x, y, z = abs(x) - half, abs(y) - half, abs(z) - half
  local u, v, w = abs(x + thin) - thin, abs(y + thin) - thin, abs(z + thin) - thin
  return min(corner(x, v, w), corner(u, y, w), corner(u, v, z))
end

-- Two become one: the seam is filled where both are nearer than `radius` to each other.
local function melted(a, b, radius)
  local near = max(radius - abs(a - b), 0) / radius
  return min(a, b) - near * near * radius / 4
end

local function turned(x, y, angle) return cos(angle) * x - sin(angle) * y, sin(angle) * x + cos(angle) * y end

local blue, yellow, red = material { color = "#4a8fd8" }, material { color = "#e8c547" }, material { color = "#e0582a" }
sdf { function(x, y, z) return ball(x + 2.1, y - 0.6, z, 0.6) end, material = blue }
sdf { function(x, y, z) return box(x - 2.2, y - 0.5, z, 0.5) end, material = yellow }
sdf { function(x, y, z)
        return melted(ball(x + 0.9, y - 0.35, z - 1.2, 0.35), ball(x + 0.4, y - 0.6, z - 1.2, 0.3), 0.3)
      end, material = material { color = "#d04a3a", specular = 0.5 } }
sdf { function(x, y, z)
        y, z = turned(y - 1, z + 0.2, 0.7)
        x, y = turned(x - 0.2, y, 0.9)
        return frame(x, y, z, 0.6, 0.07)
      end, material = red }

-- A row without end: the remainder of a division puts every point into the cell around zero.
sdf { function(x, y, z) return ball((x + 0.5) % 1 - 0.5, y - 0.3, z + 3, 0.3) end, material = material { color = 0.8 } }

-- en: Surfaces from distance functions that the scene writes itself.
-- fr name: distances sur mesure
-- fr: Des surfaces données par des fonctions de distance écrites dans la scène.
