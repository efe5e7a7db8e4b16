-- Rays graze a field exactly within a part of a pixel of its box, from a lamp above.
camera{position={0,30,0},look_at={0,0,0},up={0,0,-1}}
sun{direction={0,-1,0}}  sky{horizon={0,0,.5},zenith={0,0,.5}}  plane{}
sdf{distance.box{size={2,1,30}}:translate{-3.4,1.5,0}}
