-- As many mirroring spheres as --time says.
include "scattered.lua"
local mirror = material { reflectivity = 0.5 }
scatter(function(center, size) sphere { center = center, radius = size, material = mirror } end)
