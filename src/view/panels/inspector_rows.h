/**
 * @file
 * @brief The numbers of the rays of one pixel, row by row.
 */
#ifndef DIOPTRE_VIEW_PANELS_INSPECTOR_ROWS_H
#define DIOPTRE_VIEW_PANELS_INSPECTOR_ROWS_H

#include "view/panels/inspector.h"

/** Writes the rows of the panel: the rays, those of the chosen one in full, and the pixel.
 *  @param[in,out] inspector The inspector, with its rays; gets the rows. */
void inspector_rows_write(Inspector *inspector, const InspectorInput *input, int x, int y);

#endif
