/**
 * @file
 * @brief The rays of one pixel in the window.
 */
#include "view/inspector.h"

#include "view/inspector_rows.h"
#include "view/ray_drawing.h"

/** Degrees a second that held keys turn the second camera by. */
static const double TURN = 45;
/** How many times as near a second of a held key brings it. */
static const double NEARER = 2;
/** Share of the window's width that the numbers take, and of both that the picture does. */
static const double COLUMN = 0.36;
/** How many times as large as usual for their room letters are, if they fit. */
static const double LARGER = 1.7;

void inspector_reset(Inspector *inspector) {
    if (inspector->is_open) {
        inspector_toggle(inspector);
    }
    inspector->has_place = false;
}

void inspector_toggle(Inspector *inspector) {
    if (inspector->is_open) {
        inspector->is_open = false;
        sight_close(&inspector->sight);
        inspector_forget(inspector);
    } else if (inspector->has_place) {
        inspector_pick(inspector, inspector->x, inspector->y);
    } else {
        inspector_pick(inspector, 0.5, 0.5);
    }
}

/** Goes to a pixel. @param[in,out] inspector The inspector. @param x As a share of the picture's
 *  width. @param y As a share of its height. */
static void go_to(Inspector *inspector, double x, double y) {
    const double last = 1 - 1e-9;
    inspector->is_open = inspector->has_place = inspector->is_stale = true;
    inspector->x = SDL_clamp(x, 0, last);
    inspector->y = SDL_clamp(y, 0, last);
    inspector->chosen = 0;
}

void inspector_pick(Inspector *inspector, double x, double y) {
    inspector->has_view = false;
    go_to(inspector, x, y);
}

void inspector_walk(Inspector *inspector, int x, int y) {
    if (inspector->width > 0) {
        int column = (int)(inspector->x * inspector->width) + x;
        int row = (int)(inspector->y * inspector->height) + y;
        // The pixel's middle, so that it is the same whatever is rounded.
        go_to(inspector, (column + 0.5) / inspector->width, (row + 0.5) / inspector->height);
    }
}

void inspector_choose(Inspector *inspector, int way) {
    size_t count = inspector->probe.count;
    if (count > 0) {
        inspector->chosen = (inspector->chosen + count + (size_t)(way + (int)count)) % count;
        inspector->is_stale = true;
    }
}

void inspector_move(Inspector *inspector, Movement by) {
    ray_view_turn(&inspector->view, -TURN * by.right, -TURN * by.up);
    ray_view_zoom(&inspector->view, pow(NEARER, by.forward));
    inspector->is_moved = true;
}

void inspector_turn(Inspector *inspector, double right, double up) {
    ray_view_turn(&inspector->view, -right, -up);
    inspector->is_moved = true;
}

void inspector_outdate(Inspector *inspector) {
    inspector->is_stale = true;
}

void inspector_look_anew(Inspector *inspector) {
    inspector->has_view = false;
    inspector->is_stale = true;
}

void inspector_on_replace(Inspector *inspector) {
    inspector->is_replaced = inspector->is_stale = true;
}

void inspector_on_pass(Inspector *inspector, const SDL_Event *event) {
    if (event->user.data1 == &inspector->sight && inspector->sight.renderer) {
        sight_on_pass(&inspector->sight);
    }
}

void inspector_stop(Inspector *inspector) {
    if (inspector->sight.renderer && sight_stop(&inspector->sight)) {
        inspector->is_moved = true;
    }
}

/* --- rooms of the window ------------------------------------------------------------------------
 */

SDL_Rect inspector_inset(int width, int height) {
    SDL_Rect room = {.w = (int)(COLUMN * width), .h = (int)(COLUMN * height)};
    room.x = width - room.w;
    room.y = height - room.h;
    return room;
}

/** @return Where what the second camera sees lies, pixels of the window. @param width Pixels of the
 *  window. @param height Pixels of it. */
static SDL_Rect side_room(int width, int height) {
    return (SDL_Rect){.w = SDL_max(1, width - (int)(COLUMN * width)), .h = height};
}

/* --- keeping up --------------------------------------------------------------------------------
 */

/** Notes where lamps are. @param[in,out] inspector The inspector. @param scene The scene. */
static void note_lamps(Inspector *inspector, const Scene *scene) {
    inspector->lamp_count = 0;
    for (size_t i = 0; i < scene->light_count && inspector->lamp_count < INSPECTOR_LAMPS; i++) {
        if (scene->lights[i].kind == LIGHT_POINT) {
            inspector->lamps[inspector->lamp_count++] = scene->lights[i].position;
        }
    }
}

/** Traces the rays. @param[in,out] inspector The inspector. @param inspected What is looked into.
 *  @param[out] error What is wrong. @return false without memory. */
static bool trace_rays(Inspector *inspector, const Inspected *inspected, Error *error) {
    int x = (int)(inspector->x * inspected->sight->width),
        y = (int)(inspector->y * inspected->sight->height);
    Probe *probe = &inspector->probe;
    inspector->is_stale = false;
    inspector->width = inspected->sight->width;
    inspector->height = inspected->sight->height;
    if (!renderer_probe(inspected->sight->renderer, x, y, probe, error)) {
        inspector_toggle(inspector);
        return false;
    }
    if (!inspector->has_view) {
        SDL_Rect room = side_room(inspected->sight->width, inspected->sight->height);
        inspector->view = ray_view_choose(inspected->sight->renderer, &inspected->scene->camera,
                                          probe, room.w, room.h);
        inspector->has_view = true;
    }
    inspector->chosen = SDL_min(inspector->chosen, probe->count - 1);
    inspector->is_moved = true;
    note_lamps(inspector, inspected->scene);
    inspector_rows_fill(inspector, inspected, x, y);
    inspector_forget_words(inspector);
    return true;
}

/** @return How the second camera's picture is drawn: as the first, but there to find one's way and
 * not to be looked at for long. @param settings How the first is drawn. */
static RenderSettings side_settings(const RenderSettings *settings) {
    /** Rays a pixel at most; bits that are enough. */
    const int samples = 4, bits = 53;
    RenderSettings side = *settings;
    side.samples = SDL_min(side.samples, samples);
    if (side.engine->mantissa_bits > bits) {
        side.engine = engine_find("auto", NULL);
    }
    return side;
}

/** Makes what draws the second camera's picture, if there is none or the scene is another one.
 *  @param[in,out] inspector The inspector. @param inspected What is looked into. @param scene The
 *  scene, with the second camera. @param[out] error What is wrong. @return false without memory. */
static bool settle_side(Inspector *inspector, const Inspected *inspected, const Scene *scene,
                        Error *error) {
    Sight *sight = &inspector->sight;
    RenderSettings settings = side_settings(&inspected->sight->settings);
    bool is_replaced = inspector->is_replaced;
    inspector->is_replaced = false;
    if (!sight->renderer) {
        return sight_open(sight, inspected->sight, scene, &settings, inspected->pass_event, error);
    }
    if (is_replaced) {
        renderer_stop(sight->renderer);
        Renderer *renderer =
            renderer_create_after(inspected->sight->renderer, scene, &settings, error);
        if (!renderer) {
            return false;
        }
        sight_replace(sight, renderer, &settings);
    }
    return true;
}

/** Begins to draw what the second camera sees. @param[in,out] inspector The inspector.
 *  @param inspected What is looked into. @param[out] error What is wrong. @return false without
 *  memory. */
static bool draw_side(Inspector *inspector, const Inspected *inspected, Error *error) {
    Scene scene = *inspected->scene;
    SDL_Rect room = side_room(inspected->sight->width, inspected->sight->height);
    scene.camera = ray_view_sight(&inspector->view, room.w, room.h).camera;
    inspector->is_moved = false;
    return settle_side(inspector, inspected, &scene, error) &&
           sight_start(&inspector->sight, &scene, room.w, room.h, inspected->now, error);
}

bool inspector_update(Inspector *inspector, const Inspected *inspected, SDL_Renderer *renderer,
                      Error *error) {
    Sight *sight = &inspector->sight;
    bool is_good = true;
    if (inspector->is_open && inspector->is_stale) {
        is_good = trace_rays(inspector, inspected, error);
    }
    if (inspector->is_open && inspector->is_moved) {
        inspector->has_news = true;
        is_good = (sight->is_unseen || draw_side(inspector, inspected, error)) && is_good;
    }
    if (inspector->is_open && sight->renderer && sight_is_due(sight, inspected->now)) {
        inspector->has_news = sight_show(sight, renderer) || inspector->has_news;
    }
    return is_good;
}

/* --- showing -----------------------------------------------------------------------------------
 */

/** Shows the picture that is looked into, and marks the pixel. @param inspector The inspector.
 *  @param picture The picture. @param renderer What draws in the window. @param room Where. */
static void show_inset(const Inspector *inspector, const Canvas *picture, SDL_Renderer *renderer,
                       const SDL_Rect *room) {
    canvas_show(picture, renderer, room, room);
    SDL_RenderSetClipRect(renderer, room);
    ray_drawing_mark(renderer, room->x + inspector->x * room->w, room->y + inspector->y * room->h,
                     0.08 * room->h);
    SDL_RenderSetClipRect(renderer, NULL);
}

/** Draws the numbers anew. @param[in,out] inspector The inspector. @param screen The window.
 *  @param column The room that they have. */
static void draw_panel(Inspector *inspector, const OverlayScreen *screen, const SDL_Rect *column) {
    PanelRoom room = {column->w, column->h, LARGER * screen->scale};
    SDL_Surface *panel = panel_draw(inspector->rows, inspector->row_count, &room);
    if (panel) {
        inspector->panel = SDL_CreateTextureFromSurface(screen->renderer, panel);
        SDL_FreeSurface(panel);
    }
}

/** Shows the numbers. @param[in,out] inspector The inspector. @param screen The window.
 *  @param column The room that they have. */
static void show_panel(Inspector *inspector, const OverlayScreen *screen, const SDL_Rect *column) {
    SDL_Rect place = *column;
    if (!inspector->panel) {
        draw_panel(inspector, screen, column);
    }
    SDL_SetRenderDrawColor(screen->renderer, 15, 18, 28, SDL_ALPHA_OPAQUE);
    SDL_RenderFillRect(screen->renderer, column);
    if (inspector->panel) {
        SDL_QueryTexture(inspector->panel, NULL, NULL, &place.w, &place.h);
        SDL_RenderCopy(screen->renderer, inspector->panel, NULL, &place);
    }
}

void inspector_show(Inspector *inspector, const Canvas *picture, const OverlayScreen *screen) {
    int width = 0, height = 0;
    inspector->has_news = false;
    SDL_GetRendererOutputSize(screen->renderer, &width, &height);
    SDL_Rect room = side_room(width, height), inset = inspector_inset(width, height);
    SDL_Rect column = {inset.x, 0, inset.w, inset.y};
    canvas_show(&inspector->sight.canvas, screen->renderer, &room, &room);
    if (inspector->probe.count > 0) {
        RayDrawing drawing = {.lamps = inspector->lamps,
                              .lamp_count = inspector->lamp_count,
                              .probe = &inspector->probe,
                              .view = &inspector->view,
                              .chosen = inspector->chosen};
        ray_drawing_show(&drawing, screen->renderer, &room);
        show_panel(inspector, screen, &column);
    }
    show_inset(inspector, picture, screen->renderer, &inset);
}

void inspector_forget_words(Inspector *inspector) {
    if (inspector->panel) {
        SDL_DestroyTexture(inspector->panel);
        inspector->panel = NULL;
    }
}

void inspector_forget(Inspector *inspector) {
    canvas_forget(&inspector->sight.canvas);
    inspector_forget_words(inspector);
    inspector->is_stale = true;
}

void inspector_release(Inspector *inspector) {
    sight_close(&inspector->sight);
    inspector_forget(inspector);
    probe_release(&inspector->probe);
}
