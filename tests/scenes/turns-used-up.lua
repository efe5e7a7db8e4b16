-- Glass in glass, at a depth of 1: some rays of a packet may go on where others have ended.
camera { position = {0, 6, 0}, look_at = {0.5, -0.5, 2} }
image { depth = 1 }
ambient(0.2)
plane { point = {-1, -2, 1}, material = material { color = 0.868, transparency = 1 } }
sphere {
    center = {-0.5, -2, 1.5},
    radius = 0.75,
    material = material { reflectivity = 0.18, transparency = 0.73 },
}
