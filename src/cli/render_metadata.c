/**
 * @file
 * @brief Metadata of a rendered picture.
 */
#include "cli/render_metadata.h"

#include "base/base_name.h"
#include "base/exact_digits.h"
#include "cli/commands.h"
#include "dioptre/scene.h"

#include <ctype.h>
#include <stdarg.h>
#include <string.h>

/** Adds an entry. Other than printable ASCII becomes `?`, as not every file format names its
 *  encoding. @param format The text, as for printf. */
__attribute__((format(printf, 3, 4))) static void
add_entry(RenderMetadata *metadata, const char *name, const char *format, ...) {
    char *text = metadata->texts[metadata->count];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, RENDER_METADATA_TEXT_SIZE, format, arguments);
    va_end(arguments);
    for (char *c = text; *c; c++) {
        *c = isascii(*c) && isprint(*c) ? *c : '?';
    }
    metadata->entries[metadata->count++] = (MetadataEntry){name, text};
}

/** @return A file's name without its folder. @param path The file; `-` is standard input. */
static const char *base_name_of(const char *path) {
    return strcmp(path, "-") == 0 ? "standard input" : base_name(path);
}

void render_metadata_init(RenderMetadata *metadata, const Options *options, double time,
                          const RenderSettings *settings) {
    const char *scene = base_name_of(options->arguments[0]);
    const TraceSettings *trace = &settings->trace;
    const char *sampling = sampling_words[settings->sampling];
    const int time_digits = exact_digits(time, 1);
    char offset[64];
    *metadata = (RenderMetadata){.count = 0};
    int length = snprintf(offset, sizeof offset, "%s", offset_strategy_names[trace->offset]);
    if (trace->offset == OFFSET_FIXED) {
        snprintf(offset + length, sizeof offset - (size_t)length, " %g", trace->epsilon);
    }
    add_entry(metadata, "Software", "dioptre " DIOPTRE_VERSION);
    // JPEG keeps the description only.
    add_entry(metadata, "ImageDescription",
              "scene %s, time %.*g s, engine %s, %dx%d, samples %d, depth %d, offset %s, "
              "cutoff %g, sampling %s, methods %s, pixel %s",
              scene, time_digits, time, settings->engine->name, settings->width, settings->height,
              settings->samples, trace->depth, offset, trace->cutoff, sampling,
              method_set_words[settings->method_set], pixel_point_words[trace->pixel_point]);
    add_entry(metadata, "dioptre:scene", "%s", scene);
    add_entry(metadata, "dioptre:time", "%.*g", time_digits, time);
    add_entry(metadata, "dioptre:engine", "%s", settings->engine->name);
    add_entry(metadata, "dioptre:size", "%dx%d", settings->width, settings->height);
    add_entry(metadata, "dioptre:samples", "%d", settings->samples);
    add_entry(metadata, "dioptre:depth", "%d", trace->depth);
    add_entry(metadata, "dioptre:offset", "%s", offset);
    add_entry(metadata, "dioptre:cutoff", "%g", trace->cutoff);
    add_entry(metadata, "dioptre:sampling", "%s", sampling);
    add_entry(metadata, "dioptre:methods", "%s", method_set_words[settings->method_set]);
    add_entry(metadata, "dioptre:pixel", "%s", pixel_point_words[trace->pixel_point]);
}
