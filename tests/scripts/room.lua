-- Made of several files: what they return and set is here afterwards.
camera { position = {0, 0, 5} }
light { intensity = 2 }

local red = include "parts/red.lua"
include "parts/balls.lua"
balls(3, red)
