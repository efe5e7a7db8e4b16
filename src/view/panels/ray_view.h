/**
 * @file
 * @brief The view of rays: the rays of one pixel, drawn into the scene as a second camera sees it,
 * with their list, their formulas and their sum. It follows whatever moves.
 */
#ifndef DIOPTRE_VIEW_PANELS_RAY_VIEW_H
#define DIOPTRE_VIEW_PANELS_RAY_VIEW_H

#include "render/ray_formula.h"
#include "view/panels/help.h"
#include "view/panels/ray_overlay.h"
#include "view/state/held_keys.h"
#include "view/window/viewport.h"

/** Bytes of the heading with the final zero. */
enum { RAY_VIEW_HEADING_SIZE = 96 };
/** Largest number of lights that are marked. */
enum { RAY_VIEW_LIGHTS = 32 };
/** Kinds of rays. */
enum { RAY_KINDS = RAY_REFRACTION + 1 };

/** What the user asks for by a click; the event loop issues it as a command. */
typedef struct RayViewRequest {
    const char *command; /**< Name of a command; NULL: none. */
    bool has_ray;        /**< Whether a ray was clicked. */
    size_t ray;          /**< Its index. */
} RayViewRequest;

/** The view of rays. Starts as `{0}`: closed. */
typedef struct RayView {
    bool is_open;          /**< Whether it is shown. */
    bool has_pixel;        /**< Whether a pixel was picked yet. */
    bool is_marked;        /**< Whether the picture shows it before its rays are shown. */
    double x;              /**< Position of the pixel, fraction of the picture's width. */
    double y;              /**< The same, fraction of its height, from the top. */
    int width;             /**< Size of the picture whose rays were traced last; 0: none. */
    int height;            /**< The same. */
    bool needs_trace;      /**< Whether the rays must be traced again. */
    bool is_new;           /**< Whether no rays of the pixel were traced yet. */
    bool needs_text;       /**< Whether the formulas must be written again. */
    bool needs_draw;       /**< Whether the second camera has moved since its render was started. */
    bool needs_present;    /**< Whether anything changed since it was shown. */
    bool has_orbit;        /**< Whether #orbit is set. */
    RayTree ray_tree;      /**< The rays. */
    OrbitCamera orbit;     /**< The second camera. */
    size_t selected;       /**< Index of the chosen ray. */
    size_t hovered;        /**< Index of the ray under the mouse, plus 1; 0: none. */
    unsigned hidden_kinds; /**< Kinds of rays that are hidden: bit i is #RayType i. */
    double flight_start;   /**< When the chosen ray began its flight, seconds; 0: it is still. */
    int frames_to_reveal;  /**< Frames in which the list scrolls to the chosen ray. */
    bool is_renderer_outdated; /**< Whether the scene was replaced since the second camera's
                                  renderer was created. */
    Viewport viewport;         /**< Viewport of the second camera. */
    Vec3d light_positions[RAY_VIEW_LIGHTS]; /**< Positions of the lights. */
    size_t light_count;                     /**< Number of #light_positions. */
    CutAway cut;                            /**< Shapes that hide the rays. */
    OverlayImage overlay;                   /**< The drawn rays. */
    RayPane pane;                           /**< The drawing beside the view. */
    OverlayImage pane_image;                /**< That drawing. */
    bool is_along_light;                    /**< Whether arrows show the way of the light. */
    char heading[RAY_VIEW_HEADING_SIZE];    /**< The pixel and its colour. */
    RayFormulas formulas;                   /**< Formulas of the chosen ray. */
    RayFormulas sum;                        /**< Its sum. */
    int pages_to_scroll;                    /**< Pages by which the next frame scrolls formulas and
                                                 sum. */
    RayViewRequest request;                 /**< What the user has clicked on. */
    bool shows_hint;                        /**< Whether the list says what to do next. */
    bool is_in_lesson;                      /**< Whether a lesson has its words beside the view. */
    double buttons_fraction; /**< Height of its own row of buttons, fraction of the view of rays; 0:
                                  it has none, or none was shown yet. */
} RayView;

/** The picture whose rays are shown. */
typedef struct RayViewInput {
    const Viewport *viewport; /**< Its viewport. */
    const Scene *scene;       /**< Its scene. */
    uint32_t pass_event;      /**< SDL event of a finished pass. */
    double now;               /**< Now, seconds. */
    SDL_Rect area;            /**< The part of the window that it fills, pixels. */
} RayViewInput;

/** Opens it at the last pixel, or first at the middle; or closes it. */
void ray_view_toggle(RayView *ray_view);

/** Closes it, and forgets the pixel and how rays were drawn. */
void ray_view_reset(RayView *ray_view);

/** Opens it at a pixel, with a new view of the rays. @param x Fraction of the picture's width.
 * @param y Fraction of its height, from the top. */
void ray_view_pick(RayView *ray_view, double x, double y);

/** Chooses the pixel whose rays #ray_view_toggle will show. @param x Fraction of the picture's
 *  width. @param y Fraction of its height. */
void ray_view_aim(RayView *ray_view, double x, double y);

/** Chooses the pixel as #ray_view_aim does, and marks it in the picture until rays are shown. */
void ray_view_mark(RayView *ray_view, double x, double y);

/** Marks the pixel in a picture. @param rect Where the picture is. */
void ray_view_show_mark(const RayView *ray_view, SDL_Renderer *renderer, const SDL_Rect *rect);

/** Goes to a pixel nearby, with the same view. @param x Pixels to the right. @param y Pixels down.
 */
void ray_view_step_pixel(RayView *ray_view, int x, int y);

/** Chooses another ray whose kind is not hidden. @param step 1: the next; -1: the previous. */
void ray_view_select_ray(RayView *ray_view, int step);

/** Chooses a ray. @param ray Its index; one that does not exist counts as the last. */
void ray_view_choose_ray(RayView *ray_view, size_t ray);

/** Chooses the next ray, which flies along its path. @param now Seconds. */
void ray_view_fly(RayView *ray_view, double now);

/** Hides the rays of a kind, or shows them again. */
void ray_view_toggle_kind(RayView *ray_view, RayType kind);

/** Shows a drawing beside the view, or takes it away. */
void ray_view_toggle_pane(RayView *ray_view, RayPane pane);

/** Scrolls formulas and sum. @param pages Pages down; negative: up. */
void ray_view_scroll(RayView *ray_view, int pages);

/** Turns all arrows round: along the light, or along the rays. */
void ray_view_turn_arrows(RayView *ray_view);

/** Finds the ray under the mouse. @param x Pixels of the window. @param area See
 *  #RayViewInput.area. @param[out] ray Its index. @return Whether there is one. */
bool ray_view_ray_at(const RayView *ray_view, double x, double y, const SDL_Rect *area,
                     size_t *ray);

/** Moves the second camera around the rays. */
void ray_view_move(RayView *ray_view, Movement movement);

/** Turns the second camera around the rays, as if the mouse held them. @param right Degrees to the
 * right. @param up Degrees up. */
void ray_view_turn(RayView *ray_view, double right, double up);

/** Notifies that the scene, its camera or its lights have changed. */
void ray_view_invalidate(RayView *ray_view);

/** Puts the second camera back to its best view. */
void ray_view_reset_camera(RayView *ray_view);

/** The picture has another renderer. */
void ray_view_on_renderer_changed(RayView *ray_view);

/** Handles the event of a finished pass, if it is its own. */
void ray_view_on_pass(RayView *ray_view, const SDL_Event *event);

/** Stops an unfinished render, as the window is hidden. */
void ray_view_stop(RayView *ray_view);

/**
 * Traces the rays and renders the second camera's view, if anything changed.
 * @param renderer  Renderer of the window.
 * @return false without memory: it is closed then.
 */
bool ray_view_update(RayView *ray_view, const RayViewInput *input, SDL_Renderer *renderer,
                     Error *error);

/** @return Seconds until it changes by itself; see #VIEWPORT_NO_TIMEOUT. */
double ray_view_timeout(const RayView *ray_view, double now);

/** Where the parts of the view are. */
typedef struct RayViewLayout {
    SDL_Rect buttons;    /**< The row of buttons at the top. */
    SDL_Rect view;       /**< The second camera's picture. */
    SDL_Rect pane;       /**< The drawing beside it; empty: there is none. */
    SDL_Rect formulas;   /**< The formulas of the chosen ray and its sum, above it. */
    SDL_Rect list;       /**< The list of rays. */
    SDL_Rect inset_room; /**< The room below the list. */
    SDL_Rect inset;      /**< The picture whose rays are shown, in that room. */
} RayViewLayout;

/** @return Where its parts are. @param area The part of the window that it fills, in the unit of
 *  the result. */
RayViewLayout ray_view_layout(const RayView *ray_view, const SDL_Rect *area);

/** Draws its pictures. @param texture The picture whose rays are shown. @param area See
 *  #RayViewInput.area. */
void ray_view_show(RayView *ray_view, const StreamingTexture *texture, SDL_Renderer *renderer,
                   const SDL_Rect *area);

/**
 * Shows list, formulas, sum and numbers; sets #RayView.request if the user clicks on them.
 * @param area   See #RayViewInput.area, but in screen units.
 * @param scale  Pixels per screen unit.
 */
void ray_view_show_widgets(RayView *ray_view, const Scene *scene, const SDL_Rect *area,
                           double scale);

/** Shows its buttons in a bar that has begun: how to leave, the rays one by one, the drawings
 * beside the view, and the kinds of rays. Sets #RayView.request if the user clicks on one. */
void ray_view_show_buttons(RayView *ray_view, const Help *help);

/** Shows the buttons in a row of its own above the view, where no toolbar has them. @param area See
 *  #ray_view_show_widgets. */
void ray_view_show_own_row(RayView *ray_view, const Help *help, const SDL_Rect *area);

/** Lays the view out anew: its part of the window has another height. */
void ray_view_on_room_changed(RayView *ray_view);

/** Frees its textures: the graphics device was reset, or size or language have changed. */
void ray_view_release_textures(RayView *ray_view);

/** Frees everything. */
void ray_view_deinit(RayView *ray_view);

/** @return The rays as they are drawn, without the target. @param view Size of the second camera's
 *  picture. */
RayDrawing ray_view_drawing(const RayView *ray_view, const SDL_Rect *view);

/** @return How far the chosen ray has flown, 0 to 1; 1: it is still. */
double ray_view_flight(const RayView *ray_view, double now);

/** Lays the view out below its buttons. @param fraction Their height, fraction of the view; 0: they
 *  are elsewhere. */
void ray_view_set_buttons(RayView *ray_view, double fraction);

/** Writes heading, formulas and sum. @param x Column of the pixel. */
void ray_view_write_text(RayView *ray_view, const RayViewInput *input, int x, int y);

#endif
