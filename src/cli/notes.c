/**
 * @file
 * @brief What a picture file says of how its picture came about.
 */
#include "cli/notes.h"

#include "cli/commands.h"
#include "dioptre/offset.h"

#include <ctype.h>
#include <stdarg.h>
#include <string.h>

/**
 * Adds a note. Of what is not printable ASCII, not every format can tell what it means.
 * @param[in,out] notes  The notes.
 * @param name           What it is.
 * @param format         The text, as for printf.
 */
__attribute__((format(printf, 3, 4))) static void note(Notes *notes, const char *name,
                                                       const char *format, ...) {
    char *text = notes->texts[notes->count];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, NOTE_SIZE, format, arguments);
    va_end(arguments);
    for (char *c = text; *c; c++) {
        *c = isascii(*c) && isprint(*c) ? *c : '?';
    }
    notes->rows[notes->count++] = (PictureNote){name, text};
}

/** @return A file's name without its folder. @param path The file; `-` is standard input. */
static const char *name_of(const char *path) {
    const char *slash = strrchr(path, '/');
    return strcmp(path, "-") == 0 ? "standard input" : slash ? slash + 1 : path;
}

void notes_make(Notes *notes, const Options *options, double time, const RenderSettings *settings) {
    const char *scene = name_of(options->arguments[0]);
    const TraceSettings *trace = &settings->trace;
    char offset[64];
    *notes = (Notes){.count = 0};
    int length = snprintf(offset, sizeof offset, "%s", offset_names[trace->offset]);
    if (trace->offset == OFFSET_FIXED) {
        snprintf(offset + length, sizeof offset - (size_t)length, " %g", trace->epsilon);
    }
    note(notes, "Software", "dioptre " DIOPTRE_VERSION);
    note(notes, "ImageDescription",
         "scene %s, time %g s, engine %s, %dx%d, samples %d, depth %d, offset %s", scene, time,
         settings->engine->name, settings->width, settings->height, settings->samples, trace->depth,
         offset);
    note(notes, "dioptre:scene", "%s", scene);
    note(notes, "dioptre:time", "%g", time);
    note(notes, "dioptre:engine", "%s", settings->engine->name);
    note(notes, "dioptre:size", "%dx%d", settings->width, settings->height);
    note(notes, "dioptre:samples", "%d", settings->samples);
    note(notes, "dioptre:depth", "%d", trace->depth);
    note(notes, "dioptre:offset", "%s", offset);
}
