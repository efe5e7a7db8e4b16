/**
 * @file
 * @brief Progress on standard error, with an estimate.
 */
#include "base/clock.h"
#include "base/json.h"
#include "base/language.h"
#include "base/sanitize.h"
#include "cli/commands.h"

#include <libintl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

/** Seconds from one report to the next: five per second are smooth enough. */
static const double PROGRESS_INTERVAL = 0.2;

struct Progress {
    const Renderer *renderer; /**< Renderer of the picture under way, or NULL. */
    ProgressItem item;        /**< What is counted. */
    int count;                /**< Number of items. */
    int done;                 /**< Number of items that are done. */
    double stopped_fraction;  /**< What is done of a picture that was stopped, 0 to 1. */
    bool tells_count;         /**< Whether the items are told: not of a single picture. */
    bool is_json;             /**< JSON lines instead of one line of text. */
    bool has_begun;           /**< Whether an item was begun or done: before, others print. */
    bool is_ended;            /**< Whether the thread is to end. */
    pthread_mutex_t mutex;    /**< Guards all members. */
    pthread_cond_t wake;      /**< Signalled at the end. */
    pthread_t thread;         /**< The thread that reports. */
    double start;             /**< Begin, on #clock_now_seconds. */
};

/** @return Seconds since the start. */
static double progress_seconds(const Progress *progress) {
    return clock_now_seconds() - progress->start;
}

/** @return The fraction of all items that is done, 0 to 1. */
static double progress_fraction(const Progress *progress) {
    double current_fraction =
        progress->renderer ? renderer_progress(progress->renderer) : progress->stopped_fraction;
    return progress->count > 0 ? (progress->done + current_fraction) / progress->count : 1;
}

/** Ends a JSON line of progress. @param fraction The fraction of the work that is done, 0 to 1. */
static void write_json_estimate(JsonWriter *json, double fraction, double seconds,
                                double seconds_left) {
    json_decimal(json, "progress", fraction, 4);
    json_decimal(json, "seconds", seconds, 2);
    json_decimal(json, "seconds_left", seconds_left, 2);
    json_line_end(json);
}

/** How items are told. */
typedef struct ItemWords {
    const char *json; /**< Name of their number in JSON. */
    const char *text; /**< Format of a text. */
} ItemWords;

/** How items are told, in the order of #ProgressItem. */
static const ItemWords item_words[] = {{"frames", N_("%d of %d frames, ")},
                                       {"tests", N_("%d of %d tests, ")},
                                       {"charts", N_("%d of %d charts, ")}};

/** Prints one report. */
static void progress_print(const Progress *progress) {
    double fraction = progress_fraction(progress), seconds = progress_seconds(progress);
    double seconds_left = fraction > 0 ? seconds / fraction - seconds : 0;
    if (progress->is_json) {
        JsonWriter json = {.stream = stderr};
        json_object_begin(&json, NULL);
        if (progress->tells_count) {
            json_integer(&json, "done", progress->done);
            json_integer(&json, item_words[progress->item].json, progress->count);
        }
        write_json_estimate(&json, fraction, seconds, seconds_left);
    } else {
        fputc('\r', stderr);
        if (progress->tells_count) {
            fprintf(stderr, gettext(item_words[progress->item].text), progress->done,
                    progress->count);
        }
        fprintf(stderr, gettext("%3.0f %%, %.0f s left"), 100 * fraction, seconds_left);
        fputs(" \033[K", stderr);
    }
    fflush(stderr);
}

/** Main function of the thread: reports until the end. @return NULL */
static void *progress_main(void *argument) {
    Progress *progress = argument;
    pthread_mutex_lock(&progress->mutex);
    while (!progress->is_ended) {
        struct timespec until = clock_deadline(PROGRESS_INTERVAL);
        pthread_cond_timedwait(&progress->wake, &progress->mutex, &until);
        if (!progress->is_ended && progress->has_begun) {
            progress_print(progress);
        }
    }
    pthread_mutex_unlock(&progress->mutex);
    return NULL;
}

bool progress_is_wanted(const Options *options) {
    bool is_shown = options->progress == PROGRESS_JSON ||
                    (options->progress == PROGRESS_AUTO && isatty(STDERR_FILENO));
    return is_shown && !options->quiet;
}

/** Prints the progress of a mesh file that takes long to read. See MeshProgress::report. @param
 *  fraction The fraction that is read, 0 to 1. */
static void mesh_read_progress_print(void *context, const char *name, double fraction,
                                     double seconds) {
    /** Seconds without a report. */
    const double delay = 0.5;
    MeshReadProgress *progress = context;
    double seconds_left = fraction > 0 ? seconds / fraction - seconds : 0;
    if (seconds < delay) {
        return;
    }
    if (progress->is_json) {
        JsonWriter json = {.stream = stderr};
        json_object_begin(&json, NULL);
        json_string(&json, "mesh", name);
        write_json_estimate(&json, fraction, seconds, seconds_left);
    } else {
        fputc('\r', stderr);
        sanitize_print_line(name, stderr);
        fprintf(stderr, gettext(": %3.0f %%, %.0f s left"), 100 * fraction, seconds_left);
        fputs(" \033[K", stderr);
    }
    progress->is_shown = true;
    fflush(stderr);
}

/** Clears the line of a mesh file, if there is one. See MeshProgress::end. */
static void mesh_read_progress_clear(void *context) {
    MeshReadProgress *progress = context;
    if (progress->is_shown && !progress->is_json) {
        fputs("\r\033[K", stderr);
        fflush(stderr);
    }
    progress->is_shown = false;
}

const MeshProgress *mesh_read_progress_init(MeshReadProgress *progress, const Options *options) {
    *progress = (MeshReadProgress){
        .callbacks = {.report = mesh_read_progress_print,
                      .end = mesh_read_progress_clear,
                      .context = progress},
        .is_json = options->progress == PROGRESS_JSON,
    };
    return progress_is_wanted(options) ? &progress->callbacks : NULL;
}

Progress *progress_begin(const Options *options, ProgressItem item, int count) {
    bool is_beside_table =
        item != PROGRESS_FRAMES && options->progress == PROGRESS_AUTO && isatty(STDOUT_FILENO);
    bool is_wanted = progress_is_wanted(options) && !is_beside_table;
    Progress *progress = is_wanted ? calloc(1, sizeof *progress) : NULL;
    if (!progress) {
        return NULL;
    }
    progress->item = item;
    progress->count = count;
    progress->tells_count = count > 1 || item != PROGRESS_FRAMES;
    progress->is_json = options->progress == PROGRESS_JSON;
    progress->start = clock_now_seconds();
    pthread_mutex_init(&progress->mutex, NULL);
    pthread_cond_init(&progress->wake, NULL);
    if (pthread_create(&progress->thread, NULL, progress_main, progress) != 0) {
        free(progress);
        return NULL;
    }
    return progress;
}

/**
 * Updates the numbers that are reported.
 * @param progress  The progress, or NULL.
 * @param renderer  Renderer of the picture under way, or NULL.
 * @param done      Items finished by this call.
 * @param skipped   Items skipped by this call.
 */
static void progress_update(Progress *progress, const Renderer *renderer, int done, int skipped) {
    if (progress) {
        pthread_mutex_lock(&progress->mutex);
        progress->renderer = renderer;
        progress->has_begun = true;
        progress->done += done;
        progress->count -= skipped;
        pthread_mutex_unlock(&progress->mutex);
    }
}

void progress_start(Progress *progress) {
    progress_update(progress, NULL, 0, 0);
}

void progress_set_renderer(Progress *progress, const Renderer *renderer) {
    progress_update(progress, renderer, 0, 0);
}

void progress_done(Progress *progress) {
    progress_update(progress, NULL, 1, 0);
}

void progress_stop(Progress *progress, double fraction) {
    if (progress) {
        pthread_mutex_lock(&progress->mutex);
        progress->renderer = NULL;
        progress->stopped_fraction = fraction;
        pthread_mutex_unlock(&progress->mutex);
    }
}

void progress_skip(Progress *progress) {
    progress_update(progress, NULL, 0, 1);
}

void progress_end(Progress *progress) {
    if (!progress) {
        return;
    }
    pthread_mutex_lock(&progress->mutex);
    progress->is_ended = true;
    pthread_cond_signal(&progress->wake);
    pthread_mutex_unlock(&progress->mutex);
    pthread_join(progress->thread, NULL);
    if (progress->is_json) {
        progress_print(progress);
    } else {
        fputs("\r\033[K", stderr);
    }
    free(progress);
}
