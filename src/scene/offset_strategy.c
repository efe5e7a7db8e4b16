/**
 * @file
 * @brief Names of the offset strategies.
 */
#include "dioptre/scene.h"

const char *const offset_strategy_names[] = {
    [OFFSET_NONE] = "none", [OFFSET_FIXED] = "fixed", [OFFSET_BOUND] = "bound", NULL};
