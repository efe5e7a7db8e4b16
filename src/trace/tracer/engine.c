/**
 * @file
 * @brief The engine of this number type and width: construction of its tracer, and its vtable.
 */
#include "trace/tracer/aov.h"
#include "trace/tracer/query.h"
#include "trace/tracer/report_methods.h"
#include "trace/tracer/tile.h"

#include <limits.h>
#include <stdlib.h>

/** @return The sky in the engine's number type. */
static Sky sky_of(const SceneSky *sky) {
    Rgbd zenith_minus_horizon = {sky->zenith.red - sky->horizon.red,
                                 sky->zenith.green - sky->horizon.green,
                                 sky->zenith.blue - sky->horizon.blue};
    bool is_gradient = zenith_minus_horizon.red != 0 || zenith_minus_horizon.green != 0 ||
                       zenith_minus_horizon.blue != 0;
    return (Sky){rgb_splat(rgbs_of(sky->horizon)), rgb_splat(rgbs_of(zenith_minus_horizon)),
                 is_gradient};
}

/** Frees a tracer, or NULL. See #Engine.destroy. */
static void engine_destroy_tracer(Tracer *tracer) {
    if (tracer) {
        shape_set_deinit(&tracer->shapes);
        mesh_bvh_cache_deinit(&tracer->meshes);
        textures_deinit(&tracer->textures);
        dielectrics_deinit(&tracer->dielectrics);
        free(tracer->materials);
        free(tracer->lights);
        emitters_deinit(&tracer->emitters);
        loss_budget_deinit(&tracer->loss_budget);
        wavefront_pool_destroy(tracer->wavefronts);
        free(tracer);
    }
}

/** @return Memory for arrays of vectors, uninitialized; NULL if memory is exhausted. */
static void *simd_allocate(size_t size) {
    /** Bytes of the widest vector of all engines. */
    const size_t alignment = 64;
    return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

/** Sets camera, lights and image size. See #Engine.set_view. */
static void engine_set_view(Tracer *tracer, const Scene *scene, int width, int height) {
    Vec3d shift = vec3d_scale(tracer->origin, -1);
    SceneCamera camera = scene->camera;
    keyword_translate(&scene_camera_keyword, &camera, shift);
    tracer->camera = camera_of(&camera, width, height, tracer->pixel_point);
    footprint_set_camera(&tracer->meshes.footprint, &tracer->camera);
    dielectrics_set_camera(&tracer->dielectrics, tracer->camera.origin);
    for (size_t i = 0; i < tracer->seen_light_count; i++) {
        SceneLight light = scene->lights[i];
        keyword_translate(scene_light_keyword_for(&light), &light, shift);
        tracer->lights[i] = light_of(&light, tracer->samples);
        if (tracer->methods) {
            report_light_set(&tracer->lights[i], tracer->methods);
        }
        tracer->has_soft_shadows = tracer->has_soft_shadows || tracer->lights[i].is_soft;
    }
    emitters_set(&tracer->emitters, scene, tracer->lights, tracer->seen_light_count,
                 tracer->origin);
    if (tracer->depth > 0) {
        loss_budget_set_view(&tracer->loss_budget, scene, tracer->seen_light_count);
    }
}

/**
 * Creates the shapes, textures and dielectrics of a tracer; #engine_set_view adds camera and
 * lights.
 * @param origin  Where in the scene its coordinates start.
 * @return The tracer, or NULL without memory.
 */
static Tracer *tracer_create(const Scene *scene, Vec3d origin, const TraceSettings *settings,
                             Error *error) {
    Tracer *tracer = simd_allocate(sizeof *tracer);
    if (!tracer) {
        error_set(error, STATUS_FAILED, "no memory for a tracer");
        return NULL;
    }
    const MeshBvhCache *reuse_from = settings->reuse_from ? &settings->reuse_from->meshes : NULL;
    bool is_recursive = scene_has_secondary_rays(scene);
    *tracer = (Tracer){.sky = sky_of(&scene->sky),
                       .light_count = settings->is_unlit ? 0 : scene->light_count,
                       .seen_light_count = scene->light_count,
                       .depth = !is_recursive                     ? 0
                                : settings->depth < DEPTH_MAXIMUM ? settings->depth
                                                                  : INT_MAX,
                       .samples = settings->samples,
                       .methods = settings->methods,
                       .pixel_point = settings->pixel_point,
                       .origin = origin,
                       .ray_offset = {settings->offset, (scalar)settings->epsilon}};
    tracer->lights = simd_allocate((scene->light_count + 1) * sizeof(Light));
    tracer->materials = simd_allocate(scene->material_count * sizeof(Material));
    if (!tracer->lights || !tracer->materials || !emitters_init(&tracer->emitters, scene, error) ||
        !loss_budget_init(&tracer->loss_budget, scene, settings) ||
        !textures_init(&tracer->textures, scene, error) ||
        !mesh_bvh_cache_init(&tracer->meshes, scene, reuse_from, settings, error) ||
        !shape_set_init(&tracer->shapes, scene, &tracer->meshes, settings, error) ||
        !dielectrics_init(&tracer->dielectrics, scene, &tracer->shapes, settings)) {
        error_set(error, STATUS_FAILED, "no memory for the scene");
        engine_destroy_tracer(tracer);
        return NULL;
    }
    // The reports trace by rules of their own. Without memory the recursion traces all rays; what
    // merged rays would find is estimated there, and counted as unresolved.
    bool has_wavefronts = tracer->dielectrics.iors && tracer->depth > 0 && !tracer->methods;
    tracer->wavefronts = has_wavefronts ? wavefront_pool_create() : NULL;
    return tracer;
}

/** Creates a tracer whose coordinates start at #scene_local_origin. See #Engine.create_tracer.
 *  @return The tracer, or NULL without memory. */
static Tracer *engine_create_tracer(const Scene *scene, const TraceSettings *settings,
                                    Error *error) {
    Vec3d origin = scene_local_origin(scene);
    bool is_moved = vec3d_max_abs(origin) > 0;
    Scene *moved = is_moved ? scene_translated(scene, vec3d_scale(origin, -1), error) : NULL;
    Tracer *tracer =
        is_moved && !moved ? NULL : tracer_create(moved ? moved : scene, origin, settings, error);
    scene_destroy(moved);
    if (tracer) {
        for (size_t i = 0; i < scene->material_count; i++) {
            tracer->materials[i] = material_of(&scene->materials[i], scene->ambient);
        }
        if (!dielectrics_find_tints(&tracer->dielectrics, tracer->materials, settings)) {
            engine_destroy_tracer(tracer);
            error_set(error, STATUS_FAILED, "no memory for the scene");
            return NULL;
        }
        engine_set_view(tracer, scene, scene->image.width, scene->image.height);
    }
    return tracer;
}

/** Finds the bounding box of all bounded shapes. See #Engine.bounds. */
static void engine_bounds(const Tracer *tracer, Vec3d *low, Vec3d *high) {
    Aabbd bounds = shape_set_bounds(&tracer->shapes);
    *low = bounds.low;
    *high = bounds.high;
    *low = vec3d_add(*low, tracer->origin);
    *high = vec3d_add(*high, tracer->origin);
}

/** @return The statistics of a tracer. See #Engine.stats. */
static TracerStats engine_stats(const Tracer *tracer) {
    const ShapeSet *shapes = &tracer->shapes;
    TracerStats stats = {.linear = shapes->linear_count,
                         .in_bvh = shapes->count - shapes->linear_count,
                         .bvh_threshold = shapes->bvh_threshold,
                         .radiance_bound = (double)tracer->loss_budget.radiance_bound};
    stats.step_limit_count = step_limit_counter_load(&tracer->meshes.step_limit_counter);
    for (size_t i = 0; i < tracer->meshes.count; i++) {
        const MeshBvh *model = tracer->meshes.entries[i];
        stats.triangles += model ? model->triangle_count : 0;
        stats.triangle_bytes += model ? mesh_bvh_memory_size(model) : 0;
    }
    return stats;
}

/** The processor features that this file is compiled for. */
#if defined(__AVX512DQ__)
#define ENGINE_NEEDS ENGINE_NEEDS_AVX512
#elif defined(__AVX2__)
#define ENGINE_NEEDS ENGINE_NEEDS_AVX2
#else
#define ENGINE_NEEDS ENGINE_NEEDS_NOTHING
#endif

/** This engine. */
extern const Engine ENGINE;

const Engine ENGINE = {
    .name = ENGINE_NAME,
    .lanes = LANES,
    .mantissa_bits = MANTISSA_BITS,
    .needs = ENGINE_NEEDS,
    .create_tracer = engine_create_tracer,
    .set_view = engine_set_view,
    .trace = trace_tile,
    .trace_primary = trace_tile_primary,
    .trace_aovs = aov_trace,
    .closest_hits = query_closest_hits,
    .occluded = query_occluded,
    .intersect = query_intersect,
    .bounds = engine_bounds,
    .stats = engine_stats,
    .destroy = engine_destroy_tracer,
};
