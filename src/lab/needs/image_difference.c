/**
 * @file
 * @brief Compares renders.
 */
#include "lab/needs/image_difference.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** @return Encoded light, 8-bit steps. NaN is displayed as black. */
static double encoded_steps(double light, Encoding encoding) {
    double inside = light > 0 ? (light < 1 ? light : 1) : 0;
    return encoding_encode(encoding, inside);
}

double image_difference_steps(const double a[3], const double b[3], Encoding encoding) {
    double worst = 0;
    for (int i = 0; i < 3; i++) {
        if (a[i] != b[i]) {
            worst =
                fmax(worst, fabs(encoded_steps(a[i], encoding) - encoded_steps(b[i], encoding)));
        }
    }
    return worst;
}

/** @return The mean squared difference of the channels of two colours, clamped to 0 to 1. */
static double mean_squared_difference(const double a[3], const double b[3]) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double away = fmax(0, fmin(1, a[i])) - fmax(0, fmin(1, b[i]));
        sum += away * away;
    }
    return sum / 3;
}

ImageDifference image_difference_of(const SampledRender *a, const SampledRender *b,
                                    const SampledRender *path_reference, Encoding encoding) {
    ImageDifference difference = {.rays = a->ray_count};
    double equal_squares = 0, squares = 0;
    for (size_t i = 0; i < a->ray_count; i++) {
        const double *light = &a->rgb[3 * i], *other = &b->rgb[3 * i];
        bool is_equal = !path_reference || a->path_hashes[i] == path_reference->path_hashes[i];
        double steps = image_difference_steps(light, other, encoding),
               square = mean_squared_difference(light, other);
        squares += square;
        difference.same_path += is_equal;
        difference.edge_flips += !is_equal && steps >= IMAGE_DIFFERENCE_VISIBLE;
        difference.visible += is_equal && steps >= IMAGE_DIFFERENCE_VISIBLE;
        if (is_equal) {
            difference.max_steps = fmax(difference.max_steps, steps);
            equal_squares += square;
        }
    }
    difference.same_path_rms =
        difference.same_path ? sqrt(equal_squares / (double)difference.same_path) : 0;
    difference.total_rms = difference.rays ? sqrt(squares / (double)difference.rays) : 0;
    return difference;
}

/* --- outliers -----------------------------------------------------------------------------------
 */

/** Directions in which the camera is rotated. */
enum { SHIFT_DIRECTIONS = 8 };
/** Rotations per direction, each a quarter of the previous one: behind some mirrors the picture
 *  changes within less than #OUTLIER_CAMERA_SHIFT. */
enum { SHIFT_SCALES = 5 };

/** The search for outliers. */
typedef struct OutlierSearch {
    const PixelSet *pixels; /**< The pixels. */
    uint8_t *is_flipped;    /**< Per pixel of the picture: whether a ray flipped; owned. */
    size_t *flipped_pixels; /**< Per flipped pixel: its index in the set; owned. */
    bool *is_unexplained;   /**< Per ray of those: whether no rotation shows what it saw; owned. */
    PixelSet flipped;       /**< The flipped pixels; owned. */
} OutlierSearch;

/** Is a #PixelTest: the flipped pixels. */
static bool pixel_is_flipped(const void *context, int x, int y) {
    const OutlierSearch *search = context;
    return search->is_flipped[(size_t)y * (size_t)search->pixels->width + (size_t)x];
}

/** @return Whether a ray took another path with a visible difference. */
static bool ray_is_flipped(const SampledRender *reference_render, const SampledRender *render,
                           size_t i, Encoding encoding) {
    return reference_render->path_hashes[i] != render->path_hashes[i] &&
           image_difference_steps(&reference_render->rgb[3 * i], &render->rgb[3 * i], encoding) >=
               IMAGE_DIFFERENCE_VISIBLE;
}

/** @return Whether any ray of a pixel is flipped. @param count Pixels of the set. */
static bool any_is_flipped(const SampledRender *reference_render, const SampledRender *render,
                           size_t pixel, size_t count, Encoding encoding) {
    bool is_any = false;
    for (size_t i = pixel; i < render->ray_count; i += count) {
        is_any = is_any || ray_is_flipped(reference_render, render, i, encoding);
    }
    return is_any;
}

/** Finds the flipped pixels, in the order of the tiles. */
static void find_flipped_pixels(OutlierSearch *search, const SampledRender *reference_render,
                                const SampledRender *render, Encoding encoding) {
    size_t found = 0;
    for (size_t tile = 0; tile < search->pixels->tile_count; tile++) {
        PixelGrid grid = pixel_set_tile_grid(search->pixels, tile);
        for (size_t i = 0; i < grid.selected_count; i++) {
            size_t pixel = search->pixels->tile_first[tile] + i;
            if (any_is_flipped(reference_render, render, pixel, search->pixels->count, encoding)) {
                int x = grid.x + grid.selected[i] % grid.columns;
                int y = grid.y + grid.selected[i] / grid.columns;
                search->is_flipped[(size_t)y * (size_t)search->pixels->width + (size_t)x] = 1;
                search->flipped_pixels[found++] = pixel;
            }
        }
    }
}

/** Clears the rays whose path or colour occurs in the reference with a rotated camera. @param
 *  shifted The flipped pixels of that reference. */
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

/** Renders the reference with a rotated camera. @return false if anything is wrong. */
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

/** Rotates the camera in all directions, by less and less. @return false if anything is wrong. */
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

/** @return How many flipped rays are not explained by any rotation. */
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

/* --- noise --------------------------------------------------------------------------------------
 */

/** Least and most samples per pixel of the reference. */
enum { REFERENCE_SAMPLES_MINIMUM = 16, REFERENCE_SAMPLES_MAXIMUM = 128 };

/** Samples of the reference over samples measured. */
enum { REFERENCE_SAMPLES_FACTOR = 4 };

/** @return The mean of the first samples of a pixel in one channel. @param pixels Of the set. */
static double mean_of_samples(const SampledRender *render, size_t pixel, size_t pixels, int samples,
                              size_t channel) {
    double sum = 0;
    for (int i = 0; i < samples; i++) {
        sum += render->rgb[3 * ((size_t)i * pixels + pixel) + channel];
    }
    return sum / samples;
}

/**
 * Compares pixels with fewer samples to those with all.
 * @param[out] fraction  Fraction of the pixels with a visible difference.
 * @return Their RMS difference, 8-bit steps.
 */
static double difference_from_fewer_samples(const RenderContext *render_context,
                                            const SampledRender *render, int all, int samples,
                                            double *fraction) {
    size_t pixels = render->ray_count / (size_t)all, visible = 0;
    double squares = 0;
    for (size_t pixel = 0; pixel < pixels; pixel++) {
        double fewer[3], many[3];
        for (size_t channel = 0; channel < 3; channel++) {
            fewer[channel] = mean_of_samples(render, pixel, pixels, samples, channel);
            many[channel] = mean_of_samples(render, pixel, pixels, all, channel);
        }
        double steps =
            image_difference_steps(fewer, many, (Encoding)render_context->scene->image.encoding);
        visible += steps >= IMAGE_DIFFERENCE_VISIBLE;
        squares += steps >= IMAGE_DIFFERENCE_VISIBLE ? steps * steps : 0;
    }
    *fraction = pixels ? (double)visible / (double)pixels : 0;
    return visible ? sqrt(squares / (double)visible) : 0;
}

/** Halves the samples while no pixel changes visibly. @param all Samples of the render. */
static void reduce_samples(const RenderContext *render_context, const SampledRender *render,
                           int all, SamplingError *best) {
    while (best->samples > 1 && best->fraction == 0) {
        SamplingError half = {.samples = best->samples / 2};
        half.rms = difference_from_fewer_samples(render_context, render, all, half.samples,
                                                 &half.fraction);
        if (half.fraction > 0) {
            return;
        }
        *best = half;
    }
}

/** Is a #PixelTest: a quarter of #pixel_is_sampled, as each pixel has many samples. */
static bool pixel_is_sparse(const void *context, int x, int y) {
    return pixel_is_sampled(context, x, y) && x / 8 % 2 == 0 && y / 8 % 2 == 0;
}

/** Renders all samples of the pixels of #pixel_is_sparse. @return false if anything is wrong. */
static bool render_reference_samples(const RenderContext *render_context, const Variant *variant,
                                     SampledRender *render, Error *error) {
    RenderContext sparse_context = *render_context;
    PixelSet tried;
    if (!pixel_set_init(&tried, render_context->pixels->width, render_context->pixels->height,
                        pixel_is_sparse, NULL, error)) {
        return false;
    }
    sparse_context.pixels = &tried;
    bool is_taken = render_samples(&sparse_context, variant, render, error);
    pixel_set_deinit(&tried);
    return is_taken;
}

bool sampling_error_measure(const RenderContext *render_context, const Variant *variant,
                            SamplingError *sampling_error, Error *error) {
    Variant many = *variant;
    SampledRender render;
    int wanted = variant->trace.samples;
    wanted = wanted < REFERENCE_SAMPLES_MAXIMUM / REFERENCE_SAMPLES_FACTOR
                 ? wanted
                 : REFERENCE_SAMPLES_MAXIMUM / REFERENCE_SAMPLES_FACTOR;
    many.samples_traced = wanted * REFERENCE_SAMPLES_FACTOR > REFERENCE_SAMPLES_MINIMUM
                              ? wanted * REFERENCE_SAMPLES_FACTOR
                              : REFERENCE_SAMPLES_MINIMUM;
    many.trace.samples = many.samples_traced;
    *sampling_error = (SamplingError){.samples = wanted};
    if (!render_reference_samples(render_context, &many, &render, error)) {
        return false;
    }
    sampling_error->rms = difference_from_fewer_samples(
        render_context, &render, many.samples_traced, wanted, &sampling_error->fraction);
    reduce_samples(render_context, &render, many.samples_traced, sampling_error);
    sampled_render_deinit(&render);
    return true;
}
