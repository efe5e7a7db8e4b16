/**
 * @file
 * @brief The camera.
 */
#include "dioptre/scene.h"

/** Smallest field of view, degrees; below it, float cannot resolve pixels. */
#define FOV_MINIMUM 0.01
/** Largest field of view, degrees; at 180 the image plane would be infinitely wide. */
#define FOV_MAXIMUM 175.0
/** Largest tilt by keys and mouse, degrees above or below the horizon. */
#define ROTATED_TILT_MAXIMUM 89.0
/** Degrees to radians. */
#define RADIANS_PER_DEGREE (M_PI / 180)

/** Indices of the rows of #scene_camera_parameters, which are the bits of `given`. */
enum { ROW_POSITION, ROW_LOOK_AT, ROW_DIRECTION, ROW_UP, ROW_PAN, ROW_TILT, ROW_FOV };

/** Fields of `camera`. */
static const Parameter scene_camera_parameters[] = {
    [ROW_POSITION] = {.name = "position",
                      .type = PARAMETER_POINT,
                      .offset = offsetof(SceneCamera, position),
                      .minimum = -LENGTH_MAXIMUM,
                      .maximum = LENGTH_MAXIMUM,
                      .unit = "scene units",
                      .help = "where the eye is"},
    [ROW_LOOK_AT] = {.name = "look_at",
                     .type = PARAMETER_POINT,
                     .offset = offsetof(SceneCamera, look_at),
                     .minimum = -LENGTH_MAXIMUM,
                     .maximum = LENGTH_MAXIMUM,
                     .unit = "scene units",
                     .help = "a point in the middle of the picture"},
    [ROW_DIRECTION] = {.name = "direction",
                       .type = PARAMETER_DIRECTION,
                       .offset = offsetof(SceneCamera, direction),
                       .minimum = -LENGTH_MAXIMUM,
                       .maximum = LENGTH_MAXIMUM,
                       .unit = "any length",
                       .help = "which way it looks, instead of look_at"},
    [ROW_UP] = {.name = "up",
                .type = PARAMETER_DIRECTION,
                .offset = offsetof(SceneCamera, up),
                .minimum = -LENGTH_MAXIMUM,
                .maximum = LENGTH_MAXIMUM,
                .unit = "any length",
                .help = "which way is up in the picture"},
    [ROW_PAN] = {.name = "pan",
                 .type = PARAMETER_NUMBER,
                 .offset = offsetof(SceneCamera, pan),
                 .minimum = -36000,
                 .maximum = 36000,
                 .unit = "degrees",
                 .help = "turn to the right from -z, instead of look_at"},
    [ROW_TILT] = {.name = "tilt",
                  .type = PARAMETER_NUMBER,
                  .offset = offsetof(SceneCamera, tilt),
                  .minimum = -90,
                  .maximum = 90,
                  .unit = "degrees",
                  .help = "turn up from the horizon, with pan"},
    [ROW_FOV] = {.name = "fov",
                 .type = PARAMETER_NUMBER,
                 .offset = offsetof(SceneCamera, fov),
                 .minimum = FOV_MINIMUM,
                 .maximum = FOV_MAXIMUM,
                 .unit = "degrees",
                 .help = "horizontal field of view"},
    {0}};

/** A camera at the origin that looks along -z. */
static const SceneCamera scene_camera_defaults = {.look_at = {0, 0, -1},
                                                  .direction = {0, 0, -1},
                                                  .up = {0, 1, 0},
                                                  .fov = 46,
                                                  .target_distance = 1};

/**
 * @return The direction of two angles, a unit vector.
 * @param pan   Degrees to the right of -z.
 * @param tilt  Degrees above the horizon.
 */
static Vec3d direction_from_pan_tilt(double pan, double tilt) {
    double pan_radians = pan * RADIANS_PER_DEGREE;
    double tilt_radians = tilt * RADIANS_PER_DEGREE;
    return (Vec3d){cos(tilt_radians) * sin(pan_radians), sin(tilt_radians),
                   -cos(tilt_radians) * cos(pan_radians)};
}

/** @return A vector that is up where a camera looks along its own `up`: the axis least aligned with
 *          the direction. */
static Vec3d other_up(Vec3d direction) {
    double x = fabs(direction.x), y = fabs(direction.y), z = fabs(direction.z);
    if (y > x && y > z) {
        // For a view straight down with y up, -z is the top of the image, as on a map.
        return (Vec3d){0, 0, direction.y > 0 ? 1 : -1};
    }
    return z <= x && z <= y ? (Vec3d){0, 0, 1} : x <= y ? (Vec3d){1, 0, 0} : (Vec3d){0, 1, 0};
}

/**
 * @return The component of `up` perpendicular to `direction`, as a unit vector.
 * @param direction  A unit vector.
 * @param up         Any vector but zero.
 * @param other      What replaces `up` if it is parallel to the direction.
 */
static Vec3d orthogonal_up(Vec3d direction, Vec3d up, Vec3d other) {
    /** Sine of the angle below which two directions count as parallel. */
    const double parallel_tolerance = 1e-9;
    Vec3d right = vec3d_cross(direction, vec3d_normalize(up));
    if (!(vec3d_length(right) > parallel_tolerance)) {
        right = vec3d_cross(direction, other);
    }
    return vec3d_normalize(vec3d_cross(vec3d_normalize(right), direction));
}

/**
 * Computes direction, up and target distance. See #Keyword.finish.
 * @param values  The #SceneCamera.
 * @param given   Bits of the given rows.
 * @param error   What is wrong.
 * @return false if the fields are inconsistent.
 */
static bool scene_camera_finish(void *values, uint64_t given, Error *error) {
    SceneCamera *camera = values;
    bool by_point = given >> ROW_LOOK_AT & 1, by_direction = given >> ROW_DIRECTION & 1;
    bool by_angles = (given >> ROW_PAN | given >> ROW_TILT) & 1;
    if (by_point + by_direction + by_angles > 1) {
        return error_set(error, STATUS_SCENE,
                         "camera takes only one of look_at, direction, and pan with tilt");
    }
    if (by_point) {
        camera->direction = vec3d_subtract(camera->look_at, camera->position);
    } else if (by_angles) {
        camera->direction = direction_from_pan_tilt(camera->pan, camera->tilt);
    }
    double distance = vec3d_length(camera->direction);
    if (!(distance > 0)) {
        return error_set(error, STATUS_SCENE, "camera must not look at its own position");
    }
    camera->target_distance = by_point ? distance : 1;
    camera->direction = vec3d_normalize(camera->direction);
    // A quarter turn above the direction is upright in the picture, straight up and down as well.
    Vec3d other = by_angles ? direction_from_pan_tilt(camera->pan, camera->tilt + 90)
                            : other_up(camera->direction);
    camera->up = orthogonal_up(camera->direction, camera->up, other);
    return true;
}

const Keyword scene_camera_keyword = {.name = "camera",
                                      .help = "from where, and which way, the picture is taken",
                                      .parameters = scene_camera_parameters,
                                      .size = sizeof(SceneCamera),
                                      .defaults = &scene_camera_defaults,
                                      .finish = scene_camera_finish};

Vec3d scene_camera_right(const SceneCamera *camera) {
    return vec3d_cross(camera->direction, camera->up);
}

void scene_camera_move(SceneCamera *camera, double right, double up, double forward) {
    Vec3d offset =
        vec3d_add(vec3d_scale(scene_camera_right(camera), right),
                  vec3d_add(vec3d_scale(camera->up, up), vec3d_scale(camera->direction, forward)));
    camera->position = vec3d_add(camera->position, offset);
}

/** @return The component of a vector perpendicular to a unit vector. */
static Vec3d perpendicular_part(Vec3d v, Vec3d unit) {
    return vec3d_subtract(v, vec3d_scale(unit, vec3d_dot(v, unit)));
}

void scene_camera_walk(SceneCamera *camera, Vec3d vertical, double right, double up,
                       double forward) {
    /** Sine of the angle to the vertical below which a camera counts as looking along it. */
    const double steep_tolerance = 1e-6;
    Vec3d ahead = perpendicular_part(camera->direction, vertical);
    if (vec3d_length(ahead) < steep_tolerance) {
        double sign = vec3d_dot(camera->direction, vertical) > 0 ? -1 : 1;
        ahead = vec3d_scale(perpendicular_part(camera->up, vertical), sign);
    }
    ahead = vec3d_normalize(ahead);
    Vec3d offset = vec3d_add(vec3d_scale(vec3d_cross(ahead, vertical), right),
                             vec3d_add(vec3d_scale(vertical, up), vec3d_scale(ahead, forward)));
    camera->position = vec3d_add(camera->position, offset);
}

/**
 * @return v rotated about an axis (Rodrigues' formula).
 * @param v      The vector.
 * @param axis   A unit vector.
 * @param angle  Degrees, counter-clockwise when the axis points to the viewer.
 */
static Vec3d rotate_about_axis(Vec3d v, Vec3d axis, double angle) {
    double cosine = cos(angle * RADIANS_PER_DEGREE), sine = sin(angle * RADIANS_PER_DEGREE);
    Vec3d along = vec3d_scale(axis, vec3d_dot(axis, v) * (1 - cosine));
    return vec3d_add(vec3d_add(vec3d_scale(v, cosine), along),
                     vec3d_scale(vec3d_cross(axis, v), sine));
}

void scene_camera_rotate(SceneCamera *camera, Vec3d vertical, double pan, double tilt) {
    double sine_of_tilt = fmin(1, fmax(-1, vec3d_dot(camera->direction, vertical)));
    double old_tilt = asin(sine_of_tilt) / RADIANS_PER_DEGREE;
    double new_tilt = fmin(ROTATED_TILT_MAXIMUM, fmax(-ROTATED_TILT_MAXIMUM, old_tilt + tilt));
    Vec3d direction =
        rotate_about_axis(camera->direction, scene_camera_right(camera), new_tilt - old_tilt);
    camera->direction = vec3d_normalize(rotate_about_axis(direction, vertical, -pan));
    camera->up = orthogonal_up(camera->direction, vertical, other_up(camera->direction));
}

void scene_camera_orbit(SceneCamera *camera, Vec3d vertical, Vec3d center, double pan,
                        double tilt) {
    Vec3d offset = vec3d_subtract(center, camera->position);
    double right = vec3d_dot(offset, scene_camera_right(camera));
    double up = vec3d_dot(offset, camera->up);
    double forward = vec3d_dot(offset, camera->direction);
    scene_camera_rotate(camera, vertical, pan, tilt);
    camera->position = center;
    scene_camera_move(camera, -right, -up, -forward);
}

void scene_camera_zoom(SceneCamera *camera, double factor) {
    double half_angle = atan(tan(camera->fov / 2 * RADIANS_PER_DEGREE) * factor);
    camera->fov = fmin(FOV_MAXIMUM, fmax(FOV_MINIMUM, 2 * half_angle / RADIANS_PER_DEGREE));
}
