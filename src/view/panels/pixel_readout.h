/**
 * @file
 * @brief What the pixel under the mouse shows: its place, its colour, its number in the layer.
 */
#ifndef DIOPTRE_VIEW_PANELS_PIXEL_READOUT_H
#define DIOPTRE_VIEW_PANELS_PIXEL_READOUT_H

#include "view/gui/gui.h"
#include "view/window/viewport.h"

/**
 * Shows the readout.
 * @param viewport  The picture.
 * @param right     Position of the mouse, fraction of the picture's width.
 * @param down      Fraction of its height.
 * @param corner    Lower left corner of the window's free part, screen units.
 */
void pixel_readout_show(const Viewport *viewport, double right, double down, GuiPoint corner);

#endif
