/**
 * @file
 * @brief Playing lessons.
 */
#include "view/lesson/player.h"

#include "base/language.h"
#include "base/lesson_file.h"
#include "base/scene_name.h"
#include "view/commands/commands.h"
#include "view/commands/current_scene.h"
#include "view/commands/edits.h"
#include "view/lesson/answer_file.h"

#include <libintl.h>
#include <string.h>

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

/* --- what the panel shows --------------------------------------------------------------------- */

/** @return Whether the lesson plays without a viewer. */
static bool is_unattended(const App *app) {
    return app->settings->lesson_snapshot_dir != NULL;
}

/** Shows in the panel what the lesson does. */
static void update_panel(App *app) {
    const Player *player = &app->player;
    LessonPanel panel = {.lesson = is_unattended(app) ? NULL : player->lesson,
                         .answers = player->answers,
                         .stop = player->stop,
                         .is_waiting = player->state == PLAYER_WAITS,
                         .is_asking = player->state == PLAYER_ASKS,
                         .is_finished = player->state == PLAYER_IS_FINISHED,
                         .has_next = player->next_path[0] != '\0'};
    window_set_lesson_panel(&app->window, &panel);
}

/* --- beginning and end ------------------------------------------------------------------------ */

bool player_allows_input(const App *app) {
    return !app_is_playing(app) || app->player.state == PLAYER_WAITS;
}

/** Moves light and camera. See #StepClockMoveFn. */
static void move_by_clock(void *context, Movement light, Movement camera) {
    app_move(context, light, camera);
}

/** Puts the lesson to its beginning. */
static void rewind_lesson(App *app) {
    Player *player = &app->player;
    view_state_deinit(&player->paused_view);
    player->state = PLAYER_RUNS;
    player->step_clock =
        (StepClock){.move = move_by_clock, .context = app, .held_keys = {.speed = 1}};
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
    rewind_lesson(app);
    window_end_hint(&app->window);
    update_panel(app);
}

void player_begin(App *app) {
    if (app->settings->lesson) {
        begin_lesson(app, app->settings->lesson, NULL, app->settings->lesson_path);
    }
}

void player_end(App *app) {
    Player *player = &app->player;
    view_state_deinit(&player->paused_view);
    if (app_is_playing(app)) {
        timeline_pause(&app->timeline, app_clock(app));
    }
    if (player->lesson) {
        app->home_view.move_speed = view_state_move_speed(app->scene);
        Lesson *owned = player->owned;
        *player = (Player){0};
        update_panel(app);
        lesson_destroy(owned);
    }
}

/** Begins the lesson that was loaded with the scene on screen, if any. */
static void take_loaded_lesson(App *app) {
    Lesson *lesson = app->source.lesson;
    if (lesson) {
        app->source.lesson = NULL;
        player_end(app);
        app_restart_view(app, app->scene_time);
        begin_lesson(app, lesson, lesson, app->source.lesson_path);
    }
}

void player_open_file(App *app, const char *path) {
    if (app_is_playing(app)) {
        current_scene_is_locked(app);
        return;
    }
    player_end(app);
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
    app_set_status(app, "the lesson is over");
    if (is_unattended(app)) {
        player_end(app);
        app->exit.is_requested = true;
        return;
    }
    window_end_toast(&app->window); // The card says it.
    timeline_pause(&app->timeline, app_clock(app));
    player->state = PLAYER_IS_FINISHED;
    if (!app->settings->load || !lesson_file_next(player->path, player->next_path)) {
        player->next_path[0] = '\0';
    }
    update_panel(app);
}

/* --- stops ------------------------------------------------------------------------------------ */

/** Lets the clock run again. */
static void resume_clock(Player *player) {
    player->state = PLAYER_RUNS;
    player->start_time = clock_now_seconds() - step_clock_seconds(&player->step_clock);
}

/** Stops the lesson, and saves the view. @param state #PLAYER_WAITS or #PLAYER_ASKS. */
static void stop_lesson(App *app, PlayerState state) {
    Player *player = &app->player;
    Error error = {0};
    view_state_deinit(&player->paused_view);
    if (!view_state_save_current(&player->paused_view, &app->home_view, app->scene, &error)) {
        app_set_status(app, "no memory for the view");
        return;
    }
    player->paused_light = app->selected_light;
    player->paused_timeline = app->timeline;
    player->state = state;
    update_panel(app);
}

/** Restores the view, and lets the lesson go on. */
static void resume_lesson(App *app) {
    Player *player = &app->player;
    held_keys_clear(&app->input.held_keys);
    view_state_restore_current(&player->paused_view, &app->home_view, app->scene);
    app->selected_light = player->paused_light;
    app->timeline = player->paused_timeline;
    resume_clock(player);
    app_on_view_changed(app);
    update_panel(app);
}

/** Keeps the answer to a question. @param answer The choice, from 1. */
static void keep_answer(App *app, size_t question, int answer) {
    Player *player = &app->player;
    const AnswerRecord record = {.lesson = player->name,
                                 .question = question + 1,
                                 .answer = answer,
                                 .is_right =
                                     answer == player->lesson->questions[question].right + 1};
    Error error = {0};
    player->answers[question] = answer;
    if (app->settings->answer_path &&
        !answer_file_append(app->settings->answer_path, &record, &error)) {
        app_report_error(app, &error);
    }
}

/** @return The answer of an unattended lesson to a question, from 1. */
static int unattended_answer(const App *app, size_t index) {
    const LessonQuestion *question = &app->player.lesson->questions[index];
    const char *predictions = app->settings->predictions;
    int chosen = predictions && index < strlen(predictions) ? predictions[index] - '0' : 0;
    return chosen > 0 && chosen <= question->choice_count ? chosen : question->right + 1;
}

/** Shows a caption, a question or an explanation, and stops if it waits. */
static void show_stop(App *app, const LessonStep *step) {
    Player *player = &app->player;
    bool waits = step->waits_for_viewer || step->kind == LESSON_EXPLAIN;
    bool is_asked_for = player->repeat_end == player->next_step && player->repeat_end > 0;
    player->stop = player->next_step - 1;
    if (is_unattended(app) && step->kind == LESSON_ASK) {
        keep_answer(app, (size_t)step->action, unattended_answer(app, (size_t)step->action));
    } else if (is_unattended(app)) {
        player->state = PLAYER_CAPTURES;
    } else if (step->kind == LESSON_ASK) {
        stop_lesson(app, PLAYER_ASKS);
    } else if (waits || is_asked_for) {
        stop_lesson(app, PLAYER_WAITS);
    } else {
        update_panel(app);
    }
}

/** Takes an answer to the question on screen. @param answer The choice, from 1. @return Whether
 *  there is such a choice. */
static bool answer_question(App *app, int answer) {
    const Player *player = &app->player;
    size_t question = (size_t)player->lesson->steps[player->stop].action;
    if (answer < 1 || answer > player->lesson->questions[question].choice_count) {
        return false;
    }
    keep_answer(app, question, answer);
    resume_lesson(app);
    return true;
}

/* --- playing ---------------------------------------------------------------------------------- */

/** Runs a command, or begins its move. */
static void press(App *app, const Command *command) {
    Player *player = &app->player;
    StepClock *step_clock = &player->step_clock;
    // What the viewer may do meanwhile is no part of the picture: repeated, it would undo itself.
    bool is_skipped = player->repeat_end > 0 && command->flags & COMMAND_WHILE_PLAYING;
    if (command_is_move(command)) {
        held_keys_press(&step_clock->held_keys, command->move, step_clock_seconds(step_clock));
    } else if (!is_skipped) {
        bool shows_settings = app->window.shows_settings;
        command_run(app, command);
        // What the settings are might answer a question.
        if (!command_is(command, "settings")) {
            app->window.shows_settings = shows_settings;
        }
        window_end_toast(&app->window);
    }
}

/** Does a step. */
static void do_step(App *app, const LessonStep *step) {
    Player *player = &app->player;
    StepClock *step_clock = &player->step_clock;
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
    case LESSON_ORBIT:
        app_orbit(app, step->x, step->y,
                  (Vec3d){step->center[0], step->center[1], step->center[2]});
        break;
    case LESSON_PAN:
        app_pan(app, step->x, step->y);
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
    case LESSON_ASK:
    case LESSON_EXPLAIN:
        if (player->next_step >= player->repeat_end) {
            show_stop(app, step);
        }
        break;
    case LESSON_SNAPSHOT:
        player->state = is_unattended(app) ? PLAYER_CAPTURES : player->state;
        break;
    }
}

/** Does all steps up to a time, until one of them stops the clock. @param until Milliseconds. */
static void play_until(App *app, int64_t until) {
    Player *player = &app->player;
    const Lesson *lesson = player->lesson;
    // The second picture opens at the end of a frame; what follows may change it.
    while (!app_is_lesson_stopped(app) && player->next_step < lesson->count &&
           lesson->steps[player->next_step].time <= until &&
           !window_awaits_second_picture(&app->window)) {
        const LessonStep *step = &lesson->steps[player->next_step++];
        step_clock_advance(&player->step_clock, step->time);
        do_step(app, step);
    }
    if (app_is_lesson_stopped(app) || window_awaits_second_picture(&app->window)) {
        return;
    }
    if (player->next_step == lesson->count) {
        finish_lesson(app);
    } else {
        step_clock_advance(&player->step_clock, until);
    }
}

/** Does the steps to be repeated. */
static void repeat_steps(App *app) {
    Player *player = &app->player;
    while (player->next_step < player->repeat_end && !app_is_lesson_stopped(app) &&
           !window_awaits_second_picture(&app->window)) {
        const LessonStep *step = &player->lesson->steps[player->next_step++];
        step_clock_advance(&player->step_clock, step->time);
        do_step(app, step);
    }
    if (player->next_step >= player->repeat_end) {
        player->repeat_end = 0;
    }
    if (player->state == PLAYER_RUNS) {
        resume_clock(player);
    }
}

void player_update(App *app, double now) {
    Player *player = &app->player;
    take_loaded_lesson(app);
    if (player->is_leaving) {
        player_end(app);
    }
    if (!app_is_playing(app) || app_is_lesson_stopped(app)) {
        return;
    }
    if (player->repeat_end > 0) {
        repeat_steps(app);
    } else if (window_is_ready(&app->window)) {
        int64_t passed = (int64_t)floor((now - player->start_time) * 1000);
        play_until(app, is_unattended(app) ? INT64_MAX : SDL_max(passed, player->step_clock.now));
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
    int64_t next = SDL_min(step, step_clock_next_tick(&player->step_clock) + 1);
    return is_unattended(app) ? 0 : fmax(0, player->start_time + (double)next / 1000 - now);
}

bool player_capture(App *app, Error *error) {
    Player *player = &app->player;
    if (player->state != PLAYER_CAPTURES || !window_is_finished(&app->window) ||
        !app_is_time_settled(app)) {
        return true;
    }
    resume_clock(player);
    if (!app_save_picture(app, app->settings->lesson_snapshot_dir, player->name, error)) {
        app->exit.is_requested = true;
        app->exit.status = error->status;
        return false;
    }
    return true;
}

/* --- steps back and on ------------------------------------------------------------------------ */

/** @return Whether a step is a stop: a caption, a question, an explanation. */
static bool is_stop(const LessonStep *step) {
    return step->kind == LESSON_CAPTION || step->kind == LESSON_ASK || step->kind == LESSON_EXPLAIN;
}

/** Goes to a stop: repeats everything from the beginning, or goes on at once. @param stop Index of
 *  the step; the number of steps: the end. */
static void go_to(App *app, size_t stop) {
    Player *player = &app->player;
    if (stop < player->next_step) {
        app_restart_view(app, player->initial_time);
        rewind_lesson(app);
    } else if (app_is_lesson_stopped(app)) {
        resume_lesson(app);
    }
    player->repeat_end = SDL_min(stop + 1, player->lesson->count);
    repeat_steps(app);
}

/** Goes to the stop before, or to the present one while the lesson runs. */
static void step_back(App *app) {
    const Player *player = &app->player;
    size_t stop = player->stop < player->lesson->count ? player->stop : 0;
    bool is_passed = player->state == PLAYER_RUNS || player->state == PLAYER_IS_FINISHED;
    for (size_t i = stop + is_passed; i-- > 0;) {
        if (is_stop(&player->lesson->steps[i])) {
            stop = i;
            break;
        }
    }
    go_to(app, stop);
}

/** Goes to the next stop at once. */
static void step_on(App *app) {
    const Player *player = &app->player;
    size_t stop = player->next_step;
    while (stop < player->lesson->count && !is_stop(&player->lesson->steps[stop])) {
        stop++;
    }
    go_to(app, stop);
}

/** Plays the same lesson once more. */
static void play_again(App *app) {
    Player *player = &app->player;
    app_restart_view(app, player->initial_time);
    memset(player->answers, 0, sizeof player->answers);
    rewind_lesson(app);
    update_panel(app);
}

/** Opens the lesson after this one. */
static void open_next(App *app) {
    char path[PATH_MAX];
    SDL_strlcpy(path, app->player.next_path, sizeof path);
    if (path[0] != '\0') {
        player_open_file(app, path);
    }
}

/** Lets the lesson go on, or stops it. */
static void toggle_waiting(App *app) {
    if (app->player.state == PLAYER_WAITS) {
        resume_lesson(app);
    } else if (app->player.state == PLAYER_RUNS) {
        stop_lesson(app, PLAYER_WAITS);
    }
}

/** Does what a button or a key of the end card requests. */
static void handle_card_request(App *app, LessonRequestKind kind) {
    switch (kind) {
    case LESSON_REQUEST_NEXT:
        open_next(app);
        break;
    case LESSON_REQUEST_AGAIN:
        play_again(app);
        break;
    case LESSON_REQUEST_CLOSE:
        player_end(app);
        break;
    default:
        break;
    }
}

/** Does what a button requests while the lesson plays. */
static void handle_playing_request(App *app, LessonRequest request) {
    switch (request.kind) {
    case LESSON_REQUEST_BACK:
        step_back(app);
        break;
    case LESSON_REQUEST_ON:
        step_on(app);
        break;
    case LESSON_REQUEST_GO_TO:
        go_to(app, request.index);
        break;
    case LESSON_REQUEST_RESUME:
        toggle_waiting(app);
        break;
    case LESSON_REQUEST_ANSWER:
        answer_question(app, (int)request.index + 1);
        break;
    default:
        break;
    }
}

void player_handle_request(App *app) {
    LessonRequest request = app->window.lesson_panel.request;
    app->window.lesson_panel.request = (LessonRequest){0};
    if (request.kind == LESSON_REQUEST_NONE || !app->player.lesson) {
        return;
    }
    if (app->player.state == PLAYER_IS_FINISHED) {
        handle_card_request(app, request.kind);
    } else {
        handle_playing_request(app, request);
    }
}

/* --- keys ------------------------------------------------------------------------------------- */

/** @return The digit of a key, by its position; 0: it has none. */
static int digit_of_key(SDL_Scancode key) {
    if (key >= SDL_SCANCODE_1 && key <= SDL_SCANCODE_9) {
        return (int)(key - SDL_SCANCODE_1) + 1;
    }
    return key >= SDL_SCANCODE_KP_1 && key <= SDL_SCANCODE_KP_9 ? (int)(key - SDL_SCANCODE_KP_1) + 1
                                                                : 0;
}

bool player_handle_digit(App *app, SDL_Scancode key) {
    static const LessonRequestKind card[] = {LESSON_REQUEST_NEXT, LESSON_REQUEST_AGAIN,
                                             LESSON_REQUEST_CLOSE};
    int digit = digit_of_key(key);
    if (digit == 0 || !app->player.lesson) {
        return false;
    }
    if (app->player.state == PLAYER_ASKS) {
        answer_question(app, digit);
        return true;
    }
    if (app->player.state == PLAYER_IS_FINISHED && digit <= (int)SDL_arraysize(card)) {
        handle_card_request(app, card[digit - 1]);
        return true;
    }
    return false;
}

/** Handles a command that steers the lesson. @return Whether it does. */
static bool steer(App *app, const Command *command) {
    if (app->player.state == PLAYER_CAPTURES) {
        return false;
    }
    if (command_is(command, "time")) {
        toggle_waiting(app);
    } else if (command_is(command, "time back")) {
        step_back(app);
    } else if (command_is(command, "time on")) {
        step_on(app);
    } else {
        return false;
    }
    return true;
}

/** Handles a command while the end card is shown. @return Whether it steers the lesson. */
static bool steer_card(App *app, const Command *command) {
    if (command_is(command, "time back")) {
        step_back(app);
    }
    return command_is(command, "time") || command_is(command, "time back") ||
           command_is(command, "time on");
}

/** Says what the viewer can do instead of a command. */
static void show_refusal(App *app) {
    static const char *const words[] = {[PLAYER_RUNS] = N_("a lesson is played: Space holds it"),
                                        [PLAYER_WAITS] = N_("a lesson is held: Space goes on"),
                                        [PLAYER_ASKS] =
                                            N_("a lesson asks: press the number of your answer")};
    if (app->player.state <= PLAYER_ASKS) {
        app_set_status(app, "%s", gettext(words[app->player.state]));
    }
}

bool player_handle_command(App *app, const Command *command) {
    unsigned flags = command ? command->flags : 0;
    if (!app->player.lesson || (flags & COMMAND_WHILE_PLAYING)) {
        return false;
    }
    if (app->player.state == PLAYER_IS_FINISHED) {
        return steer_card(app, command);
    }
    if (steer(app, command)) {
        return true;
    }
    if (app->player.state == PLAYER_WAITS && (flags & COMMAND_WHILE_PAUSED)) {
        return false;
    }
    if (command) {
        show_refusal(app);
    }
    return true;
}
