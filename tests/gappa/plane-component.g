# One component of the height, plane_equation_surface in src/trace/shapes/plane_equation.h:
# a term of vec3_dot(normal, vec3_subtract(point, anchor)).
#   P: the component of the point, before it is moved onto the plane; exact
#   A: of the anchor as the engine has it; exact
#   N: of the unit normal in the wide precision; n: in the engine's, rounded unless both are alike
difference = sub_rel<@BITS@>(P, A);
term = mul_rel<@BITS@>(n, difference);

{ |n -/ N| <= @NARROWED@ ->
  |term -/ (N * (P - A))| <= @COMPONENT@ }
