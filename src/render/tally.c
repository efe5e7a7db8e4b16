/**
 * @file
 * @brief Which pixels need more samples.
 */
#include "render/tally.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/** Pixels along a side of the tiles in whose order open pixels are listed: those of a packet then
 *  lie close together. */
#define TILE 8

bool tally_resize(Tally *tally, int width, int height, bool judges, Error *error) {
    size_t pixels = (size_t)width * (size_t)height;
    if (tally->width == width && tally->height == height) {
        return true;
    }
    tally_release(tally);
    *tally = (Tally){.width = width, .height = height};
    tally->sums = malloc(3 * pixels * sizeof *tally->sums);
    bool is_made = tally->sums != NULL;
    if (judges) {
        tally->counts = malloc(pixels * sizeof *tally->counts);
        tally->lows = malloc(3 * pixels * sizeof *tally->lows);
        tally->highs = malloc(3 * pixels * sizeof *tally->highs);
        tally->rough = malloc(pixels);
        tally->open = malloc(pixels);
        is_made =
            is_made && tally->counts && tally->lows && tally->highs && tally->rough && tally->open;
    }
    if (!is_made) {
        tally_release(tally);
        return error_set(error, STATUS_FAILED, "no memory for %d x %d pixels", width, height);
    }
    return true;
}

void tally_release(Tally *tally) {
    free(tally->sums);
    free(tally->counts);
    free(tally->lows);
    free(tally->highs);
    free(tally->rough);
    free(tally->open);
    *tally = (Tally){0};
}

int tally_first(int samples) {
    int first = TALLY_LEAST;
    while (first <= samples / 8) {
        first *= 2;
    }
    return first;
}

bool tally_is_due(int sample) {
    return (sample & (sample - 1)) == 0;
}

uint16_t tally_step(const Encoder *encoder, float light, bool beyond_white) {
    /** Of a float: bits of the mantissa below those that make 128 steps an octave. */
    enum { BITS_BELOW_STEP = 16 };
    uint16_t step = encoder_encode(encoder, light);
    if (light > 1 && beyond_white) {
        const float white = 1;
        uint32_t bits, bits_of_white;
        memcpy(&bits, &light, sizeof bits);
        memcpy(&bits_of_white, &white, sizeof bits_of_white);
        step = (uint16_t)(step + ((bits - bits_of_white) >> BITS_BELOW_STEP));
    }
    return step;
}

/** @return Whether the samples of a pixel differ. @param tally The tally. @param pixel Its place.
 */
static bool is_rough(const Tally *tally, size_t pixel) {
    bool is_far = false;
    for (size_t i = 3 * pixel; i < 3 * pixel + 3; i++) {
        is_far = is_far || tally->highs[i] > tally->lows[i] + TALLY_CALM;
    }
    return is_far;
}

/** A judgement under way. */
typedef struct Judgement {
    Tally *tally;       /**< The tally. */
    int samples;        /**< Rays a pixel that are wanted. */
    atomic_size_t left; /**< Rays that are still to be drawn. */
} Judgement;

/** Judges a row of pixels by themselves. See #WorkersJob. @param context The judgement.
 *  @param index The row. */
static void row_judge(void *context, size_t index) {
    Tally *tally = ((Judgement *)context)->tally;
    size_t first = index * (size_t)tally->width;
    for (size_t pixel = first; pixel < first + (size_t)tally->width; pixel++) {
        tally->rough[pixel] = is_rough(tally, pixel);
    }
}

/** Says which pixels of a row are open. @param tally The tally, all its rows judged. @param y The
 *  row. */
static void row_open(Tally *tally, int y) {
    size_t width = (size_t)tally->width;
    int top = y > 0 ? y - 1 : 0, bottom = y + 1 < tally->height ? y + 1 : y;
    const uint8_t *here = tally->rough + (size_t)y * width;
    const uint8_t *above = tally->rough + (size_t)top * width;
    const uint8_t *below = tally->rough + (size_t)bottom * width;
    uint8_t *open = tally->open + (size_t)y * width;
    for (size_t x = 0; x < width; x++) {
        size_t left = x > 0 ? x - 1 : 0, right = x + 1 < width ? x + 1 : x;
        open[x] = above[left] | above[x] | above[right] | here[left] | here[x] | here[right] |
                  below[left] | below[x] | below[right];
    }
}

/** Finds what is to be drawn in a row of pixels. See #WorkersJob. @param context The judgement.
 *  @param index The row. */
static void row_count(void *context, size_t index) {
    Judgement *judgement = context;
    Tally *tally = judgement->tally;
    size_t first = index * (size_t)tally->width, left = 0;
    row_open(tally, (int)index);
    for (size_t pixel = first; pixel < first + (size_t)tally->width; pixel++) {
        left += tally->open[pixel] ? (size_t)judgement->samples - tally->counts[pixel] : 0;
    }
    atomic_fetch_add(&judgement->left, left);
}

size_t tally_judge(Tally *tally, Workers *workers, int samples) {
    Judgement judgement = {.tally = tally, .samples = samples};
    workers_run(workers, (size_t)tally->height, row_judge, &judgement);
    workers_run(workers, (size_t)tally->height, row_count, &judgement);
    return judgement.left;
}

/** Lists the open pixels of a row of a tile. @param open Whether each pixel of the row is.
 *  @param columns How many. @param place Of the first. @param[out] places Of those that are.
 *  @return How many. */
static size_t row_list(const uint8_t *open, int columns, int place, uint16_t *places) {
    uint64_t none = 0;
    size_t count = 0;
    if (columns == TILE && memcmp(open, &none, TILE) == 0) {
        return 0;
    }
    for (int x = 0; x < columns; x++) {
        if (open[x]) {
            places[count++] = (uint16_t)(place + x);
        }
    }
    return count;
}

size_t tally_open(const Tally *tally, const PixelGrid *block, uint16_t *places) {
    size_t count = 0;
    for (int row = 0; row < block->rows; row += TILE) {
        for (int column = 0; column < block->columns; column += TILE) {
            int columns = block->columns - column < TILE ? block->columns - column : TILE;
            for (int y = row; y < row + TILE && y < block->rows; y++) {
                size_t at =
                    (size_t)(block->y + y) * (size_t)tally->width + (size_t)(block->x + column);
                count += row_list(tally->open + at, columns, y * block->columns + column,
                                  places + count);
            }
        }
    }
    return count;
}
