-- Report D, its light modes: on the left no light at all, in the middle light and ambient light,
-- on the right light alone.
--
-- The modes are weights of a material. Without light a thing shows its own colour everywhere (it is
-- black and glows): flat, as if cut from paper. Light alone leaves what is turned away black. Only both
-- together look round and whole.

camera { position = {0, 2.6, 15}, look_at = {0, 0.85, 0}, fov = 27 }
image { width = 800, height = 400, samples = 16 }

ambient(0.28)
light { position = {-2.5, 6, 6}, intensity = 0.95 }
sky { color = "#2c3138" }

local modes = {
  function(color) return material { color = 0, emission = color } end,
  function(color) return material { color = color, specular = 0.2 } end,
  function(color) return material { color = color, specular = 0.2, ambient = 0 } end,
}

for i, paint in ipairs(modes) do
  local x = 2.3 * (i - 2)
  -- A stage of its own, and the same four things on each.
  box { min = {x - 1.1, -0.1, -1.1}, max = {x + 1.1, 0, 1.1}, material = paint "#b8ac98" }
  quad { corner = {x - 1.1, 0, -1.1}, u = {2.2, 0, 0}, v = {0, 2.2, 0}, material = paint "#7d8ea0" }
  sphere { center = {x - 0.4, 0.5, 0.2}, radius = 0.5, material = paint "#c8281e" }
  cylinder { base = {x + 0.55, 0, -0.45}, top = {x + 0.55, 1.6, -0.45}, radius = 0.28, material = paint "#e0a818" }
  box { min = {-0.28, 0, -0.28}, max = {0.28, 0.56, 0.28}, rotate = {0, 30, 0}, translate = {x + 0.45, 0, 0.55},
        material = paint "#2a8a4a" }
end

-- en: No light, light and ambient light, light alone.
-- fr name: éclairages
-- fr: Sans lumière, avec lampe et lumière ambiante, avec la lampe seule.
