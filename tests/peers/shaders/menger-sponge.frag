// scenes/menger-sponge.lua at t = 0, for march.frag.

const vec3 EYE = vec3(1.5, 1.25, 2.2), LOOK_AT = vec3(0.0, 0.42, 0.0), UP = vec3(0.0, 1.0, 0.0);
const float FOV = 40.0;
const bool ENDLESS = false, IS_SUN = true, HAS_GROUND = true;
const float TOLERANCE = 1e-4, INTENSITY = 0.9;
const vec3 LOW = vec3(-0.5, 0.0, -0.5) - 2.0 * TOLERANCE;
const vec3 HIGH = vec3(0.5, 1.0, 0.5) + 2.0 * TOLERANCE;
const vec3 SUN = vec3(-0.55363653, -0.77509115, -0.30450009), LAMP = vec3(0.0);
const vec3 AMBIENT = vec3(0.25), GROUND = vec3(0.45, 0.6, 0.4);
const vec3 HORIZON = vec3(0.75, 0.85, 0.95), ZENITH = vec3(0.2, 0.42, 0.8);
const vec3 COLOR = vec3(0.80695226, 0.58407842, 0.25415209); // #e8c98a

void prepare() {
}

float box(vec3 p) {
    vec3 v = abs(p) - 1.0;
    return length(max(v, 0.0)) + min(max(v.x, max(v.y, v.z)), 0.0);
}

// A point is in a hole along an axis if it is between the sides along the two others: the middle
// one of three numbers decides.
float field(vec3 point) {
    vec3 p = 2.0 * (point - vec3(0.0, 0.5, 0.0));
    float sponge = box(p), per_cell = 1.0;
    for (int i = 0; i < 4; i++) {
        vec3 cells = p * per_cell;
        vec3 folded = 3.0 * abs(cells - 2.0 * floor(0.5 * cells + 0.5)) - 2.0;
        vec3 depth = (abs(folded) - 1.0) / (3.0 * per_cell);
        float low = min(depth.x, depth.y), high = max(depth.x, depth.y);
        sponge = max(sponge, max(low, min(high, depth.z)));
        per_cell *= 3.0;
    }
    return 0.5 * sponge;
}
