/**
 * @file
 * @brief Fuzz target: scenes in NFF.
 */
#include "shared/script_target.h"

#include "script/nff.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Error error = {0};
    FuzzRun run;
    Scene *scene = scene_create(&error);
    FUZZ_REQUIRE(scene);
    if (fuzz_run_init(&run, data, size)) {
        run.run.scene = scene;
        if (fuzz_run_execute(&run, nff_execute)) {
            FUZZ_REQUIRE(scene->has_camera && scene->material_count >= 1);
            for (size_t i = 0; i < scene->mesh_count; i++) {
                FUZZ_REQUIRE(mesh_validate(scene->meshes[i].built, &error));
            }
        }
    }
    fuzz_run_deinit(&run);
    scene_destroy(scene);
    return 0;
}
