/**
 * @file
 * @brief What the offset strategies are called.
 */
#include "dioptre/offset_strategy.h"

const char *const offset_strategy_names[] = {
    [OFFSET_NONE] = "none", [OFFSET_FIXED] = "fixed", [OFFSET_BOUND] = "bound", NULL};
