/**
 * @file
 * @brief Lessons as text.
 */
#include "view/lesson/lesson_writer.h"

#include "base/language.h"
#include "dioptre/lesson.h"
#include "dioptre/offset_strategy.h"

#include <string.h>

/**
 * Puts text into quotes, as Lua reads it.
 * @param[out] out  The quoted text, cut to its size.
 * @param size  Bytes that fit, at least 3.
 */
static void quote_lua_string(char *out, size_t size, const char *text) {
    size_t used = 0;
    out[used++] = '"';
    for (const char *c = text; *c && used + 6 < size; c++) {
        if ((unsigned char)*c < ' ') {
            used += (size_t)snprintf(out + used, size - used, "\\%03d", *c);
        } else {
            const char *escape = strchr("\"\\", *c) ? "\\" : "";
            used += (size_t)snprintf(out + used, size - used, "%s%c", escape, *c);
        }
    }
    snprintf(out + used, size - used, "\"");
}

void lesson_writer_begin(FILE *file, const LessonHeader *header) {
    char scene[2 * PATH_MAX], name[2 * PATH_MAX];
    const TraceSettings *trace = &header->render->trace;
    quote_lua_string(scene, sizeof scene, header->scene);
    quote_lua_string(name, sizeof name, header->name);
    fprintf(
        file,
        "-- A lesson, recorded in the window. `dioptre view --lesson` and this file play it.\n");
    fprintf(file, "lesson {\n  scene = %s,\n  title = %s,\n", scene, name);
    fprintf(file, "  size = {%d, %d}, samples = %d,\n", header->width, header->height,
            header->render->samples);
    if (trace->depth >= 0) {
        fprintf(file, "  depth = %d,\n", trace->depth);
    }
    fprintf(file, "  offset = \"%s\", epsilon = %.17g, time = %.17g,\n}\n",
            offset_strategy_names[trace->offset], trace->epsilon, header->time);
}

void lesson_writer_wait(FILE *file, int64_t milliseconds) {
    const int64_t longest = (int64_t)(1000 * LESSON_WAIT_MAXIMUM);
    for (; milliseconds > 0; milliseconds -= longest) {
        int64_t duration = milliseconds < longest ? milliseconds : longest;
        fprintf(file, "wait(%.7g)\n", (double)duration / 1000);
    }
}

void lesson_writer_caption(char *step, size_t size, const char *caption) {
    char quoted[2048];
    quote_lua_string(quoted, sizeof quoted, caption);
    snprintf(step, size, "caption { %s = %s, wait = true }", language_is_french() ? "fr" : "en",
             quoted);
}
