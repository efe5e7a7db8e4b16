-- Three fields that cross, with a coarse tolerance and few steps: where a ray ends must not depend
-- on which of them it meets first.
camera { position = {-0.6, 1.15, 3}, look_at = {0, 0, 0}, fov = 60 }
light { position = {3, 4, 5} }
ambient(0.3)

red = material { color = {1, 0, 0}, reflectivity = 0.3 }
green = material { color = {0, 1, 0}, reflectivity = 0.3 }
blue = material { color = {0, 0, 1}, reflectivity = 0.3 }

block = distance.box { size = {1.8, 0.6, 1.8} }:translate { 0.1, 0.2, 0 }
ring = distance.torus { major = 1, minor = 0.4 }
melted = distance.smooth_union(distance.sphere {}, distance.box { size = {2.2, 0.4, 1} }, 0.3)

for i, field in ipairs { block, ring, melted } do
    local color = ({red, green, blue})[i]
    sdf { field, tolerance = 0.05, max_steps = 8, material = color }
end
