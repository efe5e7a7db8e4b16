/**
 * @file
 * @brief Fuzz target: the mesh that a worker hands over.
 */
#include "shared/handover.h"

#include "assets/meshes/mesh_file.h"

#include <fcntl.h>

/** Any mesh file; it is opened, but nobody reads it. */
static const char FILE_OF_PROJECT[] = "tests/meshes/hand-negative.obj";
/** Most items of an array that is made up for a head that fits its block. */
enum { ITEMS_LIMIT = 16 };

/** The input of the run. */
static FuzzInput input;
/** The block that is handed over. */
static union {
    Mesh mesh;                               /**< Its head. */
    uint8_t bytes[sizeof(Mesh) + (1 << 14)]; /**< All bytes. */
} block;

/** Makes a valid mesh of sizes from the input. @return Bytes of the block. */
static size_t make_valid(void) {
    Mesh *mesh = &block.mesh;
    mesh->position_count = 3 + fuzz_take_byte(&input) % ITEMS_LIMIT;
    mesh->normal_count = fuzz_take_byte(&input) % ITEMS_LIMIT;
    mesh->uv_count = fuzz_take_byte(&input) % ITEMS_LIMIT;
    mesh->triangle_count = 1 + fuzz_take_byte(&input) % ITEMS_LIMIT;
    mesh_bind_arrays(mesh);
    for (size_t i = 0; i < mesh->normal_count; i++) {
        mesh->normals[i] = (Vec3d){0, 1, 0};
    }
    return mesh_block_size(mesh);
}

/** Overwrites eight bytes of the block per nine bytes of the input: a place and a value. */
static void scribble(size_t size) {
    while (input.size > 0) {
        uint16_t place;
        uint64_t value;
        fuzz_take(&input, &place, sizeof place);
        fuzz_take(&input, &value, sizeof value);
        size_t start = (size_t)place * 4 % size;
        memcpy(block.bytes + start, &value, size - start < 8 ? size - start : 8);
    }
}

const void *fuzz_reply(const WorkerCall *call, size_t *size) {
    memset(call->report, 0, call->report_capacity);
    memset(&block, 0, sizeof block);
    uint8_t kind = fuzz_take_byte(&input);
    fuzz_take(&input, call->report, kind & 1 ? 1 : call->report_capacity);
    if (kind & 2) {
        *size = make_valid();
    } else {
        *size = input.size < sizeof block ? input.size : sizeof block;
        fuzz_take(&input, block.bytes, *size);
    }
    if (*size > 0) {
        scribble(*size);
    }
    return kind & 128 ? NULL : block.bytes;
}

/** Reads all of an accepted mesh. */
static void check_mesh(const Mesh *mesh) {
    Error error = {0};
    Vec3d *normals = calloc(mesh->position_count, sizeof *normals);
    FUZZ_REQUIRE(normals && mesh_validate(mesh, &error));
    mesh_smooth_normals(mesh, normals);
    for (size_t i = 0; i < mesh->position_count; i++) {
        const double *p = &mesh->positions[i].x, *low = &mesh->bounds.low.x,
                     *high = &mesh->bounds.high.x;
        for (int axis = 0; axis < 3; axis++) {
            FUZZ_REQUIRE(p[axis] >= low[axis] && p[axis] <= high[axis]);
        }
    }
    free(normals);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static AssetFile file;
    AssetBudget budget;
    Mesh *mesh = NULL;
    Error error = {0};
    input = (FuzzInput){data, size};
    if (!file.path) {
        file = (AssetFile){FILE_OF_PROJECT, open(FILE_OF_PROJECT, O_RDONLY | O_CLOEXEC), {0}};
        FUZZ_REQUIRE(fstat(file.descriptor, &file.info) == 0);
    }
    asset_budget_init(&budget);
    if (mesh_file_read(&file, &budget, NULL, &mesh, &error)) {
        check_mesh(mesh);
    } else {
        FUZZ_REQUIRE(!mesh && error.status != STATUS_OK);
        FUZZ_REQUIRE(error.status <= STATUS_SCENE || error.status == STATUS_INTERRUPTED);
        FUZZ_REQUIRE(memchr(error.message, '\0', sizeof error.message));
    }
    mesh_release(mesh);
    return 0;
}
