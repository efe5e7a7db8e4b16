/**
 * @file
 * @brief Tests of lessons as a class plays them: Space after an answer, marked pixels, chosen rays.
 */
#include "lesson_window.h"

/** A mirror before a sphere, with one lamp: ray 0 from the eye, 1 to the lamp, 2 from the mirror.
 */
static const char SCENE[] = "camera { position = {0, 1, 6}, look_at = {0, 1, 0} }\n"
                            "light { position = {1, 5, 3} }\n"
                            "quad { corner = {-4, -3, 0}, u = {8, 0, 0}, v = {0, 8, 0}, material = "
                            "material { reflectivity = 0.5 } }\n";
/** How long the lesson waits before it explains, seconds. */
static const double WAIT_SECONDS = 60;
/** A lesson that goes on for a minute after its question. */
static const char LESSON[] =
    "lesson { scene = \"scene.lua\" }\n"
    "mark(0.25, 0.75)\n"
    "ask { en = \"One?\", choices = { \"a\", \"b\" }, right = 1, because = \"So.\" }\n"
    "press \"shadow rays\"\n"
    "press \"rays\"\n"
    "ray(2)\n"
    "wait(60)\n"
    "explain()\n"
    "press \"rays\"\n"
    "wait(60)\n"
    "caption { en = \"Two\", wait = true }\n";

/** Opens the window with the lesson. @return 0 if it is open. */
static int set_up(void **state) {
    (void)state;
    return open_lesson_window(SCENE, LESSON);
}

/** Does what some frames do. */
static void frames(void) {
    for (int i = 0; i < 8; i++) {
        assert_true(settle());
        player_handle_request(&opened.app);
        player_update(&opened.app, clock_now_seconds());
    }
}

/** Issues a command as its key does while a lesson plays. */
static void steer(const char *name) {
    assert_true(player_handle_command(&opened.app, command_find(command_table, name)));
    frames();
}

/** Fails unless the lesson is in a state, at a stop of a kind. */
static void assert_at(PlayerState state, LessonStepKind kind) {
    const Player *player = &opened.app.player;
    assert_int_equal(player->state, state);
    assert_true(player->stop < lesson->count);
    assert_int_equal(lesson->steps[player->stop].kind, kind);
}

/** Space after an answer shows at once whether it is right; elsewhere it holds the lesson. */
static void test_space_after_answer(void **state) {
    (void)state;
    const Player *player = &opened.app.player;
    const LessonPanel *panel = &opened.app.window.lesson_panel;
    frames();
    assert_at(PLAYER_ASKS, LESSON_ASK);
    assert_false(panel->is_before_verdict);
    assert_true(player_handle_digit(&opened.app, SDL_SCANCODE_2));
    frames();
    assert_int_equal(player->state, PLAYER_RUNS);
    assert_true(panel->is_before_verdict);
    steer("scenes");
    assert_status("Space goes to the answer");
    steer("time");
    assert_at(PLAYER_WAITS, LESSON_EXPLAIN);
    assert_false(panel->is_before_verdict);
    assert_int_equal(player->answers[0], 2);
    steer("time");
    assert_int_equal(player->state, PLAYER_RUNS);
    assert_false(panel->is_before_verdict);
    steer("time");
    assert_int_equal(player->state, PLAYER_WAITS); // Held between two stops.
    steer("time");
    assert_int_equal(player->state, PLAYER_RUNS);
}

/** Lets the lesson run until it stops by itself: its minute of waiting is over at once. */
static void run_to_stop(void) {
    opened.app.player.start_time -= WAIT_SECONDS;
    while (opened.app.player.state == PLAYER_RUNS) {
        frames();
    }
}

/** Space that comes as late as the explanation does not leave it; a little later it does. */
static void test_space_with_explanation(void **state) {
    (void)state;
    frames();
    assert_true(player_handle_digit(&opened.app, SDL_SCANCODE_2));
    run_to_stop();
    assert_at(PLAYER_WAITS, LESSON_EXPLAIN);
    steer("time");
    assert_at(PLAYER_WAITS, LESSON_EXPLAIN);
    SDL_Delay(700);
    steer("time");
    assert_int_equal(opened.app.player.state, PLAYER_RUNS);
}

/** A pixel is marked until its rays are shown; steps back and on at once show the same rays. */
static void test_marked_pixel(void **state) {
    (void)state;
    const RayView *rays = &opened.app.window.ray_view;
    frames();
    for (int turn = 0; turn < 2; turn++) {
        assert_at(PLAYER_ASKS, LESSON_ASK);
        assert_true(rays->is_marked && !rays->is_open && rays->hidden_kinds == 0);
        assert_true(rays->x == 0.25 && rays->y == 0.75);
        steer("time on");
        assert_at(PLAYER_WAITS, LESSON_EXPLAIN);
        assert_true(rays->is_open && !rays->is_marked);
        assert_true(rays->x == 0.25 && rays->y == 0.75);
        assert_int_equal(rays->hidden_kinds, 1U << RAY_SHADOW);
        assert_int_equal(rays->selected, 2);
        assert_int_equal(rays->ray_tree.nodes[rays->selected].kind, RAY_REFLECTION);
        steer("time back");
    }
}

/** A lesson that changes settings: two key presses, a key that is held, an undo. */
static const char SETTINGS[] = "lesson { scene = \"scene.lua\", depth = 0 }\n"
                               "press \"deeper\"\n"
                               "press \"epsilon twice\"\n"
                               "press(\"epsilon twice\", true)\n"
                               "press \"deeper\"\n"
                               "press \"undo\"\n"
                               "press \"undo\"\n"
                               "caption { en = \"One\", wait = true }\n"
                               "press \"redo\"\n"
                               "caption { en = \"Two\", wait = true }\n"
                               "press \"as at first\"\n"
                               "caption { en = \"Three\", wait = true }\n"
                               "press \"deeper\"\n";

/** Opens the window with that lesson, whose depth is not that of the scene alone. @return 0 if it
 *  is open. */
static int set_up_settings(void **state) {
    (void)state;
    if (open_lesson_window(SCENE, SETTINGS) != 0) {
        return -1;
    }
    opened.own_depth = opened.app.window.own_settings.trace.depth = 5;
    return 0;
}

/** A lesson takes settings back as its viewer would: a gesture at once. Once it is over, its
 *  settings stay, and settings as at first are those of the scene alone. */
static void test_settings_of_lesson(void **state) {
    (void)state;
    App *app = &opened.app;
    const RenderSettings first = window_requested_settings(&app->window);
    frames();
    assert_at(PLAYER_WAITS, LESSON_CAPTION);
    RenderSettings present = window_requested_settings(&app->window);
    assert_int_equal(present.trace.depth, first.trace.depth + 1);
    assert_true(present.trace.epsilon == first.trace.epsilon);
    steer("time on");
    present = window_requested_settings(&app->window);
    assert_true(present.trace.epsilon == 4 * first.trace.epsilon);
    steer("time on");
    present = window_requested_settings(&app->window);
    assert_int_equal(present.trace.depth, first.trace.depth);
    steer("time on");
    assert_int_equal(app->player.state, PLAYER_IS_FINISHED);
    player_end(app);
    frames();
    present = window_requested_settings(&app->window);
    assert_int_equal(present.trace.depth, first.trace.depth + 1);
    assert_true(settle());
    current_scene_reload(app); // Later loads have no lesson either.
    assert_true(settle());
    run("as at first");
    assert_true(settle());
    assert_int_equal(app->window.viewports[0].settings.trace.depth, 5);
    run("undo");
    assert_true(settle());
    assert_int_equal(app->window.viewports[0].settings.trace.depth, first.trace.depth + 1);
    run("undo"); // What the lesson has changed can be undone, too.
    assert_true(settle());
    assert_int_equal(app->window.viewports[0].settings.trace.depth, first.trace.depth);
}

/** A lesson says itself what its tools do. */
static void test_tools_in_lesson(void **state) {
    (void)state;
    frames();
    window_end_toast(&opened.app.window);
    run("magnifier");
    frames();
    assert_string_equal(opened.app.window.toast.text, "");
}

/** Once a lesson is closed, the picture says what to press. */
static void test_hint_after_lesson(void **state) {
    (void)state;
    App *app = &opened.app;
    frames();
    while (app->player.state != PLAYER_IS_FINISHED) {
        steer("time on");
    }
    if (!app->window.gui) {
        skip();
    }
    window_end_hint(&app->window);
    frames();
    assert_string_equal(app->window.hint.text, "");
    app->window.lesson_panel.request = (LessonRequest){LESSON_REQUEST_CLOSE, 0};
    frames();
    assert_null(app->player.lesson);
    assert_non_null(strstr(app->window.hint.text, "Help: F1"));
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_space_after_answer, set_up, close_lesson_window),
        cmocka_unit_test_setup_teardown(test_space_with_explanation, set_up, close_lesson_window),
        cmocka_unit_test_setup_teardown(test_marked_pixel, set_up, close_lesson_window),
        cmocka_unit_test_setup_teardown(test_tools_in_lesson, set_up_settings, close_lesson_window),
        cmocka_unit_test_setup_teardown(test_hint_after_lesson, set_up_settings,
                                        close_lesson_window),
        cmocka_unit_test_setup_teardown(test_settings_of_lesson, set_up_settings,
                                        close_lesson_window),
    };
    return cmocka_run_group_tests_name("player", tests, NULL, NULL);
}
