/**
 * @file
 * @brief Search for surfaces that float cannot tell apart.
 */
#include "render/z_fighting/search.h"

#include <math.h>
#include <stdlib.h>

/** Compares the faces of lights with all shapes. @param planes The whole planes. */
static void compare_lights(Search *search, const BoundedShape *shapes, size_t count,
                           const SceneShape *const *planes, size_t plane_count) {
    const Scene *scene = search->scene;
    for (size_t i = 0; i < scene->light_count; i++) {
        const SceneLight *light = &scene->lights[i];
        if (!scene_light_classes[light->class_index]->face) {
            continue;
        }
        ShapeFace face = scene_light_classes[light->class_index]->face(light);
        Aabbd box = aabbd_empty();
        for (int k = 0; k < face.corner_count; k++) {
            box = aabbd_add_point(box, face.corners[k]);
        }
        double bound = shape_gap_bound(search, &box);
        for (size_t k = 0; k < plane_count && search_begin_pair(search) &&
                           search->shape_pairs++ < SHAPE_PAIRS_MAXIMUM;
             k++) {
            compare_light_with_shape(search, &face, planes[k], NULL, bound);
        }
        for (size_t k = 0; k < count && search_begin_pair(search); k++) {
            if (aabbd_overlaps(&shapes[k].box, &box) &&
                search->shape_pairs++ < SHAPE_PAIRS_MAXIMUM) {
                compare_light_with_shape(search, &face, shapes[k].shape, shapes[k].mesh, bound);
            }
        }
    }
}

/** Finds where secondary rays start: on bounded mirrors and glass, or anywhere around the scene and
 *  the eye if a mirror is unbounded. */
static void find_secondary(Search *search) {
    const Scene *scene = search->scene;
    Aabbd *box = &search->secondary;
    *box = search->centers = aabbd_empty();
    bool is_bounded = true;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneShape *shape = &scene->shapes[i];
        if (!scene_material_is_secondary(&scene->materials[shape->material_index])) {
            continue;
        }
        Aabbd bounds = scene_shape_facts(scene, shape).bounds;
        Vec3d center = vec3d_scale(vec3d_add(bounds.low, bounds.high), 0.5);
        if (!aabbd_is_bounded(bounds)) {
            ShapeFace face = {.corners = {scene->camera.position}};
            scene_shape_faces(shape, &face);
            double height = height_above(&face, scene->camera.position);
            center = vec3d_subtract(scene->camera.position, vec3d_scale(face.normal, height));
            is_bounded = false;
        }
        search->centers = aabbd_add_point(search->centers, center);
        box->low = vec3d_min(box->low, bounds.low);
        box->high = vec3d_max(box->high, bounds.high);
        search->has_secondary = true;
        search->has_glass = search->has_glass || is_glass(search, shape);
    }
    if (!is_bounded) {
        *box = aabbd_add_point(scene_bounds(scene), scene->camera.position);
    }
}

/** Memory of the search: arrays for as many shapes as the scene has. */
typedef struct SearchMemory {
    BoundedShape *shapes;      /**< Bounded shapes with flat faces, and meshes. */
    BoundedShape *spheres;     /**< Spheres. */
    const SceneShape **planes; /**< Whole planes. */
} SearchMemory;

/** Compares all shapes. */
static void search_scene(Search *search, const SearchMemory *memory) {
    const Scene *scene = search->scene;
    size_t count = 0, sphere_count = 0, plane_count = 0;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneShape *shape = &scene->shapes[i];
        const SceneShapeClass *class = scene_shape_classes[shape->class_index];
        ShapeFacts facts = scene_shape_facts(scene, shape);
        if (!aabbd_is_bounded(facts.bounds)) {
            if (class->faces) {
                memory->planes[plane_count++] = shape;
            }
        } else if (class->faces || class->shell || facts.mesh) {
            double bound = shape_gap_bound(search, &facts.bounds);
            const Vec3d reach = {bound, bound, bound};
            BoundedShape bounded = {
                {vec3d_subtract(facts.bounds.low, reach), vec3d_add(facts.bounds.high, reach)},
                shape,
                facts.mesh,
                bound};
            *(class->faces || facts.mesh ? &memory->shapes[count++]
                                         : &memory->spheres[sphere_count++]) = bounded;
        }
    }
    compare_planes(search, memory->planes, plane_count);
    for (size_t i = 0; i < plane_count; i++) {
        compare_plane_with_shapes(search, memory->planes[i], memory->shapes, count);
    }
    compare_group(search, memory->shapes, count);
    compare_lights(search, memory->shapes, count, memory->planes, plane_count);
    compare_spheres(search, memory->spheres, sphere_count);
}

ZFighting z_fighting_of(const Scene *scene) {
    const SceneCamera *camera = &scene->camera;
    double half_width = tan(camera->fov / 2 * (M_PI / 180));
    Search search = {.scene = scene,
                     .origin = scene_local_origin(scene),
                     .right = scene_camera_right(camera),
                     .half_width = half_width,
                     .half_height = half_width * scene->image.height / scene->image.width};
    size_t count = scene->shape_count + 1;
    SearchMemory memory = {calloc(count, sizeof *memory.shapes),
                           calloc(count, sizeof *memory.spheres),
                           calloc(count, sizeof *memory.planes)};
    if (memory.shapes && memory.spheres && memory.planes) {
        find_secondary(&search);
        search_scene(&search, &memory);
    }
    free(memory.planes);
    free(memory.spheres);
    free(memory.shapes);
    search.result.fraction = fmin(1, search.result.fraction);
    search.result.coincident = fmin(1, search.result.coincident);
    return search.result;
}
