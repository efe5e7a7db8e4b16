/**
 * @file
 * @brief Playing lessons.
 */
#include "view/lesson/player.h"

#include "base/language.h"
#include "view/commands/commands.h"
#include "view/commands/snapshot_command.h"
#include "view/commands/time_control.h"
#include "view/input/input.h"

#include <string.h>

/** @return Whether nobody is waited for. */
static bool is_unattended(const App *app) {
    return app->settings->lesson_snapshot_dir != NULL;
}

bool player_is_active(const App *app) {
    return app->player.lesson != NULL;
}

bool player_is_clock_stopped(const Player *player) {
    return player->is_paused || player->is_capturing;
}

bool player_allows_input(const App *app) {
    return !player_is_active(app) || app->player.is_paused;
}

/** Moves light and camera. See #StepClockMoveFn. */
static void move_by_clock(void *context, Movement light, Movement camera) {
    app_move(context, light, camera);
}

void player_begin(App *app) {
    const Lesson *lesson = app->settings->lesson;
    if (lesson) {
        app->player = (Player){
            .lesson = lesson,
            .step_clock = {.move = move_by_clock, .context = app, .held_keys = {.speed = 1}},
            .start_time = clock_now_seconds()};
        app->window.caption.title = lesson->title;
    }
}

/** Lets the clock go on. */
static void resume_clock(Player *player) {
    player->is_paused = player->is_capturing = false;
    player->start_time = clock_now_seconds() - step_clock_seconds(&player->step_clock);
}

/** Says what can be done, under the caption's heading. */
static void update_hint(App *app) {
    Caption *caption = &app->window.caption;
    caption->hint = app->player.is_paused ? N_("Space: go on") : NULL;
    overlay_invalidate(&caption->overlay);
    window_present(&app->window);
}

/** Holds the lesson. */
static void player_pause(App *app) {
    Player *player = &app->player;
    Error error = {0};
    view_state_deinit(&player->paused_view);
    if (!view_state_save_current(&player->paused_view, &app->home_view, app->scene, &error)) {
        app_set_status(app, "no memory for the view");
        return;
    }
    player->paused_light = app->selected_light;
    player->paused_timeline = app->timeline;
    player->is_paused = true;
    update_hint(app);
}

/** Puts back what the viewer has moved, and goes on. */
static void player_resume(App *app) {
    Player *player = &app->player;
    held_keys_clear(&app->held_keys);
    view_state_restore_current(&player->paused_view, &app->home_view, app->scene);
    app->selected_light = player->paused_light;
    app->timeline = player->paused_timeline;
    resume_clock(player);
    app_on_view_changed(app);
    update_hint(app);
}

/** @return How many captions a lesson has before a step. */
static size_t captions_before(const Lesson *lesson, size_t end) {
    size_t count = 0;
    for (size_t i = 0; i < end; i++) {
        count += lesson->steps[i].kind == LESSON_CAPTION;
    }
    return count;
}

/** Shows a caption. @param step The caption, the one before the next step. */
static void show_caption(App *app, const LessonStep *step) {
    Player *player = &app->player;
    Caption *caption = &app->window.caption;
    caption->text = step->text;
    caption->number = captions_before(player->lesson, player->next_step);
    caption->count = captions_before(player->lesson, player->lesson->count);
    player->is_capturing = is_unattended(app);
    if (step->waits_for_viewer && !player->is_capturing) {
        player_pause(app);
    } else {
        update_hint(app);
    }
}

/** A key goes down. */
static void press_action(App *app, const LessonStep *step) {
    Action action = (Action)step->action;
    StepClock *step_clock = &app->player.step_clock;
    if (action_is_move(action)) {
        held_keys_press(&step_clock->held_keys, action, step_clock_seconds(step_clock));
    } else {
        command_run(app, action);
    }
}

/** Does a step. @param step The step, the one before the next. */
static void do_step(App *app, const LessonStep *step) {
    StepClock *step_clock = &app->player.step_clock;
    double now = step_clock_seconds(step_clock);
    switch (step->kind) {
    case LESSON_PRESS:
        press_action(app, step);
        break;
    case LESSON_RELEASE:
        held_keys_release(&step_clock->held_keys, (Action)step->action, now);
        break;
    case LESSON_SPEED:
        held_keys_set_speed(&step_clock->held_keys, step->x, now);
        break;
    case LESSON_TURN:
        app_turn(app, step->x, step->y);
        break;
    case LESSON_ZOOM:
        app_zoom(app, step->x);
        break;
    case LESSON_SIZE:
        SDL_SetWindowSize(app->window.sdl.window, (int)step->x, (int)step->y);
        break;
    case LESSON_PIXEL:
        app_pick_pixel(app, step->x, step->y);
        break;
    case LESSON_WALK:
        app_step_pixel(app, (int)step->x, (int)step->y);
        break;
    case LESSON_BAR:
        window_move_bar(&app->window, step->x);
        break;
    case LESSON_CAPTION:
        show_caption(app, step);
        break;
    case LESSON_SNAPSHOT:
        app->player.is_capturing = is_unattended(app);
        break;
    }
}

void player_end(App *app) {
    view_state_deinit(&app->player.paused_view);
    if (player_is_active(app)) {
        timeline_pause(&app->timeline, time_control_clock(app));
        app->player = (Player){0};
        caption_close(&app->window.caption);
    }
}

/** The last step was done. */
static void player_finish(App *app) {
    bool is_over = is_unattended(app);
    step_clock_advance(&app->player.step_clock, app->player.step_clock.now + STEP_CLOCK_TICK);
    player_end(app);
    app_set_status(app, "the lesson is over");
    window_present(&app->window);
    app->should_quit = app->should_quit || is_over;
}

/** Does all steps up to a moment, unless one of them stops the clock. */
static void play_until(App *app, int64_t until) {
    Player *player = &app->player;
    const Lesson *lesson = player->lesson;
    while (!player_is_clock_stopped(player) && player->next_step < lesson->count &&
           lesson->steps[player->next_step].time <= until) {
        const LessonStep *step = &lesson->steps[player->next_step++];
        step_clock_advance(&player->step_clock, step->time);
        do_step(app, step);
    }
    if (!player_is_clock_stopped(player) && player->next_step == lesson->count) {
        player_finish(app);
    } else if (!player_is_clock_stopped(player)) {
        step_clock_advance(&player->step_clock, until);
    }
}

void player_update(App *app, double now) {
    const Player *player = &app->player;
    if (player_is_active(app) && !player_is_clock_stopped(player) &&
        window_is_ready(&app->window)) {
        int64_t passed = (int64_t)floor((now - player->start_time) * 1000);
        play_until(app, is_unattended(app) ? INT64_MAX : SDL_max(passed, player->step_clock.now));
    }
}

double player_timeout(const App *app, double now) {
    const Player *player = &app->player;
    if (!player_is_active(app) || player_is_clock_stopped(player) ||
        !window_is_ready(&app->window)) {
        return WINDOW_NO_TIMEOUT;
    }
    int64_t step = player->next_step < player->lesson->count
                       ? player->lesson->steps[player->next_step].time
                       : player->step_clock.now;
    int64_t next = SDL_min(step, step_clock_next_tick(&player->step_clock) + 1);
    return is_unattended(app) ? 0 : fmax(0, player->start_time + (double)next / 1000 - now);
}

bool player_capture(App *app, Error *error) {
    Player *player = &app->player;
    if (!player->is_capturing || !window_is_finished(&app->window) ||
        !time_control_is_settled(app)) {
        return true;
    }
    resume_clock(player);
    if (!snapshot_take(app, app->settings->lesson_snapshot_dir, app->settings->lesson_name,
                       error)) {
        app->should_quit = true;
        app->exit_status = error->status;
        return false;
    }
    return true;
}

/** @return Whether an action is the viewer's own even while a lesson is played: it changes nothing
 *  of what is drawn. */
static bool is_allowed_while_playing(Action action) {
    static const Action allowed[] = {ACTION_COPY_VIEW, ACTION_SNAPSHOT,    ACTION_TEXT_LARGER,
                                     ACTION_LANGUAGE,  ACTION_FULL_SCREEN, ACTION_TEXT_SMALLER,
                                     ACTION_HELP,      ACTION_QUIT};
    for (size_t i = 0; i < sizeof allowed / sizeof *allowed; i++) {
        if (allowed[i] == action) {
            return true;
        }
    }
    return false;
}

bool player_handle_action(App *app, Action action) {
    bool is_paused = app->player.is_paused;
    if (!player_is_active(app) || is_allowed_while_playing(action)) {
        return false;
    }
    if (action == ACTION_TOGGLE_TIME && !app->player.is_capturing) {
        is_paused ? player_resume(app) : player_pause(app);
        return true;
    }
    bool is_moving =
        action_is_move(action) || action == ACTION_RESET_VIEW || action == ACTION_NEXT_LIGHT;
    if (is_paused && is_moving) {
        return false;
    }
    if (action != ACTION_NONE) {
        app_set_status(app, is_paused ? N_("a lesson is held: Space goes on")
                                      : N_("a lesson is played: Space holds it"));
    }
    return true;
}
