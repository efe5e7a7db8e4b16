/**
 * @file
 * @brief What actions do to the view, whoever asks: a key, or a lesson.
 */
#ifndef DIOPTRE_VIEW_DEEDS_H
#define DIOPTRE_VIEW_DEEDS_H

#include "view/action.h"
#include "view/state.h"

/**
 * Does what an action asks for.
 * @param[in,out] view  The view.
 * @param action        What it asks for, not a move.
 */
void deeds_do(View *view, Action action);

#endif
