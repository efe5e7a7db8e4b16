/**
 * @file
 * @brief `dioptre compare`: how two pictures differ.
 */
#include "assets/images/image_file.h"
#include "base/json.h"
#include "base/language.h"
#include "cli/commands.h"

#include <libintl.h>
#include <stdio.h>

/** Prints a comparison. */
static void comparison_print(const PictureComparison *c, const Options *options) {
    /** Significant digits of numbers in JSON. */
    const int digits = 9;
    if (options->json) {
        JsonWriter json = {.stream = stdout};
        json_object_begin(&json, NULL);
        json_integer(&json, "width", c->width);
        json_integer(&json, "height", c->height);
        json_integer(&json, "worst_step", c->max_difference);
        json_number(&json, "share_off", c->differing_fraction, digits);
        json_number(&json, "rmse", c->rmse, digits);
        json_number(&json, "psnr", c->psnr, digits);
        json_line_end(&json);
    } else if (!options->quiet) {
        printf(gettext("worst step   %d of 255\n"), c->max_difference);
        printf(gettext("pixels off   %.4f %% by more than one step\n"),
               100 * c->differing_fraction);
        printf(gettext("RMSE         %.3g of linear light\n"), c->rmse);
        isfinite(c->psnr) ? printf(gettext("PSNR         %.1f dB\n"), c->psnr)
                          : printf(gettext("PSNR         infinite: the pictures are equal\n"));
    }
}

/**
 * Compares two pictures that were read.
 * @param[out] error  #STATUS_SCENE: their sizes differ; #STATUS_FAILED, without a message: they
 *                    differ by more than the threshold.
 */
static void compare_pictures(const Picture *a, const Picture *b, const Options *options,
                             Error *error) {
    if (a->width != b->width || a->height != b->height) {
        error_set(error, STATUS_SCENE, "%s: sizes differ: %d x %d pixels, but %s has %d x %d",
                  options->arguments[0], a->width, a->height, options->arguments[1], b->width,
                  b->height);
        return;
    }
    Picture map = {0};
    if (options->map && !picture_init(&map, a->width, a->height, error)) {
        return;
    }
    interrupt_defer(); // The map is still written after a signal: no temporary file is left.
    PictureComparison comparison = picture_compare(a, b, options->map ? &map : NULL);
    bool is_written = !options->map || image_file_write(options->map, &map, error);
    picture_deinit(&map);
    comparison_print(&comparison, options);
    if (is_written && comparison.max_difference > options->threshold) {
        error->status = STATUS_FAILED;
    }
}

void cli_compare(const Options *options, Error *error) {
    if (options->map && !image_file_check(options->map, error)) {
        return;
    }
    Picture a = {0}, b = {0};
    if (image_file_read(options->arguments[0], &a, error) &&
        image_file_read(options->arguments[1], &b, error)) {
        compare_pictures(&a, &b, options, error);
    } else if (error->status != STATUS_INTERRUPTED) {
        error->status = STATUS_UNREADABLE; // 1 would say that they differ, 3 that their sizes do.
    }
    picture_deinit(&a);
    picture_deinit(&b);
}
