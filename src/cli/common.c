/**
 * @file
 * @brief What the commands share.
 */
#include "cli/commands.h"
#include "dioptre/language.h"
#include "dioptre/script.h"

#include <ctype.h>
#include <signal.h>

/** Set by the signal handler; a signal handler can reach nothing else. */
static atomic_bool is_interrupted;

Scene *command_scene(const Options *options, Error *error) {
    return command_scene_at(options, options->time, NULL, NULL, error);
}

Scene *command_scene_at(const Options *options, double time, Stock *stock, const atomic_bool *stop,
                        Error *error) {
    ModelsProgress models;
    // The keywords of an engine that this processor can run: their checks are its code.
    ScriptRequest request = {.path = options->arguments[0],
                             .base_dir = options->base_dir,
                             .time = time,
                             .seconds = SCRIPT_SECONDS,
                             .memory = SCRIPT_MEMORY,
                             .shape_keywords = engine_find("auto", NULL)->shape_keywords,
                             .progress = models_progress(&models, options),
                             .stock = stock,
                             .stop = stop};
    return script_load(&request, error);
}

RenderSettings command_settings(const Options *options, const Scene *scene) {
    RenderSettings settings = render_settings_default(scene);
    settings.engine = options->engine ? options->engine : settings.engine;
    settings.threads = options->threads ? options->threads : settings.threads;
    settings.width = options->width ? options->width : settings.width;
    settings.height = options->height ? options->height : settings.height;
    settings.samples = options->samples ? options->samples : settings.samples;
    settings.sampling = options->sampling;
    TraceSettings *trace = &settings.trace;
    trace->depth = options->depth >= 0 ? options->depth : trace->depth;
    trace->offset = options->offset >= 0 ? (OffsetStrategy)options->offset : trace->offset;
    trace->epsilon = options->epsilon >= 0 ? options->epsilon : trace->epsilon;
    return settings;
}

void json_print_string(const char *text, FILE *stream) {
    fputc('"', stream);
    for (const unsigned char *c = (const unsigned char *)text; *c; c++) {
        if (*c == '"' || *c == '\\') {
            fprintf(stream, "\\%c", *c);
        } else if (*c < ' ') {
            fprintf(stream, "\\u%04x", *c);
        } else {
            fputc(*c, stream);
        }
    }
    fputc('"', stream);
}

void print_padded(const char *text, int width) {
    int letters = language_letters(text);
    printf("%s%*s", text, letters < width ? width - letters : 0, "");
}

void print_clean(const char *text, FILE *stream) {
    for (const char *c = text; *c; c++) {
        fputc(iscntrl((unsigned char)*c) ? '?' : *c, stream);
    }
}

/** Notes that the program should stop. @param number The signal. */
static void on_signal(int number) {
    (void)number;
    atomic_store(&is_interrupted, true);
}

const atomic_bool *interrupt_flag(void) {
    struct sigaction action = {.sa_handler = on_signal};
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    return &is_interrupted;
}
