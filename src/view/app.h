/**
 * @file
 * @brief The state of an open window, and the functions that everything in the window shares.
 *
 * The parts of src/view, from the bottom; each includes only parts above it in this list:
 *
 *     state/      screen-independent state: commands' type, held keys, clocks, overrides, edits
 *     window/     SDL: the window, textures, viewports (Window > Viewport > StreamingTexture)
 *     gui/        buttons, lists and marks: a C header over Dear ImGui
 *     loading/    threads: scene loader, list of scenes, file watcher, error meter
 *     panels/     what lies over the picture: bar, help, legends, rays, inspector, lesson, scenes
 *     window.h    the viewports and panels of one window
 *     app.h       all of that with scene, time, lesson and input: this file
 *     commands/   the table of commands, what they do, the scene on screen, the recorder
 *     lesson/     the player: it issues commands
 *     input/      keyboard, mouse, window events: they issue commands
 *     view.c      the event loop
 *
 * test_view checks this list against the `#include` lines.
 */
#ifndef DIOPTRE_VIEW_APP_H
#define DIOPTRE_VIEW_APP_H

#include "base/language.h"
#include "dioptre/view.h"
#include "view/loading/file_watcher.h"
#include "view/loading/scene_loader.h"
#include "view/state/clocks.h"
#include "view/state/command.h"
#include "view/state/edit_history.h"
#include "view/state/view_history.h"
#include "view/window.h"

#include <sys/stat.h>

/** Longest status in the title, bytes with the final zero; a longer one is cut. */
enum { STATUS_TEXT_SIZE = 256 };
/** Longest name of a scene, bytes with the final zero; a longer one is cut. */
enum { SCENE_NAME_SIZE = 256 };
/** Bytes of a caption that is typed, with the final zero. */
enum { CAPTION_INPUT_SIZE = 512 };

/** The caret of a caption that is typed. */
#define CARET "\xe2\x96\x8f"

/** SDL event types of the window's own, from #App.first_event on. */
typedef enum {
    EVENT_PASS_FINISHED,      /**< A render pass has finished. */
    EVENT_SCENE_LOADED,       /**< The requested scene is loaded. */
    EVENT_FILE_CHANGED,       /**< The scene's file was written. */
    EVENT_SCENE_LIST_CHANGED, /**< The list of scenes has changed. */
    EVENT_SIGNAL,             /**< A signal asks the program to end. */
    EVENT_COUNT               /**< Number of events. */
} AppEvent;

/** When a file was written last. */
typedef struct FileStamp {
    struct timespec time; /**< When. */
    off_t size;           /**< Its bytes. */
    ino_t inode;          /**< Which file it was. */
} FileStamp;

/** Where the scene comes from, and the next one. */
typedef struct SceneSource {
    char path[PATH_MAX];                          /**< File of the scene on screen, or `-`. */
    char name[SCENE_NAME_SIZE];                   /**< Its name, for the snapshots. */
    char labels[LANGUAGE_COUNT][SCENE_NAME_SIZE]; /**< Its names for readers, by
                                                       #language_is_french. */
    Scene *owned;                /**< The scene on screen; NULL: it is the first, the caller's. */
    Lesson *lesson;              /**< The lesson that was loaded with it and waits for the player;
                                      owned; NULL: none. */
    char lesson_path[PATH_MAX];  /**< Its file. */
    SceneLoader loader;          /**< Loads the next scene. */
    FileWatcher watcher;         /**< Reports that the file was written. */
    bool is_file_changed;        /**< Whether it was, since the last request. */
    bool has_load_error;         /**< Whether the newest scene could not be loaded. */
    char failed_path[PATH_MAX];  /**< Its file; empty: #path. */
    char next_path[PATH_MAX];    /**< File of the scene to load next; empty: none. */
    double next_load_time;       /**< Earliest time of the next request, seconds. */
    FileStamp stamp;             /**< When the scene's file was written, as far as is known. */
    FileStamp requested_stamp;   /**< The same when its text was last requested; zero: that text was
                                      faulty. */
    FileStamp shown_stamp;       /**< The same of the text of the scene on screen. */
    uint64_t requested_revision; /**< #EditHistory.revision of the last request. */
    uint64_t shown_revision;     /**< The same of the scene on screen, or of a faulty one. */
} SceneSource;

/** How the mouse moves the camera. */
typedef enum {
    CAMERA_IS_FREE,   /**< It does not, but for the left button. */
    CAMERA_IS_TURNED, /**< Around a point. */
    CAMERA_IS_PANNED  /**< In the plane of its picture, so that a point stays under the mouse. */
} CameraDrag;

/** What keyboard and mouse are doing. */
typedef struct InputState {
    HeldKeys held_keys;                      /**< The keys that are held. */
    const Command *moves[SDL_NUM_SCANCODES]; /**< The move that a key began, by its place, until it
                                                  goes up; NULL: none. */
    CameraMotion camera_motion;              /**< How keys move the camera. */
    double next_move_time;                   /**< When held keys move things again, seconds. */
    bool is_click_candidate; /**< Whether the mouse button is down and the mouse has not moved. */
    int click_x;             /**< Where it went down, screen units. */
    int click_y;             /**< The same. */
    unsigned modifiers;      /**< SDL's modifiers at the last key event: in the order of events. */
    bool is_light_dragged;   /**< Whether the mouse drags a light. */
    size_t dragged_light;    /**< Index of that light. */
    bool is_object_dragged;  /**< Whether the mouse drags the selected shape. */
    Vec3d dragged_point;     /**< Where the mouse holds it, scene units. */
    CameraDrag camera_drag;  /**< How the mouse moves the camera. */
    Uint8 camera_button;     /**< The button that holds #camera_drag; 0: none. */
    Vec3d camera_point;      /**< The point of #camera_drag, scene units. */
    bool is_pinching;        /**< Whether two fingers touch the picture. */
    float pinch_x;           /**< Their middle, fraction of the touch device's width. */
    float pinch_y;           /**< The same of its height. */
    bool has_dragged;        /**< Whether light or shape have moved since the button went down. */
} InputState;

/** What a lesson does. */
typedef enum {
    PLAYER_RUNS,       /**< Its clock runs. */
    PLAYER_WAITS,      /**< It waits for Space. */
    PLAYER_ASKS,       /**< It waits for an answer. */
    PLAYER_CAPTURES,   /**< It waits for the finished picture, to save it. */
    PLAYER_IS_FINISHED /**< It is over: its end card is shown. */
} PlayerState;

/** A lesson that plays. Starts as `{0}`: none. */
typedef struct Player {
    const Lesson *lesson;       /**< The lesson; NULL: none. */
    Lesson *owned;              /**< The same, if it was opened in the window; owned. */
    char path[PATH_MAX];        /**< Its file. */
    char name[SCENE_NAME_SIZE]; /**< Its name, for its pictures and answers. */
    char next_path[PATH_MAX];   /**< File of the lesson after it, once it is finished; empty:
                                     none. */
    PlayerState state;          /**< What it does. */
    StepClock step_clock;       /**< Its clock. */
    size_t next_step;           /**< Index of its next step. */
    size_t stop;                /**< Index of the caption, question or explanation on screen;
                                     #LESSON_STEPS_MAXIMUM: none yet. */
    size_t repeat_end;          /**< Steps up to this index are done at once, without stops; 0:
                                     none. */
    int answers[LESSON_QUESTIONS_MAXIMUM]; /**< Chosen answers, from 1; 0: none yet. */
    double initial_time;                   /**< The scene's time at its beginning, seconds. */
    double start_time;        /**< When its clock was 0, seconds on #clock_now_seconds. */
    double stop_time;         /**< When it came to the stop, on the same clock; 0: the viewer went
                                   there. */
    bool is_leaving;          /**< Whether the viewer has asked to end it. */
    ViewState paused_view;    /**< Camera and lights when it was paused; owned. */
    size_t paused_light;      /**< The selected light at that time. */
    Timeline paused_timeline; /**< The scene's time at that time. */
} Player;

/** A lesson that is recorded. Starts as `{0}`: none. */
typedef struct Recorder {
    FILE *stream;                     /**< Writes #text; NULL: nothing is recorded. */
    char *text;                       /**< Text of the lesson; owned. */
    size_t size;                      /**< Its bytes. */
    StepClock step_clock;             /**< Its clock. */
    int64_t last_step_time;           /**< Time of the last step, milliseconds. */
    double start_time;                /**< When its clock was 0, seconds on #clock_now_seconds. */
    bool is_entering_caption;         /**< Whether a caption is typed: the clock is paused. */
    char caption[CAPTION_INPUT_SIZE]; /**< What is typed so far, UTF-8. */
    char shown[CAPTION_INPUT_SIZE + sizeof CARET]; /**< The same with a caret. */
} Recorder;

/** @return Whether a message still holds. */
typedef bool StatusHoldsFn(const App *app);

/** The title of the window. */
typedef struct TitleState {
    char status_text[STATUS_TEXT_SIZE]; /**< Its last part: the newest message; empty: none. */
    StatusHoldsFn *holds;    /**< Until when it holds; NULL: it says nothing that ends. */
    double next_update_time; /**< Earliest time of its next change, seconds. */
} TitleState;

/** The end of the program. */
typedef struct ExitState {
    bool is_requested;    /**< Whether the window is to be closed. */
    Status status;        /**< Exit status of the program. */
    const char *question; /**< What was asked before leaving, in English; NULL: nothing. */
} ExitState;

/** The state of an open window. */
typedef struct App {
    const ViewSettings *settings; /**< How it was opened. */
    const Command *commands;      /**< All commands, see #command_table. */
    Window window;                /**< The picture and the panels on screen. */
    Scene *scene;                 /**< The scene on screen; its camera and lights are moved. */
    SceneSource source;           /**< Where it comes from. */
    double scene_time;            /**< Time of #scene, seconds; #timeline may be ahead. */
    Timeline timeline;            /**< The scene's time. */
    ViewState home_view;          /**< Camera and lights as the scene file has them. */
    size_t selected_light;        /**< Index of the light that keys move. */
    ViewHistory moves;            /**< How the user has moved camera and lights, and what of the
                                       pictures was chosen. */
    EditHistory edits;            /**< What the user has changed of its objects. */
    InputState input;             /**< Keyboard and mouse. */
    Player player;                /**< The lesson that plays. */
    Recorder recorder;            /**< The lesson that is recorded. */
    TitleState title;             /**< The window's title. */
    bool wants_snapshot;          /**< Whether a snapshot waits for the last pass. */
    bool wants_list;              /**< Whether the list of scenes opens with the widgets. */
    Uint32 first_event;           /**< SDL's number of #EVENT_PASS_FINISHED; the others follow. */
    ExitState exit;               /**< Whether and how the program ends. */
} App;

/* --- messages --------------------------------------------------------------------------------- */

/** Shows a status in the title, until the view changes, and for a while on the picture. @param
 * format In English, as for printf; translated here. */
void app_set_status(App *app, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Shows a status in the title alone. @param text In English; translated here. */
void app_set_title_status(App *app, const char *text);

/** Shows a status that goes, in the title and on the picture, once it does not hold any more.
 *  @param text In English; translated here. */
void app_set_status_while(App *app, StatusHoldsFn *holds, const char *text);

/** Takes the status away if it does not hold any more. */
void app_update_status(App *app);

/** Tells the window what it shows beside its pictures. */
void app_sync_window(App *app);

/** Removes the status from the title. */
void app_clear_status(App *app);

/** Reports an error on standard error, in the title and over the picture. */
void app_report_error(App *app, const Error *error);

/** Shows the notes of the scene in the title and over the picture, until the view changes. The
 *  loader has printed them. */
void app_show_notes(App *app);

/* --- time ------------------------------------------------------------------------------------- */

/** @return Whether a lesson plays, and is not over. */
bool app_is_playing(const App *app);

/** @return Whether a lesson plays and its clock is paused. */
bool app_is_lesson_stopped(const App *app);

/** @return Whether a lesson is recorded. */
bool app_is_recording(const App *app);

/** @return Now on the clock that the scene's time follows, seconds: the lesson's clock, or
 *  #clock_now_seconds. */
double app_clock(const App *app);

/** @return The scene's time as it should be now, seconds. */
double app_scene_time(const App *app);

/** @return Whether the scene depends on time, and can be loaded for other times. */
bool app_is_animated(const App *app);

/** @return Whether the time is paused, and the scene on screen is of that time and has all changes
 *  of its objects. */
bool app_is_time_settled(const App *app);

/* --- the view --------------------------------------------------------------------------------- */

/** The view has changed: the picture is drawn again. */
void app_on_view_changed(App *app);

/** Moves the selected light and the camera along the axes of the picture. While rays are shown, it
 *  moves the second camera. */
void app_move(App *app, Movement light, Movement camera);

/** Moves a light. @param light Its index; it becomes the selected light. @param offset How far,
 * scene units. */
void app_drag_light(App *app, size_t light, Vec3d offset);

/** Turns the camera, or the second camera around the rays. @param right Degrees to the right.
 *  @param up Degrees up. */
void app_turn(App *app, double right, double up);

/** Rotates the camera around a point; or the second camera around the rays, while they are shown.
 *  @param right Degrees to the right. @param up Degrees up. @param center Scene units. */
void app_orbit(App *app, double right, double up, Vec3d center);

/** Moves the camera in the plane of its picture, unless rays are shown. @param right Scene units.
 *  @param up Scene units. */
void app_pan(App *app, double right, double up);

/** Narrows the field of view, or moves the second camera nearer. @param notches Notches of the
 *  wheel; negative: the opposite. */
void app_zoom(App *app, double notches);

/** Shows the rays of a pixel. @param x Fraction of the picture's width. @param y Fraction of its
 *  height, from the top. */
void app_pick_pixel(App *app, double x, double y);

/** Shows the rays of a pixel nearby; or magnifies it, while the magnifier is on. @param right
 * Pixels to the right. @param down Pixels down. */
void app_step_pixel(App *app, int right, int down);

/** Chooses one of the rays that are shown. @param ray Its index. */
void app_choose_ray(App *app, size_t ray);

/** Notes what was chosen of the pictures before a change of it, if anything has changed: it can be
 *  undone. @param continues Whether it belongs to the change before it. */
void app_note_choice(App *app, const PictureChoice *before, bool continues);

/** A lesson is over. See #window_take_own_settings. */
void app_take_own_settings(App *app);

/** Puts camera and lights back where the scene file has them; it can be undone. */
void app_reset_view(App *app);

/** Puts back all that a lesson may change: view, settings, layer, rays, moves; pauses the time.
 *  @param time The scene's time, seconds. */
void app_restart_view(App *app, double time);

/**
 * Saves the finished picture in a numbered file, and prints the view and the path.
 * @param folder  Folder of the file.
 * @param name    First part of its name.
 * @return Whether it is saved.
 */
bool app_save_picture(App *app, const char *folder, const char *name, Error *error);

/** Prints the path of a file that was written, which ends a line. */
void app_print_path(const char *path);

/** @return The clock of a lesson, at its beginning: it moves light and camera. */
StepClock app_step_clock(App *app);

/** Saves what is on the screen, with its legend and rays, as a numbered PNG; the view and the
 * settings are its metadata. @return Whether it is saved. */
bool app_save_screen(App *app, Error *error);

#endif
