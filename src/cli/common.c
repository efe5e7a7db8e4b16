/**
 * @file
 * @brief Functions shared by several commands.
 */
#include "base/language.h"
#include "base/sanitize.h"
#include "cli/commands.h"
#include "dioptre/script.h"
#include "render/precision_estimate.h"

#include <ctype.h>
#include <libintl.h>
#include <signal.h>
#include <unistd.h>

/** Whether a signal has come, for #interrupt_flag. A signal handler can reach nothing but globals.
 */
static atomic_bool is_interrupted;
/** Whether a command looks at #is_interrupted and ends by itself. */
static atomic_bool is_awaited;

Scene *command_load_scene(const Options *options, RenderSettings *settings, Error *error) {
    Scene *scene = command_run_scene(
        options, &(SceneRun){.time = options_time(options), .stop = &is_interrupted}, error);
    if (scene) {
        *settings = command_print_notes(options, scene);
    }
    return scene;
}

/** Begins a warning with its place in the scene file. */
static void print_place(const Options *options, int line) {
    sanitize_print_line(options->arguments[0], stderr);
    fprintf(stderr, ":%d: ", line);
}

/** Says which surfaces coincide. */
static void print_coincident(const Options *options, const ZFighting *found) {
    const double percent = 100 * found->coincident;
    if (found->lines[0] > 0) {
        print_place(options, found->lines[0]);
        fprintf(
            stderr,
            gettext(
                "surfaces of lines %d and %d coincide in up to %.3g %% of the picture: rounding "
                "or their order decides which is seen\n"),
            found->lines[0], found->lines[1], percent);
    } else {
        fprintf(
            stderr,
            gettext("dioptre: two surfaces coincide in up to %.3g %% of the picture: rounding or "
                    "their order decides which is seen\n"),
            percent);
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
                             .stop = run->stop,
                             .is_quiet = options->quiet};
    Scene *scene = script_load(&request, error);
    if (scene) {
        // What is estimated of a picture, and so its engine, depends on its size.
        scene->image.width = options->width ? options->width : scene->image.width;
        scene->image.height = options->height ? options->height : scene->image.height;
    }
    return scene;
}

/** @return The settings of a scene of that estimate, with those of the command line over them. */
static RenderSettings settings_from(const Options *options, const Scene *scene,
                                    const PrecisionEstimate *estimate) {
    RenderSettings settings = precision_estimate_settings(estimate, scene);
    settings.engine = options->engine ? options->engine : settings.engine;
    settings.threads = options->threads ? options->threads : settings.threads;
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

RenderSettings command_render_settings(const Options *options, const Scene *scene) {
    PrecisionEstimate estimate = precision_estimate_of(scene);
    return settings_from(options, scene, &estimate);
}

/** Prints the notes of a scene, and what its estimate says of its surfaces. */
static void print_notes(const Options *options, const Scene *scene,
                        const PrecisionEstimate *estimate) {
    for (size_t i = 0; i < scene->note_count; i++) {
        sanitize_print_line(scene->notes[i], stderr);
        fputc('\n', stderr);
    }
    if (estimate->z_fighting.coincident >= Z_FIGHTING_COINCIDENT_SAID) {
        print_coincident(options, &estimate->z_fighting);
    }
    if (estimate->smooth_glass_line > 0) {
        print_place(options, estimate->smooth_glass_line);
        fputs(gettext("glass with smooth normals: where they reflect a ray through its own facet, "
                      "rounding decides what is seen; flat ones do not\n"),
              stderr);
    }
    if (estimate->chaotic_fraction >= PRECISION_CHAOS_SAID) {
        fprintf(
            stderr,
            gettext("dioptre: glass that traps light on chaotic paths: some %.1g %% of the pixels "
                    "may hang on the last bit, in double too\n"),
            100 * estimate->chaotic_fraction);
    }
}

RenderSettings command_print_notes(const Options *options, const Scene *scene) {
    PrecisionEstimate estimate = precision_estimate_of(scene);
    if (!options->quiet) {
        print_notes(options, scene, &estimate);
    }
    return settings_from(options, scene, &estimate);
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

void interrupt_defer(void) {
    atomic_store(&is_awaited, true);
}

const atomic_bool *interrupt_flag(void) {
    interrupt_defer();
    return &is_interrupted;
}
