/**
 * @file
 * @brief Names of the offset strategies.
 */
#include "dioptre/offset_strategy.h"

const char *const offset_strategy_names[] = {
    [OFFSET_NONE] = "none", [OFFSET_FIXED] = "fixed", [OFFSET_BOUND] = "bound", NULL};
