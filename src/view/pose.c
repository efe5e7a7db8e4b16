/**
 * @file
 * @brief Where the camera and the lights are, and moving them.
 */
#include "view/pose.h"

#include <stdlib.h>
#include <string.h>

/**
 * Plain speed: the share of the way to what the camera looks at that is gone in a second. A scene
 * is crossed in a few seconds, and a tap moves it by some pixels, whatever its size.
 */
static const double SPEED = 0.5;

/**
 * Finds which way is up in a scene. That is y; but a scene may have been made with another axis
 * up, and then the top of its picture points there. A camera that looks steeply up or down tells
 * nothing by its own up.
 * @param camera  The scene's own camera.
 * @return One of the six axes.
 */
static Vector3 scene_vertical(const Camera *camera) {
    Vector3 up = camera->up;
    double x = fabs(up.x), y = fabs(up.y), z = fabs(up.z);
    bool is_steep = fabs(camera->direction.y) > M_SQRT1_2;
    if (!is_steep && z > x && z > y) {
        return (Vector3){0, 0, copysign(1, up.z)};
    }
    if (!is_steep && x > y) {
        return (Vector3){copysign(1, up.x), 0, 0};
    }
    return (Vector3){0, is_steep ? 1 : copysign(1, up.y), 0};
}

bool pose_save(Pose *pose, const Scene *scene, Error *error) {
    /* One more than there are: a scene without lights is no lack of memory. */
    size_t count = scene->light_count;
    *pose = (Pose){.lights = calloc(count + 1, sizeof *pose->lights),
                   .is_light_moved = calloc(count + 1, sizeof *pose->is_light_moved),
                   .light_count = count};
    if (!pose->lights || !pose->is_light_moved) {
        pose_release(pose);
        return error_set(error, STATUS_FAILED, "no memory for %zu lights", scene->light_count);
    }
    if (scene->light_count > 0) {
        memcpy(pose->lights, scene->lights, scene->light_count * sizeof *pose->lights);
    }
    pose->camera = scene->camera;
    pose->vertical = scene_vertical(&scene->camera);
    return true;
}

/**
 * Puts a light where another one is; its colour stays.
 * @param[in,out] light  The light.
 * @param like           The other one.
 */
static void place_light(Light *light, const Light *like) {
    if (light->kind == like->kind) {
        light->position = like->position;
        light->direction = like->direction;
    }
}

bool pose_renew(Pose *pose, const Scene *before, Scene *scene, Error *error) {
    Pose next;
    if (!pose_save(&next, scene, error)) {
        return false;
    }
    next.is_camera_moved = pose->is_camera_moved;
    if (pose->is_camera_moved) {
        scene->camera = before->camera;
    }
    for (size_t i = 0; i < next.light_count && i < pose->light_count; i++) {
        next.is_light_moved[i] = pose->is_light_moved[i];
        if (pose->is_light_moved[i]) {
            place_light(&scene->lights[i], &before->lights[i]);
        }
    }
    pose_release(pose);
    *pose = next;
    return true;
}

void pose_restore(Pose *pose, Scene *scene) {
    scene->camera = pose->camera;
    pose->is_camera_moved = false;
    for (size_t i = 0; i < pose->light_count; i++) {
        scene->lights[i] = pose->lights[i];
        pose->is_light_moved[i] = false;
    }
}

bool pose_copy(Pose *copy, const Pose *pose, const Scene *scene, Error *error) {
    if (!pose_save(copy, scene, error)) {
        return false;
    }
    copy->is_camera_moved = pose->is_camera_moved;
    for (size_t i = 0; i < copy->light_count && i < pose->light_count; i++) {
        copy->is_light_moved[i] = pose->is_light_moved[i];
    }
    return true;
}

void pose_put_back(const Pose *copy, Pose *pose, Scene *scene) {
    scene->camera = copy->camera;
    pose->is_camera_moved = copy->is_camera_moved;
    for (size_t i = 0; i < copy->light_count && i < pose->light_count; i++) {
        scene->lights[i] = copy->lights[i];
        pose->is_light_moved[i] = copy->is_light_moved[i];
    }
}

void pose_release(Pose *pose) {
    free(pose->lights);
    free(pose->is_light_moved);
    *pose = (Pose){0};
}

/**
 * @return A movement's way through the scene.
 * @param camera    The camera whose picture the movement is seen in.
 * @param movement  The movement, in seconds.
 */
static Vector3 way(const Camera *camera, Movement movement) {
    double units = SPEED * camera->focus;
    Vector3 right = vector3_scale(camera_right(camera), movement.right * units);
    Vector3 up = vector3_scale(camera->up, movement.up * units);
    Vector3 forward = vector3_scale(camera->direction, movement.forward * units);
    return vector3_add(vector3_add(right, up), forward);
}

void pose_move(Pose *pose, Scene *scene, size_t light, Movement light_by, Movement camera_by) {
    if (light < scene->light_count && movement_is_any(light_by)) {
        pose->is_light_moved[light] = true;
        light_move(&scene->lights[light], way(&scene->camera, light_by), scene->camera.focus);
    }
    double units = SPEED * scene->camera.focus;
    pose->is_camera_moved = pose->is_camera_moved || movement_is_any(camera_by);
    camera_move(&scene->camera, camera_by.right * units, camera_by.up * units,
                camera_by.forward * units);
}
