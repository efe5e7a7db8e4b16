/**
 * @file
 * @brief The eye: the camera's rays.
 */
#ifndef DIOPTRE_TRACE_EYE_H
#define DIOPTRE_TRACE_EYE_H

#include "trace/packet.h"

/** What it takes to make a camera ray of a pixel. */
typedef struct Eye {
    Vector origin;  /**< Where the eye is. */
    Vector forward; /**< Ahead, one long. */
    Vector right;   /**< To the right, half a pixel long at distance 1. */
    Vector up;      /**< Up, half a pixel long at distance 1. */
    int width;      /**< Pixels of the picture. */
    int height;     /**< Pixels of the picture. */
} Eye;

/** A sample's place, in 1 / 256 pixels from the left and the top of its pixel; perhaps beyond it.
 */
typedef struct SamplePlace {
    int x; /**< To the right. */
    int y; /**< Down. */
} SamplePlace;

/** @return Where a sample of every pixel lies; that of sample 0 is the centre. @param sample Which.
 */
SamplePlace eye_sample(int sample);

/**
 * @return The eye of a camera (rows A1, B2): pixels are square, the height follows from the
 *         horizontal field of view.
 * @param camera  The camera.
 * @param width   Pixels of the picture.
 * @param height  Pixels of the picture.
 */
Eye eye_of(const Camera *camera, int width, int height);

/**
 * Makes the rays of #PACKET_COLUMNS by #PACKET_ROWS points of a grid of pixels.
 * @param eye     The eye.
 * @param grid    The grid.
 * @param place   Where in their pixels they go.
 * @param column  First column of the grid.
 * @param row     First row of the grid.
 * @param[out] packet  The rays, without lineage; those beyond the grid are not active.
 */
void eye_aim(const Eye *eye, const PixelGrid *grid, SamplePlace place, int column, int row,
             Packet *packet);

/**
 * Makes the rays of #PACKET_RAYS chosen pixels.
 * @param eye     The eye.
 * @param grid    The grid, of stride 1, with chosen pixels.
 * @param place   Where in their pixels they go.
 * @param first   Which of the chosen is the first.
 * @param[out] packet  The rays, without lineage; those beyond the chosen are not active.
 */
void eye_aim_chosen(const Eye *eye, const PixelGrid *grid, SamplePlace place, size_t first,
                    Packet *packet);

#endif
