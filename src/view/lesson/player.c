/**
 * @file
 * @brief Playing lessons.
 */
#include "view/lesson/player.h"

#include "base/language.h"
#include "base/lesson_file.h"
#include "base/scene_name.h"
#include "view/commands/current_scene.h"
#include "view/lesson/lesson_step.h"
#include "view/lesson/player_internal.h"

/* --- beginning and end ------------------------------------------------------------------------ */

bool player_allows_input(const App *app) {
    return !app_is_playing(app) || app->player.state == PLAYER_WAITS;
}

void player_rewind(App *app) {
    Player *player = &app->player;
    view_state_deinit(&player->paused_view);
    player->state = PLAYER_RUNS;
    player->step_clock = app_step_clock(app);
    player->next_step = player->repeat_end = 0;
    player->stop = LESSON_STEPS_MAXIMUM;
    player->start_time = clock_now_seconds();
}

/** Begins a lesson. @param owned It, if it is freed at its end. @param path Its file. */
static void begin_lesson(App *app, const Lesson *lesson, Lesson *owned, const char *path) {
    Player *player = &app->player;
    *player = (Player){.lesson = lesson, .owned = owned, .initial_time = app->scene_time};
    SDL_strlcpy(player->path, path, sizeof player->path);
    scene_name_from_path(path, player->name, sizeof player->name);
    app->home_view.move_speed = lesson->initial_settings.move_speed;
    player_rewind(app);
    window_end_hint(&app->window);
    player_update_panel(app);
}

void player_begin(App *app) {
    if (app->settings->lesson) {
        begin_lesson(app, app->settings->lesson, NULL, app->settings->lesson_path);
    }
}

/** Ends the lesson, if any. Its settings stay. */
static void end_lesson(App *app) {
    Player *player = &app->player;
    view_state_deinit(&player->paused_view);
    if (app_is_playing(app)) {
        timeline_pause(&app->timeline, app_clock(app));
    }
    if (player->lesson) {
        app->home_view.move_speed = view_state_move_speed(app->scene);
        Lesson *owned = player->owned;
        *player = (Player){0};
        player_update_panel(app);
        lesson_destroy(owned);
    }
}

void player_end(App *app) {
    if (app->player.lesson) {
        end_lesson(app);
        app_take_own_settings(app);
    }
}

void player_close(App *app) {
    player_end(app);
    if (app->window.gui) {
        window_set_hint(&app->window);
    }
}

/** Begins the lesson that was loaded with the scene on screen, if any. */
static void take_loaded_lesson(App *app) {
    Lesson *lesson = app->source.lesson;
    if (lesson) {
        app->source.lesson = NULL;
        end_lesson(app); // The settings are those of the new lesson.
        app_restart_view(app, app->scene_time);
        begin_lesson(app, lesson, lesson, app->source.lesson_path);
    }
}

void player_open_file(App *app, const char *path) {
    if (app_is_playing(app)) {
        current_scene_is_locked(app);
        return;
    }
    if (app->player.lesson) {
        player_end(app);
        app_restart_view(app, app->scene_time); // What the lesson has changed is its own.
    }
    current_scene_open(app, path);
}

void player_open_selected(App *app) {
    Browser *browser = &app->window.browser;
    char path[PATH_MAX];
    browser->is_requested = false;
    if (browser_selected_path(browser, path)) {
        player_open_file(app, path);
        browser_close(browser);
    }
}

/** Ends the lesson after its last step: shows its end card. */
static void finish_lesson(App *app) {
    Player *player = &app->player;
    step_clock_advance(&player->step_clock, player->step_clock.now + STEP_CLOCK_TICK);
    app_set_title_status(app, N_("the lesson is over")); // On the picture the card says it.
    if (player_is_unattended(app)) {
        player_end(app);
        app->exit.is_requested = true;
        return;
    }
    window_end_toast(&app->window);
    timeline_pause(&app->timeline, app_clock(app));
    player->state = PLAYER_IS_FINISHED;
    if (!app->settings->load || !lesson_file_next(player->path, player->next_path)) {
        player->next_path[0] = '\0';
    }
    player_update_panel(app);
}

/* --- playing ---------------------------------------------------------------------------------- */

/** Does all steps up to a time, until one of them stops the clock. @param until Milliseconds. */
static void play_until(App *app, int64_t until) {
    Player *player = &app->player;
    const Lesson *lesson = player->lesson;
    // A second picture, and rays, are there at the end of a frame; what follows may change them.
    while (!app_is_lesson_stopped(app) && player->next_step < lesson->count &&
           lesson->steps[player->next_step].time <= until && !window_awaits_frame(&app->window)) {
        const LessonStep *step = &lesson->steps[player->next_step++];
        step_clock_advance(&player->step_clock, step->time);
        lesson_step_do(app, step);
    }
    if (app_is_lesson_stopped(app) || window_awaits_frame(&app->window)) {
        return;
    }
    if (player->next_step == lesson->count) {
        finish_lesson(app);
    } else {
        step_clock_advance(&player->step_clock, until);
    }
}

void player_repeat_steps(App *app) {
    Player *player = &app->player;
    while (player->next_step < player->repeat_end && !app_is_lesson_stopped(app) &&
           !window_awaits_frame(&app->window)) {
        const LessonStep *step = &player->lesson->steps[player->next_step++];
        step_clock_advance(&player->step_clock, step->time);
        lesson_step_do(app, step);
    }
    if (player->next_step >= player->repeat_end) {
        player->repeat_end = 0;
    }
    if (player->state == PLAYER_RUNS) {
        player_resume_clock(player);
    }
}

void player_update(App *app, double now) {
    Player *player = &app->player;
    take_loaded_lesson(app);
    if (player->is_leaving) {
        player_close(app);
    }
    if (!app_is_playing(app) || app_is_lesson_stopped(app)) {
        return;
    }
    if (player->repeat_end > 0) {
        player_repeat_steps(app);
    } else if (window_is_ready(&app->window)) {
        int64_t passed = (int64_t)floor((now - player->start_time) * MILLISECONDS_PER_SECOND);
        play_until(app,
                   player_is_unattended(app) ? INT64_MAX : SDL_max(passed, player->step_clock.now));
    }
}

double player_timeout(const App *app, double now) {
    const Player *player = &app->player;
    bool is_due = app->source.lesson || player->is_leaving;
    bool is_running = app_is_playing(app) && !app_is_lesson_stopped(app);
    if (is_due || (is_running && player->repeat_end > 0)) {
        return 0;
    }
    if (!is_running || !window_is_ready(&app->window)) {
        return WINDOW_NO_TIMEOUT;
    }
    int64_t step = player->next_step < player->lesson->count
                       ? player->lesson->steps[player->next_step].time
                       : player->step_clock.now;
    int64_t next = SDL_min(step, step_clock_next_due(&player->step_clock));
    return player_is_unattended(app)
               ? 0
               : fmax(0, player->start_time + (double)next / MILLISECONDS_PER_SECOND - now);
}

bool player_capture(App *app, Error *error) {
    Player *player = &app->player;
    if (player->state != PLAYER_CAPTURES || !window_is_finished(&app->window) ||
        !app_is_time_settled(app)) {
        return true;
    }
    player_resume_clock(player);
    if (!app_save_picture(app, app->settings->lesson_snapshot_dir, player->name, error)) {
        app->exit.is_requested = true;
        app->exit.status = error->status;
        return false;
    }
    return true;
}
