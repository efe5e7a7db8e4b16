-- As many spheres as --time says.
include "scattered.lua"
scatter(function(center, size) sphere { center = center, radius = size } end)
