/**
 * @file
 * @brief What viewers request of a lesson, by buttons and keys: hold it, go back, go on, answer.
 */
#include "base/language.h"
#include "view/commands/leaving.h"
#include "view/lesson/player.h"
#include "view/lesson/player_internal.h"

#include <limits.h>
#include <string.h>

/* --- steps back and on ------------------------------------------------------------------------ */

/** Goes to a stop: repeats everything from the beginning, or goes on at once. @param stop Index of
 *  the step; the number of steps: the end. */
static void go_to(App *app, size_t stop) {
    Player *player = &app->player;
    if (stop < player->next_step) {
        app_restart_view(app, player->initial_time);
        player_rewind(app);
    } else if (app_is_lesson_stopped(app)) {
        player_resume(app);
    }
    player->repeat_end = SDL_min(stop + 1, player->lesson->count);
    player_repeat_steps(app);
}

/** Goes to the stop before, or to the present one while the lesson runs. */
static void step_back(App *app) {
    const Player *player = &app->player;
    size_t stop = player->stop < player->lesson->count ? player->stop : 0;
    bool is_passed = player->state == PLAYER_RUNS || player->state == PLAYER_IS_FINISHED;
    for (size_t i = stop + is_passed; i-- > 0;) {
        if (player_is_stop(&player->lesson->steps[i])) {
            stop = i;
            break;
        }
    }
    go_to(app, stop);
}

/** Goes to the next stop at once. */
static void step_on(App *app) {
    go_to(app, player_next_stop(&app->player));
}

/** Plays the same lesson once more. */
static void play_again(App *app) {
    Player *player = &app->player;
    app_restart_view(app, player->initial_time);
    memset(player->answers, 0, sizeof player->answers);
    player_rewind(app);
    player_update_panel(app);
}

/** Opens the lesson after this one. */
static void open_next(App *app) {
    char path[PATH_MAX];
    SDL_strlcpy(path, app->player.next_path, sizeof path);
    if (path[0] != '\0') {
        player_open_file(app, path);
    }
}

/** @return Whether an explanation has just come by itself: a key that was to bring it must not
 * leave it. */
static bool is_just_explained(const Player *player) {
    /** In less than that nobody has read it, seconds. */
    const double grace = 0.4;
    return player->stop < player->lesson->count &&
           player->lesson->steps[player->stop].kind == LESSON_EXPLAIN &&
           clock_now_seconds() - player->stop_time < grace;
}

/** Lets the lesson go on, or stops it; after an answer, shows at once whether it is right: a class
 *  that has answered waits for that, and not for a picture that stands still. */
static void toggle_waiting(App *app) {
    if (app->player.state == PLAYER_WAITS && !is_just_explained(&app->player)) {
        player_resume(app);
    } else if (player_is_before_verdict(&app->player)) {
        step_on(app);
    } else if (app->player.state == PLAYER_RUNS) {
        player_stop(app, PLAYER_WAITS);
    }
}

/** @return Whether nothing would be lost with the lesson: it is at its first stop, and nothing was
 *  answered. */
static bool is_at_beginning(const Player *player) {
    int asked = 0;
    lesson_panel_score(player->lesson, player->answers, &asked);
    return asked == 0 && (player->stop >= player->lesson->count ||
                          lesson_panel_number(player->lesson, player->stop) == 0);
}

/** Ends the lesson, or asks first whether it is to be ended. */
static void leave(App *app) {
    if (is_at_beginning(&app->player)) {
        app->player.is_leaving = true;
    } else {
        leaving_request(app);
    }
}

/* --- buttons ---------------------------------------------------------------------------------- */

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
        player_close(app);
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
        player_answer(app, (int)request.index + 1);
        break;
    case LESSON_REQUEST_CLOSE:
        leave(app);
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
    if (request.kind != LESSON_REQUEST_CLOSE) {
        leaving_withdraw(app, NULL);
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
    leaving_withdraw(app, NULL);
    if (app->player.state == PLAYER_ASKS) {
        player_answer(app, digit);
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
    bool is_open = app->player.state == PLAYER_ASKS && command_is(command, "time");
    if (app->player.state == PLAYER_CAPTURES || is_open) {
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
    bool is_enter = command_is(command, "caption");
    if (command_is(command, "time back")) {
        step_back(app);
    } else if (is_enter) {
        handle_card_request(app, lesson_panel_card_default(&app->window.lesson_panel));
    }
    return is_enter || command_is(command, "time") || command_is(command, "time back") ||
           command_is(command, "time on");
}

/** @return Whether the lesson still runs. See #StatusHoldsFn. */
static bool is_running(const App *app) {
    return app->player.lesson && app->player.state == PLAYER_RUNS;
}

/** @return Whether it is still held. */
static bool is_held(const App *app) {
    return app->player.state == PLAYER_WAITS;
}

/** @return Whether it still asks. */
static bool is_asking(const App *app) {
    return app->player.state == PLAYER_ASKS;
}

/** @return Whether it still runs to where a question is answered. */
static bool is_before_verdict(const App *app) {
    return is_running(app) && player_is_before_verdict(&app->player);
}

/** Says what the viewer can do instead of a command. */
static void show_refusal(App *app) {
    static const struct {
        StatusHoldsFn *holds; /**< Until when it is so. */
        const char *text;     /**< What to do. */
    } refusals[] = {
        [PLAYER_RUNS] = {is_running, N_("a lesson is played: Space holds it")},
        [PLAYER_WAITS] = {is_held, N_("a lesson is held: Space goes on")},
        [PLAYER_ASKS] = {is_asking, N_("a lesson asks: click your answer, or press its number")}};
    if (is_before_verdict(app)) {
        app_set_status_while(app, is_before_verdict,
                             N_("a lesson shows what it asked about: Space goes to the answer"));
    } else if (app->player.state <= PLAYER_ASKS) {
        app_set_status_while(app, refusals[app->player.state].holds,
                             refusals[app->player.state].text);
    }
}

bool player_handle_command(App *app, const Command *command) {
    unsigned flags = command ? command->flags : 0;
    if (!app->player.lesson || (flags & COMMAND_WHILE_PLAYING)) {
        return false;
    }
    if (command) {
        leaving_withdraw(app, command);
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
