/**
 * @file
 * @brief Fuzz target: scene files in Lua. What is accepted is a scene within its block.
 */
#include "shared/script_target.h"

/** Checks that a scene keeps within its block. */
static void check_size(const Scene *scene) {
    FUZZ_REQUIRE(scene_block_size(scene) <= SCENE_MEMORY_SIZE);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fuzz_run_scene(data, size, &scene_dialect, script_run_execute, check_size);
    return 0;
}
