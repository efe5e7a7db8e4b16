/**
 * @file
 * @brief The inspector: the rays of one pixel, drawn into the scene as a second camera sees it,
 * with their numbers. It follows whatever moves.
 */
#ifndef DIOPTRE_VIEW_PANELS_INSPECTOR_H
#define DIOPTRE_VIEW_PANELS_INSPECTOR_H

#include "render/orbit_camera.h"
#include "view/panels/panel.h"
#include "view/state/held_keys.h"
#include "view/window/viewport.h"

/** Most rows of numbers. */
enum { INSPECTOR_ROWS = 40 };
/** Bytes of a row with the final zero. */
enum { INSPECTOR_TEXT_SIZE = 128 };
/** Largest number of lights that are marked. */
enum { INSPECTOR_LIGHTS = 32 };

/** The inspector. Starts as `{0}`: closed. */
typedef struct Inspector {
    bool is_open;       /**< Whether it is shown. */
    bool has_pixel;     /**< Whether a pixel was picked yet. */
    double x;           /**< Position of the pixel, fraction of the picture's width. */
    double y;           /**< The same, fraction of its height, from the top. */
    int width;          /**< Size of the picture whose rays were traced last; 0: none. */
    int height;         /**< The same. */
    bool needs_trace;   /**< Whether the rays must be traced again. */
    bool needs_draw;    /**< Whether the second camera has moved since its render was started. */
    bool needs_present; /**< Whether anything changed since it was shown. */
    bool has_orbit;     /**< Whether #orbit is set. */
    RayTree ray_tree;   /**< The rays. */
    OrbitCamera orbit;  /**< The second camera. */
    size_t selected;    /**< Index of the ray whose numbers are shown. */
    bool is_renderer_outdated; /**< Whether the scene was replaced since the second camera's
                                  renderer was created. */
    Viewport viewport;         /**< Viewport of the second camera. */
    Vec3d light_positions[INSPECTOR_LIGHTS]; /**< Positions of the lights. */
    size_t light_count;                      /**< Number of #light_positions. */
    SDL_Texture *panel;            /**< Panel of the numbers; NULL: it must be drawn; owned. */
    PanelRow rows[INSPECTOR_ROWS]; /**< Rows of the panel. */
    char row_texts[INSPECTOR_ROWS][INSPECTOR_TEXT_SIZE]; /**< Their texts. */
    size_t row_count;                                    /**< Number of rows. */
} Inspector;

/** The picture whose rays are shown. */
typedef struct InspectorInput {
    const Viewport *viewport; /**< Its viewport. */
    const Scene *scene;       /**< Its scene. */
    uint32_t pass_event;      /**< SDL event of a finished pass. */
    double now;               /**< Now, seconds. */
    SDL_Rect area;            /**< The part of the window that it fills, pixels. */
} InspectorInput;

/** Opens it at the last pixel, or first at the middle; or closes it. */
void inspector_toggle(Inspector *inspector);

/** Closes it, and forgets the pixel. */
void inspector_reset(Inspector *inspector);

/** Opens it at a pixel, with a new view of the rays. @param x Fraction of the picture's width.
 * @param y Fraction of its height, from the top. */
void inspector_pick(Inspector *inspector, double x, double y);

/** Goes to a pixel nearby, with the same view. @param x Pixels to the right. @param y Pixels down.
 */
void inspector_step_pixel(Inspector *inspector, int x, int y);

/** Shows the numbers of another ray. @param step 1: the next; -1: the previous. */
void inspector_select_ray(Inspector *inspector, int step);

/** Moves the second camera around the rays. */
void inspector_move(Inspector *inspector, Movement movement);

/** Turns the second camera around the rays, as if the mouse held them. @param right Degrees to the
 * right. @param up Degrees up. */
void inspector_turn(Inspector *inspector, double right, double up);

/** Notifies that the scene, its camera or its lights have changed. */
void inspector_invalidate(Inspector *inspector);

/** Puts the second camera back to its best view. */
void inspector_reset_camera(Inspector *inspector);

/** The picture has another renderer. */
void inspector_on_renderer_changed(Inspector *inspector);

/** Handles the event of a finished pass, if it is its own. */
void inspector_on_pass(Inspector *inspector, const SDL_Event *event);

/** Stops an unfinished render, as the window is hidden. */
void inspector_stop(Inspector *inspector);

/**
 * Traces the rays and renders the second camera's view, if anything changed.
 * @param renderer  Renderer of the window.
 * @return false without memory: it is closed then.
 */
bool inspector_update(Inspector *inspector, const InspectorInput *input, SDL_Renderer *renderer,
                      Error *error);

/** Draws it. @param texture The picture whose rays are shown. @param area See
 *  #InspectorInput.area. */
void inspector_show(Inspector *inspector, const StreamingTexture *texture,
                    const OverlayTarget *target, const SDL_Rect *area);

/** @return Rectangle of the inset with the picture, pixels. @param area See #InspectorInput.area.
 */
SDL_Rect inspector_inset(const Inspector *inspector, const SDL_Rect *area);

/** Has the panel drawn again. */
void inspector_invalidate_panel(Inspector *inspector);

/** Frees its textures: the graphics device was reset, or size or language have changed. */
void inspector_release_textures(Inspector *inspector);

/** Frees everything. */
void inspector_deinit(Inspector *inspector);

/** Writes the rows of the panel: the rays, the selected one in full, and the sum of the pixel.
 *  @param[in,out] inspector Its rays are read, its rows written. @param x Column of the pixel. */
void inspector_rows_write(Inspector *inspector, const InspectorInput *input, int x, int y);

#endif
