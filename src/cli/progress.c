/**
 * @file
 * @brief Progress on standard error, with an estimate.
 */
#include "cli/commands.h"
#include "dioptre/clock.h"

#include <libintl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

/** Nanoseconds from one line to the next: five a second are smooth enough to read. */
#define PROGRESS_NANOSECONDS 200000000L

struct Progress {
    const Renderer *renderer; /**< Who draws the picture under way; NULL: nobody. */
    int pictures;             /**< How many pictures there will be. */
    int done;                 /**< How many of them are done. */
    bool is_film;             /**< Whether there are several. */
    bool is_json;             /**< JSON lines, not one line for people. */
    bool is_over;             /**< Whether to end. */
    pthread_mutex_t mutex;    /**< Guards all of it. */
    pthread_cond_t is_told;   /**< Told when it is over. */
    pthread_t thread;         /**< Who tells. */
    double start;             /**< When it began, on #clock_seconds. */
};

/** @return Seconds since the start. @param progress The progress. */
static double progress_seconds(const Progress *progress) {
    return clock_seconds() - progress->start;
}

/** @return The share of all pictures that is done, 0 to 1. @param progress The progress. */
static double progress_share(const Progress *progress) {
    double under_way = progress->renderer ? renderer_progress(progress->renderer) : 0;
    return progress->pictures > 0 ? (progress->done + under_way) / progress->pictures : 1;
}

/** Tells once. @param progress The progress. */
static void progress_tell(const Progress *progress) {
    double share = progress_share(progress), seconds = progress_seconds(progress);
    double left = share > 0 ? seconds / share - seconds : 0;
    if (progress->is_json) {
        fputc('{', stderr);
        if (progress->is_film) {
            fprintf(stderr, "\"done\": %d, \"frames\": %d, ", progress->done, progress->pictures);
        }
        fprintf(stderr, "\"share\": %.4f, \"seconds\": %.2f, \"seconds_left\": %.2f}\n", share,
                seconds, left);
    } else {
        fputc('\r', stderr);
        if (progress->is_film) {
            fprintf(stderr, gettext("%d of %d frames, "), progress->done, progress->pictures);
        }
        fprintf(stderr, gettext("%3.0f %%, %.0f s left"), 100 * share, left);
        fputs(" \033[K", stderr);
    }
    fflush(stderr);
}

/** Tells until it is over. @param argument The progress. @return NULL */
static void *progress_main(void *argument) {
    Progress *progress = argument;
    pthread_mutex_lock(&progress->mutex);
    while (!progress->is_over) {
        struct timespec until;
        clock_gettime(CLOCK_REALTIME, &until);
        until.tv_nsec += PROGRESS_NANOSECONDS;
        until.tv_sec += until.tv_nsec / 1000000000L;
        until.tv_nsec %= 1000000000L;
        pthread_cond_timedwait(&progress->is_told, &progress->mutex, &until);
        if (!progress->is_over) {
            progress_tell(progress);
        }
    }
    pthread_mutex_unlock(&progress->mutex);
    return NULL;
}

/** @return Whether progress is to be told. @param options Whether and how. */
static bool is_wanted(const Options *options) {
    bool is_read = options->progress == PROGRESS_JSON ||
                   (options->progress == PROGRESS_AUTO && isatty(STDERR_FILENO));
    return is_read && !options->quiet;
}

/**
 * Tells how far a model file is read, if that takes long enough to be felt. See MeshProgress::tell.
 * @param context  The progress.
 * @param name     The file.
 * @param share    How much is done.
 * @param seconds  Since the start.
 */
static void models_tell(void *context, const char *name, double share, double seconds) {
    /** Seconds after which people want to know. */
    const double patience = 0.5;
    ModelsProgress *models = context;
    double left = share > 0 ? seconds / share - seconds : 0;
    if (seconds < patience) {
        return;
    }
    if (models->is_json) {
        fputs("{\"model\": ", stderr);
        json_print_string(name, stderr);
        fprintf(stderr, ", \"share\": %.4f, \"seconds\": %.2f, \"seconds_left\": %.2f}\n", share,
                seconds, left);
    } else {
        fputc('\r', stderr);
        print_clean(name, stderr);
        fprintf(stderr, gettext(": %3.0f %%, %.0f s left"), 100 * share, left);
        fputs(" \033[K", stderr);
    }
    models->is_shown = true;
    fflush(stderr);
}

/** Clears the line, if there is one. See MeshProgress::end. @param context The progress. */
static void models_end(void *context) {
    ModelsProgress *models = context;
    if (models->is_shown && !models->is_json) {
        fputs("\r\033[K", stderr);
        fflush(stderr);
    }
    models->is_shown = false;
}

const MeshProgress *models_progress(ModelsProgress *models, const Options *options) {
    *models = (ModelsProgress){
        .teller = {.tell = models_tell, .end = models_end, .context = models},
        .is_json = options->progress == PROGRESS_JSON,
    };
    return is_wanted(options) ? &models->teller : NULL;
}

Progress *progress_begin(const Options *options, int pictures) {
    Progress *progress = is_wanted(options) ? calloc(1, sizeof *progress) : NULL;
    if (!progress) {
        return NULL;
    }
    progress->pictures = pictures;
    progress->is_film = pictures > 1;
    progress->is_json = options->progress == PROGRESS_JSON;
    progress->start = clock_seconds();
    pthread_mutex_init(&progress->mutex, NULL);
    pthread_cond_init(&progress->is_told, NULL);
    if (pthread_create(&progress->thread, NULL, progress_main, progress) != 0) {
        free(progress);
        return NULL;
    }
    return progress;
}

/**
 * Changes what is told.
 * @param progress  The progress, or NULL.
 * @param renderer  Who draws the picture under way; NULL: nobody.
 * @param done      How many pictures more are done.
 * @param left_out  How many pictures less there will be.
 */
static void progress_change(Progress *progress, const Renderer *renderer, int done, int left_out) {
    if (progress) {
        pthread_mutex_lock(&progress->mutex);
        progress->renderer = renderer;
        progress->done += done;
        progress->pictures -= left_out;
        pthread_mutex_unlock(&progress->mutex);
    }
}

void progress_watch(Progress *progress, const Renderer *renderer) {
    progress_change(progress, renderer, 0, 0);
}

void progress_done(Progress *progress) {
    progress_change(progress, NULL, 1, 0);
}

void progress_leave_out(Progress *progress) {
    progress_change(progress, NULL, 0, 1);
}

void progress_end(Progress *progress) {
    if (!progress) {
        return;
    }
    pthread_mutex_lock(&progress->mutex);
    progress->is_over = true;
    pthread_cond_signal(&progress->is_told);
    pthread_mutex_unlock(&progress->mutex);
    pthread_join(progress->thread, NULL);
    if (progress->is_json) {
        progress_tell(progress);
    } else {
        fputs("\r\033[K", stderr);
    }
    free(progress);
}
