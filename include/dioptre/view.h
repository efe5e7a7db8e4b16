/**
 * @file
 * @brief The window.
 */
#ifndef DIOPTRE_VIEW_H
#define DIOPTRE_VIEW_H

#include "dioptre/lesson.h"
#include "dioptre/renderer.h"
#include "dioptre/scene_override.h"

/** A request of the window for a scene. */
typedef struct ViewRequest {
    const char *path;  /**< Its file, or that of a lesson; NULL: the scene that was loaded last. */
    double time;       /**< Its `t`, seconds. */
    bool force_reload; /**< Whether its files may have changed since they were read. */
    bool is_lesson_over;            /**< Whether no lesson plays that the scene was loaded with. */
    const SceneOverride *overrides; /**< Values in place of those of its file; NULL: none. */
    size_t override_count;          /**< Their number, at most #SCENE_OVERRIDES_MAXIMUM. */
} ViewRequest;

/**
 * Loads a scene, or a lesson with its scene. Called from a thread of the window, never twice at
 * once.
 * @param context      #ViewSettings.loader_context.
 * @param request      The scene. After an error the previous scene stays the last loaded.
 * @param stop         Loading stops once this is true.
 * @param[out] render  Its render settings, with those of its lesson.
 * @param[out] own     The same without those of a lesson.
 * @param[out] lesson  The lesson, owned by the window; NULL: the file is a scene, or an error.
 * @param[out] error   What is wrong.
 * @return The scene, owned by the window; NULL after an error.
 */
typedef Scene *(*ViewLoader)(void *context, const ViewRequest *request, const atomic_bool *stop,
                             RenderSettings *render, RenderSettings *own, Lesson **lesson,
                             Error *error);

/**
 * Loads a scene for the list of scenes, or the scene of a lesson. Called from a thread of the
 * window, perhaps during a #ViewLoader.
 * @param context      #ViewSettings.loader_context.
 * @param path         Its file, or that of the lesson.
 * @param stop         Loading stops once this is true.
 * @param[out] render  Its render settings.
 * @param[out] error   What is wrong.
 * @return The scene, owned by the window; NULL after an error.
 */
typedef Scene *(*ViewPreviewLoader)(void *context, const char *path, const atomic_bool *stop,
                                    RenderSettings *render, Error *error);

/**
 * Loads a lesson for the list of scenes, without its scene. Called from a thread of the window.
 * @param path        The file; see #lesson_file_is.
 * @param[out] error  What is wrong.
 * @return The lesson with #Lesson.title and #Lesson.scene, to be freed with #lesson_destroy; NULL
 *         after an error.
 */
typedef Lesson *(*ViewLessonLoader)(const char *path, Error *error);

/** Settings of a window. */
typedef struct ViewSettings {
    RenderSettings render;     /**< Engine, threads, size, samples, depth, offset. */
    const RenderSettings *own; /**< The same without those of #lesson; NULL: #render. */
    bool keys_by_letter;       /**< Whether the light's keys go by their letters instead of their
                                  positions. */
    const char *path;          /**< The scene's file, or `-`; it names title and snapshots. */
    const char *snapshot_dir;  /**< Folder for the snapshots. */
    double launch_time;        /**< Start of the program, seconds on the monotonic clock. */
    double initial_time;       /**< The scene's `t` at the start, seconds. */
    ViewLoader load;           /**< Loads other scenes and times; NULL: there are none. */
    ViewPreviewLoader preview; /**< Loads scenes for the list of scenes; NULL: there is no list. */
    void *loader_context;      /**< First argument of #load and #preview. */
    ViewLessonLoader load_lesson;    /**< Loads lessons for the list of scenes; NULL: none. */
    const Lesson *lesson;            /**< A lesson to play; NULL: none. */
    const char *lesson_path;         /**< Its file. */
    const char *lesson_snapshot_dir; /**< Folder for the pictures of the lesson's captions: it plays
                                        unattended, and the window closes at its end. NULL: it is
                                        for viewers. */
    const char *predictions; /**< Choices of an unattended lesson's questions, a digit each; the
                                  questions after them are answered right. NULL: all are. */
    const char *answer_path; /**< File to which answers are appended; NULL: they are not kept. */
    bool opens_list;         /**< Whether the list of scenes is open at first. */
    bool prints_timing;      /**< Whether latencies are printed when the window closes. */
} ViewSettings;

/** Largest number of names of #view_actions, with the final NULL. */
enum { VIEW_ACTIONS_MAXIMUM = 96 };

/**
 * Returns the names of the window's commands, for lessons.
 * @param[out] names  The names, moves first, ended by NULL; #LessonStep.action is an index into
 *                    them.
 * @return Number of moves.
 */
int view_actions(const char *names[VIEW_ACTIONS_MAXIMUM]);

/** @return Whether a window can be opened here. */
bool view_is_possible(void);

/**
 * Shows a scene in a window until it is closed. SIGINT, SIGTERM and SIGHUP, unless they were
 * ignored before, close it; a second one ends the program at once.
 * @param scene       The scene; its camera and lights are moved.
 * @param settings    The settings of the window.
 * @param stop        The window closes at the next event once this is true. May be NULL.
 * @param[out] error  What is wrong: no display, or no memory.
 * @return The exit status: #STATUS_OK, #STATUS_INTERRUPTED by a signal or by `stop`, or
 *         #STATUS_FAILED. It does not return when an X server vanishes: the program ends with a
 *         message and #STATUS_FAILED.
 */
Status view_run(Scene *scene, const ViewSettings *settings, const atomic_bool *stop, Error *error);

#endif
