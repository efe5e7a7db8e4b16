/**
 * @file
 * @brief Saving, restoring and moving camera and lights.
 */
#include "view/state/view_state.h"

#include <stdlib.h>
#include <string.h>

/** Normal speed: at most this fraction of the distance to the target per second. */
static const double TARGET_SPEED = 0.5;
/** Normal speed: fraction of the scene's size per second. It crosses any scene in four seconds, and
 * a tap moves the picture by some pixels. */
static const double SCENE_SPEED = 0.25;

/** Finds the up axis of a scene: y, or another axis if the top of its picture points there. The up
 * vector of a camera that looks steeply up or down is ignored. @return One of the six axes. */
static Vec3d find_up_axis(const SceneCamera *camera) {
    Vec3d up = camera->up;
    double x = fabs(up.x), y = fabs(up.y), z = fabs(up.z);
    bool is_steep = fabs(camera->direction.y) > M_SQRT1_2;
    if (!is_steep && z > x && z > y) {
        return (Vec3d){0, 0, copysign(1, up.z)};
    }
    if (!is_steep && x > y) {
        return (Vec3d){copysign(1, up.x), 0, 0};
    }
    return (Vec3d){0, is_steep ? 1 : copysign(1, up.y), 0};
}

double view_state_move_speed(const Scene *scene) {
    Aabbd bounds = scene_bounds(scene);
    Vec3d center;
    for (size_t i = 0; i < scene->light_count; i++) {
        if (scene_light_center(&scene->lights[i], &center)) {
            bounds = aabbd_add_point(bounds, center);
        }
    }
    double size = vec3d_max_abs(vec3d_subtract(bounds.high, bounds.low));
    bool has_size = bounds.low.x <= bounds.high.x && size > 0;
    double speed = TARGET_SPEED * scene->camera.target_distance;
    return has_size ? fmin(speed, SCENE_SPEED * size) : speed;
}

/** @return Scene units per second of a held key. */
static double move_speed(const ViewState *view_state, const Scene *scene) {
    return view_state->move_speed > 0 ? view_state->move_speed
                                      : TARGET_SPEED * scene->camera.target_distance;
}

bool view_state_init(ViewState *view_state, const Scene *scene, Error *error) {
    // One more than needed: calloc(0) may return NULL.
    size_t count = scene->light_count;
    *view_state =
        (ViewState){.lights = calloc(count + 1, sizeof *view_state->lights),
                    .is_light_moved = calloc(count + 1, sizeof *view_state->is_light_moved),
                    .light_count = count};
    if (!view_state->lights || !view_state->is_light_moved) {
        view_state_deinit(view_state);
        return error_set(error, STATUS_FAILED, "no memory for %zu lights", scene->light_count);
    }
    if (scene->light_count > 0) {
        memcpy(view_state->lights, scene->lights, scene->light_count * sizeof *view_state->lights);
    }
    view_state->camera = scene->camera;
    view_state->up_axis = find_up_axis(&scene->camera);
    view_state->move_speed = view_state_move_speed(scene);
    return true;
}

bool view_state_transfer(ViewState *view_state, const Scene *previous, Scene *scene, Error *error) {
    ViewState next;
    if (!view_state_init(&next, scene, error)) {
        return false;
    }
    next.is_camera_moved = view_state->is_camera_moved;
    next.move_speed = view_state->move_speed;
    if (view_state->is_camera_moved) {
        scene->camera = previous->camera;
    }
    for (size_t i = 0; i < next.light_count && i < view_state->light_count; i++) {
        next.is_light_moved[i] = view_state->is_light_moved[i];
        if (view_state->is_light_moved[i]) {
            scene_light_copy_position(&scene->lights[i], &previous->lights[i]);
        }
    }
    view_state_deinit(view_state);
    *view_state = next;
    return true;
}

void view_state_reset(ViewState *view_state, Scene *scene) {
    scene->camera = view_state->camera;
    view_state->is_camera_moved = false;
    for (size_t i = 0; i < view_state->light_count; i++) {
        scene->lights[i] = view_state->lights[i];
        view_state->is_light_moved[i] = false;
    }
}

bool view_state_save_current(ViewState *saved, const ViewState *view_state, const Scene *scene,
                             Error *error) {
    if (!view_state_init(saved, scene, error)) {
        return false;
    }
    saved->is_camera_moved = view_state->is_camera_moved;
    for (size_t i = 0; i < saved->light_count && i < view_state->light_count; i++) {
        saved->is_light_moved[i] = view_state->is_light_moved[i];
    }
    return true;
}

void view_state_restore_current(const ViewState *saved, ViewState *view_state, Scene *scene) {
    view_state_reset(view_state, scene);
    if (saved->is_camera_moved) {
        scene->camera = saved->camera;
        view_state->is_camera_moved = true;
    }
    for (size_t i = 0; i < saved->light_count && i < view_state->light_count; i++) {
        if (saved->is_light_moved[i]) {
            scene_light_copy_position(&scene->lights[i], &saved->lights[i]);
            view_state->is_light_moved[i] = true;
        }
    }
}

void view_state_deinit(ViewState *view_state) {
    free(view_state->lights);
    free(view_state->is_light_moved);
    *view_state = (ViewState){0};
}

/** @return A movement as a vector of the scene. @param camera The camera whose picture defines the
 * axes. @param units Scene units per second. */
static Vec3d movement_offset(const SceneCamera *camera, Movement movement, double units) {
    Vec3d right = vec3d_scale(scene_camera_right(camera), movement.right * units);
    Vec3d up = vec3d_scale(camera->up, movement.up * units);
    Vec3d forward = vec3d_scale(camera->direction, movement.forward * units);
    return vec3d_add(vec3d_add(right, up), forward);
}

void view_state_move(ViewState *view_state, Scene *scene, size_t light, Movement light_movement,
                     Movement camera_movement, CameraMotion motion) {
    double units = move_speed(view_state, scene);
    if (light < scene->light_count && movement_is_nonzero(light_movement)) {
        view_state->is_light_moved[light] = true;
        scene_light_move(&scene->lights[light],
                         movement_offset(&scene->camera, light_movement, units),
                         scene->camera.target_distance);
    }
    view_state->is_camera_moved =
        view_state->is_camera_moved || movement_is_nonzero(camera_movement);
    double right = camera_movement.right * units, up = camera_movement.up * units;
    double forward = camera_movement.forward * units;
    if (motion == MOTION_WALK) {
        scene_camera_walk(&scene->camera, view_state->up_axis, right, up, forward);
    } else {
        scene_camera_move(&scene->camera, right, up, forward);
    }
}
