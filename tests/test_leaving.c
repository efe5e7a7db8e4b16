/**
 * @file
 * @brief Tests of leaving: what lies on top, a lesson, the program; the question before, and how it
 *        goes.
 */
#include "lesson_window.h"

/** A scene with a sphere to change. */
static const char SCENE[] = "camera { position = {0, 0, 6}, look_at = {0, 0, 0} }\n"
                            "light { position = {1, 2, 3} }\n"
                            "sphere { center = {0, 0, 0}, radius = 1 }\n";
/** A lesson: words, a question, words. */
static const char LESSON[] =
    "lesson { scene = \"scene.lua\" }\n"
    "caption { en = \"One\", wait = true }\n"
    "ask { en = \"Two?\", choices = { \"a\", \"b\" }, right = 1, because = \"So.\" }\n"
    "caption { en = \"Three\", wait = true }\n";

/** Opens the window. @return 0 if it is open. */
static int set_up(void **state) {
    (void)state;
    return open_app_window(SCENE, "");
}

/** Opens the window with a lesson. @return 0 if it is open. */
static int set_up_lesson(void **state) {
    (void)state;
    return open_lesson_window(SCENE, LESSON);
}

/** Does what a frame does with the lesson and the status. */
static void frame(void) {
    player_handle_request(&opened.app);
    player_update(&opened.app, clock_now_seconds());
    app_update_status(&opened.app);
}

/** Runs the lesson until it has a state; fails after a minute. */
static void play_until(PlayerState state) {
    const double start = clock_now_seconds();
    while (opened.app.player.state != state) {
        assert_true(settle());
        frame();
        assert_true(clock_now_seconds() - start < 60);
    }
}

/** Requests what the cross of the lesson's panel does. */
static void click_cross(void) {
    opened.app.window.lesson_panel.request = (LessonRequest){LESSON_REQUEST_CLOSE, 0};
    frame();
}

/** Fails unless the status is gone from the title, and its message from the picture. */
static void assert_no_status(void) {
    const App *app = &opened.app;
    assert_string_equal(app->title.status_text, "");
    assert_true(app->window.toast.end_time <= clock_now_seconds());
}

/** Changes the sphere. */
static void change_sphere(void) {
    const int sphere = scene_object_keyword_find("sphere");
    const SceneOverride wider = {sphere, 1, scene_object_row_find(sphere, "radius"), {2}};
    edits_set(&opened.app, &wider, false);
    assert_true(settle());
}

/** Esc closes the settings, opened by a key or by themselves, before anything is left. */
static void test_settings(void **state) {
    (void)state;
    App *app = &opened.app;
    Window *window = &app->window;
    window->toolbar.is_folded = true;
    run("settings");
    assert_true(window->shows_settings);
    run("leave");
    assert_false(window->shows_settings || app->exit.is_requested);
    run("deeper");
    assert_true(window->shows_settings && window->settings_end_time > 0);
    run("leave");
    assert_false(window->shows_settings || app->exit.is_requested);
    assert_true(window->settings_end_time == 0); // It would hide what is opened next.
    run("leave");
    assert_true(app->exit.is_requested);
}

/** A question stays until it is answered; it goes when nothing would be lost any more, and when the
 *  user does something else. */
static void test_question_of_changes(void **state) {
    (void)state;
    App *app = &opened.app;
    change_sphere();
    run("quit");
    frame();
    assert_status("objects were changed");
    run("undo");
    frame();
    assert_no_status();
    assert_true(settle());
    change_sphere();
    run("quit");
    frame();
    assert_status("objects were changed");
    assert_true(isinf(app->window.toast.end_time)); // On the picture, too.
    run("home");
    frame();
    assert_no_status();
    run("quit");
    assert_false(app->exit.is_requested); // It is asked anew.
    assert_status("objects were changed");
    run("quit");
    assert_true(app->exit.is_requested);
}

/** The question of a recording goes with the recording, and is no answer to another one. */
static void test_question_of_recording(void **state) {
    (void)state;
    App *app = &opened.app;
    run("record");
    change_sphere();
    run("quit");
    frame();
    assert_status("a lesson is recorded");
    run("record");
    assert_status("the lesson is in");
    frame();
    assert_status("the lesson is in");
    run("quit");
    assert_false(app->exit.is_requested);
    assert_status("objects were changed");
}

/** The question of a lesson goes with the lesson. */
static void test_question_of_lesson(void **state) {
    (void)state;
    App *app = &opened.app;
    play_until(PLAYER_WAITS);
    run("leave");
    frame();
    assert_status("a lesson plays: leave again");
    assert_true(player_handle_command(app, command_find(command_table, "time"))); // It goes on.
    frame();
    assert_no_status();
    play_until(PLAYER_ASKS);
    run("quit");
    assert_status("a lesson plays: leave again");
    assert_true(player_handle_digit(app, SDL_SCANCODE_2)); // An answer, but to the lesson's.
    frame();
    assert_no_status();
    assert_non_null(app->player.lesson);
    run("quit");
    assert_status("a lesson plays: leave again");
    run("leave");
    frame();
    assert_null(app->player.lesson);
    assert_no_status();
    assert_false(app->exit.is_requested);
}

/** What a lesson cannot do now is said for as long as it is so. */
static void test_refusals(void **state) {
    (void)state;
    App *app = &opened.app;
    const Command *scenes = command_find(command_table, "scenes");
    play_until(PLAYER_WAITS);
    assert_true(player_handle_command(app, scenes));
    assert_status("Space goes on");
    frame();
    assert_status("Space goes on");
    assert_true(player_handle_command(app, command_find(command_table, "time")));
    play_until(PLAYER_ASKS);
    assert_no_status();
    assert_true(player_handle_command(app, scenes));
    assert_status("click your answer, or press its number");
    assert_true(player_handle_digit(app, SDL_SCANCODE_2));
    frame();
    assert_no_status();
}

/** The cross of its panel leaves a lesson: at once where nothing is lost, else when clicked twice.
 */
static void test_cross(void **state) {
    (void)state;
    App *app = &opened.app;
    play_until(PLAYER_WAITS);
    click_cross();
    assert_null(app->player.lesson);
    player_begin(app);
    play_until(PLAYER_WAITS);
    assert_true(player_handle_command(app, command_find(command_table, "time on")));
    play_until(PLAYER_ASKS);
    click_cross();
    assert_non_null(app->player.lesson);
    assert_status("a lesson plays: leave again");
    click_cross();
    assert_null(app->player.lesson);
    assert_no_status();
    assert_false(app->exit.is_requested);
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_settings, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_question_of_changes, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_question_of_recording, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_question_of_lesson, set_up_lesson,
                                        close_lesson_window),
        cmocka_unit_test_setup_teardown(test_refusals, set_up_lesson, close_lesson_window),
        cmocka_unit_test_setup_teardown(test_cross, set_up_lesson, close_lesson_window),
    };
    return cmocka_run_group_tests_name("leaving", tests, NULL, NULL);
}
