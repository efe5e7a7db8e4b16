/**
 * @file
 * @brief The picture's way from the scene to the screen: pass by pass, without ever waiting.
 */
#ifndef DIOPTRE_VIEW_WINDOW_H
#define DIOPTRE_VIEW_WINDOW_H

#include "view/panels/browser.h"
#include "view/panels/caption.h"
#include "view/panels/help.h"
#include "view/panels/hud.h"
#include "view/panels/inspector.h"
#include "view/state/latency.h"
#include "view/window/sdl_window.h"
#include "view/window/split_view.h"

/** Pictures of a scene that a window shows at most. */
enum { WINDOW_VIEWPORTS = 2 };

/** What #window_timeout says where nothing is to be done until an event comes, seconds. */
#define WINDOW_NO_TIMEOUT VIEWPORT_NO_TIMEOUT

/** A window, and what is to be seen in it. Starts as `{0}`. */
typedef struct Window {
    Viewport
        viewports[WINDOW_VIEWPORTS]; /**< The pictures; the second is open only beside the first. */
    SplitView split;                 /**< How they share the window. */
    RenderSettings base_settings; /**< What is asked of both, but for what the user has changed. */
    SdlWindow sdl;                /**< Where they are shown. */
    Hud huds[WINDOW_VIEWPORTS];   /**< What is said beside them. */
    bool shows_settings;          /**< Whether it is said how they are drawn. */
    Help help;                    /**< What may lie over them. */
    Notice notice;                /**< What is said over them. */
    Browser browser;              /**< The list of scenes that may lie over them. */
    Caption caption;              /**< What a lesson says over them. */
    Inspector inspector;          /**< The rays of one pixel, which may lie over all of it. */
    double text_scale;            /**< How many times as large as usual letters are; 0: as usual. */
    Latency latency;              /**< How long keys wait for their picture. */
    double first_present_time; /**< When the very first picture was on screen, seconds; 0 before. */
    bool is_hidden;            /**< Whether nobody can see the window. */
    uint32_t pass_event;       /**< SDL event that tells of a finished pass. */
} Window;

/**
 * Opens the window and makes the renderer; drawing begins with #window_update.
 * @param[out] window  The stage; give it back with #window_close, opened or not.
 * @param settings  What is asked of the renderer.
 * @param pass_event  SDL event, registered, to be handed to #window_on_pass.
 * @return Whether it is open.
 */
bool window_open(Window *window, const Scene *scene, const RenderSettings *settings,
                 const char *title, uint32_t pass_event, Error *error);

/** Stops drawing and closes the window. */
void window_close(Window *window);

/** @return How many pictures are there. */
size_t window_viewport_count(const Window *window);

/** @return The picture that keys change. */
Viewport *window_active_viewport(Window *window);

/** The scene has changed, and is drawn anew. */
void window_invalidate(Window *window);

/** Shows something else of the picture that keys change. */
void window_set_layer(Window *window, Layer layer);

/** Changes how the picture that keys change is drawn. */
void window_override_setting(Window *window, SettingsChangeFn *change, int step);

/** Makes what draws all pictures anew, as soon as that can be. */
void window_request_new_renderers(Window *window);

/** Draws all pictures as they were asked for. */
void window_reset_overrides(Window *window);

/** Shows one picture, two side by side, or their difference. @param step 1: the next of these; -1:
 *  the one before. */
void window_cycle_split(Window *window, int step);

/** Keys change the other picture from now on. */
void window_swap_active(Window *window);

/** Moves the bar between two pictures. @param fraction To where, of the window's width. */
void window_move_bar(Window *window, double fraction);

/**
 * @return Whether the bar is under the mouse.
 * @param fraction  Where the mouse is, of the window's width.
 */
bool window_is_at_bar(const Window *window, double fraction);

/** Says how pictures are drawn, or not any more. */
void window_toggle_settings(Window *window);

/** Makes what draws the pictures as they are wanted now: one or two, with their settings. To be
 *  called while nobody else needs what drew them until now. @return false without memory; pictures
 *  are drawn as before then. */
bool window_update_renderers(Window *window, const Scene *scene, Error *error);

/** Takes note of the event that a pass has ended. */
void window_on_pass(Window *window, const SDL_Event *event);

/** Takes note that the window may be hidden, or not any more. */
void window_on_visibility(Window *window);

/** Takes note that the window may have another size; what there is is stretched meanwhile. @return
 *  Whether it has, and the picture is to be drawn anew. */
bool window_on_resize(Window *window);

/** Takes note that the graphics card lost its pictures. */
void window_on_device_reset(Window *window);

/** Shows what there is once more. */
void window_present(Window *window);

/** Draws all words anew: size, keyboard or letters have changed. */
void window_invalidate_text(Window *window);

/** Makes the letters over the picture larger or smaller. @param steps How many steps; 0: as large
 *  as usual. */
void window_scale_text(Window *window, int steps);

/** Says something at the lower edge of the picture. */
void window_set_notice(Window *window, const char *text);

/**
 * Starts to draw if anything changed, and shows the newest pass if it is time to.
 * @param scene  The scene as it is now.
 * @return false if drawing could not be started; what was on screen stays there.
 */
bool window_update(Window *window, const Scene *scene, double now, Error *error);

/** @return How long nothing is to be done, seconds; #WINDOW_NO_TIMEOUT: until an event comes. */
double window_timeout(const Window *window, double now);

/** @return Whether the next change would be drawn at once, with the one before it on screen. Moving
 *  things only then makes sure that something is to be seen on the slowest machine too. */
bool window_is_ready(const Window *window);

/** @return Whether the picture on screen is the last pass of the scene as it is now. */
bool window_is_finished(const Window *window);

/**
 * Copies the finished picture, the very bytes that are on screen.
 * @param[out] picture  The picture; give it back with #picture_deinit.
 * @return false without memory.
 */
bool window_copy_picture(Window *window, Picture *picture, Error *error);

#endif
