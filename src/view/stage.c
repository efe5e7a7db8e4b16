/**
 * @file
 * @brief The pictures' way from the scene to the screen.
 */
#include "view/stage.h"

#include "dioptre/language.h"
#include "view/snapshot.h"

#include <stdlib.h>

/** How many times as large letters get with each step. */
static const double TEXT_STEP = 1.2;
/** How many times as large, or as small, as usual they get at most. */
static const double TEXT_RANGE = 3;

/** How near to the bar the mouse drags it, as a share of the window's width. */
static const double BAR_REACH = 0.015;

bool stage_open(Stage *stage, const Scene *scene, const RenderSettings *settings, const char *title,
                uint32_t pass_event, Error *error) {
    stage->pass_event = pass_event;
    stage->asked = *settings;
    stage->notice.overlay.place = stage->caption.overlay.place = OVERLAY_BELOW;
    stage->huds[0].overlay.place = OVERLAY_LEFT;
    stage->huds[1].overlay.place = OVERLAY_RIGHT;
    split_move(&stage->split, 0.5);
    return sight_open(&stage->sights[0], NULL, scene, settings, pass_event, error) &&
           display_open(&stage->display, title, settings->width, settings->height, error);
}

void stage_close(Stage *stage) {
    inspector_release(&stage->inspector);
    for (size_t i = 0; i < STAGE_SIGHTS; i++) {
        sight_close(&stage->sights[i]);
    }
    split_release(&stage->split);
    browser_end(&stage->browser);
    stage_forget_words(stage);
    display_close(&stage->display);
    latency_release(&stage->latency);
}

/* --- pictures --------------------------------------------------------------------------------- */

size_t stage_sights(const Stage *stage) {
    return stage->split.mode != SPLIT_NONE && stage->sights[1].renderer ? 2 : 1;
}

Sight *stage_active(Stage *stage) {
    return &stage->sights[stage_sights(stage) > 1 ? stage->split.active : 0];
}

void stage_change(Stage *stage) {
    for (size_t i = 0; i < stage_sights(stage); i++) {
        stage->sights[i].is_changed = true;
        stage->sights[i].cost_before = 0;
    }
}

/** Words are brought up to date at once. @param[in,out] stage The stage. */
static void hurry_words(Stage *stage) {
    for (size_t i = 0; i < STAGE_SIGHTS; i++) {
        stage->huds[i].due = 0;
    }
}

void stage_set_layer(Stage *stage, Layer layer) {
    hurry_words(stage);
    sight_set_layer(stage_active(stage), layer);
}

void stage_tune(Stage *stage, Action action) {
    hurry_words(stage);
    stage->has_settings = true;
    sight_tune(stage_active(stage), action);
}

void stage_retune(Stage *stage) {
    for (size_t i = 0; i < stage_sights(stage); i++) {
        stage->sights[i].is_tuned = true;
    }
}

void stage_untune(Stage *stage) {
    hurry_words(stage);
    for (size_t i = 0; i < STAGE_SIGHTS; i++) {
        Sight *sight = &stage->sights[i];
        sight->tuning = (Tuning){0};
        sight->is_tuned = true;
        if (sight->renderer) {
            sight_set_layer(sight, LAYER_SHADED);
        } else {
            sight->layer = LAYER_SHADED;
        }
    }
    stage->split.mode = SPLIT_NONE;
    split_move(&stage->split, 0.5);
}

void stage_split(Stage *stage, int way) {
    hurry_words(stage);
    stage->split.mode = (SplitMode)(((int)stage->split.mode + way + SPLIT_COUNT) % SPLIT_COUNT);
    stage->split.active = stage->split.mode == SPLIT_BAR ? 1 : stage->split.active;
    for (size_t i = 0; i < STAGE_SIGHTS; i++) {
        stage->sights[i].has_pass = stage->sights[i].renderer != NULL;
    }
}

void stage_swap_active(Stage *stage) {
    hurry_words(stage);
    stage->split.active = 1 - stage->split.active;
    stage_present(stage);
}

void stage_move_bar(Stage *stage, double share) {
    split_move(&stage->split, share);
    stage_present(stage);
}

bool stage_is_at_bar(const Stage *stage, double share) {
    return stage->split.mode == SPLIT_BAR && fabs(share - stage->split.bar) < BAR_REACH;
}

void stage_toggle_settings(Stage *stage) {
    hurry_words(stage);
    stage->has_settings = !stage->has_settings;
    stage_present(stage);
}

/** Opens or closes the second picture, as is wanted. @param[in,out] stage The stage. @param scene
 * The scene. @param[out] error What is wrong. @return false without memory: there is one then. */
static bool settle_second(Stage *stage, const Scene *scene, Error *error) {
    Sight *first = &stage->sights[0], *second = &stage->sights[1];
    bool is_wanted = stage->split.mode != SPLIT_NONE;
    if (!is_wanted && second->renderer) {
        sight_close(second);
        split_release(&stage->split);
    }
    if (!is_wanted || second->renderer) {
        return true;
    }
    if (!sight_open(second, first, scene, &stage->asked, stage->pass_event, error)) {
        stage->split.mode = SPLIT_NONE;
    }
    return second->renderer != NULL;
}

bool stage_settle(Stage *stage, const Scene *scene, Error *error) {
    bool is_good = settle_second(stage, scene, error);
    for (size_t i = 0; i < stage_sights(stage); i++) {
        if (stage->sights[i].is_tuned) {
            is_good = sight_remake(&stage->sights[i], scene, &stage->asked, error) && is_good;
            inspector_on_replace(&stage->inspector);
        }
    }
    return is_good;
}

/* --- events ----------------------------------------------------------------------------------- */

void stage_on_pass(Stage *stage, const SDL_Event *event) {
    for (size_t i = 0; i < STAGE_SIGHTS; i++) {
        if (event->user.data1 == &stage->sights[i] && stage->sights[i].renderer) {
            sight_on_pass(&stage->sights[i]);
        }
    }
    inspector_on_pass(&stage->inspector, event);
}

void stage_on_visibility(Stage *stage) {
    Uint32 flags = SDL_GetWindowFlags(stage->display.window);
    stage->is_hidden = flags & (SDL_WINDOW_HIDDEN | SDL_WINDOW_MINIMIZED);
    for (size_t i = 0; stage->is_hidden && i < stage_sights(stage); i++) {
        if (sight_stop(&stage->sights[i])) {
            latency_forget(&stage->latency);
        }
    }
    if (stage->is_hidden) {
        inspector_stop(&stage->inspector);
    }
}

bool stage_on_resize(Stage *stage) {
    int width, height;
    display_size(&stage->display, &width, &height);
    bool is_other = width != stage->sights[0].width || height != stage->sights[0].height;
    if (is_other) {
        stage_forget_words(stage);
        stage_change(stage);
    }
    stage_present(stage);
    return is_other;
}

void stage_on_loss(Stage *stage) {
    stage_forget_words(stage);
    canvas_forget(&stage->split.canvas);
    for (size_t i = 0; i < STAGE_SIGHTS; i++) {
        canvas_forget(&stage->sights[i].canvas);
        stage->sights[i].has_pass = stage->sights[i].renderer != NULL;
    }
    inspector_forget(&stage->inspector);
}

/* --- showing ---------------------------------------------------------------------------------- */

/** Puts the pictures where they are shown next. @param[in,out] stage The stage. */
static void show_pictures(Stage *stage) {
    SDL_Renderer *renderer = stage->display.renderer;
    SDL_Rect room = {0}, part;
    display_size(&stage->display, &room.w, &room.h);
    part = room;
    if (stage_sights(stage) == 1) {
        canvas_show(&stage->sights[0].canvas, renderer, &room, &part);
    } else if (stage->split.mode == SPLIT_DIFFERENCE) {
        canvas_show(&stage->split.canvas, renderer, &room, &part);
    } else {
        part.w = split_column(&stage->split, room.w);
        canvas_show(&stage->sights[0].canvas, renderer, &room, &part);
        part.x = part.w;
        part.w = room.w - part.x;
        canvas_show(&stage->sights[1].canvas, renderer, &room, &part);
        split_show_bar(&stage->split, renderer);
    }
}

/** Shows what is said beside the pictures. @param[in,out] stage The stage. @param screen The
 * window.
 */
static void show_huds(Stage *stage, const OverlayScreen *screen) {
    static const char *const titles[2][STAGE_SIGHTS] = {{N_("left"), N_("right")},
                                                        {N_("left ←"), N_("right ←")}};
    size_t count = stage_sights(stage);
    bool is_difference = count > 1 && stage->split.mode == SPLIT_DIFFERENCE;
    for (size_t i = 0; i < count; i++) {
        bool is_active = stage->split.active == i;
        HudFacts facts = {.sight = &stage->sights[i],
                          .title = count > 1 ? titles[is_active][i] : NULL,
                          .has_settings = stage->has_settings,
                          .hides_layer = is_difference,
                          .difference = is_difference && i == 0 ? &stage->split.difference : NULL};
        hud_update(&stage->huds[i], &facts, clock_seconds());
        hud_show(&stage->huds[i], screen);
    }
}

void stage_present(Stage *stage) {
    double scale = stage->text_scale > 0 ? stage->text_scale : 1;
    OverlayScreen screen = {stage->display.renderer, scale, 1};
    display_begin(&stage->display);
    if (stage->inspector.is_open && !stage->help.is_open) {
        inspector_show(&stage->inspector, &stage_active(stage)->canvas, &screen);
    } else {
        show_pictures(stage);
    }
    if (!stage->help.is_open && !stage->inspector.is_open) {
        show_huds(stage, &screen);
    }
    caption_show(&stage->caption, &screen);
    notice_show(&stage->notice, &screen);
    browser_show(&stage->browser, &screen);
    help_show(&stage->help, &screen);
    display_end(&stage->display);
}

void stage_forget_words(Stage *stage) {
    overlay_forget(&stage->help.overlay);
    overlay_forget(&stage->browser.overlay);
    overlay_forget(&stage->notice.overlay);
    overlay_forget(&stage->caption.overlay);
    for (size_t i = 0; i < STAGE_SIGHTS; i++) {
        hud_forget(&stage->huds[i]);
    }
    inspector_outdate(&stage->inspector);
}

void stage_resize_words(Stage *stage, int steps) {
    double scale = stage->text_scale > 0 ? stage->text_scale : 1;
    scale *= pow(TEXT_STEP, steps);
    stage->text_scale = steps == 0 ? 0 : SDL_clamp(scale, 1 / TEXT_RANGE, TEXT_RANGE);
    stage_forget_words(stage);
    stage_present(stage);
}

void stage_say(Stage *stage, const char *words) {
    if (notice_say(&stage->notice, words)) {
        stage_present(stage);
    }
}

/** Starts to draw what has changed. @param[in,out] stage The stage. @param scene The scene. @param
 *  now Now, seconds. @param[out] error What is wrong. @return false without memory. */
static bool start_changed(Stage *stage, const Scene *scene, double now, Error *error) {
    int width, height;
    display_size(&stage->display, &width, &height);
    bool is_good = true;
    for (size_t i = 0; i < stage_sights(stage); i++) {
        Sight *sight = &stage->sights[i];
        if (sight->is_changed && !sight->is_unseen) {
            latency_drawing(&stage->latency);
            inspector_outdate(&stage->inspector);
            is_good = sight_start(sight, scene, width, height, now, error) && is_good;
        }
    }
    return is_good;
}

/** Shows the newest passes. @param[in,out] stage The stage. @param now Now, seconds. */
static void show_due(Stage *stage, double now) {
    size_t count = stage_sights(stage);
    bool is_any = false;
    for (size_t i = 0; i < count; i++) {
        if (sight_is_due(&stage->sights[i], now)) {
            is_any = sight_show(&stage->sights[i], stage->display.renderer) || is_any;
        }
    }
    if (!is_any) {
        return;
    }
    if (count > 1 && stage->split.mode == SPLIT_DIFFERENCE) {
        split_subtract(&stage->split, &stage->sights[0], &stage->sights[1],
                       stage->display.renderer);
    }
    stage_present(stage);
    double shown = clock_seconds();
    latency_shown(&stage->latency, shown);
    stage->first_shown = stage->first_shown > 0 ? stage->first_shown : shown;
}

bool stage_update(Stage *stage, const Scene *scene, double now, Error *error) {
    if (stage->is_hidden) {
        return true;
    }
    if (!start_changed(stage, scene, now, error)) {
        return false;
    }
    show_due(stage, now);
    Inspected inspected = {stage_active(stage), scene, stage->pass_event, now};
    bool is_good = inspector_update(&stage->inspector, &inspected, stage->display.renderer, error);
    if (stage->inspector.has_news) {
        stage_present(stage);
    }
    return is_good;
}

double stage_delay(const Stage *stage, double now) {
    double delay = STAGE_NEVER;
    for (size_t i = 0; !stage->is_hidden && i < stage_sights(stage); i++) {
        delay = fmin(delay, sight_delay(&stage->sights[i], now));
    }
    if (stage->inspector.is_open && !stage->is_hidden) {
        delay = fmin(delay, sight_delay(&stage->inspector.sight, now));
    }
    return delay;
}

bool stage_is_ready(const Stage *stage) {
    bool is_ready = false;
    for (size_t i = 0; i < stage_sights(stage); i++) {
        is_ready = is_ready || !stage->sights[i].is_unseen;
    }
    return is_ready && !stage->is_hidden;
}

bool stage_is_finished(const Stage *stage) {
    bool is_finished = true;
    for (size_t i = 0; i < stage_sights(stage); i++) {
        is_finished = is_finished && sight_is_finished(&stage->sights[i]);
    }
    return is_finished;
}

/** Copies what the window shows. @param[in,out] stage The stage, finished. @param[out] bgrx Where
 * to.
 *  @param pitch Bytes from a row to the next. @return false without memory. */
static bool copy_pixels(Stage *stage, uint8_t *bgrx, int pitch) {
    RenderReport report;
    return stage_sights(stage) > 1
               ? split_compose(&stage->split, &stage->sights[0], &stage->sights[1], bgrx, pitch)
               : renderer_take(stage->sights[0].renderer, &report, bgrx, pitch);
}

bool stage_copy(Stage *stage, Picture *picture, Error *error) {
    int width = stage->sights[0].width, height = stage->sights[0].height;
    size_t row = (size_t)width * 4;
    uint8_t *bgrx = malloc(row * (size_t)height);
    if (!bgrx || !copy_pixels(stage, bgrx, (int)row)) {
        free(bgrx);
        return error_set(error, STATUS_FAILED, "no memory for a snapshot");
    }
    bool is_copied = picture_init(picture, width, height, error);
    if (is_copied) {
        snapshot_convert(bgrx, picture);
    }
    free(bgrx);
    return is_copied;
}
