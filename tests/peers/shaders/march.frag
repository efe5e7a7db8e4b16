// How a fragment shader marches: the second half of each scene here, which says before it what
// the camera, the light and the colors are, the field and its box; frame.frag stands before those that
// need it.
//
// It does what src/trace/shapes/sdf.c does: the same tolerance, footprint, steps, relaxation and box;
// only the normal comes from four points around, as in most shaders, and not from derivatives.

uniform vec2 size; // Pixels of the picture.
out vec4 result;

const int MAX_STEPS = 512;
const float RELAXATION = 1.6;
const float ROUNDOFF = 5.9604645e-8;
const float FAR = 1e30;

float largest(vec3 v) {
    return max(abs(v.x), max(abs(v.y), abs(v.z)));
}

// Where rays are on a surface: this share of half a pixel off, seen from the camera.
const float FOOTPRINT = 0.125;

// How near to the surface is on it.
float tolerance_at(vec3 point) {
    float spread = FOOTPRINT * tan(radians(0.5 * FOV)) / size.x;
    return max(max(TOLERANCE, 16.0 * ROUNDOFF * largest(point)), spread * distance(point, EYE));
}

// Where a ray is in the field's box: from, to.
vec2 box_span(vec3 origin, vec3 direction, float limit) {
    vec3 a = (LOW - origin) / direction, b = (HIGH - origin) / direction;
    vec3 first = min(a, b), last = max(a, b);
    return vec2(max(0.0, max(first.x, max(first.y, first.z))),
                min(limit, min(last.x, min(last.y, last.z))));
}

// How far a ray of unit direction meets the surface, -1 where it does not.
float march(vec3 origin, vec3 direction, float limit) {
    vec2 span = ENDLESS ? vec2(0.0, limit) : box_span(origin, direction, limit);
    bool leaving = span.x <= 0.0;
    float known = span.x, radius = 0.0, stride = 0.0; // A point, the ball around it, and a step.
    for (int i = 0; i < MAX_STEPS && known + radius <= span.y; i++) {
        float way = min(known + stride, span.y);
        vec3 point = origin + way * direction;
        float distance = field(point), near = tolerance_at(point);
        leaving = leaving && distance < near;
        if (leaving) {
            known = way;
            radius = stride = near;
        } else if (way - known > radius && radius + distance < way - known) {
            stride = radius; // The balls do not touch: a safe step instead.
        } else if (distance <= near) {
            return way;
        } else {
            known = way;
            radius = distance;
            stride = RELAXATION * distance;
        }
    }
    return -1.0;
}

vec3 normal_at(vec3 point) {
    float h = max(1e-4, 5e-5 * largest(point));
    const vec2 e = vec2(1.0, -1.0);
    return normalize(e.xyy * field(point + h * e.xyy) + e.yyx * field(point + h * e.yyx) +
                     e.yxy * field(point + h * e.yxy) + e.xxx * field(point + h * e.xxx));
}

// What a point of a matt surface sends back.
vec3 shade(vec3 color, vec3 point, vec3 normal) {
    vec3 to_light = IS_SUN ? -SUN : LAMP - point;
    float distance = IS_SUN ? 1.0 : length(to_light), limit = IS_SUN ? FAR : distance;
    vec3 light = normalize(to_light);
    float cosine = dot(normal, light);
    float direct = 0.0;
    vec3 start = point + 2.0 * tolerance_at(point) * normal;
    if (cosine > 0.0 && march(start, light, limit) < 0.0) {
        direct = INTENSITY * cosine / (distance * distance);
    }
    return color * (AMBIENT + direct);
}

vec3 encode(vec3 light) {
    vec3 clamped = clamp(light, 0.0, 1.0);
    return mix(1.055 * pow(clamped, vec3(1.0 / 2.4)) - 0.055, 12.92 * clamped,
               lessThanEqual(clamped, vec3(0.0031308)));
}

vec3 view_direction() {
    vec3 forward = normalize(LOOK_AT - EYE), right = normalize(cross(forward, UP));
    // The picture's first row is the buffer's first: it is read out that way.
    vec2 place = vec2(2.0, -2.0) * (gl_FragCoord.xy - 0.5 * size) / size.x;
    vec2 across = tan(radians(0.5 * FOV)) * place;
    return normalize(forward + across.x * right + across.y * cross(right, forward));
}

void main() {
    prepare();
    vec3 direction = view_direction();
    float ground = HAS_GROUND && direction.y < 0.0 ? -EYE.y / direction.y : FAR;
    float way = march(EYE, direction, ground);
    vec3 light = mix(HORIZON, ZENITH, max(direction.y, 0.0));
    if (way >= 0.0) {
        vec3 point = EYE + way * direction;
        light = shade(COLOR, point, normal_at(point));
    } else if (ground < FAR) {
        light = shade(GROUND, EYE + ground * direction, vec3(0.0, 1.0, 0.0));
    }
    result = vec4(encode(light), 1.0);
}
