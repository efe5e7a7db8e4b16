/**
 * @file
 * @brief The compositor: viewports and panels of one window, and how they get to the screen.
 */
#ifndef DIOPTRE_VIEW_WINDOW_H
#define DIOPTRE_VIEW_WINDOW_H

#include "view/panels/browser.h"
#include "view/panels/caption.h"
#include "view/panels/help.h"
#include "view/panels/hud.h"
#include "view/panels/lesson_panel.h"
#include "view/panels/light_marks.h"
#include "view/panels/magnifier.h"
#include "view/panels/object_inspector.h"
#include "view/panels/picture_projection.h"
#include "view/panels/pixel_readout.h"
#include "view/panels/ray_view.h"
#include "view/panels/settings_chart_panel.h"
#include "view/panels/toolbar.h"
#include "view/state/latency.h"
#include "view/window/sdl_window.h"
#include "view/window/split_view.h"

/** Bytes of a message on the picture with the final zero; a longer one is cut. */
enum { TOAST_SIZE = 256 };
/** Most viewports of a window. */
enum { WINDOW_VIEWPORTS = 2 };

/** Timeout until an event comes, seconds. */
#define WINDOW_NO_TIMEOUT VIEWPORT_NO_TIMEOUT

/** What the window shows beside its pictures. Each frame of the event loop sets it anew. */
typedef struct WindowState {
    const Scene *scene;         /**< The scene on screen; NULL: none yet. */
    size_t selected_light;      /**< Index of the light that keys move. */
    bool is_animated;           /**< Whether the scene depends on time. */
    bool is_running;            /**< Whether its time runs. */
    bool is_recording;          /**< Whether a lesson is recorded. */
    bool is_playing;            /**< Whether a lesson plays. */
    bool can_undo;              /**< Whether a change can be taken back. */
    bool can_redo;              /**< Whether one can be done again. */
    const EditHistory *edits;   /**< What the user has changed of its objects. */
    const bool *is_light_moved; /**< Which lights the user has moved. */
} WindowState;

/** A message on the picture, shown for a while. Starts as `{0}`: none. */
typedef struct Toast {
    char text[TOAST_SIZE]; /**< Its text, translated; empty: none. */
    double end_time;       /**< When it goes, seconds. */
} Toast;

/** A change of the toolbar, and of the size of the window with it. Starts as `{0}`: none. */
typedef struct ToolbarChange {
    bool was_folded;     /**< Whether the toolbar was hidden before. */
    bool was_presenting; /**< Whether there was a presentation before. */
    SDL_Point before;    /**< Size of the window before, screen units. */
    SDL_Point after;     /**< The same, after it. */
} ToolbarChange;

/** The height of letters. The bar grows with it, and it shrinks with the height that the bar
 *  leaves: it has to settle. Starts as `{0}`. */
typedef struct TextFit {
    SDL_Point window;   /**< Size of the window that it is for, screen units. */
    double text_scale;  /**< #Window.text_scale then. */
    bool is_folded;     /**< Whether the bar was folded. */
    bool is_presenting; /**< Whether the window was made for a class. */
    bool has_lesson;    /**< Whether the panel of a lesson was shown. */
    bool shows_rays;    /**< Whether rays were shown. */
    bool is_french;     /**< Whether words were French, which are longer. */
    double aspect;      /**< Width of the picture by its height, which says where the panel is. */
    bool has_grown;     /**< Whether letters have grown since one of these changed. */
    float height;       /**< Height of letters, screen units. */
} TextFit;

/** What a frame says of the pixel under the mouse, or of the one that is magnified. Starts as
 * `{0}`.
 */
typedef struct Readout {
    bool is_read;            /**< Whether #pixel is known. */
    bool is_shown;           /**< Whether it is to be shown. */
    bool is_above;           /**< Whether it lies at the upper edge, and not at the lower one. */
    PixelReadout pixel;      /**< What the pixel shows. */
    char text[READOUT_SIZE]; /**< The same in words. */
    GuiRect rect;            /**< Where it lies, screen units. */
} Readout;

/** A window. Starts as `{0}`. */
typedef struct Window {
    Viewport viewports[WINDOW_VIEWPORTS];   /**< The viewports; the second is open only in the split
                                               view. */
    SplitView split;                        /**< How they share the window. */
    RenderSettings base_settings;           /**< Settings of both without the user's changes. */
    RenderSettings own_settings;            /**< The same without those of a lesson. */
    SdlWindow sdl;                          /**< The window on the screen. */
    Hud huds[WINDOW_VIEWPORTS];             /**< The panel on each viewport. */
    GuiRect hud_rects[WINDOW_VIEWPORTS];    /**< Where these lie in this frame. */
    GuiRect legend_rects[WINDOW_VIEWPORTS]; /**< Where the legends lie in it. */
    bool shows_settings;                    /**< Whether the panels show the settings. */
    double settings_end_time; /**< When they go by themselves, seconds; 0: they are pinned. */
    bool is_presenting;       /**< Whether the window is made for a class: no bar, large letters. */
    bool hides_toolbar;       /**< Whether the user or a lesson hides the toolbar, and the marks of
                                   the lights with it. */
    Toast layer_name;         /**< Name of the layer, in a presentation. */
    Help help;                /**< The help. */
    Notice notice;            /**< The notice of an error. */
    Browser browser;          /**< The list of scenes. */
    Caption caption;          /**< The caption that is typed. */
    LessonPanel lesson_panel; /**< The panel of a lesson. */
    RayView ray_view;         /**< The rays of one pixel. */
    Gui *gui;                 /**< Buttons, lists and marks; owned; NULL: no font. */
    bool opens_widgets;       /**< Whether #gui is to be created. */
    Toolbar toolbar;          /**< The bar at the upper edge. */
    int fitted_height;        /**< Height of bar and lesson panel that the window has
                                   room for, pixels. */
    ToolbarChange toolbar_change;      /**< The last time that the toolbar was shown or hidden. */
    LightMarks light_marks;            /**< The marks of the lights. */
    ObjectInspector object_inspector;  /**< The selected object. */
    Magnifier magnifier;               /**< Some pixels as squares. */
    Readout readout;                   /**< What one of them shows. */
    SettingsChartPanel settings_chart; /**< Time against error of the settings tried. */
    Toast toast;                       /**< The newest message. */
    Toast hint;                        /**< What to press, at the start. */
    double next_progress_time;         /**< When bar or legend say next how far it is,
                                            seconds. */
    WindowState state;                 /**< What they show. */
    double text_scale;                 /**< Factor of the size of letters; 0: 1. */
    TextFit text_fit;                  /**< Their height. */
    Latency latency;                   /**< The latency from keys to pictures. */
    double first_present_time; /**< When the first picture was on screen, seconds; 0: not yet. */
    bool is_hidden;            /**< Whether the window is hidden or minimized. */
    uint32_t pass_event;       /**< SDL event of a finished pass. */
} Window;

/**
 * Opens the window and creates the renderer; rendering starts with #window_update.
 * @param[out] window  To be closed with #window_close, opened or not.
 * @param pass_event  SDL event, registered, whose events go to #window_on_pass.
 * @return Whether it is open.
 */
bool window_open(Window *window, const Scene *scene, const RenderSettings *settings,
                 const char *title, uint32_t pass_event, Error *error);

/** Stops rendering and closes the window. */
void window_close(Window *window);

/** @return Number of open viewports. */
size_t window_viewport_count(const Window *window);

/** @return The active viewport, which keys change. */
Viewport *window_active_viewport(Window *window);

/** Has the scene rendered again. */
void window_invalidate(Window *window);

/** Changes the layer of the active viewport. */
void window_set_layer(Window *window, Layer layer);

/** @return The settings that the user has asked for in the active viewport; its renderer may still
 *  have those of before. */
RenderSettings window_requested_settings(const Window *window);

/** @return What the user has chosen of the pictures. */
PictureChoice window_choice(const Window *window);

/** Chooses it anew, as undo does: only what differs is drawn again. */
void window_choose(Window *window, const PictureChoice *choice);

/** Shows the settings for a while, unless the toolbar does: they have changed. */
void window_tell_settings(Window *window);

/** A lesson is over: its settings are the user's now, and those at first are the scene's own. */
void window_take_own_settings(Window *window);

/** Changes one setting of the active viewport. */
void window_override_setting(Window *window, SettingsChangeFn *change, int step);

/** Has all renderers replaced at the next #window_update_renderers. */
void window_request_new_renderers(Window *window);

/** Takes back all changes of settings, layers and the split view. */
void window_reset_overrides(Window *window);

/** Another scene comes with renderers of its own: takes back what the user has changed for the one
 *  before, and closes what was opened for it. */
void window_forget_changes(Window *window);

/** Changes the mode of the split view. @param step 1: the next; -1: the previous. */
void window_cycle_split(Window *window, int step);

/** @return Whether a second picture is wanted, or the rays of another pixel: both are there at the
 *  end of the frame. */
bool window_awaits_frame(const Window *window);

/** Makes the other viewport the active one. */
void window_swap_active(Window *window);

/** Moves the bar between two pictures. @param fraction Fraction of the picture's width. */
void window_move_bar(Window *window, double fraction);

/** @return Whether the bar is under the mouse. @param fraction Position of the mouse, fraction of
 * the picture's width. */
bool window_is_at_bar(const Window *window, double fraction);

/** @return The picture's rectangle, pixels: as large as fits in the window, with the ratio of width
 *  to height that the scene asks for. */
SDL_Rect window_picture_rect(const Window *window);

/**
 * Finds a position of the mouse in the picture; while rays are shown, in their inset.
 * @param x  Screen units.
 * @param[out] right  Fraction of the picture's width.
 * @param[out] down   Fraction of its height.
 * @return Whether it is inside.
 */
bool window_picture_position(const Window *window, int x, int y, double *right, double *down);

/**
 * Finds the pixel that the readout names and whose rays are shown: the one that is magnified, else
 * the one under the mouse.
 * @return Whether there is one: the mouse may be outside the picture, or over a panel.
 */
bool window_named_pixel(const Window *window, PixelPosition *pixel);

/** @return The light whose mark is under the mouse; NULL: none. @param x Screen units. */
const LightMark *window_light_at(const Window *window, int x, int y);

/** Finds the ray under the mouse, while rays are shown. @param x Screen units. @param[out] ray Its
 *  index. @return Whether there is one. */
bool window_ray_at(const Window *window, int x, int y, size_t *ray);

/** Finds how far a light moves while its mark is dragged. See #light_marks_drag_offset. */
bool window_drag_offset(const Window *window, size_t light, GuiPoint from, GuiPoint to,
                        bool is_along, Vec3d *offset);

/** Finds how far a thing moves that is dragged at one of its points. See
 * #picture_drag_offset_at. */
bool window_drag_offset_at(const Window *window, Vec3d point, const PictureDrag *drag,
                           Vec3d *offset);

/** @return The height of the toolbar, pixels. */
int window_toolbar_height(const Window *window);

/** @return The part of the window for the picture: below the toolbar, beside the lesson panel,
 *  pixels. */
SDL_Rect window_area(const Window *window);

/** @return Height of the window that bar and lesson panel take, pixels. */
int window_used_height(const Window *window);

/** Returns the size of that part. @param[out] width Screen units. */
void window_size_below_toolbar(const Window *window, int *width, int *height);

/** Sets the size of that part. @param width Screen units. */
void window_set_size_below_toolbar(Window *window, int width, int height);

/** Creates buttons, lists and marks, once the first picture is on screen. */
void window_open_widgets(Window *window);

/** Shows or hides the chart of settings. */
void window_toggle_chart(Window *window);

/** Shows or hides the magnifier. */
void window_toggle_magnifier(Window *window);

/** Copies the colours of a part of the picture as it is seen: of one picture, of two, or of their
 *  difference. See #renderer_copy_part. */
void window_copy_part(const Window *window, int x, int y, int columns, int rows, uint8_t *rgb);

/** Lays bar and lesson panel out again after a change of their words or letters: the picture keeps
 *  its size. */
void window_relayout_toolbar(Window *window);

/** Opens or closes the panel of a lesson. @param panel What it shows; without a lesson: closed. */
void window_set_lesson_panel(Window *window, const LessonPanel *panel);

/** Shows or hides the toolbar. In a presentation, which has none: ends that and shows it. */
void window_toggle_toolbar(Window *window);

/** Begins a presentation: no bar, larger letters, the pointer as a ring; or ends it: the toolbar is
 *  shown or hidden as before. */
void window_toggle_presentation(Window *window);

/** Sets what the window shows beside its pictures. */
void window_set_state(Window *window, const WindowState *state);

/** Shows for a while what to press: at the start, and after a lesson. */
void window_set_hint(Window *window);

/** Takes the hint away: the user has begun. */
void window_end_hint(Window *window);

/** Takes the message on the picture away. */
void window_end_toast(Window *window);

/** Shows the message on the picture until it is replaced or ended. */
void window_keep_toast(Window *window);

/** Shows a message on the picture for a while. */
void window_set_toast(Window *window, const char *text);

/** Shows or hides settings and costs. */
void window_toggle_settings(Window *window);

/** Hides settings and costs that came by themselves, from the next frame on. */
void window_end_settings(Window *window);

/** Opens, closes and replaces renderers as the settings require. No thread may load a scene from
 * the old ones meanwhile. @return false without memory; the old renderers stay then. */
bool window_update_renderers(Window *window, const Scene *scene, Error *error);

/** Handles the event of a finished pass. */
void window_on_pass(Window *window, const SDL_Event *event);

/** Handles an event after which the window may be hidden or visible. */
void window_on_visibility(Window *window);

/** Handles an event after which the window may have another size; the picture is scaled until it is
 * rendered again. @return Whether it has. */
bool window_on_resize(Window *window);

/** Handles a reset of the graphics device: all textures are lost. */
void window_on_device_reset(Window *window);

/** Draws and shows everything. */
void window_present(Window *window);

/** Has all text drawn again: size, keyboard or language have changed. */
void window_invalidate_text(Window *window);

/** Makes all letters larger or smaller. @param steps Number of steps; 0: the default size. */
void window_scale_text(Window *window, int steps);

/** Shows a notice at the lower edge of the picture. @param text Empty: closes it. */
void window_set_notice(Window *window, const char *text);

/**
 * Starts rendering if anything changed, and shows the newest pass if it is due.
 * @param scene  The scene as it is now.
 * @return false without memory; the picture on screen stays then.
 */
bool window_update(Window *window, const Scene *scene, double now, Error *error);

/** @return Seconds until the next #window_update; #WINDOW_NO_TIMEOUT: until an event comes. */
double window_timeout(const Window *window, double now);

/** @return Whether a change would be rendered at once, with the previous one on screen. Moving only
 * then guarantees pictures in between on the slowest machine too. */
bool window_is_ready(const Window *window);

/** @return Whether the picture on screen is the last pass of the scene as it is now. */
bool window_is_finished(const Window *window);

/** Copies the picture on screen. @param[out] picture To be freed with #picture_deinit. @return
 * false without memory. */
bool window_copy_picture(Window *window, Picture *picture, Error *error);

/** Copies what is on the screen but bar and messages. @param[out] picture To be freed with
 *  #picture_deinit. @return false without memory, or if SDL cannot read the screen. */
bool window_copy_screen(Window *window, Picture *picture, Error *error);

#endif
