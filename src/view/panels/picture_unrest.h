/**
 * @file
 * @brief How much a part of a picture says: where a caption hides least.
 */
#ifndef DIOPTRE_VIEW_PANELS_PICTURE_UNREST_H
#define DIOPTRE_VIEW_PANELS_PICTURE_UNREST_H

#include "view/window/viewport.h"

/**
 * @return The variance of brightness in a strip of the picture on screen, of a few hundred pixels;
 *         0 before the first pass.
 * @param top     Upper end, fraction of the picture's height.
 * @param bottom  Lower end.
 */
double picture_unrest(const Viewport *viewport, double top, double bottom);

#endif
