/**
 * @file
 * @brief Making models.
 */
#include "trace/model.h"

#include "trace/shapes/shear.h"

#include <stdlib.h>
#include <string.h>

/** Bytes: the widest vector of any engine. */
#define MODEL_ALIGNMENT 64

/** @return A corner of a triangle. @param mesh The mesh. @param triangle Which triangle.
 *  @param corner Which corner, 0 to 2. */
static Vector3 mesh_corner(const Mesh *mesh, size_t triangle, int corner) {
    return mesh->positions[mesh->triangles[triangle].at[corner]];
}

/** @return The box around a triangle. @param mesh The mesh. @param triangle Which triangle. */
static Bounds triangle_bounds(const Mesh *mesh, size_t triangle) {
    Corner corners[3];
    for (int i = 0; i < 3; i++) {
        corners[i] = corner_of(mesh_corner(mesh, triangle, i));
    }
    return corners_bounds(corners, 3);
}

/** Works out the boxes of all triangles, and the one around them. @param model The model.
 *  @param mesh The mesh. @param[out] boxes One for each triangle. */
static void boxes_fill(Model *model, const Mesh *mesh, Bounds *boxes) {
    model->bounds = triangle_bounds(mesh, 0);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        boxes[i] = triangle_bounds(mesh, i);
        for (int axis = 0; axis < 3; axis++) {
            scalar low = boxes[i].low[axis], high = boxes[i].high[axis];
            model->bounds.low[axis] = low < model->bounds.low[axis] ? low : model->bounds.low[axis];
            model->bounds.high[axis] =
                high > model->bounds.high[axis] ? high : model->bounds.high[axis];
            model->reach = -low > model->reach ? -low : model->reach;
            model->reach = high > model->reach ? high : model->reach;
        }
    }
}

/** Puts a triangle into a block. @param[in,out] block The block. @param lane Where in it.
 *  @param mesh The mesh. @param triangle Which triangle. */
static void block_place(TriangleBlock *block, int lane, const Mesh *mesh, uint32_t triangle) {
    for (int corner = 0; corner < 3; corner++) {
        Vector3 at = mesh_corner(mesh, triangle, corner);
        real_set_lane(&block->corners[corner].x, lane, (scalar)at.x);
        real_set_lane(&block->corners[corner].y, lane, (scalar)at.y);
        real_set_lane(&block->corners[corner].z, lane, (scalar)at.z);
    }
    block->triangles[lane] = triangle;
}

/** Lays the triangles out in the order of the tree. @param model The model, with its tree.
 *  @param mesh The mesh. @return false without memory. */
static bool blocks_make(Model *model, const Mesh *mesh) {
    size_t size = model->tree.block_count * sizeof *model->blocks;
    model->blocks = aligned_alloc(MODEL_ALIGNMENT,
                                  (size + MODEL_ALIGNMENT - 1) / MODEL_ALIGNMENT * MODEL_ALIGNMENT);
    for (size_t i = 0; model->blocks && i < model->tree.block_count * LANES; i++) {
        block_place(&model->blocks[i / LANES], (int)(i % LANES), mesh, model->tree.order[i]);
    }
    return model->blocks != NULL;
}

/** @return The normals to interpolate, to be freed; NULL without memory. @param mesh The mesh.
 *  @param from_file Whether they are the file's. */
static Point *normals_make(const Mesh *mesh, bool from_file) {
    size_t count = from_file ? mesh->normal_count : mesh->position_count;
    Vector3 *smooth = from_file ? NULL : malloc(count * sizeof *smooth);
    Point *normals = malloc(count * sizeof *normals);
    const Vector3 *source = from_file ? mesh->normals : smooth;
    if (smooth) {
        mesh_smooth_normals(mesh, smooth);
    }
    for (size_t i = 0; normals && source && i < count; i++) {
        normals[i] = (Point){(scalar)source[i].x, (scalar)source[i].y, (scalar)source[i].z};
    }
    free(smooth);
    if (!source) {
        free(normals);
        return NULL;
    }
    return normals;
}

/** Lays what belongs to triangles out in the order of the blocks. @param model The model, with its
 *  tree. @param triangles It, in the order of the mesh. @return The same for each slot, to be
 *  freed; NULL without memory. */
static MeshTriangle *slots_make(const Model *model, const MeshTriangle *triangles) {
    size_t slots = model->tree.block_count * LANES;
    MeshTriangle *ordered = malloc(slots * sizeof *ordered);
    for (size_t i = 0; ordered && i < slots; i++) {
        ordered[i] = triangles[model->tree.order[i]];
    }
    return ordered;
}

/** Keeps what interpolating normals needs. @param model The model, with its tree. @param mesh The
 *  mesh. @param source Where the normals come from. @return false without memory. */
static bool normals_keep(Model *model, const Mesh *mesh, NormalSource source) {
    if (source == NORMALS_FLAT) {
        return true;
    }
    bool from_file = source == NORMALS_FILE && mesh->normal_count > 0;
    const MeshTriangle *places = from_file ? mesh->triangle_normals : mesh->triangles;
    model->normals = normals_make(mesh, from_file);
    model->normal_count = from_file ? mesh->normal_count : mesh->position_count;
    model->places = slots_make(model, places);
    return model->normals && model->places;
}

/** Keeps the places on a picture. @param model The model, with its tree. @param mesh The mesh.
 *  @return false without memory. */
static bool spots_keep(Model *model, const Mesh *mesh) {
    if (mesh->uv_count == 0) {
        return true;
    }
    model->spot_count = mesh->uv_count;
    model->spots = malloc(mesh->uv_count * sizeof *model->spots);
    for (size_t i = 0; model->spots && i < mesh->uv_count; i++) {
        model->spots[i] = (Spot){(scalar)mesh->uvs[i].u, (scalar)mesh->uvs[i].v};
    }
    model->spot_at = slots_make(model, mesh->triangle_uvs);
    return model->spots && model->spot_at;
}

/** Gives a model back; the last owner's call gives its memory back. @param model It, or NULL. */
static void model_release(Model *model) {
    if (model && atomic_fetch_sub(&model->owners, 1) == 1) {
        tree_release(&model->tree);
        free(model->blocks);
        free(model->normals);
        free(model->places);
        free(model->spots);
        free(model->spot_at);
        mesh_destroy(model->mesh);
        free(model);
    }
}

/** Fills a model. @param[in,out] model The model, with its mesh. @param source Where its normals
 *  come from. @param models Who builds the tree, and whether pictures are shown. @return false
 *  without memory. */
static bool model_fill(Model *model, NormalSource source, const Models *models) {
    const Mesh *mesh = model->mesh;
    Bounds *boxes = malloc(mesh->triangle_count * sizeof *boxes);
    if (boxes) {
        boxes_fill(model, mesh, boxes);
    }
    bool is_made =
        boxes && tree_build(&model->tree, boxes, mesh->triangle_count, LANES, models->crew);
    free(boxes);
    /* A number of a block must be found with the 32 bits of a lane. */
    is_made = is_made && model->tree.block_count <= (size_t)(INT32_MAX / BLOCK_NUMBERS) &&
              blocks_make(model, mesh) && normals_keep(model, mesh, source) &&
              (!models->has_textures || spots_keep(model, mesh));
    /* The blocks say it now. */
    free(model->tree.order);
    model->tree.order = NULL;
    return is_made;
}

/** @return A model with one owner; NULL without memory. @param mesh The mesh. @param source Where
 *  its normals come from. @param models Who builds the tree, and whether pictures are shown.
 *  @param[out] error What is wrong. */
static Model *model_create(Mesh *mesh, NormalSource source, const Models *models, Error *error) {
    Model *model = malloc(sizeof *model);
    if (model) {
        *model = (Model){.triangle_count = mesh->triangle_count, .mesh = mesh_share(mesh)};
        atomic_init(&model->owners, 1);
    }
    if (!model || !model_fill(model, source, models)) {
        model_release(model);
        error_set(error, STATUS_FAILED, "no memory for a tree over %zu triangles",
                  mesh->triangle_count);
        return NULL;
    }
    return model;
}

size_t model_size(const Model *model) {
    size_t slots = model->tree.block_count * LANES;
    return tree_size(&model->tree) + model->tree.block_count * sizeof *model->blocks +
           model->normal_count * sizeof *model->normals + model->spot_count * sizeof *model->spots +
           (model->places ? slots * sizeof *model->places : 0) +
           (model->spot_at ? slots * sizeof *model->spot_at : 0);
}

bool models_init(Models *models, const Scene *scene, const Models *former,
                 const TraceSettings *settings, Error *error) {
    size_t count = scene->mesh_count * MODEL_KINDS;
    *models = (Models){.count = count,
                       .meshes = scene->meshes,
                       .former = former,
                       .crew = &settings->crew,
                       .has_textures = scene_has_textures(scene),
                       .relaxation = (scalar)settings->relaxation,
                       .footprint = {.share = (scalar)settings->footprint}};
    models->all = calloc(count + 1, sizeof *models->all);
    return models->all ||
           error_set(error, STATUS_FAILED, "no memory for %zu models", scene->mesh_count);
}

void models_release(Models *models) {
    for (size_t i = 0; models->all && i < models->count; i++) {
        model_release(models->all[i]);
    }
    free(models->all);
    *models = (Models){0};
}

/** @return Whether a model has all that a scene asks for. @param model The model. @param models The
 *  models of the scene. */
static bool model_serves(const Model *model, const Models *models) {
    return !models->has_textures || model->spots || model->mesh->uv_count == 0;
}

/** @return A model that a former tracer has made, with one owner more; NULL if there is none.
 *  @param models The models, and the former ones. @param mesh The mesh. @param source Where its
 *  normals come from. */
static Model *model_share(const Models *models, const Mesh *mesh, NormalSource source) {
    const Models *former = models->former;
    for (size_t i = source; former && i < former->count; i += MODEL_KINDS) {
        Model *model = former->all[i];
        if (model && model->mesh == mesh && model_serves(model, models)) {
            atomic_fetch_add(&model->owners, 1);
            return model;
        }
    }
    return NULL;
}

const Model *models_get(Models *models, size_t mesh, NormalSource source, Error *error) {
    Model **model = &models->all[mesh * MODEL_KINDS + source];
    Mesh *made_of = models->meshes[mesh].mesh;
    if (!*model) {
        *model = model_share(models, made_of, source);
    }
    if (!*model) {
        *model = model_create(made_of, source, models, error);
    }
    return *model;
}
