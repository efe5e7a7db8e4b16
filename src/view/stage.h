/**
 * @file
 * @brief The picture's way from the scene to the screen: pass by pass, without ever waiting.
 */
#ifndef DIOPTRE_VIEW_STAGE_H
#define DIOPTRE_VIEW_STAGE_H

#include "dioptre/renderer.h"
#include "view/caption.h"
#include "view/display.h"
#include "view/help.h"
#include "view/latency.h"
#include "view/notice.h"

/** What #stage_delay says where nothing is to be done until an event comes, seconds. */
#define STAGE_NEVER HUGE_VAL

/** A renderer, a window, and what of the one is to be seen in the other. Starts as `{0}`. */
typedef struct Stage {
    Renderer *renderer;  /**< What draws; owned. */
    Display display;     /**< Where it is shown. */
    Help help;           /**< What may lie over it. */
    Notice notice;       /**< What is said over it. */
    Caption caption;     /**< What a lesson says over it. */
    double text_scale;   /**< How many times as large as usual its letters are; 0: as usual. */
    Latency latency;     /**< How long keys wait for their picture. */
    RenderReport report; /**< How the picture on screen stands. */
    int width;           /**< Pixels of the drawing under way. */
    int height;          /**< Pixels of the drawing under way. */
    double started;      /**< When it was started, seconds. */
    double first_shown;  /**< When the very first picture was on screen, seconds; 0 before. */
    bool is_changed;     /**< Whether the scene or the window changed since it was started. */
    bool is_unseen;      /**< Whether nothing of it has been on screen yet. */
    bool has_pass;       /**< Whether there may be a pass that is not on screen yet. */
    bool is_hidden;      /**< Whether nobody can see the window. */
    uint32_t pass_event; /**< SDL event that tells of a finished pass. */
    atomic_bool is_told; /**< Whether such an event is on its way. */
} Stage;

/** @return Seconds on the monotonic clock. */
double stage_clock(void);

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

/**
 * Shows another scene from now on, drawn by another renderer; what is on screen stays meanwhile.
 * @param[in,out] stage  The stage, ready.
 * @param renderer       The renderer, with the settings of the one before; owned from now on.
 */
void stage_replace(Stage *stage, Renderer *renderer);

/** Takes note of the event that a pass has ended. @param[in,out] stage The stage. */
void stage_on_pass(Stage *stage);

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
bool stage_copy(const Stage *stage, Picture *picture, Error *error);

#endif
