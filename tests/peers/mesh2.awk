# Turns an OBJ of triangles into POV-Ray's `mesh2`. With -v smooth=1 it has normals: at each corner
# the mean of its triangles' normals, each weighted by its angle there, as `normals = "smooth"` says.
# The last brace is left to whoever includes it, after the material.

# Sets ex, ey, ez to the way from corner i to corner j.
function edge_of(i, j) { ex = x[j] - x[i]; ey = y[j] - y[i]; ez = z[j] - z[i] }

# Adds the normal of the triangle i, j, k to corner i, by the angle there.
function corner_add(i, j, k,    ax, ay, az, nx, ny, nz, area, weight) {
    edge_of(i, j); ax = ex; ay = ey; az = ez
    edge_of(i, k)
    nx = ay * ez - az * ey; ny = az * ex - ax * ez; nz = ax * ey - ay * ex
    area = sqrt(nx * nx + ny * ny + nz * nz)
    weight = area > 0 ? atan2(area, ax * ex + ay * ey + az * ez) / area : 0
    u[i] += weight * nx; v[i] += weight * ny; w[i] += weight * nz
}

$1 == "v" { positions++; x[positions] = $2; y[positions] = $3; z[positions] = $4 }
$1 == "f" { faces++; a[faces] = $2 + 0; b[faces] = $3 + 0; c[faces] = $4 + 0 }

END {
    print "mesh2 {\nvertex_vectors {" positions
    for (i = 1; i <= positions; i++) printf ", <%.9g, %.9g, %.9g>\n", x[i], y[i], z[i]
    print "}"
    for (f = 1; smooth && f <= faces; f++) {
        corner_add(a[f], b[f], c[f])
        corner_add(b[f], c[f], a[f])
        corner_add(c[f], a[f], b[f])
    }
    if (smooth) print "normal_vectors {" positions
    for (i = 1; smooth && i <= positions; i++) {
        size = sqrt(u[i] * u[i] + v[i] * v[i] + w[i] * w[i])
        printf ", <%.9g, %.9g, %.9g>\n", u[i] / size, v[i] / size, w[i] / size
    }
    if (smooth) print "}"
    print "face_indices {" faces
    for (f = 1; f <= faces; f++) printf ", <%d, %d, %d>\n", a[f] - 1, b[f] - 1, c[f] - 1
    print "}"
}
