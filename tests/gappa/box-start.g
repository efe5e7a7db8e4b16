# Where a ray leaves the face of a box: ray_offset_origin in src/trace/tracer/ray_offset.h, along the
# normal, which is an axis. The unit of length is the largest coordinate of the point.
# The start is off the face, on the right side, and the next test compares just these two numbers.
offset = @ERROR@b-@BITS@;
start = add_rel<@BITS@>(face, offset);

{ face in [-1,1] -> start - face >= @START@ }

start - face -> (start - (face + offset)) + offset;
