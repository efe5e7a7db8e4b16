/**
 * @file
 * @brief Looking beside an edge.
 */
#include "lab/strays.h"

#include <stdlib.h>
#include <string.h>

/** Sides to which the eye is turned. */
enum { SIDES = 8 };
/** How often it is turned there, each time a quarter as far: behind some mirrors the picture
 * changes within less than #STRAYS_NUDGE. */
enum { NEARINGS = 5 };

/** What is known of the pixels of a studio. */
typedef struct Lost {
    const Pixels *pixels; /**< The pixels. */
    uint8_t *is_flipped;  /**< Of each place in the picture: whether a ray flipped; owned. */
    size_t *place;        /**< Of each flipped pixel: its place among all; owned. */
    bool *is_lost;        /**< Of each ray of those: whether it still is; owned. */
    Pixels flipped;       /**< The flipped pixels; owned. */
} Lost;

/** @return Whether a pixel has flipped. See #PixelTest. @param context The #Lost. @param x Its
 *  column. @param y Its row. */
static bool pixel_is_flipped(const void *context, int x, int y) {
    const Lost *lost = context;
    return lost->is_flipped[(size_t)y * (size_t)lost->pixels->width + (size_t)x];
}

/** @return Whether a ray took another way, and shows it. @param truth The ways and colours.
 *  @param shot The shot. @param i Which ray. @param encoding How light is shown. */
static bool ray_is_flipped(const Shot *truth, const Shot *shot, size_t i, Encoding encoding) {
    return truth->trails[i] != shot->trails[i] &&
           contrast_steps(&truth->rgb[3 * i], &shot->rgb[3 * i], encoding) >= CONTRAST_VISIBLE;
}

/** @return Whether any ray of a pixel is flipped. @param truth As it should be. @param shot As it
 *  is. @param pixel Which pixel. @param count Pixels. @param encoding How light is shown. */
static bool any_is_flipped(const Shot *truth, const Shot *shot, size_t pixel, size_t count,
                           Encoding encoding) {
    bool is_any = false;
    for (size_t i = pixel; i < shot->count; i += count) {
        is_any = is_any || ray_is_flipped(truth, shot, i, encoding);
    }
    return is_any;
}

/** Finds the flipped pixels, in the order of the blocks. @param[in,out] lost What is known; with
 *  room. @param truth As it should be. @param shot As it is. @param encoding How light is shown. */
static void flipped_find(Lost *lost, const Shot *truth, const Shot *shot, Encoding encoding) {
    size_t found = 0;
    for (size_t block = 0; block < lost->pixels->blocks; block++) {
        PixelGrid grid = pixels_grid(lost->pixels, block);
        for (size_t i = 0; i < grid.chosen_count; i++) {
            size_t pixel = lost->pixels->first[block] + i;
            if (any_is_flipped(truth, shot, pixel, lost->pixels->count, encoding)) {
                int x = grid.x + grid.chosen[i] % grid.columns;
                int y = grid.y + grid.chosen[i] / grid.columns;
                lost->is_flipped[(size_t)y * (size_t)lost->pixels->width + (size_t)x] = 1;
                lost->place[found++] = pixel;
            }
        }
    }
}

/** Strikes out the rays that see, a little aside, what they saw. @param[in,out] lost What is known.
 *  @param aside The flipped pixels from there. @param shot The shot. @param encoding How light is
 *  shown. */
static void lost_look(Lost *lost, const Shot *aside, const Shot *shot, Encoding encoding) {
    for (size_t i = 0; i < aside->count; i++) {
        size_t pixel = lost->place[i % lost->flipped.count];
        size_t ray = i / lost->flipped.count * lost->pixels->count + pixel;
        bool is_there =
            aside->trails[i] == shot->trails[ray] ||
            contrast_steps(&aside->rgb[3 * i], &shot->rgb[3 * ray], encoding) < CONTRAST_VISIBLE;
        lost->is_lost[i] = lost->is_lost[i] && !is_there;
    }
}

/** Turns the eye to one side. @param studio The flipped pixels. @param manner How, and how far the
 *  eye is turned. @param[in,out] lost What is known. @param shot The shot. @param[out] error What
 * is wrong. @return false if anything is. */
static bool side_look(const Studio *studio, const Manner *manner, Lost *lost, const Shot *shot,
                      Error *error) {
    Shot aside;
    if (!shot_take(studio, manner, &aside, error)) {
        return false;
    }
    lost_look(lost, &aside, shot, (Encoding)studio->scene->image.encoding);
    shot_release(&aside);
    return true;
}

/** Turns the eye to all sides, less and less. @param studio What is shot. @param reference How.
 *  @param[in,out] lost What is known. @param shot The shot. @param[out] error What is wrong.
 *  @return false if anything is. */
static bool sides_look(const Studio *studio, const Manner *reference, Lost *lost, const Shot *shot,
                       Error *error) {
    Studio beside = *studio;
    beside.pixels = &lost->flipped;
    bool is_done = true;
    double nudge = STRAYS_NUDGE;
    for (int nearing = 0; nearing < NEARINGS; nearing++, nudge /= 4) {
        for (int side = 0; is_done && side < SIDES; side++) {
            Manner manner = *reference;
            manner.right = nudge * cos(2 * M_PI * side / SIDES);
            manner.up = nudge * sin(2 * M_PI * side / SIDES);
            is_done = side_look(&beside, &manner, lost, shot, error);
        }
    }
    return is_done;
}

/** @return How many rays are lost. @param lost What is known. @param truth As it should be.
 *  @param shot As it is. @param encoding How light is shown. */
static size_t lost_count(const Lost *lost, const Shot *truth, const Shot *shot, Encoding encoding) {
    size_t count = 0, flipped = lost->flipped.count;
    for (size_t i = 0; flipped > 0 && i < flipped * (shot->count / lost->pixels->count); i++) {
        size_t ray = i / flipped * lost->pixels->count + lost->place[i % flipped];
        count += lost->is_lost[i] && ray_is_flipped(truth, shot, ray, encoding);
    }
    return count;
}

bool strays_count(const Studio *studio, const Manner *reference, const Shot *truth,
                  const Shot *shot, size_t *strays, Error *error) {
    const Pixels *pixels = studio->pixels;
    Encoding encoding = (Encoding)studio->scene->image.encoding;
    Lost lost = {.pixels = pixels,
                 .is_flipped = calloc((size_t)pixels->width, (size_t)pixels->height),
                 .place = calloc(pixels->count + 1, sizeof *lost.place),
                 .is_lost = malloc(shot->count + 1)};
    bool is_done = lost.is_flipped && lost.place && lost.is_lost;
    *strays = 0;
    if (is_done) {
        memset(lost.is_lost, true, shot->count);
        flipped_find(&lost, truth, shot, encoding);
        is_done = pixels_make(&lost.flipped, pixels->width, pixels->height, pixel_is_flipped, &lost,
                              error);
        is_done = is_done &&
                  (lost.flipped.count == 0 || sides_look(studio, reference, &lost, shot, error));
    } else {
        error_set(error, STATUS_FAILED, "no memory for %zu pixels", pixels->count);
    }
    *strays = is_done ? lost_count(&lost, truth, shot, encoding) : 0;
    pixels_release(&lost.flipped);
    free(lost.is_flipped);
    free(lost.place);
    free(lost.is_lost);
    return is_done;
}
