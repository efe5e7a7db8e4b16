/**
 * @file
 * @brief What the offset strategies are called: on the command line, in lessons, in the window.
 */
#ifndef DIOPTRE_OFFSET_STRATEGY_H
#define DIOPTRE_OFFSET_STRATEGY_H

#include "dioptre/engine.h"

/** The strategies' names, in the order of #OffsetStrategy; ended by NULL. */
extern const char *const offset_strategy_names[];

#endif
