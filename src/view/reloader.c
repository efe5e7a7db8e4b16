/**
 * @file
 * @brief The thread that makes scenes.
 */
#include "view/reloader.h"

#include <SDL.h>
#include <string.h>

bool reload_is_whole(const Reload *reload) {
    bool is_whole = reload->scene != NULL;
    for (size_t i = 0; i < RELOAD_PICTURES; i++) {
        const ReloadPicture *picture = &reload->pictures[i];
        is_whole = is_whole && (picture->renderer || !picture->former);
    }
    return is_whole;
}

void reload_release(Reload *reload) {
    for (size_t i = 0; i < RELOAD_PICTURES; i++) {
        renderer_destroy(reload->pictures[i].renderer);
        reload->pictures[i].renderer = NULL;
    }
    scene_destroy(reload->scene);
    reload->scene = NULL;
}

/** Makes what draws a scene. @param[in,out] reload The answer, with its scene. @param[in,out]
 *  picture Which picture. */
static void picture_make(Reload *reload, ReloadPicture *picture) {
    picture->settings = reload->asked;
    tuning_apply(&picture->tuning, &picture->settings);
    picture->renderer =
        renderer_create_after(picture->former, reload->scene, &picture->settings, &reload->error);
}

/**
 * Answers a question.
 * @param settings         How scenes are loaded and drawn.
 * @param stop             It is given up once this is true.
 * @param[in,out] reload   The question, then the answer.
 */
static void answer(const ViewSettings *settings, const atomic_bool *stop, Reload *reload) {
    const ViewRequest request = {.path = reload->path[0] ? reload->path : NULL,
                                 .time = reload->time,
                                 .is_anew = reload->is_anew};
    reload->scene =
        settings->load(settings->context, &request, stop, &reload->asked, &reload->error);
    for (size_t i = 0; reload->scene && i < RELOAD_PICTURES; i++) {
        if (reload->pictures[i].former) {
            picture_make(reload, &reload->pictures[i]);
        }
    }
}

/** The thread's life. @param context The #Reloader. @return NULL */
static void *live(void *context) {
    Reloader *reloader = context;
    pthread_mutex_lock(&reloader->mutex);
    while (!atomic_load(&reloader->is_over)) {
        if (!reloader->is_asked) {
            pthread_cond_wait(&reloader->is_told, &reloader->mutex);
            continue;
        }
        Reload reload = reloader->reload;
        pthread_mutex_unlock(&reloader->mutex);
        answer(reloader->settings, &reloader->is_over, &reload);
        pthread_mutex_lock(&reloader->mutex);
        reloader->reload = reload;
        reloader->is_asked = false;
        reloader->is_answered = true;
        SDL_Event event = {.type = reloader->event};
        SDL_PushEvent(&event);
    }
    pthread_mutex_unlock(&reloader->mutex);
    return NULL;
}

/**
 * Starts the thread, once.
 * @param[in,out] reloader  The thread.
 * @param[out] error        Why not.
 * @return Whether it runs.
 */
static bool start(Reloader *reloader, Error *error) {
    if (!reloader->is_started) {
        pthread_mutex_init(&reloader->mutex, NULL);
        pthread_cond_init(&reloader->is_told, NULL);
        int code = pthread_create(&reloader->thread, NULL, live, reloader);
        if (code != 0) {
            return error_set(error, STATUS_FAILED, "cannot start a thread: %s", error_system(code));
        }
        reloader->is_started = true;
    }
    return true;
}

bool reloader_ask(Reloader *reloader, const ViewRequest *request,
                  const ReloadPicture pictures[RELOAD_PICTURES], Error *error) {
    if (!start(reloader, error)) {
        return false;
    }
    pthread_mutex_lock(&reloader->mutex);
    Reload *question = &reloader->reload;
    *question = (Reload){.time = request->time, .is_anew = request->is_anew};
    SDL_strlcpy(question->path, request->path ? request->path : "", sizeof question->path);
    memcpy(question->pictures, pictures, sizeof question->pictures);
    reloader->is_asked = true;
    pthread_cond_signal(&reloader->is_told);
    pthread_mutex_unlock(&reloader->mutex);
    return true;
}

bool reloader_has_answer(Reloader *reloader) {
    if (!reloader->is_started) {
        return false;
    }
    pthread_mutex_lock(&reloader->mutex);
    bool is_there = reloader->is_answered;
    pthread_mutex_unlock(&reloader->mutex);
    return is_there;
}

bool reloader_is_busy(Reloader *reloader) {
    if (!reloader->is_started) {
        return false;
    }
    pthread_mutex_lock(&reloader->mutex);
    bool is_busy = reloader->is_asked || reloader->is_answered;
    pthread_mutex_unlock(&reloader->mutex);
    return is_busy;
}

bool reloader_take(Reloader *reloader, Reload *reload) {
    if (!reloader->is_started) {
        return false;
    }
    pthread_mutex_lock(&reloader->mutex);
    bool is_there = reloader->is_answered;
    if (is_there) {
        *reload = reloader->reload;
        reloader->is_answered = false;
    }
    pthread_mutex_unlock(&reloader->mutex);
    return is_there;
}

void reloader_end(Reloader *reloader) {
    if (!reloader->is_started) {
        return;
    }
    pthread_mutex_lock(&reloader->mutex);
    atomic_store(&reloader->is_over, true);
    pthread_cond_signal(&reloader->is_told);
    pthread_mutex_unlock(&reloader->mutex);
    pthread_join(reloader->thread, NULL);
    if (reloader->is_answered) {
        reload_release(&reloader->reload);
    }
    pthread_cond_destroy(&reloader->is_told);
    pthread_mutex_destroy(&reloader->mutex);
    reloader->is_started = false;
}
