/**
 * @file
 * @brief The camera's rays.
 */
#include "trace/tracer/camera.h"

#include "trace/math/sobol.h"

/**
 * Places in a pixel are multiples of this share of it: then a ray's place in the picture is a whole
 * number that every engine, float too, holds exactly, and all engines ask about the same points.
 */
#define SUBPIXELS 256

/**
 * Which of Sobol's scrambled sequences the samples of a pixel follow: of 1500, the one whose mean
 * is nearest the truth over edges of all directions, with 4, 8, 16 and 64 samples (doc/tour.md,
 * "Samples").
 */
#define SAMPLE_SEED 1293

/** Half of 2^32: sample 0 is the centre of the pixel. */
#define SAMPLE_CENTER 0x80000000u

Camera camera_of(const SceneCamera *camera, int width, int height) {
    double half_pixel = tan(camera->fov / 2 * (M_PI / 180)) / width;
    return (Camera){.origin = vec3_of(camera->position),
                    .forward = vec3_of(camera->direction),
                    .right = vec3_of(vec3d_scale(scene_camera_right(camera), half_pixel)),
                    .up = vec3_of(vec3d_scale(camera->up, half_pixel)),
                    .width = width,
                    .height = height};
}

/**
 * @return Where the share of a tent of 2 pixels lies left of which there is a given share of it, in
 *         1 / #SUBPIXELS from the pixel's left edge. So each sample counts alike, and their mean is
 *         the picture seen through the tent (Ernst, Stamminger, Greiner, *Filter Importance
 * Sampling*, 2006).
 * @param cumulative  The share, of 2^32.
 */
static int tent_sample(uint32_t cumulative) {
    double left = cumulative * 0x1p-31, right = 2 - left;
    double offset = left < 1 ? sqrt(left) - 1 : 1 - sqrt(right);
    return (int)floor((offset + 0.5) * SUBPIXELS + 0.5);
}

PixelJitter pixel_jitter_of(int sample) {
    if (sample == 0) {
        return (PixelJitter){SUBPIXELS / 2, SUBPIXELS / 2};
    }
    // Exclusive or with the first point, which keeps the points as even as they are.
    SobolPoint first = sobol_point(0, SAMPLE_SEED);
    SobolPoint point = sobol_point((uint32_t)sample, SAMPLE_SEED);
    return (PixelJitter){tent_sample(point.x ^ first.x ^ SAMPLE_CENTER),
                         tent_sample(point.y ^ first.y ^ SAMPLE_CENTER)};
}

/**
 * @return LANES rays, from the columns of one row on.
 * @param x  Twice the distance from the picture's middle, pixels, to the right.
 * @param y  Twice the distance from the picture's middle, pixels, up.
 */
INLINE Ray camera_ray(const Camera *camera, real x, real y) {
    Vec3 offset = vec3_add(vec3_scale(camera->right, x), vec3_scale(camera->up, y));
    return ray_of(camera->origin, vec3_normalize(vec3_add(offset, camera->forward)));
}

/**
 * @return Twice a ray's distance from the picture's middle along one axis, in 1 / #SUBPIXELS: a
 * whole number, the same with the sign turned on the other side of the middle, and exact in float
 *         up to 16384 pixels.
 * @param pixel  The pixel's place along the axis.
 * @param jitter  The ray's in the pixel.
 * @param size   Pixels of the picture along the axis.
 */
static int doubled_offset_from_center(int pixel, int jitter, int size) {
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

void camera_generate_rays(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                          int column, int row, Packet *packet) {
    const scalar scale = (scalar)1 / SUBPIXELS;
    real lane_index = lane_indices();
    packet->wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        int c = column + v * LANES % PACKET_COLUMNS, r = row + v * LANES / PACKET_COLUMNS;
        int pixel_x = grid->x + c * grid->stride, pixel_y = grid->y + r * grid->stride;
        int twice_x = doubled_offset_from_center(pixel_x, jitter.x, camera->width);
        int twice_y = doubled_offset_from_center(pixel_y, jitter.y, camera->height);
        real x = real_of((scalar)twice_x) + lane_index * (scalar)(2 * SUBPIXELS * grid->stride);
        packet->rays[v] = camera_ray(camera, x * scale, real_of((scalar)-twice_y * scale));
        packet->active[v] =
            (lane_index < real_of((scalar)(grid->columns - c))) & mask_of(r < grid->rows);
        packet->limit[v] = real_of(INFINITE);
    }
}

void camera_generate_selected_rays(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                                   size_t first, Packet *packet) {
    const scalar scale = (scalar)1 / SUBPIXELS;
    size_t last = grid->selected_count - 1;
    packet->wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real x = {0}, y = {0};
        size_t start = first + (size_t)v * LANES;
        for (int i = 0; i < LANES; i++) {
            size_t at = start + (size_t)i;
            int pixel = grid->selected[at < last ? at : last];
            int pixel_x = grid->x + pixel % grid->columns,
                pixel_y = grid->y + pixel / grid->columns;
            real_set_lane(&x, i,
                          (scalar)doubled_offset_from_center(pixel_x, jitter.x, camera->width));
            real_set_lane(&y, i,
                          (scalar)-doubled_offset_from_center(pixel_y, jitter.y, camera->height));
            mask_set_lane(&packet->active[v], i, at <= last);
        }
        packet->rays[v] = camera_ray(camera, x * scale, y * scale);
        packet->limit[v] = real_of(INFINITE);
    }
}
