/**
 * @file
 * @brief A sight: one picture of the window, with settings of its own.
 *
 * It is drawn pass by pass in the background, and nobody ever waits for it. A window has one sight,
 * or two of the same scene side by side; a third may look at it with another camera: whoever starts
 * it says which scene, and whoever shows it, where.
 */
#ifndef DIOPTRE_VIEW_SIGHT_H
#define DIOPTRE_VIEW_SIGHT_H

#include "dioptre/clock.h"
#include "view/canvas.h"
#include "view/tuning.h"

#include <math.h>

/** What delays say where nothing is to be done until an event comes, seconds. */
#define SIGHT_NEVER HUGE_VAL

/** One picture of the window. Starts as `{0}`: closed. */
typedef struct Sight {
    Renderer *renderer;      /**< What draws; owned. NULL: it is closed. */
    RenderSettings settings; /**< How it draws. */
    Tuning tuning;           /**< What the user has changed of that. */
    Layer layer;             /**< What it shows. */
    Canvas canvas;           /**< Its newest pass that is on screen. */
    RenderReport report;     /**< How that stands. */
    double cost;             /**< How long a whole picture took, seconds; 0: not known yet. */
    double cost_before;      /**< The same before settings or layer were changed; 0: never. */
    int width;               /**< Pixels of the drawing under way. */
    int height;              /**< Pixels of the drawing under way. */
    double started;          /**< When it was started, seconds. */
    bool is_tuned;           /**< Whether the settings changed since the renderer was made. */
    bool is_changed;         /**< Whether scene, window or settings changed since it was started. */
    bool is_unseen;          /**< Whether nothing of it has been on screen yet. */
    bool has_pass;           /**< Whether there may be a pass that is not on screen yet. */
    uint32_t pass_event; /**< SDL event that tells of a finished pass; its data1 is the sight. */
    atomic_bool is_told; /**< Whether such an event is on its way. */
} Sight;

/**
 * Makes what draws a sight; drawing begins with #sight_start. Its tuning and its layer stay.
 * @param[in,out] sight  The sight, closed; give it back with #sight_close.
 * @param former         Another sight of the same scene, to share with; NULL: there is none.
 * @param scene          The scene.
 * @param asked          What is asked for, but for the tuning.
 * @param pass_event     SDL event, registered, to be handed to #sight_on_pass.
 * @param[out] error     What is wrong.
 * @return Whether it is open.
 */
bool sight_open(Sight *sight, const Sight *former, const Scene *scene, const RenderSettings *asked,
                uint32_t pass_event, Error *error);

/** Stops drawing and gives all back but tuning and layer. @param[in,out] sight The sight. */
void sight_close(Sight *sight);

/** Changes how it is drawn: #sight_remake is wanted then. @param[in,out] sight The sight, open.
 *  @param action See #tuning_change. */
void sight_tune(Sight *sight, Action action);

/** Changes what it shows. @param[in,out] sight The sight, open. @param layer What. */
void sight_set_layer(Sight *sight, Layer layer);

/**
 * Makes what draws it anew, as its tuning wants it; what is on screen stays meanwhile.
 * @param[in,out] sight  The sight, open.
 * @param scene          The scene.
 * @param asked          What is asked for, but for the tuning.
 * @param[out] error     What is wrong.
 * @return false without memory; it draws as before then.
 */
bool sight_remake(Sight *sight, const Scene *scene, const RenderSettings *asked, Error *error);

/**
 * Shows another scene from now on; what is on screen stays meanwhile.
 * @param[in,out] sight  The sight, open.
 * @param renderer       What draws; owned from now on.
 * @param settings       How it draws.
 */
void sight_replace(Sight *sight, Renderer *renderer, const RenderSettings *settings);

/** Takes note of the event that a pass has ended. @param[in,out] sight The sight. */
void sight_on_pass(Sight *sight);

/** Stops an unfinished drawing, as nobody sees it. @param[in,out] sight The sight. @return Whether
 *  there was one. */
bool sight_stop(Sight *sight);

/**
 * Starts to draw a scene as it is now.
 * @param[in,out] sight  The sight, open.
 * @param scene          The scene.
 * @param width          Pixels.
 * @param height         Pixels.
 * @param now            Now, seconds.
 * @param[out] error     What is wrong.
 * @return false without memory.
 */
bool sight_start(Sight *sight, const Scene *scene, int width, int height, double now, Error *error);

/** @return Whether there is a pass that should be shown now. @param[in,out] sight The sight.
 *  @param now Now, seconds. */
bool sight_is_due(Sight *sight, double now);

/** Brings the newest pass to its canvas. @param[in,out] sight The sight, with a pass. @param
 * renderer What draws in the window. @return Whether it is there. */
bool sight_show(Sight *sight, SDL_Renderer *renderer);

/** @return How long nothing is to be done, seconds. @param sight The sight. @param now Now. */
double sight_delay(const Sight *sight, double now);

/** @return Whether the picture on screen is the last pass of the scene as it is now.
 *  @param sight The sight. */
bool sight_is_finished(const Sight *sight);

#endif
