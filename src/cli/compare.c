/**
 * @file
 * @brief `dioptre compare`: how two pictures differ.
 */
#include "base/language.h"
#include "cli/commands.h"
#include "dioptre/image_file.h"

#include <libintl.h>
#include <stdio.h>

/** Exit statuses of `compare` that other commands do not have. */
enum {
    COMPARE_DIFFERENT = 1,     /**< They differ by more than the threshold. */
    COMPARE_SIZE_MISMATCH = 3, /**< Their sizes differ. */
    COMPARE_UNREADABLE = 4     /**< One of them cannot be read. */
};

/** Prints a comparison. */
static void comparison_print(const PictureComparison *c, const Options *options) {
    if (options->json) {
        printf("{\"width\": %d, \"height\": %d, \"worst_step\": %d, \"share_off\": %.9g, "
               "\"rmse\": %.9g, \"psnr\": ",
               c->width, c->height, c->max_difference, c->differing_fraction, c->rmse);
        // JSON has no infinity: equal pictures have no ratio of signal to noise.
        isfinite(c->psnr) ? printf("%.9g}\n", c->psnr) : printf("null}\n");
    } else if (!options->quiet) {
        printf(gettext("worst step   %d of 255\n"), c->max_difference);
        printf(gettext("pixels off   %.4f %% by more than one step\n"),
               100 * c->differing_fraction);
        printf(gettext("RMSE         %.3g of linear light\n"), c->rmse);
        isfinite(c->psnr) ? printf(gettext("PSNR         %.1f dB\n"), c->psnr)
                          : printf(gettext("PSNR         infinite: the pictures are equal\n"));
    }
}

/** Compares two pictures that were read. @return The exit status. */
static int compare_pictures(const Picture *a, const Picture *b, const Options *options,
                            Error *error) {
    if (a->width != b->width || a->height != b->height) {
        error_set(error, STATUS_FAILED, "sizes differ: %s has %d x %d pixels, %s has %d x %d",
                  options->arguments[0], a->width, a->height, options->arguments[1], b->width,
                  b->height);
        return COMPARE_SIZE_MISMATCH;
    }
    Picture map = {0};
    if (options->map && !picture_init(&map, a->width, a->height, error)) {
        return STATUS_FAILED;
    }
    PictureComparison comparison = picture_compare(a, b, options->map ? &map : NULL);
    bool is_written = !options->map || image_file_write(options->map, &map, error);
    picture_deinit(&map);
    comparison_print(&comparison, options);
    return !is_written                                      ? (int)error->status
           : comparison.max_difference > options->threshold ? COMPARE_DIFFERENT
                                                            : STATUS_OK;
}

/** Compares two files. See #Command.run. @return The exit status. */
static int compare_run(const Options *options, Error *error) {
    Picture a = {0}, b = {0};
    int status = COMPARE_UNREADABLE;
    if (image_file_read(options->arguments[0], &a, error) &&
        image_file_read(options->arguments[1], &b, error)) {
        status = compare_pictures(&a, &b, options, error);
    }
    picture_deinit(&a);
    picture_deinit(&b);
    return status;
}

const Command compare_command = {.name = "compare",
                                 .usage = N_("A B"),
                                 .help = N_("says how two pictures differ"),
                                 .accepts = "TMJq",
                                 .arguments = 2,
                                 .run = compare_run};
