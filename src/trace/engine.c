/**
 * @file
 * @brief The engine: the tracer of this number type and width as an object.
 */
#include "trace/ask.h"
#include "trace/grid.h"
#include "trace/origin.h"
#include "trace/survey.h"

#include <stdlib.h>

/**
 * Weight below which a ray cannot change the picture: half a step of 8 bits, 1 / 510, at the dark
 * end of the sRGB curve, where the slope is 12.92.
 */
#define WEIGHT_CUTOFF 1.5e-4

/** @return The sky in the engine's number type. @param sky The sky. */
static Backdrop backdrop_of(const Sky *sky) {
    Color rise = {sky->zenith.red - sky->horizon.red, sky->zenith.green - sky->horizon.green,
                  sky->zenith.blue - sky->horizon.blue};
    bool is_gradient = rise.red != 0 || rise.green != 0 || rise.blue != 0;
    return (Backdrop){light3_of(scalar3_of(sky->horizon)), light3_of(scalar3_of(rise)),
                      is_gradient};
}

/** Gives a tracer back. See #Engine.release. @param tracer The tracer, or NULL. */
static void engine_release(Tracer *tracer) {
    if (tracer) {
        shape_list_release(&tracer->list);
        models_release(&tracer->models);
        textures_release(&tracer->textures);
        glass_release(&tracer->glass);
        free(tracer->surfaces);
        free(tracer->lamps);
        glow_release(&tracer->glow);
        free(tracer);
    }
}

/** @return Memory for things that hold vectors, zero. @param size Bytes. */
static void *vector_allocate(size_t size) {
    /** Bytes: the widest vector of any engine. */
    const size_t alignment = 64;
    return aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

/** Takes camera, lights and size anew. See #Engine.look.
 *  @param tracer The tracer. @param scene The scene. @param width Pixels. @param height Pixels. */
static void engine_look(Tracer *tracer, const Scene *scene, int width, int height) {
    Vector3 way = vector3_scale(tracer->origin, -1);
    Camera camera = scene->camera;
    keyword_move(&camera_keyword, &camera, way);
    tracer->eye = eye_of(&camera, width, height);
    footprint_look(&tracer->models.footprint, &tracer->eye);
    glass_look(&tracer->glass, tracer->eye.origin);
    for (size_t i = 0; i < tracer->lamp_count; i++) {
        Light light = scene->lights[i];
        keyword_move(light_keyword_of(&light), &light, way);
        tracer->lamps[i] = lamp_of(&light, tracer->samples);
        tracer->is_soft = tracer->is_soft || tracer->lamps[i].is_soft;
    }
    glow_look(&tracer->glow, scene, tracer->origin);
}

/** @return A tracer whose shapes are there, without camera; NULL without memory.
 *  @param scene The scene. @param settings What is asked for. @param[out] error What is wrong. */
static Tracer *tracer_create(const Scene *scene, const TraceSettings *settings, Error *error) {
    Tracer *tracer = vector_allocate(sizeof *tracer);
    if (!tracer) {
        error_set(error, STATUS_FAILED, "no memory for a tracer");
        return NULL;
    }
    const Models *former = settings->former ? &settings->former->models : NULL;
    bool is_recursive = scene_has_mirrors(scene) || scene_has_glass(scene);
    *tracer = (Tracer){.backdrop = backdrop_of(&scene->sky),
                       .lamp_count = scene->light_count,
                       .depth = is_recursive ? settings->depth : 0,
                       .cutoff = (scalar)(settings->cutoff > 0 ? settings->cutoff : WEIGHT_CUTOFF),
                       .samples = settings->samples,
                       .shines = scene_has_highlights(scene),
                       .departure = {settings->offset, (scalar)settings->epsilon}};
    tracer->lamps = vector_allocate((scene->light_count + 1) * sizeof(Lamp));
    tracer->surfaces = vector_allocate(scene->material_count * sizeof(Surface));
    if (!tracer->lamps || !tracer->surfaces || !glow_init(&tracer->glow, scene, error) ||
        !textures_init(&tracer->textures, scene, error) ||
        !models_init(&tracer->models, scene, former, settings, error) ||
        !shape_list_init(&tracer->list, scene, &tracer->models, settings, error) ||
        !glass_init(&tracer->glass, scene, &tracer->list, settings)) {
        error_set(error, STATUS_FAILED, "no memory for the scene");
        engine_release(tracer);
        return NULL;
    }
    return tracer;
}

/** @return The same, with coordinates that begin elsewhere. @param scene The scene. @param settings
 *  What is asked for. @param origin Where in the scene. @param[out] error What is wrong. */
static Tracer *tracer_create_at(const Scene *scene, const TraceSettings *settings, Vector3 origin,
                                Error *error) {
    Scene *near = scene_moved(scene, shape_keywords, vector3_scale(origin, -1), error);
    Tracer *tracer = near ? tracer_create(near, settings, error) : NULL;
    if (tracer) {
        tracer->origin = origin;
    }
    scene_destroy(near);
    return tracer;
}

/** How often the origin is moved at most: very far away, where a scene's size is not seen in the
 *  engine's numbers, the first move only comes near. */
enum { ORIGIN_MOVES = 4 };

/** @return A tracer for a scene. See #Engine.prepare.
 *  @param scene The scene. @param settings What is asked for. @param[out] error What is wrong. */
static Tracer *engine_prepare(const Scene *scene, const TraceSettings *settings, Error *error) {
    Tracer *tracer = tracer_create(scene, settings, error);
    for (int moves = 0; tracer && moves < ORIGIN_MOVES; moves++) {
        Vector3 offset = origin_offset(&tracer->list);
        if (vector3_largest(offset) == 0) {
            break;
        }
        Vector3 origin = vector3_add(tracer->origin, offset);
        engine_release(tracer);
        tracer = tracer_create_at(scene, settings, origin, error);
    }
    if (tracer) {
        for (size_t i = 0; i < scene->material_count; i++) {
            tracer->surfaces[i] = surface_of(&scene->materials[i], scene->ambient);
        }
        glass_survey(&tracer->glass, tracer->surfaces);
        engine_look(tracer, scene, scene->image.width, scene->image.height);
    }
    return tracer;
}

/** Finds the box of all bounded shapes. See #Engine.bounds. @param tracer The tracer.
 *  @param[out] low Its lowest corner. @param[out] high Its highest. */
static void engine_bounds(const Tracer *tracer, Vector3 *low, Vector3 *high) {
    origin_bounds(&tracer->list, low, high);
    *low = vector3_add(*low, tracer->origin);
    *high = vector3_add(*high, tracer->origin);
}

/** Says what a tracer was made of. See #Engine.contents. @param tracer The tracer. @return It. */
static TracerContents engine_contents(const Tracer *tracer) {
    const ShapeList *list = &tracer->list;
    TracerContents contents = {.listed = list->loose_count,
                               .planted = list->count - list->loose_count,
                               .tree_from = list->tree_from};
    contents.stalled = stalls_count(&tracer->models.stalls);
    for (size_t i = 0; i < tracer->models.count; i++) {
        const Model *model = tracer->models.all[i];
        contents.triangles += model ? model->triangle_count : 0;
        contents.triangle_bytes += model ? model_size(model) : 0;
    }
    return contents;
}

/** This engine. */
extern const Engine ENGINE;

const Engine ENGINE = {
    .name = ENGINE_NAME,
    .lanes = LANES,
    .mantissa_bits = MANTISSA_BITS,
    .shape_keywords = shape_keywords,
    .prepare = engine_prepare,
    .look = engine_look,
    .trace = grid_trace,
    .cast = grid_cast,
    .survey = survey_grid,
    .nearest = ask_nearest,
    .shadowed = ask_shadowed,
    .intersect = ask_intersect,
    .bounds = engine_bounds,
    .contents = engine_contents,
    .measure = shape_measure,
    .release = engine_release,
};
