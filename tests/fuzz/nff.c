/**
 * @file
 * @brief Fuzz target: scenes in NFF.
 */
#include "shared/script_target.h"

#include "script/nff.h"

/** Checks the meshes that a scene has made of patches. */
static void check_meshes(const Scene *scene) {
    Error error = {0};
    for (size_t i = 0; i < scene->mesh_count; i++) {
        FUZZ_REQUIRE(mesh_validate(scene->meshes[i].built, &error));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_run_scene(data, size, NULL, nff_execute, check_meshes);
    return 0;
}
