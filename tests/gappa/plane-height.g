# The sum of vec3_dot(normal, vec3_subtract(point, anchor)), plane_equation_surface in
# src/trace/shapes/plane_equation.h. The unit of length is the largest |P - A|.
#   T1, T2, T3: N * (P - A), exact; t1, t2, t3: as plane-component.g bounds them
# In words (Hoelder, Cauchy-Schwarz): |T1| + |T2| + |T3| is at most |N1| + |N2| + |N3|, at most the
# root of 3. So the errors of the terms are together at most that times COMPONENT: @TERMS@.
H = T1 + T2 + T3;
terms_error = (t1 + t2 + t3) - H;
sum = add_rel<@BITS@>(t1, t2);
height = add_rel<@BITS@>(sum, t3);

{ |t3 -/ T3| <= @COMPONENT@ /\ |T3| <= 1 /\ |H| <= @HEIGHT@ /\ |terms_error| <= @TERMS@ ->
  |height - H| <= @SUM@ }

# The first two terms cancel the third but for the height.
t1 + t2 -> terms_error + H - t3;
height - H -> (height - (sum + t3)) + (sum - (t1 + t2)) + terms_error;
sum + t3 -> (sum - (t1 + t2)) + (terms_error + H);
