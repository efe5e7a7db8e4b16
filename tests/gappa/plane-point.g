# The point that is moved onto the plane, and the bound on its distance from there:
# plane_equation_surface in src/trace/shapes/plane_equation.h. The unit of length is M, the sum of
# the largest coordinates of the point and of the anchor.
#   largest: of the point; anchor: of the anchor, in the wide precision; magnitude: in the engine's
#   spread: the largest |P - A|; the point was moved by not quite HEIGHT
#   height_error: of height, in lengths of spread: plane-height.g
#   N * move: the sum of N * mul_rel(n, height), where N * N is 1: height * (1 + move)
#   anchor_error, point_error: the sums of N times what the anchor's and the last rounding change;
#   |N1| + |N2| + |N3| is at most the root of 3
height = H + height_error * spread;
distance = (0 - height_error * spread) - move * height + (anchor_error + point_error);
computed = mul_rel<@BITS@>(@ERROR@b-@BITS@, add_rel<@BITS@>(largest, magnitude));

{ largest in [0,1] /\ anchor in [0,1] /\ largest + anchor in [1,1] /\ |magnitude -/ anchor| <= @NARROWED@ /\
  |H| <= @HEIGHT@ /\ |height_error| <= @SUM@ /\ spread in [0,@SPREAD@] /\ |move| <= @MOVE@ /\
  |anchor_error + point_error| <= @LAST@ ->
  |distance| <= @BOUND@ /\ computed >= @BOUND@ }
