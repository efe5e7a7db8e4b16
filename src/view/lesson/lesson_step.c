/**
 * @file
 * @brief Does the steps of a lesson.
 */
#include "view/lesson/lesson_step.h"

#include "view/commands/commands.h"
#include "view/commands/edits.h"
#include "view/lesson/action_names.h"
#include "view/lesson/player_internal.h"

/* --- keys ------------------------------------------------------------------------------------- */

/** #LESSON_PRESS: runs a command, or begins its move. */
static void press(App *app, const LessonStep *step) {
    Player *player = &app->player;
    StepClock *step_clock = &player->step_clock;
    const Command *command = command_of_action(step->action);
    // What the viewer may do meanwhile is no part of the picture: repeated, it would undo itself.
    bool is_skipped = player->repeat_end > 0 && command->flags & COMMAND_WHILE_PLAYING;
    if (command_is_move(command)) {
        held_keys_press(&step_clock->held_keys, command->move, step_clock_seconds(step_clock));
    } else if (!is_skipped) {
        bool shows_settings = app->window.shows_settings;
        command_run(app, command, step->continues);
        // What the settings are might answer a question.
        if (!command_is(command, "settings")) {
            app->window.shows_settings = shows_settings;
        }
        if (!app->title.holds) { // What was said to the user before stays.
            window_end_toast(&app->window);
        }
    }
}

/** #LESSON_RELEASE: ends a move. */
static void release(App *app, const LessonStep *step) {
    StepClock *step_clock = &app->player.step_clock;
    held_keys_release(&step_clock->held_keys, command_of_action(step->action)->move,
                      step_clock_seconds(step_clock));
}

/** #LESSON_SPEED. */
static void set_speed(App *app, const LessonStep *step) {
    StepClock *step_clock = &app->player.step_clock;
    held_keys_set_speed(&step_clock->held_keys, step->x, step_clock_seconds(step_clock));
}

/* --- camera and window ------------------------------------------------------------------------ */

/** @return The three numbers of a step. */
static Vec3d vector_of_step(const LessonStep *step) {
    return (Vec3d){step->x, step->y, step->z};
}

/** #LESSON_TURN. */
static void turn(App *app, const LessonStep *step) {
    app_turn(app, step->x, step->y);
}

/** #LESSON_ORBIT. */
static void orbit(App *app, const LessonStep *step) {
    const double *center = step->center;
    app_orbit(app, step->x, step->y, (Vec3d){center[0], center[1], center[2]});
}

/** #LESSON_PAN. */
static void pan(App *app, const LessonStep *step) {
    app_pan(app, step->x, step->y);
}

/** #LESSON_ZOOM. */
static void zoom(App *app, const LessonStep *step) {
    app_zoom(app, step->x);
}

/** #LESSON_SIZE. */
static void set_size(App *app, const LessonStep *step) {
    window_set_size_below_toolbar(&app->window, (int)step->x, (int)step->y);
}

/** #LESSON_BAR. */
static void move_bar(App *app, const LessonStep *step) {
    window_move_bar(&app->window, step->x);
}

/* --- rays ------------------------------------------------------------------------------------- */

/** #LESSON_PIXEL. */
static void pick_pixel(App *app, const LessonStep *step) {
    app_pick_pixel(app, step->x, step->y);
}

/** #LESSON_MARK. */
static void mark_pixel(App *app, const LessonStep *step) {
    ray_view_mark(&app->window.ray_view, step->x, step->y);
    window_present(&app->window);
}

/** #LESSON_WALK. */
static void walk(App *app, const LessonStep *step) {
    app_step_pixel(app, (int)step->x, (int)step->y);
}

/** #LESSON_RAY. */
static void choose_ray(App *app, const LessonStep *step) {
    app_choose_ray(app, (size_t)step->action);
}

/* --- objects ---------------------------------------------------------------------------------- */

/** #LESSON_DRAG. */
static void drag_light(App *app, const LessonStep *step) {
    app_drag_light(app, (size_t)step->action, vector_of_step(step));
}

/** #LESSON_SELECT. */
static void select_object(App *app, const LessonStep *step) {
    const Uvd pixel = {step->x, step->y};
    edits_select(app, step->keyword, step->action, step->x >= 0 ? &pixel : NULL);
}

/** #LESSON_SET. */
static void set_field(App *app, const LessonStep *step) {
    const SceneOverride override = {
        step->keyword, step->action, step->row, {step->x, step->y, step->z}};
    edits_set(app, &override, step->continues);
}

/** #LESSON_MOVE. */
static void move_object(App *app, const LessonStep *step) {
    edits_move(app, step->keyword, step->action, vector_of_step(step), step->continues);
}

/* --- stops ------------------------------------------------------------------------------------ */

/** #LESSON_CAPTION, #LESSON_ASK, #LESSON_EXPLAIN: steps that are repeated do not stop again. */
static void stop(App *app, const LessonStep *step) {
    const Player *player = &app->player;
    if (player->next_step >= player->repeat_end) {
        player_show_stop(app, step);
    }
}

/** #LESSON_SNAPSHOT. */
static void take_snapshot(App *app, const LessonStep *step) {
    (void)step;
    if (player_is_unattended(app)) {
        app->player.state = PLAYER_CAPTURES;
    }
}

void lesson_step_do(App *app, const LessonStep *step) {
    /** What each kind of step does. */
    static void (*const actions[])(App * app, const LessonStep *step) = {
        [LESSON_PRESS] = press,   [LESSON_RELEASE] = release,  [LESSON_SPEED] = set_speed,
        [LESSON_TURN] = turn,     [LESSON_ORBIT] = orbit,      [LESSON_PAN] = pan,
        [LESSON_ZOOM] = zoom,     [LESSON_SIZE] = set_size,    [LESSON_PIXEL] = pick_pixel,
        [LESSON_WALK] = walk,     [LESSON_RAY] = choose_ray,   [LESSON_MARK] = mark_pixel,
        [LESSON_BAR] = move_bar,  [LESSON_DRAG] = drag_light,  [LESSON_SELECT] = select_object,
        [LESSON_SET] = set_field, [LESSON_MOVE] = move_object, [LESSON_CAPTION] = stop,
        [LESSON_ASK] = stop,      [LESSON_EXPLAIN] = stop,     [LESSON_SNAPSHOT] = take_snapshot,
    };
    actions[step->kind](app, step);
}
