/**
 * @file
 * @brief The picture's way from the scene to the screen: pass by pass, without ever waiting.
 */
#ifndef DIOPTRE_VIEW_STAGE_H
#define DIOPTRE_VIEW_STAGE_H

#include "view/browser.h"
#include "view/caption.h"
#include "view/display.h"
#include "view/help.h"
#include "view/hud.h"
#include "view/inspector.h"
#include "view/latency.h"
#include "view/notice.h"
#include "view/split.h"

/** Pictures of a scene that a window shows at most. */
enum { STAGE_SIGHTS = 2 };

/** What #stage_delay says where nothing is to be done until an event comes, seconds. */
#define STAGE_NEVER SIGHT_NEVER

/** A window, and what is to be seen in it. Starts as `{0}`. */
typedef struct Stage {
    Sight sights[STAGE_SIGHTS]; /**< The pictures; the second is open only beside the first. */
    Split split;                /**< How they share the window. */
    RenderSettings asked;       /**< What is asked of both, but for what the user has changed. */
    Display display;            /**< Where they are shown. */
    Hud huds[STAGE_SIGHTS];     /**< What is said beside them. */
    bool has_settings;          /**< Whether it is said how they are drawn. */
    Help help;                  /**< What may lie over them. */
    Notice notice;              /**< What is said over them. */
    Browser browser;            /**< The list of scenes that may lie over them. */
    Caption caption;            /**< What a lesson says over them. */
    Inspector inspector;        /**< The rays of one pixel, which may lie over all of it. */
    double text_scale;          /**< How many times as large as usual letters are; 0: as usual. */
    Latency latency;            /**< How long keys wait for their picture. */
    double first_shown;  /**< When the very first picture was on screen, seconds; 0 before. */
    bool is_hidden;      /**< Whether nobody can see the window. */
    uint32_t pass_event; /**< SDL event that tells of a finished pass. */
} Stage;

/**
 * Opens the window and makes the renderer; drawing begins with #stage_update.
 * @param[out] stage  The stage; give it back with #stage_close, opened or not.
 * @param scene       The scene.
 * @param settings    What is asked of the renderer.
 * @param title       The window's first title.
 * @param pass_event  SDL event, registered, to be handed to #stage_on_pass.
 * @param[out] error  What is wrong.
 * @return Whether it is open.
 */
bool stage_open(Stage *stage, const Scene *scene, const RenderSettings *settings, const char *title,
                uint32_t pass_event, Error *error);

/** Stops drawing and closes the window. @param[in,out] stage The stage. */
void stage_close(Stage *stage);

/** @return How many pictures are there. @param stage The stage. */
size_t stage_sights(const Stage *stage);

/** @return The picture that keys change. @param stage The stage. */
Sight *stage_active(Stage *stage);

/** The scene has changed, and is drawn anew. @param[in,out] stage The stage. */
void stage_change(Stage *stage);

/** Shows something else of the picture that keys change. @param[in,out] stage The stage.
 *  @param layer What. */
void stage_set_layer(Stage *stage, Layer layer);

/** Changes how the picture that keys change is drawn. @param[in,out] stage The stage. @param action
 *  See #tuning_change. */
void stage_tune(Stage *stage, Action action);

/** Makes what draws all pictures anew, as soon as that can be. @param[in,out] stage The stage. */
void stage_retune(Stage *stage);

/** Draws all pictures as they were asked for. @param[in,out] stage The stage. */
void stage_untune(Stage *stage);

/** Shows one picture, two side by side, or their difference. @param[in,out] stage The stage.
 *  @param way 1: the next of these; -1: the one before. */
void stage_split(Stage *stage, int way);

/** Keys change the other picture from now on. @param[in,out] stage The stage. */
void stage_swap_active(Stage *stage);

/** Moves the bar between two pictures. @param[in,out] stage The stage. @param share To where, of
 * the window's width. */
void stage_move_bar(Stage *stage, double share);

/** @return Whether the bar is under the mouse. @param stage The stage. @param share Where the mouse
 *  is, of the window's width. */
bool stage_is_at_bar(const Stage *stage, double share);

/** Says how pictures are drawn, or not any more. @param[in,out] stage The stage. */
void stage_toggle_settings(Stage *stage);

/**
 * Makes what draws the pictures as they are wanted now: one or two, with their settings. To be
 * called while nobody else needs what drew them until now.
 * @param[in,out] stage  The stage.
 * @param scene          The scene.
 * @param[out] error     What is wrong.
 * @return false without memory; pictures are drawn as before then.
 */
bool stage_settle(Stage *stage, const Scene *scene, Error *error);

/** Takes note of the event that a pass has ended. @param[in,out] stage The stage. @param event The
 *  event. */
void stage_on_pass(Stage *stage, const SDL_Event *event);

/** Takes note that the window may be hidden, or not any more. @param[in,out] stage The stage. */
void stage_on_visibility(Stage *stage);

/**
 * Takes note that the window may have another size; what there is is stretched meanwhile.
 * @param[in,out] stage  The stage.
 * @return Whether it has, and the picture is to be drawn anew.
 */
bool stage_on_resize(Stage *stage);

/** Takes note that the graphics card lost its pictures. @param[in,out] stage The stage. */
void stage_on_loss(Stage *stage);

/** Shows what there is once more. @param[in,out] stage The stage. */
void stage_present(Stage *stage);

/** Draws all words anew: size, keyboard or letters have changed. @param[in,out] stage The stage. */
void stage_forget_words(Stage *stage);

/** Makes the letters over the picture larger or smaller. @param[in,out] stage The stage.
 *  @param steps How many steps; 0: as large as usual. */
void stage_resize_words(Stage *stage, int steps);

/** Says something at the lower edge of the picture. @param[in,out] stage The stage.
 *  @param words What; empty: nothing more. */
void stage_say(Stage *stage, const char *words);

/**
 * Starts to draw if anything changed, and shows the newest pass if it is time to.
 * @param[in,out] stage  The stage.
 * @param scene          The scene as it is now.
 * @param now            Now, seconds.
 * @param[out] error     What is wrong.
 * @return false if drawing could not be started; what was on screen stays there.
 */
bool stage_update(Stage *stage, const Scene *scene, double now, Error *error);

/**
 * @return How long nothing is to be done, seconds; #STAGE_NEVER: until an event comes.
 * @param stage  The stage.
 * @param now    Now, seconds.
 */
double stage_delay(const Stage *stage, double now);

/**
 * @return Whether the next change would be drawn at once, with the one before it on screen. Moving
 *         things only then makes sure that something is to be seen on the slowest machine too.
 * @param stage  The stage.
 */
bool stage_is_ready(const Stage *stage);

/** @return Whether the picture on screen is the last pass of the scene as it is now.
 *  @param stage The stage. */
bool stage_is_finished(const Stage *stage);

/**
 * Copies the finished picture, the very bytes that are on screen.
 * @param stage         The stage, finished.
 * @param[out] picture  The picture; give it back with #picture_release.
 * @param[out] error    What is wrong.
 * @return false without memory.
 */
bool stage_copy(Stage *stage, Picture *picture, Error *error);

#endif
