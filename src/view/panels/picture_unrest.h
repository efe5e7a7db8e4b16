/**
 * @file
 * @brief How much a part of a picture says: where a caption hides least.
 */
#ifndef DIOPTRE_VIEW_PANELS_PICTURE_UNREST_H
#define DIOPTRE_VIEW_PANELS_PICTURE_UNREST_H

#include "view/window/viewport.h"

/** A part of a picture, fractions of its width and height; what lies outside counts as black. */
typedef struct PicturePart {
    double left;   /**< Left end. */
    double top;    /**< Upper end. */
    double right;  /**< Right end. */
    double bottom; /**< Lower end. */
} PicturePart;

/** @return The variance of brightness in a part of the picture on screen, of a few hundred pixels;
 *          0 before the first pass. */
double picture_unrest(const Viewport *viewport, const PicturePart *part);

#endif
