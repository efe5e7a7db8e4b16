/**
 * @file
 * @brief The camera's rays.
 */
#include "trace/eye.h"

#include "trace/sequence.h"

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
 * @return Where the share of a tent of 2 pixels lies left of which there is a given share of it, in
 *         1 / #SUBPIXELS from the pixel's left edge. So each sample counts alike, and their mean is
 *         the picture seen through the tent (Ernst, Stamminger, Greiner, *Filter Importance
 * Sampling*, 2006).
 * @param share  The share, of 2^32.
 */
static int tent_place(uint32_t share) {
    double left = share * 0x1p-31, right = 2 - left;
    double offset = left < 1 ? sqrt(left) - 1 : 1 - sqrt(right);
    return (int)floor((offset + 0.5) * SUBPIXELS + 0.5);
}

SamplePlace eye_sample(int sample) {
    if (sample == 0) {
        return (SamplePlace){SUBPIXELS / 2, SUBPIXELS / 2};
    }
    // Exclusive or with the first point, which keeps the points as even as they are.
    SequencePoint first = sequence_point(0, SAMPLE_SEED);
    SequencePoint point = sequence_point((uint32_t)sample, SAMPLE_SEED);
    return (SamplePlace){tent_place(point.x ^ first.x ^ SAMPLE_CENTER),
                         tent_place(point.y ^ first.y ^ SAMPLE_CENTER)};
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

/**
 * @return Twice a ray's distance from the picture's middle along one axis, in 1 / #SUBPIXELS: a
 * whole number, the same with the sign turned on the other side of the middle, and exact in float
 *         up to 16384 pixels.
 * @param pixel  The pixel's place along the axis.
 * @param place  The ray's in the pixel.
 * @param size   Pixels of the picture along the axis.
 */
static int twice_from_middle(int pixel, int place, int size) {
    return 2 * (pixel * SUBPIXELS + place) - size * SUBPIXELS;
}

/** @return 0, 1, 2, ... in the lanes. */
INLINE real lane_numbers(void) {
    real numbers = {0};
    for (int i = 0; i < LANES; i++) {
        real_set_lane(&numbers, i, (scalar)i);
    }
    return numbers;
}

void eye_aim(const Eye *eye, const PixelGrid *grid, SamplePlace place, int column, int row,
             Packet *packet) {
    const scalar share = (scalar)1 / SUBPIXELS;
    real lanes = lane_numbers();
    packet->wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        int c = column + v * LANES % PACKET_COLUMNS, r = row + v * LANES / PACKET_COLUMNS;
        int pixel_x = grid->x + c * grid->stride, pixel_y = grid->y + r * grid->stride;
        int twice_x = twice_from_middle(pixel_x, place.x, eye->width);
        int twice_y = twice_from_middle(pixel_y, place.y, eye->height);
        real x = real_of((scalar)twice_x) + lanes * (scalar)(2 * SUBPIXELS * grid->stride);
        packet->rays[v] = eye_ray(eye, x * share, real_of((scalar)-twice_y * share));
        packet->active[v] =
            (lanes < real_of((scalar)(grid->columns - c))) & mask_of(r < grid->rows);
        packet->limit[v] = real_of(INFINITE);
    }
}

void eye_aim_chosen(const Eye *eye, const PixelGrid *grid, SamplePlace place, size_t first,
                    Packet *packet) {
    const scalar share = (scalar)1 / SUBPIXELS;
    size_t last = grid->chosen_count - 1;
    packet->wants_points = true;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real x = {0}, y = {0};
        size_t start = first + (size_t)v * LANES;
        for (int i = 0; i < LANES; i++) {
            size_t at = start + (size_t)i;
            int pixel = grid->chosen[at < last ? at : last];
            int pixel_x = grid->x + pixel % grid->columns,
                pixel_y = grid->y + pixel / grid->columns;
            real_set_lane(&x, i, (scalar)twice_from_middle(pixel_x, place.x, eye->width));
            real_set_lane(&y, i, (scalar)-twice_from_middle(pixel_y, place.y, eye->height));
            mask_set_lane(&packet->active[v], i, at <= last);
        }
        packet->rays[v] = eye_ray(eye, x * share, y * share);
        packet->limit[v] = real_of(INFINITE);
    }
}
