-- As many boxes as --time says.
include "scattered.lua"
scatter(function(center, size)
  local x, y, z = center[1], center[2], center[3]
  box { min = {x - size, y - size, z - size}, max = {x + size, y + size, z + size} }
end)
