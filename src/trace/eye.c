/**
 * @file
 * @brief The camera's rays.
 */
#include "trace/eye.h"

/**
 * Places in a pixel are multiples of this share of it: then a ray's place in the picture is a whole
 * number that every engine, float too, holds exactly, and all engines ask about the same points.
 */
#define SUBPIXELS 256

/**
 * Steps of the additive recurrence that spreads the samples over a pixel: 1 / p and 1 / p^2 of the
 * plastic number p = 1.3247..., as shares of 2^32 (M. Roberts, *The Unreasonable Effectiveness of
 * Quasirandom Sequences*, 2018). In integers: the same on every machine.
 */
#define SAMPLE_STEP_X 0xC13FA9A9u
/** See #SAMPLE_STEP_X. */
#define SAMPLE_STEP_Y 0x91E10DA5u
/** Half of 2^32: sample 0 is the centre of the pixel. */
#define SAMPLE_CENTER 0x80000000u

Eye eye_of(const Camera *camera, int width, int height) {
    double half_pixel = tan(camera->fov / 2 * (M_PI / 180)) / width;
    return (Eye){.origin = vector_of(camera->position),
                 .forward = vector_of(camera->direction),
                 .right = vector_of(vector3_scale(camera_right(camera), half_pixel)),
                 .up = vector_of(vector3_scale(camera->up, half_pixel)),
                 .width = width,
                 .height = height};
}

/**
 * @return A sample's place in its pixel, in 1 / #SUBPIXELS, 0 to #SUBPIXELS - 1.
 * @param sample  Which sample.
 * @param step    Step of the sequence along this axis.
 */
static int sample_place(int sample, uint32_t step) {
    return (int)((SAMPLE_CENTER + (uint32_t)sample * step) / (UINT32_MAX / SUBPIXELS + 1));
}

/**
 * @return LANES rays, from the columns of one row on.
 * @param eye   The eye.
 * @param x     Twice the distance from the picture's middle, pixels, to the right.
 * @param y     Twice the distance from the picture's middle, pixels, up.
 */
INLINE Ray eye_ray(const Eye *eye, real x, real y) {
    Vector across = vector_add(vector_scale(eye->right, x), vector_scale(eye->up, y));
    return ray_of(eye->origin, vector_normalize(vector_add(across, eye->forward)));
}

/** @return 0, 1, 2, ... in the lanes. */
INLINE real lane_numbers(void) {
    real numbers = {0};
    for (int i = 0; i < LANES; i++) {
        real_set_lane(&numbers, i, (scalar)i);
    }
    return numbers;
}

void eye_aim(const Eye *eye, const PixelGrid *grid, int column, int row, Packet *packet) {
    const scalar share = (scalar)1 / SUBPIXELS;
    int place_x = sample_place(grid->sample, SAMPLE_STEP_X);
    int place_y = sample_place(grid->sample, SAMPLE_STEP_Y);
    real lanes = lane_numbers();
    packet->wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        int c = column + v * LANES % PACKET_COLUMNS, r = row + v * LANES / PACKET_COLUMNS;
        int pixel_x = grid->x + c * grid->stride, pixel_y = grid->y + r * grid->stride;
        // Twice the place less the size, in 1 / SUBPIXELS: whole numbers, the same with the sign
        // turned on the other side of the middle, and exact in float up to 16384 pixels.
        int twice_x = 2 * (pixel_x * SUBPIXELS + place_x) - eye->width * SUBPIXELS;
        int twice_y = 2 * (pixel_y * SUBPIXELS + place_y) - eye->height * SUBPIXELS;
        real x = real_of((scalar)twice_x) + lanes * (scalar)(2 * SUBPIXELS * grid->stride);
        packet->rays[v] = eye_ray(eye, x * share, real_of((scalar)-twice_y * share));
        packet->active[v] =
            (lanes < real_of((scalar)(grid->columns - c))) & mask_of(r < grid->rows);
        packet->limit[v] = real_of(INFINITE);
    }
}
