// scenes/endless-frames.lua at t = 0, between frame.frag and march.frag.

const vec3 EYE = vec3(1.1, 1.2, 0.0), LOOK_AT = vec3(0.4, 0.55, -4.0), UP = vec3(0.15, 1.0, 0.0);
const float FOV = 66.0;
const bool ENDLESS = true, IS_SUN = false, HAS_GROUND = false;
const vec3 LOW = vec3(0.0), HIGH = vec3(0.0), SUN = vec3(0.0), GROUND = vec3(0.0);
const vec3 LAMP = vec3(1.4, 1.7, 0.0), AMBIENT = vec3(0.02);
const float INTENSITY = 22.0, TOLERANCE = 1e-4;
const vec3 HORIZON = vec3(0.02, 0.03, 0.06), ZENITH = HORIZON;
const vec3 COLOR = vec3(0.74540421, 0.18782077, 0.02315337); // #e0782a

const float PERIOD = 2.5, HALF = 0.5;
mat3 turn;  // From the scene's space to the frame's.
vec3 reach; // Half the edges of the box around a turned frame.

void prepare() {
    vec2 x = vec2(cos(radians(20.0)), sin(radians(20.0)));
    vec2 y = vec2(cos(radians(25.0)), sin(radians(25.0)));
    mat3 about_x = mat3(1.0, 0.0, 0.0, 0.0, x.x, x.y, 0.0, -x.y, x.x);
    mat3 about_y = mat3(y.x, 0.0, -y.y, 0.0, 1.0, 0.0, y.y, 0.0, y.x);
    mat3 forth = about_y * about_x;
    turn = transpose(forth);
    reach = HALF * (abs(forth[0]) + abs(forth[1]) + abs(forth[2]));
}

// The nearest frame may stand in the next cell; it is asked if its box is nearer than the nearest.
float field(vec3 p) {
    vec3 local = p - PERIOD * floor(p / PERIOD + 0.5);
    vec3 next = mix(vec3(PERIOD), vec3(-PERIOD), lessThan(local, vec3(0.0)));
    float nearest = box_frame(turn * local, HALF, 0.06);
    for (int i = 1; i < 8; i++) {
        vec3 q = local - next * vec3(i & 1, i >> 1 & 1, i >> 2);
        vec3 outside = abs(q) - reach;
        float beside = max(outside.x, max(outside.y, outside.z));
        if (beside < nearest) {
            nearest = min(nearest, max(beside, box_frame(turn * q, HALF, 0.06)));
        }
    }
    return nearest;
}
