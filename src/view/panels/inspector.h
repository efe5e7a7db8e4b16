/**
 * @file
 * @brief The rays of one pixel in the window: drawn into the scene as a second camera sees it, with
 *        their numbers beside. It follows whatever moves.
 */
#ifndef DIOPTRE_VIEW_PANELS_INSPECTOR_H
#define DIOPTRE_VIEW_PANELS_INSPECTOR_H

#include "render/orbit_camera.h"
#include "view/panels/panel.h"
#include "view/state/held_keys.h"
#include "view/window/viewport.h"

/** Rows of numbers at most. */
enum { INSPECTOR_ROWS = 40 };
/** Bytes of a row at most. */
enum { INSPECTOR_TEXT_SIZE = 128 };
/** Lamps that are marked at most. */
enum { INSPECTOR_LIGHTS = 32 };

/** The rays of one pixel in the window. Starts as `{0}`: closed, at the upper left. */
typedef struct Inspector {
    bool is_open;       /**< Whether it is shown. */
    bool has_pixel;     /**< Whether a pixel was picked yet. */
    double x;           /**< The pixel, as a share of the picture's width. */
    double y;           /**< The pixel, as a share of its height. */
    int width;          /**< Pixels of the picture that was looked into last; 0: none was. */
    int height;         /**< Pixels of it. */
    bool needs_trace;   /**< Whether the rays must be traced anew. */
    bool needs_draw;    /**< Whether the second camera has moved since its picture was begun. */
    bool needs_present; /**< Whether there is something that was not shown yet. */
    bool has_orbit;     /**< Whether it was chosen how the rays are looked at. */
    RayTree ray_tree;   /**< The rays. */
    OrbitCamera orbit;  /**< How they are looked at. */
    size_t selected;    /**< The ray whose numbers are shown. */
    bool is_renderer_outdated; /**< Whether the scene is another one than the second camera sees. */
    Viewport viewport;         /**< What the second camera sees. */
    Vec3d light_positions[INSPECTOR_LIGHTS]; /**< Where lamps are. */
    size_t light_count;                      /**< How many. */
    SDL_Texture *panel;            /**< The numbers as a picture; NULL: to be made; owned. */
    PanelRow rows[INSPECTOR_ROWS]; /**< The numbers. */
    char row_texts[INSPECTOR_ROWS][INSPECTOR_TEXT_SIZE]; /**< What the rows say. */
    size_t row_count;                                    /**< How many rows. */
} Inspector;

/** What is looked into. */
typedef struct InspectorInput {
    const Viewport *viewport; /**< The picture, with its newest camera. */
    const Scene *scene;       /**< The scene as it is drawn. */
    uint32_t pass_event;      /**< SDL event that tells of a finished pass. */
    double now;               /**< Now, seconds. */
} InspectorInput;

/** Opens it at the pixel that was picked last, at first at the middle; or closes it. */
void inspector_toggle(Inspector *inspector);

/** Closes it, and forgets which pixel was picked. */
void inspector_reset(Inspector *inspector);

/**
 * Opens it at a pixel, or goes there.
 * @param x  The pixel, as a share of the picture's width.
 * @param y  As a share of its height.
 */
void inspector_pick(Inspector *inspector, double x, double y);

/** Goes to a pixel beside; it is looked at from where it is. @param x Pixels to the right. */
void inspector_step_pixel(Inspector *inspector, int x, int y);

/** Shows the numbers of another ray. @param step 1: the next; -1: the one before. */
void inspector_select_ray(Inspector *inspector, int step);

/** Moves the second camera around the rays. */
void inspector_move(Inspector *inspector, Movement movement);

/** Turns the second camera around the rays, as if they were held. @param right Degrees to the
 *  right. */
void inspector_turn(Inspector *inspector, double right, double up);

/** The scene, its camera or its lamps have changed. */
void inspector_invalidate(Inspector *inspector);

/** It is looked at the rays anew, as is best. */
void inspector_reset_camera(Inspector *inspector);

/** Another renderer draws the picture from now on. */
void inspector_on_renderer_changed(Inspector *inspector);

/** Takes note of the event that a pass has ended, if it is its own. */
void inspector_on_pass(Inspector *inspector, const SDL_Event *event);

/** Stops an unfinished drawing, as nobody sees it. */
void inspector_stop(Inspector *inspector);

/**
 * Traces the rays anew if anything changed, and draws what the second camera sees.
 * @param renderer  What draws in the window.
 * @return false without memory: it is closed then.
 */
bool inspector_update(Inspector *inspector, const InspectorInput *input, SDL_Renderer *renderer,
                      Error *error);

/** Shows it over the whole window. @param texture The picture that is looked into. */
void inspector_show(Inspector *inspector, const StreamingTexture *texture,
                    const OverlayTarget *target);

/**
 * @return Where the picture that is looked into lies while this is open, pixels of the window.
 * @param width  Pixels of the window.
 */
SDL_Rect inspector_inset(int width, int height);

/** Forgets its words: they are drawn anew. */
void inspector_invalidate_panel(Inspector *inspector);

/** Forgets its pictures: the graphics card lost them, size or words have changed. */
void inspector_release_textures(Inspector *inspector);

/** Gives all back. */
void inspector_deinit(Inspector *inspector);

/** Writes the rows of the panel: the rays, the selected one in full, and the sum of the pixel.
 *  @param[in,out] inspector Its rays are read, its rows written. @param x Column of the pixel. */
void inspector_rows_write(Inspector *inspector, const InspectorInput *input, int x, int y);

#endif
