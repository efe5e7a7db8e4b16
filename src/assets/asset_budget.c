/**
 * @file
 * @brief What all meshes and pictures of a scene may take together.
 */
#include "assets/asset_budget.h"

void asset_budget_init(AssetBudget *budget) {
    *budget = (AssetBudget){.memory = ASSET_MEMORY_LIMIT,
                            .file_bytes = ASSET_FILE_LIMIT,
                            .seconds = ASSET_TIME_LIMIT,
                            .count = ASSET_COUNT_LIMIT};
}

bool asset_budget_take_file(AssetBudget *budget, Error *error) {
    if (budget->count == 0) {
        return error_set(error, STATUS_SCENE, "a scene may name at most %d models and pictures",
                         ASSET_COUNT_LIMIT);
    }
    budget->count--;
    return true;
}

bool asset_budget_take_file_bytes(AssetBudget *budget, size_t size, Error *error) {
    if (size > budget->file_bytes) {
        return error_set(error, STATUS_SCENE,
                         "the scene's models and pictures are files of more than %zu MiB together",
                         ASSET_FILE_LIMIT >> 20);
    }
    budget->file_bytes -= size;
    return true;
}

bool asset_budget_take_memory(AssetBudget *budget, size_t size, Error *error) {
    if (size > budget->memory) {
        return asset_budget_set_memory_error(error);
    }
    budget->memory -= size;
    return true;
}

void asset_budget_take_seconds(AssetBudget *budget, double seconds) {
    budget->seconds -= seconds;
}

bool asset_budget_set_memory_error(Error *error) {
    return error_set(error, STATUS_SCENE,
                     "the scene's models and pictures take more than %zu MiB of memory together",
                     ASSET_MEMORY_LIMIT >> 20);
}

bool asset_budget_set_time_error(Error *error) {
    return error_set(error, STATUS_SCENE,
                     "the scene's models and pictures take more than %g s of processor time "
                     "together",
                     ASSET_TIME_LIMIT);
}
