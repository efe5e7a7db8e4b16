/**
 * @file
 * @brief All that an open window knows.
 */
#ifndef DIOPTRE_VIEW_APP_H
#define DIOPTRE_VIEW_APP_H

#include "dioptre/view.h"
#include "view/commands/timeline.h"
#include "view/commands/view_state.h"
#include "view/input/held_keys.h"
#include "view/lesson/player.h"
#include "view/lesson/recorder.h"
#include "view/loading/file_watcher.h"
#include "view/loading/scene_loader.h"
#include "view/window/window.h"

/** Longest note in the title, bytes with the final zero; a longer one is cut. */
enum { STATUS_TEXT_SIZE = 256 };
/** Longest name of a scene, bytes with the final zero; a longer one is cut. */
enum { SCENE_NAME_SIZE = 256 };

/** SDL event types of the window's own. */
typedef enum {
    EVENT_PASS_FINISHED,      /**< A pass has ended. */
    EVENT_SCENE_LOADED,       /**< The scene that was asked for is there. */
    EVENT_FILE_CHANGED,       /**< The scene's file was written. */
    EVENT_SCENE_LIST_CHANGED, /**< There is news in the list of scenes. */
    EVENT_SIGNAL,             /**< A signal asks the program to end. */
    EVENT_COUNT               /**< How many there are. */
} AppEvent;

/** An open window. */
typedef struct App {
    const ViewSettings *settings; /**< How it was opened. */
    Scene *scene;                 /**< What it shows; camera and lights are moved. */
    Scene *owned_scene;           /**< The same where it is not the first; owned, else NULL. */
    Timeline timeline;            /**< What time it is. */
    double scene_time;            /**< The time of the scene, seconds: that of some moments ago. */
    double next_load_time;        /**< When a scene of another time is asked for, seconds. */
    SceneLoader loader;           /**< Who makes it. */
    FileWatcher watcher;          /**< Who tells that its file was written. */
    bool is_file_changed;         /**< Whether it was. */
    bool has_load_error;          /**< Whether the newest scene could not be had. */
    char failed_path[PATH_MAX];   /**< Its file; empty: that of the scene that is shown. */
    char next_path[PATH_MAX];     /**< File of another scene that is wanted; empty: none is. */
    char path[PATH_MAX];          /**< File of the scene that is shown, or `-`. */
    char name[SCENE_NAME_SIZE];   /**< Name of the scene: in the title and of the snapshots. */
    ViewState home_view;          /**< The scene's own view. */
    Window window;                /**< The way from the scene to the screen. */
    HeldKeys held_keys;           /**< The keys that are held. */
    Player player;                /**< The lesson that is played. */
    Recorder recorder;            /**< The lesson that is recorded. */
    size_t selected_light;        /**< Place of the light that the keys move. */
    double next_move_time;        /**< When held keys move things again, seconds. */
    bool is_click_candidate;      /**< Whether the mouse's button is down and it has not moved. */
    int click_x;                  /**< Where it went down, units of the screen. */
    int click_y;                  /**< See #click_x. */
    bool wants_snapshot;          /**< Whether a snapshot waits for the last pass. */
    char status_text[STATUS_TEXT_SIZE]; /**< What the title says besides how the drawing stands. */
    double next_title_time;             /**< When the title may change again, seconds. */
    Uint32 first_event; /**< SDL's number for #EVENT_PASS_FINISHED; the others follow. */
    bool should_quit;   /**< Whether the window is to be closed. */
    Status exit_status; /**< What the program should end with. */
} App;

/** Puts a note into the title, until the next change of the view. @param format The note in
 *  English, as for printf, looked up here. */
void app_set_status(App *app, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Says on standard error, in the title and over the picture what went wrong. */
void app_report_error(App *app, const Error *error);

/** Takes the note out of the title. */
void app_clear_status(App *app);

/** The view has changed: it is drawn anew. */
void app_on_view_changed(App *app);

#endif
