/**
 * @file
 * @brief Finding the typeface.
 */
#include "view/gui/typeface.h"

#include <stddef.h>
#include <unistd.h>

/** A typeface of a folder. */
#define TYPEFACE(folder, regular_, bold_)                                                          \
    { .regular = folder regular_, .bold = folder bold_ }

/** Typefaces where distributions install them. Only DejaVu has all signs. */
static const Typeface typefaces[] = {
    TYPEFACE("/usr/share/fonts/truetype/dejavu/", "DejaVuSans.ttf", "DejaVuSans-Bold.ttf"),
    TYPEFACE("/usr/share/fonts/TTF/", "DejaVuSans.ttf", "DejaVuSans-Bold.ttf"),
    TYPEFACE("/usr/share/fonts/dejavu-sans-fonts/", "DejaVuSans.ttf", "DejaVuSans-Bold.ttf"),
    TYPEFACE("/usr/share/fonts/dejavu/", "DejaVuSans.ttf", "DejaVuSans-Bold.ttf"),
    TYPEFACE("/usr/local/share/fonts/dejavu/", "DejaVuSans.ttf", "DejaVuSans-Bold.ttf"),
    TYPEFACE("/usr/share/fonts/truetype/liberation/", "LiberationSans-Regular.ttf",
             "LiberationSans-Bold.ttf"),
    TYPEFACE("/usr/share/fonts/truetype/liberation2/", "LiberationSans-Regular.ttf",
             "LiberationSans-Bold.ttf"),
    TYPEFACE("/usr/share/fonts/liberation-sans/", "LiberationSans-Regular.ttf",
             "LiberationSans-Bold.ttf"),
    TYPEFACE("/usr/share/fonts/truetype/noto/", "NotoSans-Regular.ttf", "NotoSans-Bold.ttf"),
};

const Typeface *typeface_find(void) {
    for (size_t i = 0; i < sizeof typefaces / sizeof *typefaces; i++) {
        if (access(typefaces[i].regular, R_OK) == 0) {
            return &typefaces[i];
        }
    }
    return NULL;
}
