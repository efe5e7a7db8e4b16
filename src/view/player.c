/**
 * @file
 * @brief Playing lessons.
 */
#include "view/player.h"

#include "dioptre/language.h"
#include "view/controls.h"
#include "view/deeds.h"
#include "view/play.h"
#include "view/shoot.h"

#include <string.h>

/** @return Whether nobody is waited for. @param view The view. */
static bool is_by_itself(const View *view) {
    return view->settings->lesson_snapshots != NULL;
}

bool player_is_on(const View *view) {
    return view->player.lesson != NULL;
}

bool player_is_still(const Player *player) {
    return player->is_held || player->is_shooting;
}

bool player_leaves_view(const View *view) {
    return !player_is_on(view) || view->player.is_held;
}

/** Moves light and camera. See #MetronomeMover. @param context The #View. @param light See there.
 *  @param camera See there. */
static void move(void *context, Movement light, Movement camera) {
    controls_move(context, light, camera);
}

void player_begin(View *view) {
    const Lesson *lesson = view->settings->lesson;
    if (lesson) {
        view->player =
            (Player){.lesson = lesson,
                     .metronome = {.move = move, .context = view, .motion = {.speed = 1}},
                     .began = clock_seconds()};
        view->stage.caption.title = lesson->title;
    }
}

/** Lets the clock go on. @param[in,out] player The lesson. */
static void go_on(Player *player) {
    player->is_held = player->is_shooting = false;
    player->began = clock_seconds() - metronome_seconds(&player->metronome);
}

/** Says what can be done, under the caption's heading. @param[in,out] view The view. */
static void tell_hint(View *view) {
    Caption *caption = &view->stage.caption;
    caption->hint = view->player.is_held ? N_("Space: go on") : NULL;
    overlay_forget(&caption->overlay);
    stage_present(&view->stage);
}

/** Holds the lesson. @param[in,out] view The view. */
static void hold(View *view) {
    Player *player = &view->player;
    Error error = {0};
    pose_release(&player->kept);
    if (!pose_copy(&player->kept, &view->home, view->scene, &error)) {
        view_note(view, "no memory for the view");
        return;
    }
    player->light = view->light;
    player->timeline = view->timeline;
    player->is_held = true;
    tell_hint(view);
}

/** Puts back what the viewer has moved, and goes on. @param[in,out] view The view. */
static void release(View *view) {
    Player *player = &view->player;
    motion_forget(&view->motion);
    pose_put_back(&player->kept, &view->home, view->scene);
    view->light = player->light;
    view->timeline = player->timeline;
    go_on(player);
    view_changed(view);
    tell_hint(view);
}

/** @return How many captions a lesson has before a step. @param lesson The lesson. @param end The
 *          step's place. */
static size_t captions_before(const Lesson *lesson, size_t end) {
    size_t count = 0;
    for (size_t i = 0; i < end; i++) {
        count += lesson->steps[i].kind == LESSON_CAPTION;
    }
    return count;
}

/** Shows a caption. @param[in,out] view The view. @param step The caption, the one before the next
 *  step. */
static void show_caption(View *view, const LessonStep *step) {
    Player *player = &view->player;
    Caption *caption = &view->stage.caption;
    caption->text = step->text;
    caption->number = captions_before(player->lesson, player->next);
    caption->count = captions_before(player->lesson, player->lesson->count);
    player->is_shooting = is_by_itself(view);
    if (step->waits && !player->is_shooting) {
        hold(view);
    } else {
        tell_hint(view);
    }
}

/** A key goes down. @param[in,out] view The view. @param step Which. */
static void press(View *view, const LessonStep *step) {
    Action action = (Action)step->action;
    Metronome *metronome = &view->player.metronome;
    if (action_is_move(action)) {
        motion_press(&metronome->motion, action, metronome_seconds(metronome));
    } else {
        deeds_do(view, action);
    }
}

/** Does a step. @param[in,out] view The view. @param step The step, the one before the next. */
static void do_step(View *view, const LessonStep *step) {
    Metronome *metronome = &view->player.metronome;
    double now = metronome_seconds(metronome);
    switch (step->kind) {
    case LESSON_PRESS:
        press(view, step);
        break;
    case LESSON_RELEASE:
        motion_release(&metronome->motion, (Action)step->action, now);
        break;
    case LESSON_SPEED:
        motion_set_speed(&metronome->motion, step->right, now);
        break;
    case LESSON_TURN:
        controls_turn(view, step->right, step->up);
        break;
    case LESSON_ZOOM:
        controls_zoom(view, step->right);
        break;
    case LESSON_SIZE:
        SDL_SetWindowSize(view->stage.display.window, (int)step->right, (int)step->up);
        break;
    case LESSON_PIXEL:
        controls_pick(view, step->right, step->up);
        break;
    case LESSON_WALK:
        controls_walk(view, (int)step->right, (int)step->up);
        break;
    case LESSON_BAR:
        stage_move_bar(&view->stage, step->right);
        break;
    case LESSON_CAPTION:
        show_caption(view, step);
        break;
    case LESSON_SNAPSHOT:
        view->player.is_shooting = is_by_itself(view);
        break;
    }
}

void player_end(View *view) {
    pose_release(&view->player.kept);
    if (player_is_on(view)) {
        timeline_hold(&view->timeline, play_clock(view));
        view->player = (Player){0};
        caption_close(&view->stage.caption);
    }
}

/** The last step was done. @param[in,out] view The view. */
static void finish(View *view) {
    bool is_over = is_by_itself(view);
    metronome_go(&view->player.metronome, view->player.metronome.now + METRONOME_BEAT);
    player_end(view);
    view_note(view, "the lesson is over");
    stage_present(&view->stage);
    view->is_over = view->is_over || is_over;
}

/** Does all steps up to a moment, unless one of them stops the clock. @param[in,out] view The view.
 *  @param until The moment, milliseconds. */
static void play_until(View *view, int64_t until) {
    Player *player = &view->player;
    const Lesson *lesson = player->lesson;
    while (!player_is_still(player) && player->next < lesson->count &&
           lesson->steps[player->next].time <= until) {
        const LessonStep *step = &lesson->steps[player->next++];
        metronome_go(&player->metronome, step->time);
        do_step(view, step);
    }
    if (!player_is_still(player) && player->next == lesson->count) {
        finish(view);
    } else if (!player_is_still(player)) {
        metronome_go(&player->metronome, until);
    }
}

void player_update(View *view, double now) {
    const Player *player = &view->player;
    if (player_is_on(view) && !player_is_still(player) && stage_is_ready(&view->stage)) {
        int64_t passed = (int64_t)floor((now - player->began) * 1000);
        play_until(view, is_by_itself(view) ? INT64_MAX : SDL_max(passed, player->metronome.now));
    }
}

double player_delay(const View *view, double now) {
    const Player *player = &view->player;
    if (!player_is_on(view) || player_is_still(player) || !stage_is_ready(&view->stage)) {
        return STAGE_NEVER;
    }
    int64_t step = player->next < player->lesson->count ? player->lesson->steps[player->next].time
                                                        : player->metronome.now;
    int64_t next = SDL_min(step, metronome_next(&player->metronome) + 1);
    return is_by_itself(view) ? 0 : fmax(0, player->began + (double)next / 1000 - now);
}

bool player_shoot(View *view, Error *error) {
    Player *player = &view->player;
    if (!player->is_shooting || !stage_is_finished(&view->stage) || !play_is_at_rest(view)) {
        return true;
    }
    go_on(player);
    if (!shoot(view, view->settings->lesson_snapshots, view->settings->lesson_name, error)) {
        view->is_over = true;
        view->status = error->status;
        return false;
    }
    return true;
}

/** @return Whether an action is the viewer's own even while a lesson is played: it changes nothing
 *          of what is drawn. @param action The action. */
static bool is_private(Action action) {
    static const Action own[] = {ACTION_COPY,     ACTION_SNAPSHOT,    ACTION_TEXT_LARGER,
                                 ACTION_LANGUAGE, ACTION_FULL_SCREEN, ACTION_TEXT_SMALLER,
                                 ACTION_HELP,     ACTION_LEAVE};
    for (size_t i = 0; i < sizeof own / sizeof *own; i++) {
        if (own[i] == action) {
            return true;
        }
    }
    return false;
}

bool player_takes(View *view, Action action) {
    bool is_held = view->player.is_held;
    if (!player_is_on(view) || is_private(action)) {
        return false;
    }
    if (action == ACTION_TIME && !view->player.is_shooting) {
        is_held ? release(view) : hold(view);
        return true;
    }
    bool is_moving = action_is_move(action) || action == ACTION_HOME || action == ACTION_NEXT_LIGHT;
    if (is_held && is_moving) {
        return false;
    }
    if (action != ACTION_NONE) {
        view_note(view, is_held ? N_("a lesson is held: Space goes on")
                                : N_("a lesson is played: Space holds it"));
    }
    return true;
}
