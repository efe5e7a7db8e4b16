/**
 * @file
 * @brief A sight: one picture of the window, with settings of its own.
 *
 * It is drawn pass by pass in the background, and nobody ever waits for it. A window has one sight,
 * or two of the same scene side by side; a third may look at it with another camera: whoever starts
 * it says which scene, and whoever shows it, where.
 */
#ifndef DIOPTRE_VIEW_WINDOW_VIEWPORT_H
#define DIOPTRE_VIEW_WINDOW_VIEWPORT_H

#include "base/clock.h"
#include "view/state/settings_override.h"
#include "view/window/sdl_window.h"

#include <math.h>

/** What delays say where nothing is to be done until an event comes, seconds. */
#define VIEWPORT_NO_TIMEOUT HUGE_VAL

/** One picture of the window. Starts as `{0}`: closed. */
typedef struct Viewport {
    Renderer *renderer;         /**< What draws; owned. NULL: it is closed. */
    RenderSettings settings;    /**< How it draws. */
    SettingsOverride overrides; /**< What the user has changed of that. */
    Layer layer;                /**< What it shows. */
    StreamingTexture texture;   /**< Its newest pass that is on screen. */
    RenderStats report;         /**< How that stands. */
    double render_seconds;      /**< How long a whole picture took, seconds; 0: not known yet. */
    double
        previous_render_seconds; /**< The same before settings or layer were changed; 0: never. */
    int width;                   /**< Pixels of the drawing under way. */
    int height;                  /**< Pixels of the drawing under way. */
    double start_time;           /**< When it was started, seconds. */
    bool needs_new_renderer;     /**< Whether the settings changed since the renderer was made. */
    bool needs_restart;      /**< Whether scene, window or settings changed since it was started. */
    bool awaits_first_frame; /**< Whether nothing of it has been on screen yet. */
    bool has_new_pass;       /**< Whether there may be a pass that is not on screen yet. */
    uint32_t pass_event; /**< SDL event that tells of a finished pass; its data1 is the sight. */
    atomic_bool is_event_queued; /**< Whether such an event is on its way. */
} Viewport;

/**
 * Makes what draws a sight; drawing begins with #viewport_start. Its tuning and its layer stay.
 * @param[in,out] viewport  The sight, closed; give it back with #viewport_close.
 * @param reuse_from  Another sight of the same scene, to share with; NULL: there is none.
 * @param base  What is asked for, but for the tuning.
 * @param pass_event  SDL event, registered, to be handed to #viewport_on_pass.
 * @return Whether it is open.
 */
bool viewport_open(Viewport *viewport, const Viewport *reuse_from, const Scene *scene,
                   const RenderSettings *base, uint32_t pass_event, Error *error);

/** Stops drawing and gives all back but tuning and layer. */
void viewport_close(Viewport *viewport);

/** Changes how it is drawn: #viewport_update_renderer is wanted then. */
void viewport_override_setting(Viewport *viewport, SettingsChangeFn *change, int step);

/** Changes what it shows. */
void viewport_set_layer(Viewport *viewport, Layer layer);

/**
 * Makes what draws it anew, as its tuning wants it; what is on screen stays meanwhile.
 * @param base  What is asked for, but for the tuning.
 * @return false without memory; it draws as before then.
 */
bool viewport_update_renderer(Viewport *viewport, const Scene *scene, const RenderSettings *base,
                              Error *error);

/** Shows another scene from now on; what is on screen stays meanwhile. @param renderer What draws;
 *  owned from now on. */
void viewport_set_renderer(Viewport *viewport, Renderer *renderer, const RenderSettings *settings);

/** Takes note of the event that a pass has ended. */
void viewport_on_pass(Viewport *viewport);

/** Stops an unfinished drawing, as nobody sees it. @return Whether there was one. */
bool viewport_stop(Viewport *viewport);

/** Starts to draw a scene as it is now. @return false without memory. */
bool viewport_start(Viewport *viewport, const Scene *scene, int width, int height, double now,
                    Error *error);

/** @return Whether there is a pass that should be shown now. */
bool viewport_has_frame(Viewport *viewport, double now);

/** Brings the newest pass to its canvas. @param[in,out] viewport The sight, with a pass. @param
 * renderer What draws in the window. @return Whether it is there. */
bool viewport_upload(Viewport *viewport, SDL_Renderer *renderer);

/** @return How long nothing is to be done, seconds. */
double viewport_timeout(const Viewport *viewport, double now);

/** @return Whether the picture on screen is the last pass of the scene as it is now. */
bool viewport_is_finished(const Viewport *viewport);

#endif
