-- A file that includes itself.
camera {}
include "ring.lua"
