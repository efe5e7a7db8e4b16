-- Boxes without end along x, moved by a transform of the shape: they have no box.
camera { position = {0,2,9}, look_at = {0,2,0} }
light { position = {0,8,5} }
sdf { distance.box{size={0.8,0.8,0.8}}:repeat_every{2,0,0}, translate={0,3,0} }
plane{point={0,-1,0}}
