// scenes/turned-frame.lua, between frame.frag and march.frag.

const vec3 EYE = vec3(1.2, 1.6, 3.4), LOOK_AT = vec3(0.0, 0.85, 0.0), UP = vec3(0.0, 1.0, 0.0);
const float FOV = 46.0;
const bool ENDLESS = false, IS_SUN = true, HAS_GROUND = true;
const float TOLERANCE = 1e-4, INTENSITY = 0.9;
const vec3 SUN = vec3(-0.48795004, -0.78072006, -0.39036003), LAMP = vec3(0.0);
const vec3 AMBIENT = vec3(0.22), GROUND = vec3(0.45, 0.6, 0.4);
const vec3 HORIZON = vec3(0.75, 0.85, 0.95), ZENITH = vec3(0.2, 0.42, 0.8);
const vec3 COLOR = vec3(0.74540421, 0.09758735, 0.02315337); // #e0582a

// The columns: from the scene's space to the frame's.
const mat3 TURN = mat3(0.64085638, -0.40782254, 0.65037210, 0.64085638, 0.75063339, -0.16078747,
                       -0.42261826, 0.51983679, 0.74240388);
const vec3 MIDDLE = vec3(0.0, 0.95, 0.0);
const vec3 REACH = vec3(1.01943062, 0.93136635, 1.01091536) + 2.0 * TOLERANCE;
const vec3 LOW = MIDDLE - REACH, HIGH = MIDDLE + REACH;

void prepare() {
}

float field(vec3 p) {
    return box_frame(TURN * (p - MIDDLE), 0.6, 0.07);
}
