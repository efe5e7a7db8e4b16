# The point, centre plus vector, and the bound on its distance from the sphere: sphere_surface in
# src/trace/shapes/sphere.c. The unit of length is the sum of the largest coordinate P of the point
# and of the radius R.
# In words: the point is C + R V + e, where V is the exact unit vector, and e has three parts. The
# vector's is at most VECTOR * R along V. Rounding a coordinate of the centre, at most |p| + R |V|,
# and the last rounding give at most CENTER * R + LAST * P along V; the sum of |V| is at most the
# root of 3. Across V, e is at most ACROSS * (P + R) long, which moves the point off the sphere by
# at most its square over 2 R. For a small sphere far away, the whole length of e is taken instead.
R = 1 - P;
near = along_radius * R + along_point * P + across * across / 2 / R;
far = along_radius * R + center_far * R + along_point * P;
computed = mul_rel<@BITS@>(@ERROR@b-@BITS@, add_rel<@BITS@>(P, r));

{ P in [0,1] /\ |r -/ R| <= @NARROWED@ /\ |along_radius| <= @RADIUS@ /\ |along_point| <= @LAST@ /\
  |center_far| <= @CENTER@ /\ |across| <= @ACROSS@ ->
  (P <= 0.75 -> |near| <= @BOUND@) /\ (P >= 0.5 -> |far| <= @BOUND@) /\ computed >= @BOUND@ }

P + r -> 1 + (r - R);
$ P in 64;
