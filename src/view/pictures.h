/**
 * @file
 * @brief What keys do to the pictures: layers, settings, two of them side by side.
 */
#ifndef DIOPTRE_VIEW_PICTURES_H
#define DIOPTRE_VIEW_PICTURES_H

#include "view/state.h"

/** Does what is asked of the pictures. @param[in,out] view The view. @param action What; others are
 *  passed over. */
void pictures_act(View *view, Action action);

#endif
