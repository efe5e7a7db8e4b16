/**
 * @file
 * @brief The camera: ray generation.
 */
#ifndef DIOPTRE_TRACE_TRACER_CAMERA_H
#define DIOPTRE_TRACE_TRACER_CAMERA_H

#include "trace/tracer/packet.h"

/** The camera of an image in the engine's number type. */
typedef struct Camera {
    Vec3 origin;  /**< The camera position. */
    Vec3 forward; /**< Viewing direction, a unit vector. */
    Vec3 right;   /**< To the right, half a pixel long at distance 1. */
    Vec3 up;      /**< Up, half a pixel long at distance 1. */
    int width;    /**< Pixels of the image. */
    int height;   /**< Pixels of the image. */
    int shift;    /**< By how much rays go to the left and up, in 1 / 256 pixels; 0: not at all. */
} Camera;

/** Positions in a pixel are multiples of 1 / SUBPIXELS. So a position in the image is a whole
 * number of them, which every engine, float too, represents exactly: all engines trace the same
 * rays. */
#define SUBPIXELS 256

/** The position of a sample in its pixel, in 1 / 256 pixels from the left and the top. The filter
 *  is wider than a pixel, so it may lie outside. */
typedef struct PixelJitter {
    int x; /**< To the right. */
    int y; /**< Down. */
} PixelJitter;

/** @return The position of a sample, the same in all pixels; sample 0 is the centre. */
PixelJitter pixel_jitter_of(int sample);

/**
 * @return The camera of an image. Pixels are square: the height follows from the horizontal field
 *         of view.
 * @param width  Pixels of the image.
 * @param height  Pixels of the image.
 * @param point  Where in its pixel a ray goes.
 */
Camera camera_of(const SceneCamera *camera, int width, int height, PixelPoint point);

/* A grid is divided into packets: of PACKET_COLUMNS by PACKET_ROWS pixels, row by row; or, if
   pixels are selected, of PACKET_RAYS of those in their order. */

/** @return The number of rays of a grid. */
static inline size_t grid_ray_count(const PixelGrid *grid) {
    return grid->selected ? grid->selected_count : (size_t)grid->columns * (size_t)grid->rows;
}

/** @return The number of packets along the rows of a grid. */
static inline int grid_packet_columns(const PixelGrid *grid) {
    return (grid->columns + PACKET_COLUMNS - 1) / PACKET_COLUMNS;
}

/** @return The number of packets of a grid. */
static inline int grid_packet_count(const PixelGrid *grid) {
    return grid->selected
               ? (int)((grid->selected_count + PACKET_RAYS - 1) / PACKET_RAYS)
               : grid_packet_columns(grid) * ((grid->rows + PACKET_ROWS - 1) / PACKET_ROWS);
}

/** The position of a pixel in a grid. */
typedef struct GridPosition {
    int column; /**< From the left. */
    int row;    /**< From the top. */
} GridPosition;

/** @return The first pixel of a packet. @param index Its index; no pixels are selected. */
static inline GridPosition grid_packet_position(const PixelGrid *grid, int index) {
    int across = grid_packet_columns(grid);
    return (GridPosition){index % across * PACKET_COLUMNS, index / across * PACKET_ROWS};
}

/** @return Whether all pixels of a packet lie in a grid. @param first Its first pixel. */
static inline bool grid_has_whole_packet(const PixelGrid *grid, GridPosition first) {
    return first.column + PACKET_COLUMNS <= grid->columns && first.row + PACKET_ROWS <= grid->rows;
}

/** @return The pixel of the first lane of a vector; it may lie beyond the grid. The other lanes
 *          follow in its row. @param first The first pixel of the packet. */
static inline GridPosition grid_vector_position(GridPosition first, int v) {
    return (GridPosition){first.column + v * LANES % PACKET_COLUMNS,
                          first.row + v * LANES / PACKET_COLUMNS};
}

/** @return The beam of all camera rays of a grid of which no pixels are selected. */
Beam camera_beam(const Camera *camera, const PixelGrid *grid, PixelJitter jitter);

/** @return The beam of a packet of such a grid. @param index Its index. */
Beam camera_packet_beam(const Camera *camera, const PixelGrid *grid, PixelJitter jitter, int index);

/** @return LANES camera rays. @param x Twice the distance from the centre of the image, pixels, to
 *  the right. @param y The same upwards. */
INLINE Ray camera_ray(const Camera *camera, real x, real y) {
    Vec3 offset = vec3_add(vec3_scale(camera->right, x), vec3_scale(camera->up, y));
    return ray_of(camera->origin, vec3_normalize(vec3_add(offset, camera->forward)));
}

/**
 * @return Twice a ray's distance from the centre of the image along one axis, in 1 / #SUBPIXELS: an
 *         integer, symmetric about the centre, and exact in float up to 16384 pixels.
 * @param pixel  Index of the pixel along the axis.
 * @param jitter  The ray's position in the pixel.
 * @param size  Pixels of the image along the axis.
 */
static inline int doubled_offset_from_center(int pixel, int jitter, int size) {
    return 2 * (pixel * SUBPIXELS + jitter) - size * SUBPIXELS;
}

/** @return 0, 1, 2, ... in the lanes. */
INLINE real lane_indices(void) {
    real numbers = {0};
    for (int i = 0; i < LANES; i++) {
        real_set_lane(&numbers, i, (scalar)i);
    }
    return numbers;
}

/** @return The position of samples, as rays go to the left and up. */
INLINE PixelJitter camera_shifted(const Camera *camera, PixelJitter jitter) {
    return (PixelJitter){jitter.x - camera->shift, jitter.y - camera->shift};
}

/** @return LANES camera rays of a row of a grid of which no pixels are selected. @param jitter From
 *  camera_shifted(). @param position Of the first of them. */
INLINE Ray camera_grid_ray(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                           GridPosition position) {
    const scalar scale = (scalar)1 / SUBPIXELS;
    int pixel_x = grid->x + position.column * grid->stride,
        pixel_y = grid->y + position.row * grid->stride;
    int twice_x = doubled_offset_from_center(pixel_x, jitter.x, camera->width);
    int twice_y = doubled_offset_from_center(pixel_y, jitter.y, camera->height);
    real x = real_of((scalar)twice_x) + lane_indices() * (scalar)(2 * SUBPIXELS * grid->stride);
    return camera_ray(camera, x * scale, real_of((scalar)-twice_y * scale));
}

/** Number of rays in a #CameraRun: longer runs gain nothing (measured). Engines of several lanes
 *  need none. */
enum { CAMERA_RUN_RAYS = LANES == 1 ? 16 : 1 };

/** Camera rays of neighbours in a row, which an engine of one lane generates together. The root and
 *  the four quotients of a ray take long, and those of the others are computed meanwhile. */
typedef struct CameraRun {
    int first;                 /**< Index of the first ray's packet. */
    int count;                 /**< Number of rays; 0: none yet. */
    Ray rays[CAMERA_RUN_RAYS]; /**< The rays. */
} CameraRun;

/**
 * Generates the camera rays of a packet.
 * @param jitter  Where in its pixel each ray goes.
 * @param index  Index of the packet, below grid_packet_count().
 * @param[in,out] run  Rays of this grid and jitter that were generated already, and those that are
 *         generated now; at first empty. NULL: rays are generated packet by packet.
 * @param[out] packet  The rays, without #Packet.context; inactive beyond the grid. They have a
 *         beam, unless pixels are selected.
 */
void camera_generate_rays(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                          int index, CameraRun *run, Packet *packet);

#endif
