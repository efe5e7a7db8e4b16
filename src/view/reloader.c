/**
 * @file
 * @brief The thread that makes scenes.
 */
#include "view/reloader.h"

#include <SDL.h>
#include <string.h>

/**
 * Answers a question.
 * @param settings         How scenes are loaded and drawn.
 * @param former           What draws the scene before.
 * @param stop             It is given up once this is true.
 * @param[in,out] reload   The question, then the answer.
 */
static void answer(const ViewSettings *settings, const Renderer *former, const atomic_bool *stop,
                   Reload *reload) {
    RenderSettings render;
    const ViewRequest request = {.path = reload->path[0] ? reload->path : NULL,
                                 .time = reload->time,
                                 .is_anew = reload->is_anew};
    reload->scene = settings->load(settings->context, &request, stop, &render, &reload->error);
    if (reload->scene) {
        reload->renderer = renderer_create_after(former, reload->scene, &render, &reload->error);
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
        const Renderer *former = reloader->former;
        pthread_mutex_unlock(&reloader->mutex);
        answer(reloader->settings, former, &reloader->is_over, &reload);
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

bool reloader_ask(Reloader *reloader, const ViewRequest *request, const Renderer *former,
                  Error *error) {
    if (!start(reloader, error)) {
        return false;
    }
    pthread_mutex_lock(&reloader->mutex);
    Reload *question = &reloader->reload;
    *question = (Reload){.time = request->time, .is_anew = request->is_anew};
    SDL_strlcpy(question->path, request->path ? request->path : "", sizeof question->path);
    reloader->former = former;
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
        renderer_destroy(reloader->reload.renderer);
        scene_destroy(reloader->reload.scene);
    }
    pthread_cond_destroy(&reloader->is_told);
    pthread_mutex_destroy(&reloader->mutex);
    reloader->is_started = false;
}
