camera {}
include "parts/wrong.lua"
