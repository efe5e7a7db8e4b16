/**
 * @file
 * @brief Functions shared by several commands.
 */
#include "base/language.h"
#include "base/sanitize.h"
#include "cli/commands.h"
#include "dioptre/script.h"
#include "render/z_fighting/z_fighting.h"

#include <ctype.h>
#include <libintl.h>
#include <signal.h>
#include <unistd.h>

/** Whether a signal has come, for #interrupt_flag. A signal handler can reach nothing but globals.
 */
static atomic_bool is_interrupted;
/** Whether a command looks at #is_interrupted and ends by itself. */
static atomic_bool is_awaited;

Scene *command_load_scene(const Options *options, Error *error) {
    Scene *scene = command_run_scene(
        options, &(SceneRun){.time = options->time, .stop = &is_interrupted}, error);
    if (scene) {
        command_print_notes(scene);
    }
    return scene;
}

/** Says which surfaces coincide. */
static void print_coincident(const ZFighting *found) {
    const double percent = 100 * found->coincident;
    if (found->lines[0] > 0) {
        fprintf(
            stderr,
            gettext(
                "dioptre: surfaces of lines %d and %d coincide in up to %.3g %% of the picture: "
                "rounding or their order decides which is seen\n"),
            found->lines[0], found->lines[1], percent);
    } else {
        fprintf(
            stderr,
            gettext("dioptre: two surfaces coincide in up to %.3g %% of the picture: rounding or "
                    "their order decides which is seen\n"),
            percent);
    }
}

void command_print_notes(const Scene *scene) {
    for (size_t i = 0; i < scene->note_count; i++) {
        sanitize_print_line(scene->notes[i], stderr);
        fputc('\n', stderr);
    }
    ZFighting found = z_fighting_of(scene);
    if (found.coincident >= Z_FIGHTING_COINCIDENT_SAID) {
        print_coincident(&found);
    }
}

Scene *command_run_scene(const Options *options, const SceneRun *run, Error *error) {
    MeshReadProgress mesh_progress;
    ScriptRequest request = {.path = options->arguments[0],
                             .base_dir = options->base_dir,
                             .time = run->time,
                             .time_limit = SCRIPT_TIME_LIMIT,
                             .memory_limit = SCRIPT_MEMORY_LIMIT,
                             .progress = mesh_read_progress_init(&mesh_progress, options),
                             .cache = run->cache,
                             .overrides = run->overrides,
                             .override_count = run->override_count,
                             .stop = run->stop};
    return script_load(&request, error);
}

RenderSettings command_render_settings(const Options *options, const Scene *scene) {
    RenderSettings settings = render_settings_default(scene);
    settings.engine = options->engine ? options->engine : settings.engine;
    settings.threads = options->threads ? options->threads : settings.threads;
    settings.width = options->width ? options->width : settings.width;
    settings.height = options->height ? options->height : settings.height;
    settings.samples = options->samples ? options->samples : settings.samples;
    settings.sampling = (Sampling)options->sampling;
    TraceSettings *trace = &settings.trace;
    method_set_apply((MethodSet)options->methods, &settings);
    trace->depth = options->depth >= 0 ? options->depth : trace->depth;
    trace->cutoff = options->cutoff >= 0 ? options->cutoff : trace->cutoff;
    trace->offset = options->offset >= 0 ? (OffsetStrategy)options->offset : trace->offset;
    trace->pixel_point = (PixelPoint)options->pixel;
    trace->epsilon = options->epsilon >= 0 ? options->epsilon : trace->epsilon;
    return settings;
}

void print_padded(const char *text, int width) {
    int text_width = language_text_width(text);
    printf("%s%*s", text, text_width < width ? width - text_width : 0, "");
}

/** Handles the signals that end programs. */
static void on_signal(int number) {
    (void)number;
    if (!atomic_load(&is_awaited)) {
        _exit(STATUS_INTERRUPTED); // There is no output yet.
    }
    atomic_store(&is_interrupted, true);
}

void interrupt_init(void) {
    struct sigaction action = {.sa_handler = on_signal}, hangup;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    // nohup ignores SIGHUP, so that the program survives its terminal.
    if (sigaction(SIGHUP, NULL, &hangup) == 0 && hangup.sa_handler != SIG_IGN) {
        sigaction(SIGHUP, &action, NULL);
    }
}

const atomic_bool *interrupt_flag(void) {
    atomic_store(&is_awaited, true);
    return &is_interrupted;
}
