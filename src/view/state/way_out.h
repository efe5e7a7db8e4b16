/**
 * @file
 * @brief Whether the user can end the program from within.
 */
#ifndef DIOPTRE_VIEW_STATE_WAY_OUT_H
#define DIOPTRE_VIEW_STATE_WAY_OUT_H

#include <stdbool.h>

/** @return Whether there is a command that ends the program. In a page there is none: what was left
 *  would be a page that does nothing, and its tab is closed by the browser. */
bool way_out_exists(void);

#endif
