-- scenes/endless-frames.lua with a ball far away: then the copies are not gone through cell by cell, but all
-- neighbours are asked at each step.
camera { position = {1.1, 1.2, 0}, look_at = {0.4, 0.55, -4}, up = {0.15, 1, 0}, fov = 66 }
image { width = 800, height = 600 }
ambient(0.02)
light { position = {1.4, 1.7, 0}, intensity = 22, falloff = "inverse_square" }
sky { color = {0.02, 0.03, 0.06} }

local frame = distance.box_frame { size = {1, 1, 1}, edge = 0.12 }:rotate{20, 25, 0}
local frames = frame:repeat_every{2.5, 2.5, 2.5}
local ball = distance.sphere { radius = 0.01 }:translate{0, 0, 1000}
sdf { distance.union(frames, ball), material = material { color = "#e0782a" } }
