# A component of the vector from the centre to the point: vec3_normalize, then vec3_scale by the
# radius, in sphere_surface (src/trace/shapes/sphere.c). The unit of length is that of the vector.
#   V: the component before it is normalised; exact
#   dot: the squared length, which sphere-length.g bounds
#   root, inverse: its square root and the inverse of that, each rounded once
#   R: the radius in the wide precision; r: in the engine's, rounded unless both are alike
#   one: 1, a variable so that relative errors chain
normal = mul_rel<@BITS@>(V, inverse);
vector = mul_rel<@BITS@>(normal, r);

{ one in [1,1] /\ dot -/ 1 in [-@DOT@,@DOT@] /\ |root -/ sqrt(dot)| <= 1b-@BITS@ /\
  |inverse -/ (1 / root)| <= 1b-@BITS@ /\ |r -/ R| <= @NARROWED@ ->
  |inverse -/ one| <= @INVERSE@ /\ |vector -/ ((V * one) * R)| <= @VECTOR@ }
