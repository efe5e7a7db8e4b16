/**
 * @file
 * @brief Where a lesson stops: captions, questions and explanations.
 */
#include "base/language.h"
#include "view/lesson/answer_file.h"
#include "view/lesson/player_internal.h"

#include <string.h>

bool player_is_unattended(const App *app) {
    return app->settings->lesson_snapshot_dir != NULL;
}

bool player_is_stop(const LessonStep *step) {
    return step->kind == LESSON_CAPTION || step->kind == LESSON_ASK || step->kind == LESSON_EXPLAIN;
}

size_t player_next_stop(const Player *player) {
    const Lesson *lesson = player->lesson;
    size_t stop = player->next_step;
    while (stop < lesson->count && !player_is_stop(&lesson->steps[stop])) {
        stop++;
    }
    return stop;
}

bool player_is_before_verdict(const Player *player) {
    const size_t stop = player_next_stop(player);
    return player->state == PLAYER_RUNS && stop < player->lesson->count &&
           player->lesson->steps[stop].kind == LESSON_EXPLAIN;
}

void player_update_panel(App *app) {
    const Player *player = &app->player;
    LessonPanel panel = {.lesson = player_is_unattended(app) ? NULL : player->lesson,
                         .answers = player->answers,
                         .stop = player->stop,
                         .is_waiting = player->state == PLAYER_WAITS,
                         .is_before_verdict = player->lesson && player_is_before_verdict(player),
                         .is_asking = player->state == PLAYER_ASKS,
                         .is_finished = player->state == PLAYER_IS_FINISHED,
                         .has_next = player->next_path[0] != '\0'};
    window_set_lesson_panel(&app->window, &panel);
}

void player_resume_clock(Player *player) {
    player->state = PLAYER_RUNS;
    player->start_time = clock_now_seconds() - step_clock_seconds(&player->step_clock);
}

void player_stop(App *app, PlayerState state) {
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
    player_update_panel(app);
}

void player_resume(App *app) {
    Player *player = &app->player;
    held_keys_clear(&app->input.held_keys);
    view_state_restore_current(&player->paused_view, &app->home_view, app->scene);
    app->selected_light = player->paused_light;
    app->timeline = player->paused_timeline;
    player_resume_clock(player);
    app_on_view_changed(app);
    player_update_panel(app);
}

/** Reports an error, which ends an unattended lesson. */
static void report_lesson_error(App *app, const Error *error) {
    app_report_error(app, error);
    if (player_is_unattended(app)) {
        app->exit = (ExitState){.is_requested = true, .status = error->status};
    }
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
        report_lesson_error(app, &error);
    }
}

/** Answers a question of an unattended lesson: by its prediction, or right if there is none. */
static void answer_unattended(App *app, size_t index) {
    const LessonQuestion *question = &app->player.lesson->questions[index];
    const char *predictions = app->settings->predictions;
    bool is_predicted = predictions && index < strlen(predictions);
    int chosen = is_predicted ? predictions[index] - '0' : question->right + 1;
    if (chosen >= 1 && chosen <= question->choice_count) {
        keep_answer(app, index, chosen);
        return;
    }
    Error error = {0};
    error_set(&error, STATUS_USAGE, "--predictions must be from 1 to %d for question %zu, not %d",
              question->choice_count, index + 1, chosen);
    report_lesson_error(app, &error);
}

void player_show_stop(App *app, const LessonStep *step) {
    Player *player = &app->player;
    bool waits = step->waits_for_viewer || step->kind == LESSON_EXPLAIN;
    bool is_asked_for = player->repeat_end == player->next_step && player->repeat_end > 0;
    player->stop = player->next_step - 1;
    if (player_is_unattended(app) && step->kind == LESSON_ASK) {
        answer_unattended(app, (size_t)step->action);
    } else if (player_is_unattended(app)) {
        player->state = PLAYER_CAPTURES;
    } else if (step->kind == LESSON_ASK) {
        player_stop(app, PLAYER_ASKS);
    } else if (waits || is_asked_for) {
        player->stop_time = is_asked_for ? 0 : clock_now_seconds();
        player_stop(app, PLAYER_WAITS);
    } else {
        player_update_panel(app);
    }
}

bool player_answer(App *app, int answer) {
    const Player *player = &app->player;
    size_t question = (size_t)player->lesson->steps[player->stop].action;
    if (answer < 1 || answer > player->lesson->questions[question].choice_count) {
        return false;
    }
    keep_answer(app, question, answer);
    player_resume(app);
    return true;
}
