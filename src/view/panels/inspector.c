/**
 * @file
 * @brief The rays of one pixel in the window.
 */
#include "view/panels/inspector.h"

#include "view/panels/ray_overlay.h"

/** Degrees per second that held keys turn the second camera. */
static const double TURN_PER_SECOND = 45;
/** Factor of the zoom per second of a held key. */
static const double ZOOM_PER_SECOND = 2;
/** Size of the column of numbers and of the inset, fraction of the window. */
static const double COLUMN_FRACTION = 0.36;
/** Factor of the size of letters, if they fit. */
static const double FONT_SCALE = 1.7;

void inspector_reset(Inspector *inspector) {
    if (inspector->is_open) {
        inspector_toggle(inspector);
    }
    inspector->has_pixel = false;
}

void inspector_toggle(Inspector *inspector) {
    if (inspector->is_open) {
        inspector->is_open = false;
        viewport_close(&inspector->viewport);
        inspector_release_textures(inspector);
    } else if (inspector->has_pixel) {
        inspector_pick(inspector, inspector->x, inspector->y);
    } else {
        inspector_pick(inspector, 0.5, 0.5);
    }
}

/** Goes to a pixel. @param x Fraction of the picture's width. @param y Fraction of its height. */
static void set_pixel(Inspector *inspector, double x, double y) {
    const double last = 1 - 1e-9;
    inspector->is_open = inspector->has_pixel = inspector->needs_trace = true;
    inspector->x = SDL_clamp(x, 0, last);
    inspector->y = SDL_clamp(y, 0, last);
    inspector->selected = 0;
}

void inspector_pick(Inspector *inspector, double x, double y) {
    inspector->has_orbit = false;
    set_pixel(inspector, x, y);
}

void inspector_step_pixel(Inspector *inspector, int x, int y) {
    if (inspector->width > 0) {
        int column = (int)(inspector->x * inspector->width) + x;
        int row = (int)(inspector->y * inspector->height) + y;
        // The centre of the pixel, so that rounding cannot change it.
        set_pixel(inspector, (column + 0.5) / inspector->width, (row + 0.5) / inspector->height);
    }
}

void inspector_select_ray(Inspector *inspector, int step) {
    size_t count = inspector->ray_tree.count;
    if (count > 0) {
        inspector->selected = (inspector->selected + count + (size_t)(step + (int)count)) % count;
        inspector->needs_trace = true;
    }
}

void inspector_move(Inspector *inspector, Movement movement) {
    orbit_camera_rotate(&inspector->orbit, -TURN_PER_SECOND * movement.right,
                        -TURN_PER_SECOND * movement.up);
    orbit_camera_zoom(&inspector->orbit, pow(ZOOM_PER_SECOND, movement.forward));
    inspector->needs_draw = true;
}

void inspector_turn(Inspector *inspector, double right, double up) {
    orbit_camera_rotate(&inspector->orbit, -right, -up);
    inspector->needs_draw = true;
}

void inspector_invalidate(Inspector *inspector) {
    inspector->needs_trace = true;
}

void inspector_reset_camera(Inspector *inspector) {
    inspector->has_orbit = false;
    inspector->needs_trace = true;
}

void inspector_on_renderer_changed(Inspector *inspector) {
    inspector->is_renderer_outdated = inspector->needs_trace = true;
}

void inspector_on_pass(Inspector *inspector, const SDL_Event *event) {
    if (event->user.data1 == &inspector->viewport && inspector->viewport.renderer) {
        viewport_on_pass(&inspector->viewport);
    }
}

void inspector_stop(Inspector *inspector) {
    if (inspector->viewport.renderer && viewport_stop(&inspector->viewport)) {
        inspector->needs_draw = true;
    }
}

/* --- rooms of the window ------------------------------------------------------------------------
 */

SDL_Rect inspector_inset(const Inspector *inspector, const SDL_Rect *area) {
    SDL_Rect rect = {.w = (int)(COLUMN_FRACTION * area->w), .h = (int)(COLUMN_FRACTION * area->h)};
    if (inspector->width > 0) { // As large as fits, with the shape of the picture.
        double scale =
            SDL_min((double)rect.w / inspector->width, (double)rect.h / inspector->height);
        rect.w = (int)(scale * inspector->width);
        rect.h = (int)(scale * inspector->height);
    }
    rect.x = area->x + area->w - rect.w;
    rect.y = area->y + area->h - rect.h;
    return rect;
}

/** @return Rectangle of the second camera's view, pixels. */
static SDL_Rect side_view_rect(const SDL_Rect *area) {
    return (SDL_Rect){area->x, area->y, SDL_max(1, area->w - (int)(COLUMN_FRACTION * area->w)),
                      area->h};
}

/* --- keeping up --------------------------------------------------------------------------------
 */

/** Copies the positions of the lights. */
static void collect_light_positions(Inspector *inspector, const Scene *scene) {
    inspector->light_count = 0;
    for (size_t i = 0; i < scene->light_count && inspector->light_count < INSPECTOR_LIGHTS; i++) {
        Vec3d *position = &inspector->light_positions[inspector->light_count];
        inspector->light_count += scene_light_center(&scene->lights[i], position);
    }
}

/** Traces the rays, and writes their numbers. @return false without memory. */
static bool trace_rays(Inspector *inspector, const InspectorInput *input, Error *error) {
    int x = (int)(inspector->x * input->viewport->width),
        y = (int)(inspector->y * input->viewport->height);
    RayTree *ray_tree = &inspector->ray_tree;
    inspector->needs_trace = false;
    inspector->width = input->viewport->width;
    inspector->height = input->viewport->height;
    if (!renderer_record_ray_tree(input->viewport->renderer, x, y, ray_tree, error)) {
        inspector_toggle(inspector);
        return false;
    }
    if (!inspector->has_orbit) {
        SDL_Rect rect = side_view_rect(&input->area);
        inspector->orbit = orbit_camera_fit(input->viewport->renderer, &input->scene->camera,
                                            ray_tree, rect.w, rect.h);
        inspector->has_orbit = true;
    }
    inspector->selected = SDL_min(inspector->selected, ray_tree->count - 1);
    inspector->needs_draw = true;
    collect_light_positions(inspector, input->scene);
    inspector_rows_write(inspector, input, x, y);
    inspector_invalidate_panel(inspector);
    return true;
}

/** @return Settings of the second camera's view: those of the picture, with fewer samples and at
 * most double precision. */
static RenderSettings side_view_settings(const RenderSettings *settings) {
    /** Most samples; sufficient bits of the mantissa. */
    const int samples = 4, bits = 53;
    RenderSettings side = *settings;
    side.samples = SDL_min(side.samples, samples);
    if (side.engine->mantissa_bits > bits) {
        side.engine = engine_find("auto", NULL);
    }
    return side;
}

/** Creates the second camera's renderer, or replaces it after a change of the scene. @param scene
 * The scene, with the second camera. @return false without memory. */
static bool update_side_renderer(Inspector *inspector, const InspectorInput *input,
                                 const Scene *scene, Error *error) {
    Viewport *viewport = &inspector->viewport;
    RenderSettings settings = side_view_settings(&input->viewport->settings);
    bool is_outdated = inspector->is_renderer_outdated;
    inspector->is_renderer_outdated = false;
    if (!viewport->renderer) {
        return viewport_open(viewport, input->viewport, scene, &settings, input->pass_event, error);
    }
    if (is_outdated) {
        renderer_stop(viewport->renderer);
        Renderer *renderer =
            renderer_create_reusing(input->viewport->renderer, scene, &settings, error);
        if (!renderer) {
            return false;
        }
        viewport_set_renderer(viewport, renderer, &settings);
    }
    return true;
}

/** Starts to render the second camera's view. @return false without memory. */
static bool draw_side_view(Inspector *inspector, const InspectorInput *input, Error *error) {
    Scene scene = *input->scene;
    SDL_Rect rect = side_view_rect(&input->area);
    scene.camera = orbit_camera_project(&inspector->orbit, rect.w, rect.h).camera;
    inspector->needs_draw = false;
    return update_side_renderer(inspector, input, &scene, error) &&
           viewport_start(&inspector->viewport, &scene, rect.w, rect.h, input->now, error);
}

bool inspector_update(Inspector *inspector, const InspectorInput *input, SDL_Renderer *renderer,
                      Error *error) {
    Viewport *viewport = &inspector->viewport;
    bool ok = true;
    if (inspector->is_open && inspector->needs_trace) {
        ok = trace_rays(inspector, input, error);
    }
    if (inspector->is_open && inspector->needs_draw) {
        inspector->needs_present = true;
        ok = (viewport->awaits_first_frame || draw_side_view(inspector, input, error)) && ok;
    }
    if (inspector->is_open && viewport->renderer && viewport_has_frame(viewport, input->now)) {
        inspector->needs_present = viewport_upload(viewport, renderer) || inspector->needs_present;
    }
    return ok;
}

/* --- showing -----------------------------------------------------------------------------------
 */

/** Draws the inset: the picture, and a mark at the pixel. */
static void draw_inset(const Inspector *inspector, const StreamingTexture *texture,
                       SDL_Renderer *renderer, const SDL_Rect *rect) {
    streaming_texture_draw(texture, renderer, rect, rect);
    SDL_RenderSetClipRect(renderer, rect);
    ray_overlay_mark_pixel(renderer, rect->x + inspector->x * rect->w,
                           rect->y + inspector->y * rect->h, 0.08 * rect->h);
    SDL_RenderSetClipRect(renderer, NULL);
}

/** Draws the panel of numbers. */
static void render_panel(Inspector *inspector, const OverlayTarget *target,
                         const SDL_Rect *column) {
    PanelBounds bounds = {column->w, column->h, FONT_SCALE * target->scale};
    SDL_Surface *panel = panel_draw(inspector->rows, inspector->row_count, &bounds);
    if (panel) {
        inspector->panel = SDL_CreateTextureFromSurface(target->renderer, panel);
        SDL_FreeSurface(panel);
    }
}

/** Shows the panel of numbers in its column. */
static void draw_panel_column(Inspector *inspector, const OverlayTarget *target,
                              const SDL_Rect *column) {
    SDL_Rect destination = *column;
    if (!inspector->panel) {
        render_panel(inspector, target, column);
    }
    SDL_SetRenderDrawColor(target->renderer, 15, 18, 28, SDL_ALPHA_OPAQUE);
    SDL_RenderFillRect(target->renderer, column);
    if (inspector->panel) {
        SDL_QueryTexture(inspector->panel, NULL, NULL, &destination.w, &destination.h);
        SDL_RenderCopy(target->renderer, inspector->panel, NULL, &destination);
    }
}

void inspector_show(Inspector *inspector, const StreamingTexture *texture,
                    const OverlayTarget *target, const SDL_Rect *area) {
    inspector->needs_present = false;
    SDL_Rect rect = side_view_rect(area), inset = inspector_inset(inspector, area);
    SDL_Rect column = {rect.x + rect.w, area->y, area->w - rect.w, inset.y - area->y};
    streaming_texture_draw(&inspector->viewport.texture, target->renderer, &rect, &rect);
    if (inspector->ray_tree.count > 0) {
        RayOverlay overlay = {.light_positions = inspector->light_positions,
                              .light_count = inspector->light_count,
                              .ray_tree = &inspector->ray_tree,
                              .orbit = &inspector->orbit,
                              .selected = inspector->selected};
        ray_overlay_draw(&overlay, target->renderer, &rect);
        draw_panel_column(inspector, target, &column);
    }
    draw_inset(inspector, texture, target->renderer, &inset);
}

void inspector_invalidate_panel(Inspector *inspector) {
    if (inspector->panel) {
        SDL_DestroyTexture(inspector->panel);
        inspector->panel = NULL;
    }
}

void inspector_release_textures(Inspector *inspector) {
    streaming_texture_release(&inspector->viewport.texture);
    inspector_invalidate_panel(inspector);
    inspector->needs_trace = true;
}

void inspector_deinit(Inspector *inspector) {
    viewport_close(&inspector->viewport);
    inspector_release_textures(inspector);
    ray_tree_deinit(&inspector->ray_tree);
}
