/**
 * @file
 * @brief The eye: the camera's rays.
 */
#ifndef DIOPTRE_TRACE_TRACER_CAMERA_H
#define DIOPTRE_TRACE_TRACER_CAMERA_H

#include "trace/tracer/packet.h"

/** What it takes to make a camera ray of a pixel. */
typedef struct Camera {
    Vec3 origin;  /**< Where the eye is. */
    Vec3 forward; /**< Ahead, one long. */
    Vec3 right;   /**< To the right, half a pixel long at distance 1. */
    Vec3 up;      /**< Up, half a pixel long at distance 1. */
    int width;    /**< Pixels of the picture. */
    int height;   /**< Pixels of the picture. */
} Camera;

/** A sample's place, in 1 / 256 pixels from the left and the top of its pixel; perhaps beyond it.
 */
typedef struct PixelJitter {
    int x; /**< To the right. */
    int y; /**< Down. */
} PixelJitter;

/** @return Where a sample of every pixel lies; that of sample 0 is the centre. */
PixelJitter pixel_jitter_of(int sample);

/**
 * @return The eye of a camera (rows A1, B2): pixels are square, the height follows from the
 *         horizontal field of view.
 * @param width  Pixels of the picture.
 * @param height  Pixels of the picture.
 */
Camera camera_of(const SceneCamera *camera, int width, int height);

/**
 * Makes the rays of #PACKET_COLUMNS by #PACKET_ROWS points of a grid of pixels.
 * @param jitter  Where in their pixels they go.
 * @param column  First column of the grid.
 * @param row  First row of the grid.
 * @param[out] packet  The rays, without lineage; those beyond the grid are not active.
 */
void camera_generate_rays(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                          int column, int row, Packet *packet);

/**
 * Makes the rays of #PACKET_RAYS chosen pixels.
 * @param grid  The grid, of stride 1, with chosen pixels.
 * @param jitter  Where in their pixels they go.
 * @param first  Which of the chosen is the first.
 * @param[out] packet  The rays, without lineage; those beyond the chosen are not active.
 */
void camera_generate_selected_rays(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                                   size_t first, Packet *packet);

#endif
