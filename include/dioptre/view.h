/**
 * @file
 * @brief The window.
 */
#ifndef DIOPTRE_VIEW_H
#define DIOPTRE_VIEW_H

#include "dioptre/lesson.h"
#include "dioptre/renderer.h"

/** A scene that the window wants. */
typedef struct ViewRequest {
    const char *path;  /**< Its file; NULL: that of the scene that was loaded last. */
    double time;       /**< Its `t`, seconds. */
    bool force_reload; /**< Whether its files may have changed since they were read. */
} ViewRequest;

/**
 * Loads a scene. Called from a thread of the window, never twice at once.
 * @param context      #ViewSettings.loader_context.
 * @param request      Which scene. If anything is wrong, the one before stays the last loaded.
 * @param stop         It should be given up once this is true.
 * @param[out] render  How it is to be drawn.
 * @param[out] error   What is wrong.
 * @return The scene, the window's to give back; NULL if anything is wrong.
 */
typedef Scene *(*ViewLoader)(void *context, const ViewRequest *request, const atomic_bool *stop,
                             RenderSettings *render, Error *error);

/**
 * Loads a scene that is looked at beside the one in the window. Called from a thread of the window,
 * perhaps while another one loads by a #ViewLoader.
 * @param context      #ViewSettings.loader_context.
 * @param path         Its file.
 * @param stop         It should be given up once this is true.
 * @param[out] render  How it is to be drawn.
 * @param[out] error   What is wrong.
 * @return The scene, the window's to give back; NULL if anything is wrong.
 */
typedef Scene *(*ViewPreviewLoader)(void *context, const char *path, const atomic_bool *stop,
                                    RenderSettings *render, Error *error);

/** How the window is opened. */
typedef struct ViewSettings {
    RenderSettings render;     /**< Engine, threads, size, samples, depth, offset. */
    bool keys_by_letter;       /**< The light's keys by their letters, not by their places. */
    const char *path;          /**< The scene's file, or `-`; it names title and snapshots. */
    const char *snapshot_dir;  /**< Folder for the snapshots. */
    double launch_time;        /**< Seconds on the monotonic clock when the program started. */
    double initial_time;       /**< The scene's `t` at first, seconds. */
    ViewLoader load;           /**< Loads others, or it at other times; NULL: there is no other. */
    ViewPreviewLoader preview; /**< Loads scenes for the list of scenes; NULL: there is no list. */
    void *loader_context;      /**< Handed to #load and #preview. */
    const Lesson *lesson;      /**< What is done in the window; NULL: nothing by itself. */
    const char *lesson_name;   /**< Its name, which its snapshots get. */
    const char
        *lesson_snapshot_dir; /**< Folder for the pictures of its captions: it waits for nobody,
                                and the window closes at its end; NULL: it is for people. */
    bool prints_timing;       /**< Whether first picture and latencies are said when it closes. */
} ViewSettings;

/** Most names of #view_actions, with the final NULL. */
enum { VIEW_ACTIONS_MAXIMUM = 96 };

/** Returns the names of the window's commands, for lessons. @param[out] names The names, moves
 *  first, ended by NULL; #LessonStep.action is an index into them. @return Number of moves. */
int view_actions(const char *names[VIEW_ACTIONS_MAXIMUM]);

/**
 * @return Whether a window can be opened here at all.
 */
bool view_is_possible(void);

/**
 * Shows a scene in a window until it is closed. Meanwhile SIGINT, SIGTERM and SIGHUP, unless they
 * were ignored before, close it, and a second one ends the program at once.
 * @param scene       The scene; its camera and lights are moved.
 * @param settings    How.
 * @param stop        The window closes once this is true, as soon as it wakes for any event. May be
 *                    NULL.
 * @param[out] error  What is wrong: no display, or the display went away.
 * @return What the program should end with: #STATUS_OK, #STATUS_INTERRUPTED by a signal or by
 *         `stop`, or #STATUS_FAILED. When an X server vanishes it does not return: the program ends
 *         with words and #STATUS_FAILED.
 */
Status view_run(Scene *scene, const ViewSettings *settings, const atomic_bool *stop, Error *error);

#endif
