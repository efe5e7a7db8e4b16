/**
 * @file
 * @brief What the pixel under the mouse shows: its place, what is there, its colour, its number.
 */
#ifndef DIOPTRE_VIEW_PANELS_PIXEL_READOUT_H
#define DIOPTRE_VIEW_PANELS_PIXEL_READOUT_H

#include "dioptre/renderer.h"
#include "dioptre/scene.h"

#include <stddef.h>

/** Bytes of the readout with the final zero. */
enum { READOUT_SIZE = 512 };
/** Most pictures that a readout compares. */
enum { READOUT_PICTURES = 2 };

/** One pixel of one picture, or of two. */
typedef struct PixelReadout {
    const Scene *scene;                      /**< The scene; NULL: shapes have no name. */
    int x;                                   /**< The pixel's column. */
    int y;                                   /**< Its row. */
    bool is_magnified;                       /**< Whether it is that of the magnifier, and not the
                                                  one under the mouse. */
    PixelReading readings[READOUT_PICTURES]; /**< What it shows: in the left picture first. */
    size_t count;                            /**< Number of pictures. */
    int samples;                             /**< Most samples that the colour of one picture is
                                                  the mean of: where the first ones agree, it is
                                                  that of fewer. */
} PixelReadout;

/** Writes the value of one picture alone. @param picture Its index. */
void pixel_readout_value(const PixelReadout *readout, size_t picture, char text[READOUT_SIZE]);

/** Writes the difference of two pictures alone. */
void pixel_readout_difference(const PixelReading readings[READOUT_PICTURES],
                              char text[READOUT_SIZE]);

/** Writes a readout, in one line for each picture and one for their difference. */
void pixel_readout_write(const PixelReadout *readout, char text[READOUT_SIZE]);

#endif
