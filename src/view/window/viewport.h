/**
 * @file
 * @brief A viewport: one picture of the window, with its own renderer, settings and layer.
 *
 * It is rendered in the background, pass by pass, and never waited for. A window has one viewport,
 * or two of the same scene side by side; the view of rays has a third with another camera.
 */
#ifndef DIOPTRE_VIEW_WINDOW_VIEWPORT_H
#define DIOPTRE_VIEW_WINDOW_VIEWPORT_H

#include "base/clock.h"
#include "view/state/settings_override.h"
#include "view/window/sdl_window.h"

#include <math.h>

/** Timeout until an event comes, seconds. */
#define VIEWPORT_NO_TIMEOUT HUGE_VAL

/** A viewport. Starts as `{0}`: closed. */
typedef struct Viewport {
    Renderer *renderer;         /**< The renderer; owned; NULL: the viewport is closed. */
    RenderSettings settings;    /**< Its settings in force. */
    SettingsOverride overrides; /**< What the user has changed of the settings. */
    Layer layer;                /**< The layer on screen. */
    StreamingTexture texture;   /**< The newest pass on screen. */
    RenderStats report;         /**< Statistics of that pass. */
    bool is_report_old;         /**< Whether settings or layer have changed since that pass. */
    LayerMarks marks;           /**< Where its artefacts are. */
    double render_seconds;      /**< Time of a pass with all pixels, seconds; 0: not known yet. */
    double previous_render_seconds; /**< The same before the last change of settings or layer; 0:
                                       none. */
    int width;                      /**< Pixels of the current render. */
    int height;                     /**< Pixels of the current render. */
    double start_time;              /**< Start of the current render, seconds. */
    bool needs_new_renderer; /**< Whether settings have changed since the renderer was created. */
    bool needs_restart;      /**< Whether scene, window or settings have changed since the start. */
    bool awaits_first_frame; /**< Whether no pass of the current render was on screen yet. */
    bool has_new_pass;       /**< Whether there may be a pass that is not on screen yet. */
    uint32_t pass_event;     /**< SDL event of a finished pass; its data1 is the viewport. */
    atomic_bool is_event_queued; /**< Whether such an event is in the queue. */
} Viewport;

/**
 * Creates the renderer; rendering starts with #viewport_start. Overrides and layer are kept.
 * @param[in,out] viewport  A closed viewport, to be closed with #viewport_close.
 * @param reuse_from  Another viewport of the same scene, whose data is shared; NULL: none.
 * @param base  The settings without the user's changes.
 * @param pass_event  SDL event, registered, whose events go to #viewport_on_pass.
 * @return Whether it is open.
 */
bool viewport_open(Viewport *viewport, const Viewport *reuse_from, const Scene *scene,
                   const RenderSettings *base, uint32_t pass_event, Error *error);

/** Stops rendering and frees all but overrides and layer. */
void viewport_close(Viewport *viewport);

/** Changes a setting; #viewport_update_renderer must follow. */
void viewport_override_setting(Viewport *viewport, const RenderSettings *base,
                               SettingsChangeFn *change, int step);

/** Gives the viewport, which may be closed, what was changed of the settings and a layer; only what
 *  differs is drawn again. #viewport_update_renderer must follow. */
void viewport_choose(Viewport *viewport, const RenderSettings *base,
                     const SettingsOverride *overrides, Layer layer);

/** Changes the layer. */
void viewport_set_layer(Viewport *viewport, Layer layer);

/**
 * Replaces the renderer by one with the overridden settings; the picture on screen stays until its
 * first pass.
 * @param base  The settings without the user's changes.
 * @return false without memory; the old renderer stays then.
 */
bool viewport_update_renderer(Viewport *viewport, const Scene *scene, const RenderSettings *base,
                              Error *error);

/** Replaces the renderer by that of another scene; the picture on screen stays until its first
 * pass. @param renderer Ownership passes. */
void viewport_set_renderer(Viewport *viewport, Renderer *renderer, const RenderSettings *settings);

/** Handles the event of a finished pass. */
void viewport_on_pass(Viewport *viewport);

/** Stops an unfinished render, as the window is hidden. @return Whether there was one. */
bool viewport_stop(Viewport *viewport);

/** Starts to render a scene as it is now. @return false without memory. */
bool viewport_start(Viewport *viewport, const Scene *scene, int width, int height, double now,
                    Error *error);

/** @return Whether a pass is to be shown now. */
bool viewport_has_frame(Viewport *viewport, double now);

/** Copies the newest pass to the texture. @return false if SDL failed. */
bool viewport_upload(Viewport *viewport, SDL_Renderer *renderer);

/** @return Whether the next frame starts to draw: something has changed, and what was drawn last is
 *  on screen. */
bool viewport_is_start_due(const Viewport *viewport);

/** @return Seconds until a coarse pass is to be shown; 0: a picture is to be started. */
double viewport_timeout(const Viewport *viewport, double now);

/** @return Whether the picture on screen is the last pass of the scene as it is now. */
bool viewport_is_finished(const Viewport *viewport);

#endif
