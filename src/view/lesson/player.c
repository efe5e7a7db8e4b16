/**
 * @file
 * @brief Playing lessons.
 */
#include "view/lesson/player.h"

#include "base/language.h"
#include "view/commands/commands.h"
#include "view/commands/edits.h"

/* --- names for lessons ------------------------------------------------------------------------ */

/** Finds the next command that is a move, or that is none. @return NULL: there is no other. */
static const Command *next_named(const Command *row, bool is_move) {
    while (command_is_row(row) && (!row->name || command_is_move(row) != is_move)) {
        row++;
    }
    return command_is_row(row) ? row : NULL;
}

const Command *command_of_action(int action) {
    for (int is_move = 1; is_move >= 0; is_move--) {
        const Command *row = next_named(command_table, is_move);
        for (; row; row = next_named(row + 1, is_move)) {
            if (action-- == 0) {
                return row;
            }
        }
    }
    return NULL;
}

int view_actions(const char *names[VIEW_ACTIONS_MAXIMUM]) {
    int count = 0, move_count = 0;
    for (const Command *row;
         count < VIEW_ACTIONS_MAXIMUM - 1 && (row = command_of_action(count));) {
        names[count++] = row->name;
        move_count += command_is_move(row);
    }
    names[count] = NULL;
    return move_count;
}

/* --- playing ---------------------------------------------------------------------------------- */

/** @return Whether the lesson plays without a viewer. */
static bool is_unattended(const App *app) {
    return app->settings->lesson_snapshot_dir != NULL;
}

bool player_allows_input(const App *app) {
    return !app_is_playing(app) || app->player.is_paused;
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

/** Lets the clock run again. */
static void resume_clock(Player *player) {
    player->is_paused = player->is_capturing = false;
    player->start_time = clock_now_seconds() - step_clock_seconds(&player->step_clock);
}

/** Shows beside the caption's heading which key resumes the lesson. */
static void update_hint(App *app) {
    Caption *caption = &app->window.caption;
    caption->hint = app->player.is_paused ? N_("Space: go on") : NULL;
    overlay_invalidate(&caption->overlay);
    window_present(&app->window);
}

/** Pauses the lesson, and saves the view. */
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

/** Restores the view, and resumes the lesson. */
static void player_resume(App *app) {
    Player *player = &app->player;
    held_keys_clear(&app->input.held_keys);
    view_state_restore_current(&player->paused_view, &app->home_view, app->scene);
    app->selected_light = player->paused_light;
    app->timeline = player->paused_timeline;
    resume_clock(player);
    app_on_view_changed(app);
    update_hint(app);
}

/** @return Number of captions before a step. */
static size_t captions_before(const Lesson *lesson, size_t end) {
    size_t count = 0;
    for (size_t i = 0; i < end; i++) {
        count += lesson->steps[i].kind == LESSON_CAPTION;
    }
    return count;
}

/** Shows a caption, and pauses or captures. */
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

/** Runs a command, or begins its move. */
static void press(App *app, const Command *command) {
    StepClock *step_clock = &app->player.step_clock;
    if (command_is_move(command)) {
        held_keys_press(&step_clock->held_keys, command->move, step_clock_seconds(step_clock));
    } else {
        command_run(app, command);
    }
}

/** Does a step. */
static void do_step(App *app, const LessonStep *step) {
    StepClock *step_clock = &app->player.step_clock;
    double now = step_clock_seconds(step_clock);
    switch (step->kind) {
    case LESSON_PRESS:
        press(app, command_of_action(step->action));
        break;
    case LESSON_RELEASE:
        held_keys_release(&step_clock->held_keys, command_of_action(step->action)->move, now);
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
        window_set_size_below_toolbar(&app->window, (int)step->x, (int)step->y);
        break;
    case LESSON_PIXEL:
        app_pick_pixel(app, step->x, step->y);
        break;
    case LESSON_WALK:
        app_step_pixel(app, (int)step->x, (int)step->y);
        break;
    case LESSON_RAY:
        app_choose_ray(app, (size_t)step->action);
        break;
    case LESSON_BAR:
        window_move_bar(&app->window, step->x);
        break;
    case LESSON_DRAG:
        app_drag_light(app, (size_t)step->action, (Vec3d){step->x, step->y, step->z});
        break;
    case LESSON_SELECT:
        edits_select(app, step->keyword, step->action,
                     step->x >= 0 ? &(Uvd){step->x, step->y} : NULL);
        break;
    case LESSON_SET:
        edits_set(
            app,
            &(SceneOverride){step->keyword, step->action, step->row, {step->x, step->y, step->z}},
            step->continues);
        break;
    case LESSON_MOVE:
        edits_move(app, step->keyword, step->action, (Vec3d){step->x, step->y, step->z},
                   step->continues);
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
    if (app_is_playing(app)) {
        timeline_pause(&app->timeline, app_clock(app));
        app->player = (Player){0};
        caption_close(&app->window.caption);
    }
}

/** Ends the lesson after its last step. */
static void player_finish(App *app) {
    bool closes_window = is_unattended(app);
    step_clock_advance(&app->player.step_clock, app->player.step_clock.now + STEP_CLOCK_TICK);
    player_end(app);
    app_set_status(app, "the lesson is over");
    window_present(&app->window);
    app->exit.is_requested = app->exit.is_requested || closes_window;
}

/** Does all steps up to a time, until one of them stops the clock. @param until Milliseconds. */
static void play_until(App *app, int64_t until) {
    Player *player = &app->player;
    const Lesson *lesson = player->lesson;
    while (!app_is_lesson_stopped(app) && player->next_step < lesson->count &&
           lesson->steps[player->next_step].time <= until) {
        const LessonStep *step = &lesson->steps[player->next_step++];
        step_clock_advance(&player->step_clock, step->time);
        do_step(app, step);
    }
    if (!app_is_lesson_stopped(app) && player->next_step == lesson->count) {
        player_finish(app);
    } else if (!app_is_lesson_stopped(app)) {
        step_clock_advance(&player->step_clock, until);
    }
}

void player_update(App *app, double now) {
    const Player *player = &app->player;
    if (app_is_playing(app) && !app_is_lesson_stopped(app) && window_is_ready(&app->window)) {
        int64_t passed = (int64_t)floor((now - player->start_time) * 1000);
        play_until(app, is_unattended(app) ? INT64_MAX : SDL_max(passed, player->step_clock.now));
    }
}

double player_timeout(const App *app, double now) {
    const Player *player = &app->player;
    if (!app_is_playing(app) || app_is_lesson_stopped(app) || !window_is_ready(&app->window)) {
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
    if (!player->is_capturing || !window_is_finished(&app->window) || !app_is_time_settled(app)) {
        return true;
    }
    resume_clock(player);
    if (!app_save_picture(app, app->settings->lesson_snapshot_dir, app->settings->lesson_name,
                          error)) {
        app->exit.is_requested = true;
        app->exit.status = error->status;
        return false;
    }
    return true;
}

bool player_handle_command(App *app, const Command *command) {
    bool is_paused = app->player.is_paused;
    unsigned flags = command ? command->flags : 0;
    if (!app_is_playing(app) || (flags & COMMAND_WHILE_PLAYING)) {
        return false;
    }
    if (command_is(command, "time") && !app->player.is_capturing) {
        is_paused ? player_resume(app) : player_pause(app);
        return true;
    }
    if (is_paused && (flags & COMMAND_WHILE_PAUSED)) {
        return false;
    }
    if (command) {
        app_set_status(app, is_paused ? N_("a lesson is held: Space goes on")
                                      : N_("a lesson is played: Space holds it"));
    }
    return true;
}
