-- Report B: frames of cubes without end, which turn with the time: --time, or Space in the
-- window.
--
-- One frame is enough. The point is put back into the cell around zero, wherever it is; but the
-- nearest frame may stand in the next cell, so those are asked, too. A sun would light none of them: on
-- its endless way here every ray of light is stopped. So the eye carries a lamp.

local along = -t / 2
camera { position = {1.1, 1.2, along}, look_at = {0.4, 0.55, along - 4}, up = {0.15, 1, 0}, fov = 66 }
image { width = 800, height = 600 }
ambient(0.02)
light { position = {1.4, 1.7, along}, intensity = 22, falloff = "inverse_square" }
sky { color = {0.02, 0.03, 0.06} }

local frame = distance.box_frame { size = {1, 1, 1}, edge = 0.12 }:rotate{20 + 40 * t % 360, 25, 20 * t % 360}
sdf { frame:repeat_every{2.5, 2.5, 2.5}, material = material { color = "#e0782a" } }

-- en: Frames of cubes without end, which turn with the time.
-- fr name: armatures sans fin
-- fr: Des armatures de cubes à l’infini, qui tournent avec le temps.
