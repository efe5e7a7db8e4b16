/**
 * @file
 * @brief A thread that makes another scene, or the same of another time, and what draws it, while
 *        the window lives on.
 */
#ifndef DIOPTRE_VIEW_RELOADER_H
#define DIOPTRE_VIEW_RELOADER_H

#include "dioptre/view.h"
#include "view/tuning.h"

#include <limits.h>
#include <pthread.h>

/** Pictures of a scene, at most. */
enum { RELOAD_PICTURES = 2 };

/** What draws a picture of it. */
typedef struct ReloadPicture {
    const Renderer *former;  /**< What draws the scene before; NULL: there is no such picture. */
    Tuning tuning;           /**< What the user has changed of how it is drawn. */
    RenderSettings settings; /**< How it is drawn then. */
    Renderer *renderer;      /**< What draws it; NULL: it could not be made, or is not wanted. */
} ReloadPicture;

/** Another scene, or the same of another time. */
typedef struct Reload {
    char path[PATH_MAX];  /**< Its file; empty: that of the scene before. */
    double time;          /**< Its time, seconds. */
    bool is_anew;         /**< Whether its files may have changed. */
    Scene *scene;         /**< The scene; NULL: it could not be made. */
    RenderSettings asked; /**< How it is to be drawn, but for what the user has changed. */
    ReloadPicture pictures[RELOAD_PICTURES]; /**< What draws it; the first is always wanted. */
    Error error;                             /**< Why not. */
} Reload;

/** The thread, and what it is asked. Starts as `{.settings = ...}`. */
typedef struct Reloader {
    const ViewSettings *settings; /**< How scenes are loaded and drawn. */
    uint32_t event;               /**< SDL event, registered, that tells of an answer. */
    bool is_started;              /**< Whether the thread runs. */
    pthread_t thread;             /**< The thread. */
    pthread_mutex_t mutex;        /**< Guards what follows. */
    pthread_cond_t is_told;       /**< Told when there is something to do. */
    bool is_asked;                /**< Whether there is a question that was not answered yet. */
    bool is_answered;             /**< Whether there is an answer that was not taken yet. */
    Reload reload;                /**< The question's time, then the answer. */
    atomic_bool is_over;          /**< Whether to end, at once. */
} Reloader;

/**
 * Asks for a scene. The first question starts the thread.
 * @param[in,out] reloader  The thread; every question before was answered, and the answer taken.
 * @param request           Which scene; copied.
 * @param pictures          What of it is to be drawn; copied. The new renderers share with the
 * former ones what both need: those must stay there until the answer is.
 * @param[out] error        What is wrong.
 * @return false if there is no thread to ask.
 */
bool reloader_ask(Reloader *reloader, const ViewRequest *request,
                  const ReloadPicture pictures[RELOAD_PICTURES], Error *error);

/** @return Whether there is a question or an answer that was not taken. @param reloader The thread.
 */
bool reloader_is_busy(Reloader *reloader);

/** @return Whether there is an answer that was not taken. @param reloader The thread. */
bool reloader_has_answer(Reloader *reloader);

/**
 * Takes an answer.
 * @param[in,out] reloader  The thread.
 * @param[out] reload       The answer, the caller's to give back.
 * @return false while there is none.
 */
bool reloader_take(Reloader *reloader, Reload *reload);

/** @return Whether all that was wanted is there. @param reload An answer. */
bool reload_is_whole(const Reload *reload);

/** Gives scene and renderers back. @param[in,out] reload An answer. */
void reload_release(Reload *reload);

/** Ends the thread, whatever it does. @param[in,out] reloader The thread, started or not. */
void reloader_end(Reloader *reloader);

#endif
