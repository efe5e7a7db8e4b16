// How far from the corner at zero of a box that fills all that is negative.
float corner(vec3 v) {
    return length(max(v, 0.0)) + min(max(v.x, max(v.y, v.z)), 0.0);
}

// The frame of a cube around zero, by half its edge and half how thick its bars are.
float box_frame(vec3 p, float half_edge, float thick) {
    p = abs(p) - half_edge;
    vec3 q = abs(p + thick) - thick;
    return min(corner(vec3(p.x, q.yz)), min(corner(vec3(q.x, p.y, q.z)), corner(vec3(q.xy, p.z))));
}
