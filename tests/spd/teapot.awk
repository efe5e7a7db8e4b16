# Cuts the teapot of the Standard Procedural Databases into more polygons: awk -v size=12 -f teapot.awk teapot.nff
#
# teapot.nff is of size 6: each of its 32 bicubic patches is cut into 6 x 6 cells of two triangles, but those without area, and
# the board below into 6 x 6 squares. The printed hits of 1999 are of size 12. The control points of a patch follow from its 49
# points by least squares, and are multiples of 1/16000. With size=6, the result is teapot.nff again, but for the normals, which
# are left out: each patch is a `p` instead of a `pp`.

function bernstein(k, x) {
    return k == 0 ? (1 - x) ^ 3 : k == 1 ? 3 * x * (1 - x) ^ 2 : k == 2 ? 3 * x * x * (1 - x) : x ^ 3
}

# fit(): the matrix that gives four control points of a cubic curve from its points at 0, 1/6, ... 1: (B^T B)^-1 B^T.
function fit(    i, j, k, r, factor, a) {
    for (i = 0; i < 4; i++) {
        for (j = 0; j < 4; j++)
            for (k = 0; k <= 6; k++) a[i, j] += bernstein(i, k / 6) * bernstein(j, k / 6)
        for (k = 0; k <= 6; k++) a[i, 4 + k] = bernstein(i, k / 6)
    }
    for (i = 0; i < 4; i++)
        for (r = 0; r < 4; r++) {
            factor = r == i ? 1 - 1 / a[i, i] : a[r, i] / a[i, i]
            for (j = 10; j >= i; j--) a[r, j] -= factor * a[i, j]
        }
    for (i = 0; i < 4; i++)
        for (k = 0; k <= 6; k++) from_points[i, k] = a[i, 4 + k]
}

# corner(c): sets the steps (di, dj) of corner c of a cell, counted around it.
function corner(c) {
    c %= 4
    di = c >= 2
    dj = c == 1 || c == 2
}

# is_left_out(p, i, t): whether the file leaves out triangle t of a cell, at the tip of the lid and in the middle of the bottom.
function is_left_out(p, i, t) {
    return i == 0 && t == 0 && (p >= 20 && p < 24 || p >= 28)
}

function write_vertex(p, s, t,    axis, k, l, sum, line) {
    for (axis = 0; axis < 3; axis++) {
        sum = 0
        for (k = 0; k < 4; k++)
            for (l = 0; l < 4; l++) sum += control[p, k, l, axis] * bernstein(k, s) * bernstein(l, t)
        if (sum < 1e-12 && sum > -1e-12) sum = 0
        line = line (axis ? " " : "") sprintf("%g", sum)
    }
    print line
}

# Solves patch p for its control points.
function solve(p,    axis, i, j, k, l, sum, row) {
    for (axis = 0; axis < 3; axis++) {
        for (i = 0; i <= 6; i++)
            for (l = 0; l < 4; l++) {
                row[i, l] = 0
                for (j = 0; j <= 6; j++) row[i, l] += from_points[l, j] * point[p, i, j, axis]
            }
        for (k = 0; k < 4; k++)
            for (l = 0; l < 4; l++) {
                sum = 0
                for (i = 0; i <= 6; i++) sum += from_points[k, i] * row[i, l]
                control[p, k, l, axis] = int(sum * 16000 + (sum < 0 ? -0.5 : 0.5)) / 16000
            }
    }
}

# Squares of one colour of the board: parity 1 or 0.
function write_board(parity,    i, j, k) {
    for (i = 0; i < size; i++)
        for (j = 0; j < size; j++)
            if ((i + j) % 2 == parity) {
                print "p 4"
                for (k = 0; k < 4; k++)
                    printf "%g %g 0\n", 4 * (2 * (i + (k % 3 ? 1 : 0)) / size - 1), 4 * (2 * (j + (k >= 2)) / size - 1)
            }
}

BEGIN {
    if (!size) size = 12
    fit()
    patch = cell_i = cell_j = triangle = 0
}

# The points of the patches, in the order of the file.
$1 == "pp" {
    if (is_left_out(patch, cell_i, triangle)) triangle++
    for (k = 0; k < 3; k++) {
        getline
        corner(k + 2 * triangle)
        for (axis = 0; axis < 3; axis++) point[patch, cell_i + di, cell_j + dj, axis] = $(axis + 1)
    }
    if (++triangle == 2) {
        triangle = 0
        if (++cell_j == 6) {
            cell_j = 0
            if (++cell_i == 6) {
                cell_i = 0
                patch++
            }
        }
    }
    next
}
# The board is written anew, after the fill colour of its squares.
$1 == "p" {
    count = $2
    for (k = 0; k < count; k++) getline
    next
}
$1 == "f" {
    print
    if (colors < 2) write_board(1 - colors)
    colors++
    next
}
{ print }

END {
    for (p = 0; p < 32; p++) {
        # The points at a tip that no triangle of the file has.
        if (p >= 20 && p < 24 || p >= 28)
            for (axis = 0; axis < 3; axis++) point[p, 0, 6, axis] = point[p, 0, 0, axis]
        solve(p)
        for (i = 0; i < size; i++)
            for (j = 0; j < size; j++)
                for (t = 0; t < 2; t++) {
                    if (is_left_out(p, i, t)) continue
                    print "p 3"
                    for (k = 0; k < 3; k++) {
                        corner(k + 2 * t)
                        write_vertex(p, (i + di) / size, (j + dj) / size)
                    }
                }
    }
}
