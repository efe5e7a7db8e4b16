/**
 * @file
 * @brief Names of the offset strategies, for the command line, lessons and the window.
 */
#ifndef DIOPTRE_OFFSET_STRATEGY_H
#define DIOPTRE_OFFSET_STRATEGY_H

#include "dioptre/engine.h"

/** The names, in the order of #OffsetStrategy; ended by NULL. */
extern const char *const offset_strategy_names[];

#endif
