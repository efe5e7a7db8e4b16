/**
 * @file
 * @brief The shapes that hide the rays of a pixel from a second camera.
 */
#include "render/cut_away.h"

#include "render/renderer_internal.h"

#include <stdlib.h>
#include <string.h>

/** Points along a ray that are to be seen, with its end. */
enum { POINTS_PER_RAY = 4 };
/** Most rays whose points are to be seen. */
enum { RAYS_MAXIMUM = 48 };
/** Most shapes behind each other that are left out. */
enum { LAYERS_MAXIMUM = 6 };
/** A hit that is nearer by this fraction of the distance hides a point. */
static const double TOLERANCE = 1e-3;

void cut_away_deinit(CutAway *cut) {
    free(cut->may_be_hidden);
    free(cut->is_hidden);
    free(cut->shapes);
    *cut = (CutAway){0};
}

/** @return Whether a shape is a flat wall. */
static bool is_wall(const SceneShape *shape) {
    ShapeFace faces[SHAPE_FACES_MAXIMUM];
    return scene_shape_faces(shape, faces) == 1 && !faces[0].is_solid;
}

/** @return Whether light goes through a shape. */
static bool is_transparent(const Scene *scene, size_t shape) {
    return scene_material_is_transparent(&scene->materials[scene->shapes[shape].material_index]);
}

/** Makes room for a scene's shapes. @return false without memory: there is none then. */
static bool reserve(CutAway *cut, size_t count) {
    if (cut->shape_count == count) {
        return true;
    }
    cut_away_deinit(cut);
    cut->may_be_hidden = calloc(count, sizeof *cut->may_be_hidden);
    cut->is_hidden = calloc(count, sizeof *cut->is_hidden);
    cut->shapes = calloc(count, sizeof *cut->shapes);
    cut->shape_count = count;
    if (!cut->may_be_hidden || !cut->is_hidden || !cut->shapes) {
        cut_away_deinit(cut);
    }
    return cut->shape_count == count;
}

/** Lists the shapes that are left. */
static void collect_shapes(CutAway *cut, const Scene *scene) {
    cut->left_count = 0;
    for (size_t i = 0; i < cut->shape_count; i++) {
        if (!cut->is_hidden[i]) {
            cut->shapes[cut->left_count++] = scene->shapes[i];
        }
    }
}

bool cut_away_begin(CutAway *cut, const Scene *scene, const RayTree *tree) {
    const size_t count = scene->shape_count;
    if (count == 0 || count > CUT_AWAY_SHAPES_MAXIMUM) {
        cut_away_deinit(cut);
        return false;
    }
    if (!reserve(cut, count)) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        cut->may_be_hidden[i] = !is_transparent(scene, i);
    }
    for (size_t i = 0; i < tree->count; i++) {
        int shape = tree->nodes[i].shape;
        if (shape >= 0 && !is_wall(&scene->shapes[shape])) {
            cut->may_be_hidden[shape] = false;
        }
    }
    collect_shapes(cut, scene);
    return true;
}

bool cut_away_may_hide(const CutAway *cut, int shape) {
    return shape >= 0 && (size_t)shape < cut->shape_count && cut->may_be_hidden[shape];
}

/** Leaves out what hides one point. @param[in,out] is_hidden For each shape whether it is left
 *  out. */
static void hide_before(const CutAway *cut, const Renderer *renderer, const Scene *scene, Vec3d eye,
                        Vec3d point, bool *is_hidden) {
    Vec3d to = vec3d_subtract(point, eye);
    double passed = 0;
    for (int layer = 0; layer < LAYERS_MAXIMUM; layer++) {
        Vec3d from = vec3d_add(eye, vec3d_scale(to, passed));
        RayQuery ray = {{from.x, from.y, from.z}, {to.x, to.y, to.z}};
        int shape;
        double distance;
        renderer->settings.engine->closest_hits(renderer->tracer, 1, &ray, &shape, &distance);
        passed += distance + TOLERANCE / 4;
        if (shape < 0 || passed >= 1 - TOLERANCE) {
            return;
        }
        if (cut->may_be_hidden[shape]) {
            is_hidden[shape] = true;
        } else if (!is_transparent(scene, (size_t)shape)) {
            return; // It stays; what is behind it stays hidden.
        }
    }
}

bool cut_away_update(CutAway *cut, const Renderer *renderer, const Scene *scene,
                     const RayTree *tree, Vec3d eye) {
    bool *is_hidden = calloc(cut->shape_count + 1, sizeof *is_hidden);
    if (!is_hidden || cut->shape_count == 0) {
        free(is_hidden);
        return false;
    }
    for (size_t i = 0; i < tree->count && i < RAYS_MAXIMUM; i++) {
        const RayTreeNode *ray = &tree->nodes[i];
        double length = fmin(ray->distance, ray->limit);
        for (int part = 1; part <= POINTS_PER_RAY && isfinite(length); part++) {
            Vec3d along = vec3d_scale(ray->direction, length * part / POINTS_PER_RAY);
            hide_before(cut, renderer, scene, eye, vec3d_add(ray->origin, along), is_hidden);
        }
    }
    bool is_other = memcmp(is_hidden, cut->is_hidden, cut->shape_count * sizeof *is_hidden) != 0;
    memcpy(cut->is_hidden, is_hidden, cut->shape_count * sizeof *is_hidden);
    free(is_hidden);
    if (is_other) {
        collect_shapes(cut, scene);
    }
    return is_other;
}

Scene cut_away_scene(const CutAway *cut, const Scene *scene) {
    Scene left = *scene;
    if (cut->shape_count > 0) {
        left.shapes = cut->shapes;
        left.shape_count = cut->left_count;
    }
    return left;
}
