/**
 * @file
 * @brief The camera.
 */
#include "dioptre/camera.h"

/** Narrowest field of view, degrees: a telescope; below it float cannot tell pixels apart. */
#define FOV_MINIMUM 0.01
/** Widest field of view, degrees: at 180 the picture plane would be infinitely wide. */
#define FOV_MAXIMUM 175.0
/** Steepest look by the keys and the mouse, degrees above or below the horizon. */
#define TILT_MAXIMUM 89.0
/** Degrees to radians. */
#define RADIANS_PER_DEGREE (M_PI / 180)

/** Rows of #camera_parameters by place: which bit of `given` stands for which field. */
enum { ROW_POSITION, ROW_LOOK_AT, ROW_DIRECTION, ROW_UP, ROW_PAN, ROW_TILT, ROW_FOV };

/** Fields of `camera`. */
static const Parameter camera_parameters[] = {
    [ROW_POSITION] = {.name = "position",
                      .type = PARAMETER_POINT,
                      .offset = offsetof(Camera, position),
                      .minimum = -LENGTH_MAXIMUM,
                      .maximum = LENGTH_MAXIMUM,
                      .unit = "scene units",
                      .help = "where the eye is"},
    [ROW_LOOK_AT] = {.name = "look_at",
                     .type = PARAMETER_POINT,
                     .offset = offsetof(Camera, look_at),
                     .minimum = -LENGTH_MAXIMUM,
                     .maximum = LENGTH_MAXIMUM,
                     .unit = "scene units",
                     .help = "a point in the middle of the picture"},
    [ROW_DIRECTION] = {.name = "direction",
                       .type = PARAMETER_DIRECTION,
                       .offset = offsetof(Camera, direction),
                       .minimum = -LENGTH_MAXIMUM,
                       .maximum = LENGTH_MAXIMUM,
                       .unit = "any length",
                       .help = "which way it looks, instead of look_at"},
    [ROW_UP] = {.name = "up",
                .type = PARAMETER_DIRECTION,
                .offset = offsetof(Camera, up),
                .minimum = -LENGTH_MAXIMUM,
                .maximum = LENGTH_MAXIMUM,
                .unit = "any length",
                .help = "which way is up in the picture"},
    [ROW_PAN] = {.name = "pan",
                 .type = PARAMETER_NUMBER,
                 .offset = offsetof(Camera, pan),
                 .minimum = -36000,
                 .maximum = 36000,
                 .unit = "degrees",
                 .help = "turn to the right from -z, instead of look_at"},
    [ROW_TILT] = {.name = "tilt",
                  .type = PARAMETER_NUMBER,
                  .offset = offsetof(Camera, tilt),
                  .minimum = -90,
                  .maximum = 90,
                  .unit = "degrees",
                  .help = "turn up from the horizon, with pan"},
    [ROW_FOV] = {.name = "fov",
                 .type = PARAMETER_NUMBER,
                 .offset = offsetof(Camera, fov),
                 .minimum = FOV_MINIMUM,
                 .maximum = FOV_MAXIMUM,
                 .unit = "degrees",
                 .help = "horizontal field of view"},
    {0}};

/** A camera at the origin that looks along -z. */
static const Camera camera_defaults = {
    .look_at = {0, 0, -1}, .direction = {0, 0, -1}, .up = {0, 1, 0}, .fov = 46, .focus = 1};

/**
 * @return The direction of two angles (row B2), a unit vector.
 * @param pan   Degrees to the right of -z.
 * @param tilt  Degrees above the horizon.
 */
static Vector3 direction_of_angles(double pan, double tilt) {
    double p = pan * RADIANS_PER_DEGREE;
    double q = tilt * RADIANS_PER_DEGREE;
    return (Vector3){cos(q) * sin(p), sin(q), -cos(q) * cos(p)};
}

/**
 * @return The part of `up` at right angles to `direction`, a unit vector. Where the two are
 *         parallel, the axis least aligned with the direction takes the place of `up`.
 * @param direction  A unit vector.
 * @param up         Any vector but zero.
 */
static Vector3 upright(Vector3 direction, Vector3 up) {
    /** Sine of the angle below which two directions count as parallel: 1e-9 of a radian. */
    const double parallel = 1e-9;
    Vector3 right = vector3_cross(direction, vector3_normalize(up));
    if (!(vector3_length(right) > parallel)) {
        double x = fabs(direction.x), y = fabs(direction.y), z = fabs(direction.z);
        Vector3 axis = z <= x && z <= y ? (Vector3){0, 0, 1}
                       : x <= y         ? (Vector3){1, 0, 0}
                                        : (Vector3){0, 1, 0};
        /* Looking straight down with y up, -z is the top of the picture, as on a map. */
        axis = y > x && y > z ? (Vector3){0, 0, direction.y > 0 ? 1 : -1} : axis;
        right = vector3_cross(direction, axis);
    }
    return vector3_normalize(vector3_cross(vector3_normalize(right), direction));
}

/**
 * Works out direction, up and focus. See #Keyword.finish.
 * @param[in,out] values  A #Camera.
 * @param given           Which rows were given.
 * @param[out] error      What is wrong.
 * @return false where the fields do not fit together.
 */
static bool camera_finish(void *values, uint64_t given, Error *error) {
    Camera *camera = values;
    bool by_point = given >> ROW_LOOK_AT & 1, by_direction = given >> ROW_DIRECTION & 1;
    bool by_angles = (given >> ROW_PAN | given >> ROW_TILT) & 1;
    if (by_point + by_direction + by_angles > 1) {
        return error_set(error, STATUS_SCENE,
                         "camera takes only one of look_at, direction, and pan with tilt");
    }
    if (by_point) {
        camera->direction = vector3_subtract(camera->look_at, camera->position);
    } else if (by_angles) {
        camera->direction = direction_of_angles(camera->pan, camera->tilt);
    }
    double distance = vector3_length(camera->direction);
    if (!(distance > 0)) {
        return error_set(error, STATUS_SCENE, "camera must not look at its own position");
    }
    camera->focus = by_point ? distance : 1;
    camera->direction = vector3_normalize(camera->direction);
    camera->up = upright(camera->direction, camera->up);
    return true;
}

const Keyword camera_keyword = {.name = "camera",
                                .help = "from where, and which way, the picture is taken",
                                .parameters = camera_parameters,
                                .size = sizeof(Camera),
                                .defaults = &camera_defaults,
                                .finish = camera_finish};

Vector3 camera_right(const Camera *camera) {
    return vector3_cross(camera->direction, camera->up);
}

void camera_move(Camera *camera, double right, double up, double forward) {
    Vector3 step = vector3_add(
        vector3_scale(camera_right(camera), right),
        vector3_add(vector3_scale(camera->up, up), vector3_scale(camera->direction, forward)));
    camera->position = vector3_add(camera->position, step);
}

/**
 * @return v turned about an axis (Rodrigues' formula).
 * @param v      Any vector.
 * @param axis   A unit vector.
 * @param angle  Degrees, counter-clockwise for who sees the axis come towards them.
 */
static Vector3 rotated(Vector3 v, Vector3 axis, double angle) {
    double c = cos(angle * RADIANS_PER_DEGREE), s = sin(angle * RADIANS_PER_DEGREE);
    Vector3 along = vector3_scale(axis, vector3_dot(axis, v) * (1 - c));
    return vector3_add(vector3_add(vector3_scale(v, c), along),
                       vector3_scale(vector3_cross(axis, v), s));
}

void camera_turn(Camera *camera, Vector3 vertical, double pan, double tilt) {
    double sine = fmin(1, fmax(-1, vector3_dot(camera->direction, vertical)));
    double now = asin(sine) / RADIANS_PER_DEGREE;
    double wanted = fmin(TILT_MAXIMUM, fmax(-TILT_MAXIMUM, now + tilt));
    Vector3 direction = rotated(camera->direction, camera_right(camera), wanted - now);
    camera->direction = vector3_normalize(rotated(direction, vertical, -pan));
    camera->up = upright(camera->direction, vertical);
}

void camera_zoom(Camera *camera, double factor) {
    double half = atan(tan(camera->fov / 2 * RADIANS_PER_DEGREE) * factor);
    camera->fov = fmin(FOV_MAXIMUM, fmax(FOV_MINIMUM, 2 * half / RADIANS_PER_DEGREE));
}
