/**
 * @file
 * @brief Sums of samples and adaptive sampling.
 */
#include "render/sample_accumulator.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/** Side of the squares in whose order active pixels are listed, pixels: those of a packet are then
 *  close together. */
#define LIST_TILE 8

bool sample_accumulator_resize(SampleAccumulator *accumulator, int width, int height,
                               bool is_adaptive, Error *error) {
    size_t pixels = (size_t)width * (size_t)height;
    if (accumulator->width == width && accumulator->height == height) {
        return true;
    }
    sample_accumulator_deinit(accumulator);
    *accumulator = (SampleAccumulator){.width = width, .height = height};
    accumulator->sums = malloc(3 * pixels * sizeof *accumulator->sums);
    bool is_made = accumulator->sums != NULL;
    if (is_adaptive) {
        accumulator->counts = malloc(pixels * sizeof *accumulator->counts);
        accumulator->minima = malloc(3 * pixels * sizeof *accumulator->minima);
        accumulator->maxima = malloc(3 * pixels * sizeof *accumulator->maxima);
        accumulator->noisy = malloc(pixels);
        accumulator->active = malloc(pixels);
        is_made = is_made && accumulator->counts && accumulator->minima && accumulator->maxima &&
                  accumulator->noisy && accumulator->active;
    }
    if (!is_made) {
        sample_accumulator_deinit(accumulator);
        return error_set(error, STATUS_FAILED, "no memory for %d x %d pixels", width, height);
    }
    return true;
}

void sample_accumulator_deinit(SampleAccumulator *accumulator) {
    free(accumulator->sums);
    free(accumulator->counts);
    free(accumulator->minima);
    free(accumulator->maxima);
    free(accumulator->noisy);
    free(accumulator->active);
    *accumulator = (SampleAccumulator){0};
}

int adaptive_first_samples(int samples) {
    int first = ADAPTIVE_SAMPLES_MINIMUM;
    while (first <= samples / 8) {
        first *= 2;
    }
    return first;
}

bool adaptive_is_update_due(int sample) {
    return (sample & (sample - 1)) == 0;
}

uint16_t adaptive_code(const Encoder *encoder, float linear, bool beyond_white) {
    /** Mantissa bits of a float below those that make 128 steps per octave. */
    enum { BITS_BELOW_STEP = 16 };
    uint16_t code = encoder_encode(encoder, linear);
    if (linear > 1 && beyond_white) {
        const float white = 1;
        uint32_t bits, bits_of_white;
        memcpy(&bits, &linear, sizeof bits);
        memcpy(&bits_of_white, &white, sizeof bits_of_white);
        code = (uint16_t)(code + ((bits - bits_of_white) >> BITS_BELOW_STEP));
    }
    return code;
}

/** @return Whether the samples of a pixel differ by more than the tolerance. */
static bool is_noisy(const SampleAccumulator *accumulator, size_t pixel) {
    bool is_different = false;
    for (size_t i = 3 * pixel; i < 3 * pixel + 3; i++) {
        is_different =
            is_different || accumulator->maxima[i] > accumulator->minima[i] + ADAPTIVE_TOLERANCE;
    }
    return is_different;
}

/** An update of the active pixels. */
typedef struct ActiveUpdate {
    SampleAccumulator *accumulator; /**< The accumulator. */
    int samples;                    /**< Samples per pixel. */
    atomic_size_t remaining;        /**< Rays that remain. */
} ActiveUpdate;

/** Finds the noisy pixels of a row. See #ThreadPoolTask. */
static void update_noisy_row(void *context, size_t index) {
    SampleAccumulator *accumulator = ((ActiveUpdate *)context)->accumulator;
    size_t first = index * (size_t)accumulator->width;
    for (size_t pixel = first; pixel < first + (size_t)accumulator->width; pixel++) {
        accumulator->noisy[pixel] = is_noisy(accumulator, pixel);
    }
}

/** Finds the active pixels of a row. @param accumulator The accumulator, with the noisy pixels of
 * all rows. */
static void update_active_row(SampleAccumulator *accumulator, int y) {
    size_t width = (size_t)accumulator->width;
    int top = y > 0 ? y - 1 : 0, bottom = y + 1 < accumulator->height ? y + 1 : y;
    const uint8_t *center = accumulator->noisy + (size_t)y * width;
    const uint8_t *above = accumulator->noisy + (size_t)top * width;
    const uint8_t *below = accumulator->noisy + (size_t)bottom * width;
    uint8_t *active = accumulator->active + (size_t)y * width;
    for (size_t x = 0; x < width; x++) {
        size_t left = x > 0 ? x - 1 : 0, right = x + 1 < width ? x + 1 : x;
        active[x] = above[left] | above[x] | above[right] | center[left] | center[x] |
                    center[right] | below[left] | below[x] | below[right];
    }
}

/** Finds the active pixels of a row and counts their remaining rays. See #ThreadPoolTask. */
static void count_remaining_row(void *context, size_t index) {
    ActiveUpdate *update = context;
    SampleAccumulator *accumulator = update->accumulator;
    size_t first = index * (size_t)accumulator->width, remaining = 0;
    update_active_row(accumulator, (int)index);
    for (size_t pixel = first; pixel < first + (size_t)accumulator->width; pixel++) {
        remaining +=
            accumulator->active[pixel] ? (size_t)update->samples - accumulator->counts[pixel] : 0;
    }
    atomic_fetch_add(&update->remaining, remaining);
}

size_t sample_accumulator_update_active(SampleAccumulator *accumulator, ThreadPool *thread_pool,
                                        int samples) {
    ActiveUpdate update = {.accumulator = accumulator, .samples = samples};
    thread_pool_run(thread_pool, (size_t)accumulator->height, update_noisy_row, &update);
    thread_pool_run(thread_pool, (size_t)accumulator->height, count_remaining_row, &update);
    return update.remaining;
}

/**
 * Lists the active pixels of a row of a tile.
 * @param active  For each pixel of the row, whether it is active.
 * @param[out] indices  Indices of the active pixels.
 * @return Number of active pixels.
 */
static size_t list_active_row(const uint8_t *active, int columns, int first_index,
                              uint16_t *indices) {
    uint64_t none = 0;
    size_t count = 0;
    if (columns == LIST_TILE && memcmp(active, &none, LIST_TILE) == 0) {
        return 0;
    }
    for (int x = 0; x < columns; x++) {
        if (active[x]) {
            indices[count++] = (uint16_t)(first_index + x);
        }
    }
    return count;
}

size_t sample_accumulator_list_active(const SampleAccumulator *accumulator, const PixelGrid *tile,
                                      uint16_t *indices) {
    size_t count = 0;
    for (int row = 0; row < tile->rows; row += LIST_TILE) {
        for (int column = 0; column < tile->columns; column += LIST_TILE) {
            int columns = tile->columns - column < LIST_TILE ? tile->columns - column : LIST_TILE;
            for (int y = row; y < row + LIST_TILE && y < tile->rows; y++) {
                size_t first_pixel =
                    (size_t)(tile->y + y) * (size_t)accumulator->width + (size_t)(tile->x + column);
                count += list_active_row(accumulator->active + first_pixel, columns,
                                         y * tile->columns + column, indices + count);
            }
        }
    }
    return count;
}
