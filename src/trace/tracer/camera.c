/**
 * @file
 * @brief Generation of camera rays.
 */
#include "trace/tracer/camera.h"

#include "trace/math/sobol.h"

/** The scrambling of Sobol's sequence that the samples of a pixel follow. Of 1500, its mean is the
 *  nearest to the exact one over edges of all directions, with 4, 8, 16 and 64 samples
 *  (doc/tour.md, "Samples"). */
#define SAMPLE_SEED 1293

/** Half of 2^32: sample 0 is the centre of the pixel. */
#define SAMPLE_CENTER 0x80000000u

Camera camera_of(const SceneCamera *camera, int width, int height, PixelPoint point) {
    double half_pixel = tan(camera->fov / 2 * (M_PI / 180)) / width;
    return (Camera){.origin = vec3_of(camera->position),
                    .forward = vec3_of(camera->direction),
                    .right = vec3_of(vec3d_scale(scene_camera_right(camera), half_pixel)),
                    .up = vec3_of(vec3d_scale(camera->up, half_pixel)),
                    .width = width,
                    .height = height,
                    .shift = point == PIXEL_CORNER ? SUBPIXELS / 2 : 0};
}

/**
 * @return A position distributed by a tent filter 2 pixels wide, in 1 / #SUBPIXELS from the pixel's
 *         left edge: the inverse of the filter's cumulative distribution. So all samples have equal
 *         weights (Ernst, Stamminger, Greiner, *Filter Importance Sampling*, 2006).
 * @param cumulative  The cumulative distribution at the position, in 2^-32.
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
    // The exclusive or with the first point moves that to the centre, and keeps the points evenly
    // distributed.
    SobolPoint first = sobol_point(0, SAMPLE_SEED);
    SobolPoint point = sobol_point((uint32_t)sample, SAMPLE_SEED);
    return (PixelJitter){tent_sample(point.x ^ first.x ^ SAMPLE_CENTER),
                         tent_sample(point.y ^ first.y ^ SAMPLE_CENTER)};
}

Beam camera_beam(const Camera *camera, const PixelGrid *grid, PixelJitter jitter) {
    const scalar scale = (scalar)1 / SUBPIXELS;
    int last_x = grid->x + (grid->columns - 1) * grid->stride,
        last_y = grid->y + (grid->rows - 1) * grid->stride;
    int left = doubled_offset_from_center(grid->x, jitter.x - camera->shift, camera->width),
        right = doubled_offset_from_center(last_x, jitter.x - camera->shift, camera->width),
        top = -doubled_offset_from_center(grid->y, jitter.y - camera->shift, camera->height),
        bottom = -doubled_offset_from_center(last_y, jitter.y - camera->shift, camera->height);
    scalar half = scale / 2;
    Vec3s x = vec3s_first_lane(camera->right), y = vec3s_first_lane(camera->up);
    Vec3s middle = vec3s_add(vec3s_scale(x, (scalar)(left + right) * half),
                             vec3s_scale(y, (scalar)(top + bottom) * half));
    return (Beam){.origin = vec3s_first_lane(camera->origin),
                  .axis = vec3s_add(middle, vec3s_first_lane(camera->forward)),
                  .across = vec3s_scale(x, (scalar)(right - left) * half),
                  .up = vec3s_scale(y, (scalar)(top - bottom) * half)};
}

/** Generates the rays of a packet of a whole grid. */
static void camera_generate_grid_rays(const Camera *camera, const PixelGrid *grid,
                                      PixelJitter jitter, int index, Packet *packet) {
    const GridPosition first = grid_packet_position(grid, index);
    const bool is_whole = grid_has_whole_packet(grid, first);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        GridPosition position = grid_vector_position(first, v);
        packet->rays[v] = camera_grid_ray(camera, grid, jitter, position);
        packet->active[v] = mask_of(true);
        if (!is_whole) {
            packet->active[v] =
                (lane_indices() < real_of((scalar)(grid->columns - position.column))) &
                mask_of(position.row < grid->rows);
        }
    }
}

/** Generates the rays of a run: as many as its row still has. @param index Index of the first one's
 *  packet. */
static void camera_run_generate(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                                int index, CameraRun *run) {
    GridPosition position = grid_packet_position(grid, index);
    const int left = grid->columns - position.column;
    run->first = index;
    run->count = left < CAMERA_RUN_RAYS ? left : CAMERA_RUN_RAYS;
    for (int i = 0; i < run->count; i++) {
        run->rays[i] = camera_grid_ray(camera, grid, jitter, position);
        position.column++;
    }
}

/** Takes the ray of a packet from a run, in engines of one lane. */
static void camera_take_ray(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                            int index, CameraRun *run, Packet *packet) {
    if (index - run->first >= run->count) {
        camera_run_generate(camera, grid, jitter, index, run);
    }
    packet->rays[0] = run->rays[index - run->first];
    packet->active[0] = mask_of(true);
}

/** Generates the rays of a packet of selected pixels. */
static void camera_generate_selected_rays(const Camera *camera, const PixelGrid *grid,
                                          PixelJitter jitter, int index, Packet *packet) {
    const scalar scale = (scalar)1 / SUBPIXELS;
    size_t first = (size_t)index * PACKET_RAYS, last = grid->selected_count - 1;
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real x = {0}, y = {0};
        for (int i = 0; i < LANES; i++) {
            size_t at = first + (size_t)(v * LANES + i);
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
    }
}

Beam camera_packet_beam(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                        int index) {
    GridPosition first = grid_packet_position(grid, index);
    PixelGrid part = *grid;
    part.x += first.column * grid->stride;
    part.y += first.row * grid->stride;
    part.columns = PACKET_COLUMNS;
    part.rows = PACKET_ROWS;
    return camera_beam(camera, &part, jitter);
}

void camera_generate_rays(const Camera *camera, const PixelGrid *grid, PixelJitter jitter,
                          int index, CameraRun *run, Packet *packet) {
    packet_init(packet, PACKET_VECTORS, true);
    // A beam of one ray would serve nothing.
    packet->has_beam = LANES > 1 && !grid->selected;
    packet->only_shape = NULL;
    if (packet->has_beam) {
        packet->beam = camera_packet_beam(camera, grid, jitter, index);
    }
    jitter = camera_shifted(camera, jitter);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        packet->limit[v] = real_of(INFINITE);
    }
    if (grid->selected) {
        camera_generate_selected_rays(camera, grid, jitter, index, packet);
    } else if (LANES == 1 && run) {
        camera_take_ray(camera, grid, jitter, index, run, packet);
    } else {
        camera_generate_grid_rays(camera, grid, jitter, index, packet);
    }
}
