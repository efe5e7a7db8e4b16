/**
 * @file
 * @brief Looking beside an edge.
 */
#include "lab/needs/outliers.h"

#include <stdlib.h>
#include <string.h>

/** Sides to which the eye is turned. */
enum { SHIFT_DIRECTIONS = 8 };
/** How often it is turned there, each time a quarter as far: behind some mirrors the picture
 * changes within less than #OUTLIER_CAMERA_SHIFT. */
enum { SHIFT_SCALES = 5 };

/** What is known of the pixels of a studio. */
typedef struct OutlierSearch {
    const PixelSet *pixels; /**< The pixels. */
    uint8_t *is_flipped;    /**< Of each place in the picture: whether a ray flipped; owned. */
    size_t *flipped_pixels; /**< Of each flipped pixel: its place among all; owned. */
    bool *is_unexplained;   /**< Of each ray of those: whether it still is; owned. */
    PixelSet flipped;       /**< The flipped pixels; owned. */
} OutlierSearch;

/** @return Whether a pixel has flipped. See #PixelTest. */
static bool pixel_is_flipped(const void *context, int x, int y) {
    const OutlierSearch *search = context;
    return search->is_flipped[(size_t)y * (size_t)search->pixels->width + (size_t)x];
}

/**
 * @return Whether a ray took another way, and shows it.
 * @param encoding  How light is shown.
 */
static bool ray_is_flipped(const SampledRender *reference_render, const SampledRender *render,
                           size_t i, Encoding encoding) {
    return reference_render->path_hashes[i] != render->path_hashes[i] &&
           image_difference_steps(&reference_render->rgb[3 * i], &render->rgb[3 * i], encoding) >=
               IMAGE_DIFFERENCE_VISIBLE;
}

/**
 * @return Whether any ray of a pixel is flipped.
 * @param reference_render  As it should be.
 * @param encoding  How light is shown.
 */
static bool any_is_flipped(const SampledRender *reference_render, const SampledRender *render,
                           size_t pixel, size_t count, Encoding encoding) {
    bool is_any = false;
    for (size_t i = pixel; i < render->ray_count; i += count) {
        is_any = is_any || ray_is_flipped(reference_render, render, i, encoding);
    }
    return is_any;
}

/**
 * Finds the flipped pixels, in the order of the blocks.
 * @param[in,out] search  What is known; with room.
 * @param reference_render  As it should be.
 * @param encoding  How light is shown.
 */
static void find_flipped_pixels(OutlierSearch *search, const SampledRender *reference_render,
                                const SampledRender *render, Encoding encoding) {
    size_t found = 0;
    for (size_t block = 0; block < search->pixels->tile_count; block++) {
        PixelGrid grid = pixel_set_tile_grid(search->pixels, block);
        for (size_t i = 0; i < grid.selected_count; i++) {
            size_t pixel = search->pixels->tile_first[block] + i;
            if (any_is_flipped(reference_render, render, pixel, search->pixels->count, encoding)) {
                int x = grid.x + grid.selected[i] % grid.columns;
                int y = grid.y + grid.selected[i] / grid.columns;
                search->is_flipped[(size_t)y * (size_t)search->pixels->width + (size_t)x] = 1;
                search->flipped_pixels[found++] = pixel;
            }
        }
    }
}

/**
 * Strikes out the rays that see, a little aside, what they saw.
 * @param shifted  The flipped pixels from there.
 * @param encoding  How light is shown.
 */
static void clear_explained_rays(OutlierSearch *search, const SampledRender *shifted,
                                 const SampledRender *render, Encoding encoding) {
    for (size_t i = 0; i < shifted->ray_count; i++) {
        size_t pixel = search->flipped_pixels[i % search->flipped.count];
        size_t ray = i / search->flipped.count * search->pixels->count + pixel;
        bool is_there = shifted->path_hashes[i] == render->path_hashes[ray] ||
                        image_difference_steps(&shifted->rgb[3 * i], &render->rgb[3 * ray],
                                               encoding) < IMAGE_DIFFERENCE_VISIBLE;
        search->is_unexplained[i] = search->is_unexplained[i] && !is_there;
    }
}

/**
 * Turns the eye to one side.
 * @param variant  How, and how far the eye is turned.
 * @return false if anything is.
 */
static bool render_shifted(const RenderContext *render_context, const Variant *variant,
                           OutlierSearch *search, const SampledRender *render, Error *error) {
    SampledRender shifted;
    if (!render_samples(render_context, variant, &shifted, error)) {
        return false;
    }
    clear_explained_rays(search, &shifted, render, (Encoding)render_context->scene->image.encoding);
    sampled_render_deinit(&shifted);
    return true;
}

/** Turns the eye to all sides, less and less. @return false if anything is. */
static bool render_all_shifts(const RenderContext *render_context, const Variant *reference,
                              OutlierSearch *search, const SampledRender *render, Error *error) {
    RenderContext shifted_context = *render_context;
    shifted_context.pixels = &search->flipped;
    bool is_done = true;
    double shift = OUTLIER_CAMERA_SHIFT;
    for (int shift_step = 0; shift_step < SHIFT_SCALES; shift_step++, shift /= 4) {
        for (int side = 0; is_done && side < SHIFT_DIRECTIONS; side++) {
            Variant variant = *reference;
            variant.shift_right = shift * cos(2 * M_PI * side / SHIFT_DIRECTIONS);
            variant.shift_up = shift * sin(2 * M_PI * side / SHIFT_DIRECTIONS);
            is_done = render_shifted(&shifted_context, &variant, search, render, error);
        }
    }
    return is_done;
}

/**
 * @return How many rays are lost.
 * @param reference_render  As it should be.
 * @param encoding  How light is shown.
 */
static size_t count_unexplained_rays(const OutlierSearch *search,
                                     const SampledRender *reference_render,
                                     const SampledRender *render, Encoding encoding) {
    size_t count = 0, flipped = search->flipped.count;
    for (size_t i = 0; flipped > 0 && i < flipped * (render->ray_count / search->pixels->count);
         i++) {
        size_t ray = i / flipped * search->pixels->count + search->flipped_pixels[i % flipped];
        count +=
            search->is_unexplained[i] && ray_is_flipped(reference_render, render, ray, encoding);
    }
    return count;
}

bool outliers_count(const RenderContext *render_context, const Variant *reference,
                    const SampledRender *reference_render, const SampledRender *render,
                    size_t *outliers, Error *error) {
    const PixelSet *pixels = render_context->pixels;
    Encoding encoding = (Encoding)render_context->scene->image.encoding;
    OutlierSearch search = {.pixels = pixels,
                            .is_flipped = calloc((size_t)pixels->width, (size_t)pixels->height),
                            .flipped_pixels =
                                calloc(pixels->count + 1, sizeof *search.flipped_pixels),
                            .is_unexplained = malloc(render->ray_count + 1)};
    bool is_done = search.is_flipped && search.flipped_pixels && search.is_unexplained;
    *outliers = 0;
    if (is_done) {
        memset(search.is_unexplained, true, render->ray_count);
        find_flipped_pixels(&search, reference_render, render, encoding);
        is_done = pixel_set_init(&search.flipped, pixels->width, pixels->height, pixel_is_flipped,
                                 &search, error);
        is_done = is_done && (search.flipped.count == 0 ||
                              render_all_shifts(render_context, reference, &search, render, error));
    } else {
        error_set(error, STATUS_FAILED, "no memory for %zu pixels", pixels->count);
    }
    *outliers = is_done ? count_unexplained_rays(&search, reference_render, render, encoding) : 0;
    pixel_set_deinit(&search.flipped);
    free(search.is_flipped);
    free(search.flipped_pixels);
    free(search.is_unexplained);
    return is_done;
}
