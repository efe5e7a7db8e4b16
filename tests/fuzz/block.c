/**
 * @file
 * @brief Fuzz target: the block of a scene that a worker hands over.
 *
 * The block of a good scene is made once. Each input overwrites some of its bytes; what the program
 * accepts is then read from end to end, as a tracer would.
 */
#include "shared/handover.h"
#include "shared/script_target.h"

#include "assets/meshes/mesh_worker.h"
#include "dioptre/sdf_tape.h"
#include "script/script_worker.h"

/** Address of all scenes: between the sanitizer's heap and its shadow nothing else lies. */
static void *const ADDRESS = (void *)0x500000000000;
/** A file of the project, whose text the program reads, and nobody runs. */
static const char FILE_OF_PROJECT[] = "scenes/box.lua";
/** The good scene: each kind of shape, light and field. */
static const char TEXT[] =
    "camera { position = {0, 0, 9} }\n"
    "image { samples = 4 }\n"
    "sky { horizon = 1, zenith = {0, 0, 1} }\n"
    "light { radius = 1 }\n"
    "sun { direction = {0, -1, 0} }\n"
    "local glass = material { transparency = 0.9, ior = 1.5 }\n"
    "sphere { material = glass, translate = {1, 2, 3}, rotate = {1, 2, 3} }\n"
    "plane {}\nquad {}\nbox {}\ndisk {}\ncylinder {}\ncone {}\ntriangle {}\n"
    "mesh { file = 'models/die.obj' }\n"
    "sphere { material = material { texture = 'pictures/die.png' } }\n"
    "local field = distance.sphere {}\n"
    "sdf { distance.smooth_union(field, distance.box {}, 0.1):translate{1, 2, 3} }\n"
    "sdf { function(x, y, z) return x * x + y * y + math.sin(z) - 1 end }\n";

/** The input of the run. */
static FuzzInput input;
/** The block of the good scene. */
static uint8_t *good;
/** Its bytes. */
static size_t good_size;

Scene *__wrap_scene_create(Error *error);

/** Creates each scene at the same address, so that the pointers in the block hold. */
Scene *__wrap_scene_create(Error *error) {
    return scene_create_at(ADDRESS, error);
}

/** Makes the block of the good scene. */
static void make_good(void) {
    FuzzRun run;
    Error error = {0};
    Scene *scene = scene_create_at(ADDRESS, &error);
    FUZZ_REQUIRE(scene);
    FUZZ_REQUIRE(fuzz_run_init(&run, (const uint8_t *)TEXT, strlen(TEXT)));
    run.run.dialect = &scene_dialect;
    run.run.scene = scene;
    bool is_good = fuzz_run_execute(&run, script_run_execute);
    if (!is_good) {
        fprintf(stderr, "%s\n", run.run.result->error.message);
    }
    FUZZ_REQUIRE(is_good);
    good_size = scene_block_size(scene);
    good = malloc(good_size);
    FUZZ_REQUIRE(good);
    memcpy(good, scene, good_size);
    fuzz_run_deinit(&run);
    scene_destroy(scene);
}

/** Hands over a triangle. @return Its block. */
static const void *reply_mesh(const WorkerCall *call, size_t *size) {
    static union {
        Mesh mesh;                          /**< Its head. */
        uint8_t bytes[sizeof(Mesh) + 1024]; /**< All bytes. */
    } block;
    block.mesh = (Mesh){.position_count = 3, .triangle_count = 1};
    mesh_bind_arrays(&block.mesh);
    block.mesh.positions[1].x = block.mesh.positions[2].y = 1;
    block.mesh.triangles[0] = (MeshTriangle){{0, 1, 2}};
    *(bool *)call->report = true;
    *size = mesh_block_size(&block.mesh);
    return &block;
}

/** Hands over a texel. @return Its block. */
static const void *reply_texture(const WorkerCall *call, size_t *size) {
    static struct {
        Texture texture;   /**< Its head. */
        uint8_t texels[3]; /**< Its texel. */
    } block = {.texture = {.width = 1, .height = 1}};
    *(bool *)call->report = true;
    *size = sizeof block.texture + sizeof block.texels;
    return &block;
}

const void *fuzz_reply(const WorkerCall *call, size_t *size) {
    static uint8_t *bytes;
    memset(call->report, 0, call->report_capacity);
    if (strcmp(call->task, SCRIPT_SCENE_TASK) != 0) {
        bool is_mesh = strcmp(call->task, MESH_WORKER_TASK) == 0;
        return (is_mesh ? reply_mesh : reply_texture)(call, size);
    }
    bytes = bytes ? bytes : malloc(good_size);
    memcpy(bytes, good, good_size);
    while (input.size > 0) {
        uint16_t place;
        uint64_t value;
        uint8_t kind = fuzz_take_byte(&input);
        fuzz_take(&input, &place, sizeof place);
        fuzz_take(&input, &value, sizeof value);
        size_t start = (size_t)place * 4 % good_size;
        // A small number, an address in the block, or any bits.
        value = kind < 96 ? kind : kind < 160 ? (uintptr_t)ADDRESS + value % good_size : value;
        memcpy(bytes + start, &value, good_size - start < 8 ? good_size - start : 8);
    }
    *size = good_size;
    return bytes;
}

// --- what the program reads ----------------------------------------------------------------------

/** Sums of what is read, so that nothing is left out. */
static volatile unsigned sum;

/** Reads bytes. */
static void read_bytes(const void *bytes, size_t size) {
    for (size_t i = 0; i < size; i++) {
        sum += ((const uint8_t *)bytes)[i];
    }
}

/** Reads the parameters of a shape. */
static void read_shape(const Scene *scene, const SceneShape *shape) {
    const Keyword *keyword = scene_shape_keywords[shape->class_index];
    read_bytes(&scene->materials[shape->material_index], sizeof *scene->materials);
    read_bytes(shape->transform, shape->transform ? sizeof *shape->transform : 0);
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        const char *value = (const char *)shape->parameters + row->offset;
        if (row->type == PARAMETER_SDF) {
            const Sdf *field;
            memcpy(&field, value, sizeof field);
            read_bytes(field, sizeof *field);
            FUZZ_REQUIRE(sdf_check(field));
        } else if (row->type == PARAMETER_MESH) {
            size_t index;
            memcpy(&index, value, sizeof index);
            FUZZ_REQUIRE(scene->meshes[index].mesh->triangle_count >= 1);
        } else {
            read_bytes(value, sizeof(double));
        }
    }
}

/** @return Whether there is such a kind of light. */
static bool is_light_class(size_t index) {
    size_t count = 0;
    while (scene_light_classes[count]) {
        count++;
    }
    return index < count;
}

/** Reads all of an accepted scene. */
static void read_scene(const Scene *scene) {
    FUZZ_REQUIRE(scene->has_camera && scene->material_count >= 1);
    for (size_t i = 0; i < scene->material_count; i++) {
        FUZZ_REQUIRE(scene->materials[i].texture_id <= scene->texture_count);
    }
    FUZZ_REQUIRE(scene->sky.texture_id <= scene->texture_count);
    for (size_t i = 0; i < scene->shape_count; i++) {
        read_shape(scene, &scene->shapes[i]);
    }
    for (size_t i = 0; i < scene->note_count; i++) {
        read_bytes(scene->notes[i], strlen(scene->notes[i]));
    }
    read_bytes(scene->lights, scene->light_count * sizeof *scene->lights);
    for (size_t i = 0; i < scene->light_count; i++) {
        FUZZ_REQUIRE(is_light_class(scene->lights[i].class_index));
    }
    sum += scene_has_reflection(scene) + scene_has_textures(scene);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Error error = {0};
    if (!good) {
        make_good();
    }
    input = (FuzzInput){data, size};
    const ScriptRequest request = {.path = FILE_OF_PROJECT,
                                   .time_limit = SCRIPT_TIME_LIMIT,
                                   .memory_limit = SCRIPT_MEMORY_LIMIT};
    Scene *scene = script_load(&request, &error);
    if (scene) {
        read_scene(scene);
    } else {
        fuzz_check_error(&error);
        FUZZ_REQUIRE(error.status <= STATUS_SCENE || error.status == STATUS_INTERRUPTED);
    }
    scene_destroy(scene);
    return 0;
}
