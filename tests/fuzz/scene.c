/**
 * @file
 * @brief Fuzz target: scene files in Lua. What is accepted is a scene within its block.
 */
#include "shared/script_target.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Error error = {0};
    FuzzRun run;
    Scene *scene = scene_create(&error);
    FUZZ_REQUIRE(scene);
    if (fuzz_run_init(&run, data, size)) {
        run.run.dialect = &scene_dialect;
        run.run.scene = scene;
        if (fuzz_run_execute(&run, script_run_execute)) {
            FUZZ_REQUIRE(scene->has_camera && scene->material_count >= 1);
            FUZZ_REQUIRE(scene_block_size(scene) <= SCENE_MEMORY_SIZE);
        }
    }
    fuzz_run_deinit(&run);
    scene_destroy(scene);
    return 0;
}
