/**
 * @file
 * @brief Comparing few samples with many.
 */
#include "lab/smoothness.h"

#include <math.h>

/** Samples that are traced at least and at most to see what fewer are worth. */
enum { SAMPLES_LEAST = 16, SAMPLES_MOST = 128 };

/** How many times as many samples are compared with. */
enum { SAMPLES_TIMES = 4 };

/** @return The mean of the first samples of a pixel, one primary. @param shot The shot.
 *  @param pixel Its place. @param pixels How many there are. @param samples How many samples.
 *  @param primary Which. */
static double mean_of(const Shot *shot, size_t pixel, size_t pixels, int samples, size_t primary) {
    double sum = 0;
    for (int i = 0; i < samples; i++) {
        sum += shot->rgb[3 * ((size_t)i * pixels + pixel) + primary];
    }
    return sum / samples;
}

/** Finds how far pixels are off with fewer samples. @param studio What was shot. @param shot All
 *  samples. @param all How many. @param samples How many fewer. @param[out] share Share of the
 *  pixels that are off. @return By how many steps, root of the mean square of those. */
static double samples_error(const Studio *studio, const Shot *shot, int all, int samples,
                            double *share) {
    size_t pixels = shot->count / (size_t)all, off = 0;
    double squares = 0;
    for (size_t pixel = 0; pixel < pixels; pixel++) {
        double few[3], many[3];
        for (size_t primary = 0; primary < 3; primary++) {
            few[primary] = mean_of(shot, pixel, pixels, samples, primary);
            many[primary] = mean_of(shot, pixel, pixels, all, primary);
        }
        double steps = contrast_steps(few, many, (Encoding)studio->scene->image.encoding);
        off += steps >= CONTRAST_VISIBLE;
        squares += steps >= CONTRAST_VISIBLE ? steps * steps : 0;
    }
    *share = pixels ? (double)off / (double)pixels : 0;
    return off ? sqrt(squares / (double)off) : 0;
}

/** Halves the samples while nothing changes. @param studio What was shot. @param shot All samples.
 *  @param all How many. @param[in,out] best What the most leave that are wanted. */
static void samples_halve(const Studio *studio, const Shot *shot, int all, Smoothness *best) {
    while (best->samples > 1 && best->share == 0) {
        Smoothness half = {.samples = best->samples / 2};
        half.rms = samples_error(studio, shot, all, half.samples, &half.share);
        if (half.share > 0) {
            return;
        }
        *best = half;
    }
}

/** @return Whether a pixel is tried: one of four that pilots sample, as each is traced so often.
 * See #PixelTest. @param context Not looked at. @param x Its column. @param y Its row. */
static bool pixel_is_tried(const void *context, int x, int y) {
    return pixel_is_sampled(context, x, y) && x / 8 % 2 == 0 && y / 8 % 2 == 0;
}

/** Takes all samples of the pixels that are tried. @param studio What is shot. @param manner How.
 *  @param[out] shot The shot. @param[out] error What is wrong. @return false if anything is. */
static bool samples_take(const Studio *studio, const Manner *manner, Shot *shot, Error *error) {
    Studio few = *studio;
    Pixels tried;
    if (!pixels_make(&tried, studio->pixels->width, studio->pixels->height, pixel_is_tried, NULL,
                     error)) {
        return false;
    }
    few.pixels = &tried;
    bool is_taken = shot_take(&few, manner, shot, error);
    pixels_release(&tried);
    return is_taken;
}

bool smoothness_find(const Studio *studio, const Manner *manner, Smoothness *smoothness,
                     Error *error) {
    Manner many = *manner;
    Shot shot;
    int wanted = manner->trace.samples;
    wanted = wanted < SAMPLES_MOST / SAMPLES_TIMES ? wanted : SAMPLES_MOST / SAMPLES_TIMES;
    many.rays = wanted * SAMPLES_TIMES > SAMPLES_LEAST ? wanted * SAMPLES_TIMES : SAMPLES_LEAST;
    many.trace.samples = many.rays;
    *smoothness = (Smoothness){.samples = wanted};
    if (!samples_take(studio, &many, &shot, error)) {
        return false;
    }
    smoothness->rms = samples_error(studio, &shot, many.rays, wanted, &smoothness->share);
    samples_halve(studio, &shot, many.rays, smoothness);
    shot_release(&shot);
    return true;
}
