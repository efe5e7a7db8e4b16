/**
 * @file
 * @brief Fuzz target: OBJ texts. What is read becomes a valid mesh.
 */
#include "fuzz.h"

#include "assets/meshes/mesh_builder.h"
#include "assets/meshes/obj_reader.h"

/** Ignores progress, but its range. See #MeshSink.report_progress. */
static void check_progress(void *context, double fraction) {
    (void)context;
    FUZZ_REQUIRE(fraction >= 0 && fraction <= 1);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    MeshBuilder builder;
    Error error = {0};
    Mesh counts;
    mesh_builder_init(&builder, &error);
    const MeshSink sink = {
        .context = &builder, .add_triangle = mesh_builder_add, .report_progress = check_progress};
    bool is_read = obj_read((const char *)data, size, &sink, &builder.repairs, &error);
    if (is_read && mesh_builder_finish(&builder, &counts)) {
        Error invalid = {0};
        Mesh *mesh = mesh_create(&counts, &invalid);
        FUZZ_REQUIRE(mesh);
        mesh_builder_copy(&builder, mesh);
        FUZZ_REQUIRE(mesh_validate(mesh, &invalid));
        mesh_release(mesh);
    } else {
        FUZZ_REQUIRE(error.status == STATUS_SCENE && error.message[0]);
    }
    mesh_builder_deinit(&builder);
    return 0;
}
