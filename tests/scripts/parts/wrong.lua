-- The error is reported in this file, on the next line.
sphere { radius = -1 }
