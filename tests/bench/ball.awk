# awk -v rows=N -f ball.awk: a bumpy ball of 4 N (N - 1) triangles, as OBJ. Whatever N is, the bumps and
# the outline are the same.
BEGIN {
    pi = atan2(0, -1); columns = 2 * rows
    print "v 0 1 0"
    for (row = 1; row < rows; row++)
        for (column = 0; column < columns; column++) {
            down = pi * row / rows; around = pi * column / rows
            radius = 0.95 + 0.05 * sin(12 * down) * cos(12 * around) * sin(down)
            printf "v %.7f %.7f %.7f\n", radius * sin(down) * cos(around), radius * cos(down), radius * sin(down) * sin(around)
        }
    print "v 0 -1 0"
    last = 2 + columns * (rows - 1)
    for (column = 0; column < columns; column++) {
        here = column; next_one = (column + 1) % columns
        print "f", 1, 2 + next_one, 2 + here
        for (row = 0; row < rows - 2; row++) {
            top = 2 + row * columns; bottom = top + columns
            print "f", top + here, top + next_one, bottom + next_one
            print "f", top + here, bottom + next_one, bottom + here
        }
        print "f", last, last - columns + here, last - columns + next_one
    }
}
