# The squared length in vec3_normalize, which sphere_surface (src/trace/shapes/sphere.c) calls. The
# unit of length is that of the vector: its squared components are together 1.
#   W: the sum of the squares of x and y; Z: the square of z; exact
#   w: mul_rel(x, x) + mul_rel(y, y); no term is negative, so its relative error is at most theirs
#   z: mul_rel(z, z)
Z = 1 - W;
dot = add_rel<@BITS@>(sum, z);

{ W in [0,1] /\ |w -/ W| <= 1b-@BITS@ /\ |sum -/ w| <= 1b-@BITS@ /\ |z -/ Z| <= 1b-@BITS@ ->
  dot -/ 1 in [-@DOT@,@DOT@] }

dot - 1 -> (dot - (sum + z)) + (sum - w) + (w - W) + (z - Z);
sum + z -> 1 + (sum - w) + (w - W) + (z - Z);
$ W in 32;
