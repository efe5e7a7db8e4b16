/**
 * @file
 * @brief The rays of one pixel in the window.
 */
#include "view/panels/ray_view.h"

/** Frames in which the list scrolls to the chosen ray: the first one learns its height. */
enum { REVEAL_FRAMES = 4 };
/** Degrees per second that held keys turn the second camera. */
static const double TURN_PER_SECOND = 45;
/** Factor of the zoom per second of a held key. */
static const double ZOOM_PER_SECOND = 2;
/** Largest width of the column of the list and the inset, and height of the inset, fraction of the
 *  view: a picture of the view's own shape fills the column's width. */
static const double COLUMN_FRACTION = 0.4;
/** Least width of that column, fraction of the view: its rows would break into single words. */
static const double COLUMN_FRACTION_MINIMUM = 0.3;
/** Colour of the ground beside an inset that is narrower than its column, 0xRRGGBB: that of the
 *  list above it. */
static const unsigned INSET_GROUND = 0x0d0f18;
/** Length of an arm of the mark at the pixel, fraction of the picture's height. */
static const double MARK_FRACTION = 0.08;
/** Width of the drawing beside the view, fraction of both. */
static const double PANE_FRACTION = 0.5;
/** Rows of text that fill the height of the window, as everywhere in it. */
static const double ROWS_PER_WINDOW = 30;
/** Smallest height of letters, pixels. */
static const double TEXT_SIZE_MINIMUM = 14;
/** Width of the line between the view and the inset, fraction of the view's height. */
static const double RULE_FRACTION = 0.004;
/** Height of formulas and sum, fraction of the view: they are what it is opened for. */
static const double FORMULAS_FRACTION = 0.46;
/** The same in a lesson, whose words stand beside the view and are about the picture. */
static const double LESSON_FORMULAS_FRACTION = 0.25;
/** Difference of heights of the buttons that is only rounding. */
static const double BUTTONS_TOLERANCE = 0.004;
/** Seconds in which a ray flies along its path. */
static const double FLIGHT_SECONDS = 0.4;
/** Seconds from one picture of a flight to the next: a frame of a 60 Hz screen. */
static const double FLIGHT_INTERVAL = 0.016;
/** How near to a ray the mouse chooses it, fraction of the picture's height. */
static const double RAY_REACH = 0.02;

void ray_view_reset(RayView *ray_view) {
    if (ray_view->is_open) {
        ray_view_toggle(ray_view);
    }
    ray_view->has_pixel = ray_view->is_marked = ray_view->is_along_light = false;
    ray_view->hidden_kinds = 0;
    ray_view->pane = RAY_PANE_NONE;
}

void ray_view_toggle(RayView *ray_view) {
    if (ray_view->is_open) {
        ray_view->is_open = false;
        viewport_close(&ray_view->viewport);
        ray_view_release_textures(ray_view);
    } else if (ray_view->has_pixel) {
        ray_view_pick(ray_view, ray_view->x, ray_view->y);
    } else {
        ray_view_pick(ray_view, 0.5, 0.5);
    }
}

/** Goes to a pixel. @param x Fraction of the picture's width. @param y Fraction of its height. */
static void set_pixel(RayView *ray_view, double x, double y) {
    const double last = 1 - 1e-9;
    ray_view->is_open = ray_view->has_pixel = true;
    ray_view->needs_trace = ray_view->is_new = true;
    ray_view->is_marked = false;
    ray_view->x = SDL_clamp(x, 0, last);
    ray_view->y = SDL_clamp(y, 0, last);
    ray_view->selected = 0;
    ray_view->frames_to_reveal = REVEAL_FRAMES;
    ray_view->flight_start = 0;
}

void ray_view_pick(RayView *ray_view, double x, double y) {
    ray_view->has_orbit = false;
    set_pixel(ray_view, x, y);
}

void ray_view_aim(RayView *ray_view, double x, double y) {
    if (!ray_view->is_open) {
        ray_view->x = x;
        ray_view->y = y;
        ray_view->has_pixel = true;
        ray_view->has_orbit = false;
    }
}

void ray_view_mark(RayView *ray_view, double x, double y) {
    ray_view_aim(ray_view, x, y);
    ray_view->is_marked = !ray_view->is_open;
}

void ray_view_step_pixel(RayView *ray_view, int x, int y) {
    if (ray_view->width > 0) {
        int column = (int)(ray_view->x * ray_view->width) + x;
        int row = (int)(ray_view->y * ray_view->height) + y;
        // The centre of the pixel, so that rounding cannot change it.
        set_pixel(ray_view, (column + 0.5) / ray_view->width, (row + 0.5) / ray_view->height);
    }
}

/** The chosen ray has changed, or how rays are drawn. */
static void redraw_rays(RayView *ray_view) {
    ray_overlay_release(&ray_view->overlay);
    ray_overlay_release(&ray_view->pane_image);
    ray_view->frames_to_reveal = REVEAL_FRAMES;
    ray_view->needs_text = ray_view->needs_present = true;
}

void ray_view_choose_ray(RayView *ray_view, size_t ray) {
    if (ray_view->ray_tree.count > 0) {
        ray_view->selected = SDL_min(ray, ray_view->ray_tree.count - 1);
        ray_view->flight_start = 0;
        redraw_rays(ray_view);
    }
}

/** @return Whether the rays of a kind are hidden. */
static bool is_hidden(const RayView *ray_view, size_t ray) {
    return ray_view->hidden_kinds >> ray_view->ray_tree.nodes[ray].kind & 1;
}

void ray_view_select_ray(RayView *ray_view, int step) {
    size_t count = ray_view->ray_tree.count, ray = ray_view->selected;
    for (size_t turn = 0; turn < count; turn++) {
        ray = (ray + count + (size_t)(step + (int)count)) % count;
        if (!is_hidden(ray_view, ray)) {
            break;
        }
    }
    ray_view_choose_ray(ray_view, ray);
}

void ray_view_fly(RayView *ray_view, double now) {
    ray_view_select_ray(ray_view, 1);
    ray_view->flight_start = ray_view->ray_tree.count > 0 ? now : 0;
}

double ray_view_flight(const RayView *ray_view, double now) {
    bool flies = ray_view->flight_start > 0;
    return flies ? SDL_clamp((now - ray_view->flight_start) / FLIGHT_SECONDS, 0, 1) : 1;
}

void ray_view_toggle_kind(RayView *ray_view, RayType kind) {
    ray_view->hidden_kinds ^= 1U << kind;
    redraw_rays(ray_view);
}

void ray_view_toggle_pane(RayView *ray_view, RayPane pane) {
    ray_view->pane = ray_view->pane == pane ? RAY_PANE_NONE : pane;
    ray_view_reset_camera(ray_view); // The view has another shape.
    redraw_rays(ray_view);
}

void ray_view_scroll(RayView *ray_view, int pages) {
    ray_view->pages_to_scroll += pages;
    ray_view->needs_present = true;
}

void ray_view_set_buttons(RayView *ray_view, double fraction) {
    if (fabs(fraction - ray_view->buttons_fraction) > BUTTONS_TOLERANCE) {
        ray_view->buttons_fraction = fraction;
        ray_view_on_room_changed(ray_view);
    }
}

void ray_view_on_room_changed(RayView *ray_view) {
    ray_view_reset_camera(ray_view); // The view has another height.
    redraw_rays(ray_view);
}

void ray_view_turn_arrows(RayView *ray_view) {
    ray_view->is_along_light = !ray_view->is_along_light;
    redraw_rays(ray_view);
}

void ray_view_move(RayView *ray_view, Movement movement) {
    orbit_camera_rotate(&ray_view->orbit, -TURN_PER_SECOND * movement.right,
                        -TURN_PER_SECOND * movement.up);
    if (ray_view->selected < ray_view->ray_tree.count) {
        const RayTreeNode *chosen = &ray_view->ray_tree.nodes[ray_view->selected];
        orbit_camera_zoom(&ray_view->orbit, pow(ZOOM_PER_SECOND, movement.forward),
                          orbit_camera_ray_middle(&ray_view->orbit, chosen));
    }
    ray_view->needs_draw = true;
}

void ray_view_turn(RayView *ray_view, double right, double up) {
    orbit_camera_rotate(&ray_view->orbit, -right, -up);
    ray_view->needs_draw = true;
}

void ray_view_invalidate(RayView *ray_view) {
    ray_view->needs_trace = true;
}

void ray_view_reset_camera(RayView *ray_view) {
    ray_view->has_orbit = false;
    ray_view->needs_trace = true;
}

void ray_view_on_renderer_changed(RayView *ray_view) {
    ray_view->is_renderer_outdated = ray_view->needs_trace = true;
}

void ray_view_on_pass(RayView *ray_view, const SDL_Event *event) {
    if (event->user.data1 == &ray_view->viewport && ray_view->viewport.renderer) {
        viewport_on_pass(&ray_view->viewport);
    }
}

void ray_view_stop(RayView *ray_view) {
    if (ray_view->viewport.renderer && viewport_stop(&ray_view->viewport)) {
        ray_view->needs_draw = true;
    }
}

/* --- rooms of the window ------------------------------------------------------------------------
 */

/** Finds the inset, as large as fits with the shape of the picture, and the room for it in the
 * lower right corner, which it fills but in a narrow column. */
static void lay_out_inset(const RayView *ray_view, const SDL_Rect *area, RayViewLayout *layout) {
    const double widest = COLUMN_FRACTION * area->w, highest = COLUMN_FRACTION * area->h;
    SDL_Rect inset = {.w = (int)(widest + 0.5), .h = (int)(highest + 0.5)}, room;
    if (ray_view->width > 0) {
        double scale = SDL_min(widest / ray_view->width, highest / ray_view->height);
        inset.w = (int)(scale * ray_view->width + 0.5);
        inset.h = (int)(scale * ray_view->height + 0.5);
    }
    room = inset;
    room.w = SDL_max(inset.w, (int)(COLUMN_FRACTION_MINIMUM * area->w));
    room.x = area->x + area->w - room.w;
    room.y = area->y + area->h - room.h;
    inset.x = room.x + (room.w - inset.w) / 2;
    inset.y = room.y;
    layout->inset = inset;
    layout->inset_room = room;
}

RayViewLayout ray_view_layout(const RayView *ray_view, const SDL_Rect *area) {
    RayViewLayout layout;
    lay_out_inset(ray_view, area, &layout);
    const int width = SDL_max(1, area->w - layout.inset_room.w),
              top = (int)(ray_view->buttons_fraction * area->h + 0.5),
              formulas = (int)(area->h * (ray_view->is_in_lesson ? LESSON_FORMULAS_FRACTION
                                                                 : FORMULAS_FRACTION));
    layout.buttons = (SDL_Rect){area->x, area->y, area->w, top};
    layout.formulas = (SDL_Rect){area->x, area->y + top, width, formulas};
    layout.view =
        (SDL_Rect){area->x, area->y + top + formulas, width, SDL_max(1, area->h - top - formulas)};
    layout.pane = (SDL_Rect){0};
    if (ray_view->pane != RAY_PANE_NONE) {
        layout.pane = layout.view;
        layout.view.w = SDL_max(1, (int)(width * (1 - PANE_FRACTION)));
        layout.pane.x += layout.view.w;
        layout.pane.w = width - layout.view.w;
    }
    layout.list = (SDL_Rect){area->x + width, area->y + top, area->w - width,
                             SDL_max(1, layout.inset_room.y - area->y - top)};
    return layout;
}

RayDrawing ray_view_drawing(const RayView *ray_view, const SDL_Rect *view) {
    return (RayDrawing){.tree = &ray_view->ray_tree,
                        .orbit = &ray_view->orbit,
                        .view = orbit_camera_project(&ray_view->orbit, view->w, view->h),
                        .selected = ray_view->selected,
                        .hovered = ray_view->hovered,
                        .hidden_kinds = ray_view->hidden_kinds,
                        .is_along_light = ray_view->is_along_light,
                        .hides_selected = ray_view->flight_start > 0};
}

bool ray_view_ray_at(const RayView *ray_view, double x, double y, const SDL_Rect *area,
                     size_t *ray) {
    SDL_Rect view = ray_view_layout(ray_view, area).view;
    SDL_Point point = {(int)x, (int)y};
    if (!ray_view->is_open || ray_view->ray_tree.count == 0 || !SDL_PointInRect(&point, &view)) {
        return false;
    }
    RayDrawing drawing = ray_view_drawing(ray_view, &view);
    *ray = ray_drawing_at(&drawing, x - view.x, y - view.y, RAY_REACH * area->h);
    return *ray != RAY_DRAWING_UNSELECTED;
}

/* --- keeping up --------------------------------------------------------------------------------
 */

/** Copies the positions of the lights. */
static void collect_light_positions(RayView *ray_view, const Scene *scene) {
    ray_view->light_count = 0;
    for (size_t i = 0; i < scene->light_count && ray_view->light_count < RAY_VIEW_LIGHTS; i++) {
        Vec3d *position = &ray_view->light_positions[ray_view->light_count];
        ray_view->light_count += scene_light_center(&scene->lights[i], position);
    }
}

/** Traces the rays. @return false without memory. */
static bool trace_rays(RayView *ray_view, const RayViewInput *input, Error *error) {
    int x = (int)(ray_view->x * input->viewport->width),
        y = (int)(ray_view->y * input->viewport->height);
    RayTree *ray_tree = &ray_view->ray_tree;
    ray_view->needs_trace = ray_view->is_new = false;
    ray_view->width = input->viewport->width;
    ray_view->height = input->viewport->height;
    if (!renderer_record_ray_tree(input->viewport->renderer, x, y, ray_tree, error)) {
        ray_view_toggle(ray_view);
        return false;
    }
    cut_away_begin(&ray_view->cut, input->scene, ray_tree);
    if (!ray_view->has_orbit) {
        SDL_Rect rect = ray_view_layout(ray_view, &input->area).view;
        ray_view->orbit = orbit_camera_fit(input->viewport->renderer, input->scene, &ray_view->cut,
                                           ray_tree, ray_view->hidden_kinds, rect.w, rect.h);
        ray_view->has_orbit = true;
    }
    ray_view->selected = SDL_min(ray_view->selected, ray_tree->count - 1);
    ray_view->needs_draw = ray_view->needs_text = true;
    ray_overlay_release(&ray_view->pane_image);
    collect_light_positions(ray_view, input->scene);
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
static bool update_side_renderer(RayView *ray_view, const RayViewInput *input, const Scene *scene,
                                 Error *error) {
    Viewport *viewport = &ray_view->viewport;
    RenderSettings settings = side_view_settings(&input->viewport->settings);
    bool is_outdated = ray_view->is_renderer_outdated;
    ray_view->is_renderer_outdated = false;
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

/** Starts to render the second camera's view, without what hides the rays. @return false without
 *  memory. */
static bool draw_side_view(RayView *ray_view, const RayViewInput *input, Error *error) {
    SDL_Rect rect = ray_view_layout(ray_view, &input->area).view;
    SceneCamera camera = orbit_camera_project(&ray_view->orbit, rect.w, rect.h).camera;
    if (cut_away_update(&ray_view->cut, input->viewport->renderer, input->scene,
                        &ray_view->ray_tree, camera.position)) {
        ray_view->is_renderer_outdated = true;
    }
    Scene scene = cut_away_scene(&ray_view->cut, input->scene);
    scene.camera = camera;
    ray_view->needs_draw = false;
    ray_overlay_release(&ray_view->overlay);
    return update_side_renderer(ray_view, input, &scene, error) &&
           viewport_start(&ray_view->viewport, &scene, rect.w, rect.h, input->now, error);
}

/** Draws the drawing beside the view. */
static void draw_pane(RayView *ray_view, const RayViewInput *input, SDL_Renderer *renderer) {
    RayViewLayout layout = ray_view_layout(ray_view, &input->area);
    RayPaneInput pane = {.renderer = input->viewport->renderer,
                         .scene = input->scene,
                         .engine = input->viewport->settings.engine,
                         .drawing = ray_view_drawing(ray_view, &layout.view),
                         .text_size = SDL_max(TEXT_SIZE_MINIMUM, input->area.h / ROWS_PER_WINDOW)};
    pane.drawing.hides_selected = false;
    ray_overlay_draw_pane(&ray_view->pane_image, ray_view->pane, &pane, renderer,
                          SDL_max(1, layout.pane.w), layout.pane.h);
    ray_view->needs_present = true;
}

/** Moves the flying ray on. */
static void update_flight(RayView *ray_view, double now) {
    if (ray_view_flight(ray_view, now) >= 1) {
        ray_view->flight_start = 0;
        ray_overlay_release(&ray_view->overlay);
    }
    ray_view->needs_present = true;
}

/** @return Whether anything is to be traced, written or drawn. */
static bool is_due(const RayView *ray_view) {
    bool can_draw = !ray_view->viewport.awaits_first_frame;
    return ray_view->is_open &&
           (ray_view->needs_trace || ray_view->needs_text || (ray_view->needs_draw && can_draw));
}

double ray_view_timeout(const RayView *ray_view, double now) {
    if (is_due(ray_view)) {
        return 0; // A button has opened it, and no other event may come.
    }
    double delay = viewport_timeout(&ray_view->viewport, now);
    return ray_view->flight_start > 0 ? SDL_min(delay, FLIGHT_INTERVAL) : delay;
}

bool ray_view_update(RayView *ray_view, const RayViewInput *input, SDL_Renderer *renderer,
                     Error *error) {
    Viewport *viewport = &ray_view->viewport;
    bool ok = true;
    if (ray_view->is_open && ray_view->needs_trace) {
        ok = trace_rays(ray_view, input, error);
    }
    if (ray_view->is_open && ray_view->needs_text) {
        ray_view->needs_text = false;
        ray_view_write_text(ray_view, input, (int)(ray_view->x * ray_view->width),
                            (int)(ray_view->y * ray_view->height));
        ray_view->needs_present = true;
    }
    if (ray_view->is_open && renderer && ray_view->pane && !ray_view->pane_image.texture) {
        draw_pane(ray_view, input, renderer);
    }
    if (ray_view->is_open && ray_view->flight_start > 0) {
        update_flight(ray_view, input->now);
    }
    if (ray_view->is_open && ray_view->needs_draw) {
        ray_view->needs_present = true;
        ok = (viewport->awaits_first_frame || draw_side_view(ray_view, input, error)) && ok;
    }
    if (ray_view->is_open && viewport->renderer && viewport_has_frame(viewport, input->now)) {
        ray_view->needs_present = viewport_upload(viewport, renderer) || ray_view->needs_present;
    }
    return ok;
}

/* --- showing -----------------------------------------------------------------------------------
 */

void ray_view_show_mark(const RayView *ray_view, SDL_Renderer *renderer, const SDL_Rect *rect) {
    SDL_RenderSetClipRect(renderer, rect);
    ray_overlay_mark_pixel(renderer, rect->x + ray_view->x * rect->w,
                           rect->y + ray_view->y * rect->h, MARK_FRACTION * rect->h);
    SDL_RenderSetClipRect(renderer, NULL);
}

/** Draws the inset: the picture, and a mark at the pixel. */
static void draw_inset(const RayView *ray_view, const StreamingTexture *texture,
                       SDL_Renderer *renderer, const SDL_Rect *area, const RayViewLayout *layout) {
    const SDL_Rect *room = &layout->inset_room;
    SDL_SetRenderDrawColor(renderer, INSET_GROUND >> 16, INSET_GROUND >> 8 & 255,
                           INSET_GROUND & 255, 255);
    SDL_RenderFillRect(renderer, room);
    streaming_texture_draw(texture, renderer, &layout->inset, &layout->inset);
    const SDL_Rect rule = {room->x, room->y, (int)ceil(RULE_FRACTION * area->h), room->h};
    SDL_RenderFillRect(renderer, &rule); // Two skies would run into each other.
    ray_view_show_mark(ray_view, renderer, &layout->inset);
}

void ray_view_show(RayView *ray_view, const StreamingTexture *texture, SDL_Renderer *renderer,
                   const SDL_Rect *area) {
    RayViewLayout layout = ray_view_layout(ray_view, area);
    ray_view->needs_present = false;
    streaming_texture_draw(&ray_view->viewport.texture, renderer, &layout.view, &layout.view);
    if (ray_view->ray_tree.count > 0) {
        RayOverlay overlay = {.light_positions = ray_view->light_positions,
                              .light_count = ray_view->light_count,
                              .drawing = ray_view_drawing(ray_view, &layout.view)};
        ray_overlay_show(&ray_view->overlay, &overlay, renderer, &layout.view);
    }
    if (ray_view->pane != RAY_PANE_NONE && ray_view->pane_image.texture) {
        SDL_RenderCopy(renderer, ray_view->pane_image.texture, NULL, &layout.pane);
    }
    draw_inset(ray_view, texture, renderer, area, &layout);
}

void ray_view_release_textures(RayView *ray_view) {
    streaming_texture_release(&ray_view->viewport.texture);
    ray_overlay_release(&ray_view->overlay);
    ray_overlay_release(&ray_view->pane_image);
    ray_view->needs_trace = true;
}

void ray_view_deinit(RayView *ray_view) {
    viewport_close(&ray_view->viewport);
    ray_view_release_textures(ray_view);
    ray_tree_deinit(&ray_view->ray_tree);
    cut_away_deinit(&ray_view->cut);
}
