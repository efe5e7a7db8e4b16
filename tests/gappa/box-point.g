# A coordinate of a point on a box: box_snap_to_face in src/trace/shapes/box.c. The unit of length
# is the largest coordinate of the point.
#   FACE: of the scene; face: as the engine has it. A point between two rounded faces is off the
#   exact one by no more.
# The distance in space is at most the root of 3 times that along one axis.
computed = @ERROR@b-@BITS@;

{ face in [-1,1] /\ |face -/ FACE| <= @NARROWED@ ->
  |1.7320509 * (face - FACE)| <= @BOUND@ /\ computed >= @BOUND@ }
