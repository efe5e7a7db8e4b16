/**
 * @file
 * @brief Comparing few samples with many.
 */
#include "lab/needs/sampling_error.h"

#include <math.h>

/** Samples that are traced at least and at most to see what fewer are worth. */
enum { REFERENCE_SAMPLES_MINIMUM = 16, REFERENCE_SAMPLES_MAXIMUM = 128 };

/** How many times as many samples are compared with. */
enum { REFERENCE_SAMPLES_FACTOR = 4 };

/**
 * @return The mean of the first samples of a pixel, one primary.
 * @param pixels  How many there are.
 */
static double mean_of_samples(const SampledRender *render, size_t pixel, size_t pixels, int samples,
                              size_t channel) {
    double sum = 0;
    for (int i = 0; i < samples; i++) {
        sum += render->rgb[3 * ((size_t)i * pixels + pixel) + channel];
    }
    return sum / samples;
}

/**
 * Finds how far pixels are off with fewer samples.
 * @param[out] fraction  Share of the pixels that are off.
 * @return By how many steps, root of the mean square of those.
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

/** Halves the samples while nothing changes. @param[in,out] best What the most leave that are
 *  wanted. */
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

/** @return Whether a pixel is tried: one of four that pilots sample, as each is traced so often.
 *  See #PixelTest. */
static bool pixel_is_sparse(const void *context, int x, int y) {
    return pixel_is_sampled(context, x, y) && x / 8 % 2 == 0 && y / 8 % 2 == 0;
}

/** Takes all samples of the pixels that are tried. @return false if anything is. */
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
