/**
 * @file
 * @brief All that an open window knows.
 */
#ifndef DIOPTRE_VIEW_STATE_H
#define DIOPTRE_VIEW_STATE_H

#include "dioptre/view.h"
#include "view/motion.h"
#include "view/player.h"
#include "view/pose.h"
#include "view/recorder.h"
#include "view/reloader.h"
#include "view/stage.h"
#include "view/timeline.h"
#include "view/watch.h"

/** Longest note in the title, bytes with the final zero; a longer one is cut. */
enum { NOTE_SIZE = 256 };
/** Longest name of a scene, bytes with the final zero; a longer one is cut. */
enum { SCENE_NAME_SIZE = 256 };

/** SDL event types of the window's own. */
typedef enum {
    EVENT_PASS,      /**< A pass has ended. */
    EVENT_SCENE,     /**< The scene that was asked for is there. */
    EVENT_FILE,      /**< The scene's file was written. */
    EVENT_LIST,      /**< There is news in the list of scenes. */
    EVENT_INTERRUPT, /**< A signal asks the program to end. */
    EVENT_COUNT      /**< How many there are. */
} EventKind;

/** An open window. */
typedef struct View {
    const ViewSettings *settings; /**< How it was opened. */
    Scene *scene;                 /**< What it shows; camera and lights are moved. */
    Scene *own_scene;             /**< The same where it is not the first; owned, else NULL. */
    Timeline timeline;            /**< What time it is. */
    double time;                  /**< The time of the scene, seconds: that of some moments ago. */
    double next_time;             /**< When a scene of another time is asked for, seconds. */
    Reloader reloader;            /**< Who makes it. */
    Watch watch;                  /**< Who tells that its file was written. */
    bool is_outdated;             /**< Whether it was. */
    bool is_wrong;                /**< Whether the newest scene could not be had. */
    char wrong_path[PATH_MAX];    /**< Its file; empty: that of the scene that is shown. */
    char next_path[PATH_MAX];     /**< File of another scene that is wanted; empty: none is. */
    char path[PATH_MAX];          /**< File of the scene that is shown, or `-`. */
    char name[SCENE_NAME_SIZE];   /**< Name of the scene: in the title and of the snapshots. */
    Pose home;                    /**< The scene's own view. */
    Stage stage;                  /**< The way from the scene to the screen. */
    Motion motion;                /**< The keys that are held. */
    Player player;                /**< The lesson that is played. */
    Recorder recorder;            /**< The lesson that is recorded. */
    size_t light;                 /**< Place of the light that the keys move. */
    double next_step;             /**< When held keys move things again, seconds. */
    bool is_click;                /**< Whether the mouse's button is down and it has not moved. */
    int click_x;                  /**< Where it went down, units of the screen. */
    int click_y;                  /**< See #click_x. */
    bool wants_snapshot;          /**< Whether a snapshot waits for the last pass. */
    char note[NOTE_SIZE];         /**< What the title says besides how the drawing stands. */
    double title_due;             /**< When the title may change again, seconds. */
    Uint32 first_event;           /**< SDL's number for #EVENT_PASS; the others follow. */
    bool is_over;                 /**< Whether the window is to be closed. */
    Status status;                /**< What the program should end with. */
} View;

/**
 * Puts a note into the title, until the next change of the view.
 * @param[in,out] view  The view.
 * @param format        The note in English, as for printf, looked up here.
 */
void view_note(View *view, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Says on standard error, in the title and over the picture what went wrong. @param[in,out] view
 *  The view. @param error What went wrong. */
void view_report(View *view, const Error *error);

/** Takes the note out of the title. @param[in,out] view The view. */
void view_hush(View *view);

/**
 * The view has changed: it is drawn anew.
 * @param[in,out] view  The view.
 */
void view_changed(View *view);

#endif
