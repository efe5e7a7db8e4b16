/**
 * @file
 * @brief Tests of lessons without a screen: clock, names, texts. tests/lesson.sh contains the
 *        others.
 */
#include "fixtures.h"

#include "base/lesson_file.h"
#include "dioptre/lesson.h"
#include "dioptre/scene_override.h"
#include "dioptre/script.h"
#include "dioptre/view.h"
#include "view/commands/commands.h"
#include "view/commands/recorder.h"
#include "view/lesson/action_names.h"
#include "view/panels/lesson_panel.h"
#include "view/state/clocks.h"

#include <limits.h>
#include <stdlib.h>
#include <unistd.h>

/** A log of movements. */
typedef struct MovementLog {
    double checksum; /**< A checksum of all movements and their order. */
    int count;       /**< Number of movements that are not zero. */
} MovementLog;

/** Logs a movement. See #StepClockMoveFn. */
static void log_movement(void *context, Movement light, Movement camera) {
    MovementLog *log = context;
    log->checksum = log->checksum * 1.1 + camera.right + 0.3 * light.up;
    log->count += movement_is_nonzero(camera) || movement_is_nonzero(light);
}

/** @return The movement of a command. */
static Move move(const char *name) {
    return command_find(command_table, name)->move;
}

/**
 * Holds two keys for a while, with a given frame time.
 * @param frame Milliseconds from one update to the next.
 * @return The log.
 */
static MovementLog hold_two_keys(int64_t frame) {
    MovementLog log = {0};
    StepClock step_clock = {.move = log_movement, .context = &log, .held_keys = {.speed = 1}};
    static const struct {
        int64_t time;
        const char *name;
        bool is_press;
    } keys[] = {{33, "camera right", true},
                {48, "light up", true}, // At a tick.
                {411, "camera right", false},
                {412, "light up", false}};
    size_t next = 0;
    for (int64_t now = frame; now < 1000 + frame; now += frame) {
        for (; next < 4 && keys[next].time <= now; next++) {
            step_clock_advance(&step_clock, keys[next].time);
            (keys[next].is_press ? held_keys_press : held_keys_release)(
                &step_clock.held_keys, move(keys[next].name), step_clock_seconds(&step_clock));
        }
        step_clock_advance(&step_clock, now);
    }
    return log;
}

/** The movement is bitwise equal at any frame rate. */
static void test_step_clock(void **state) {
    (void)state;
    static const int64_t frames[] = {1, 3, 16, 17, 40, 250, 5000};
    MovementLog exact = hold_two_keys(1);
    assert_true(exact.count > 20);
    for (size_t i = 0; i < sizeof frames / sizeof *frames; i++) {
        MovementLog log = hold_two_keys(frames[i]);
        assert_true(log.checksum == exact.checksum && log.count == exact.count);
    }
}

/** There is a next tick only while a key is held. */
static void test_step_clock_next(void **state) {
    (void)state;
    MovementLog log = {0};
    StepClock step_clock = {.move = log_movement, .context = &log, .held_keys = {.speed = 1}};
    step_clock_advance(&step_clock, 100);
    assert_true(step_clock_next_due(&step_clock) == INT64_MAX);
    held_keys_press(&step_clock.held_keys, move("camera up"), step_clock_seconds(&step_clock));
    assert_int_equal(step_clock_next_due(&step_clock), 113);
    assert_int_equal(log.count, 0);
}

/** Lessons name commands by an index, moves first. */
static void test_action_names(void **state) {
    (void)state;
    const char *names[VIEW_ACTIONS_MAXIMUM];
    int move_count = view_actions(names), count = 0;
    for (; names[count]; count++) {
        const Command *command = command_of_action(count);
        assert_string_equal(names[count], command->name);
        assert_true(command_is_move(command) == (count < move_count));
    }
    assert_null(command_of_action(count));
    assert_int_equal(move_count, 12);
    assert_string_equal(names[0], "light up");
    assert_false(command_find(command_table, "home")->flags & COMMAND_UNRECORDED);
    assert_true(command_find(command_table, "leave")->flags & COMMAND_UNRECORDED);
}

/** Texts are in the chosen language if available, else in the other. */
static void test_words(void **state) {
    (void)state;
    assert_string_equal(lesson_text_localized(&(LessonText){"one", "un"}, true), "un");
    assert_string_equal(lesson_text_localized(&(LessonText){"one", "un"}, false), "one");
    assert_string_equal(lesson_text_localized(&(LessonText){"one", NULL}, true), "one");
    assert_string_equal(lesson_text_localized(&(LessonText){NULL, "un"}, false), "un");
    assert_string_equal(lesson_text_localized(&(LessonText){0}, true), "");
}

/** A full lesson is reported. */
static void test_full(void **state) {
    (void)state;
    Error error = {0};
    Lesson *lesson = lesson_create(&error);
    char *words = calloc(1, LESSON_TEXT_MAXIMUM);
    assert_non_null(lesson);
    memset(words, 'x', LESSON_TEXT_MAXIMUM - 3);
    assert_non_null(lesson_store_text(lesson, words, &error));
    assert_string_equal(lesson_store_text(lesson, "y", &error), "y");
    assert_null(lesson_store_text(lesson, "", &error));
    const LessonStep step = {.kind = LESSON_SNAPSHOT};
    while (lesson->count < LESSON_STEPS_MAXIMUM) {
        assert_true(lesson_add(lesson, &step, &error));
    }
    assert_false(lesson_add(lesson, &step, &error));
    assert_string_equal(error.message, "a lesson may have at most 65536 steps");
    lesson_destroy(lesson);
    free(words);
}

/** A question asked again is found by its text; answers are counted; a full lesson is reported. */
static void test_questions(void **state) {
    (void)state;
    Error error = {0};
    Lesson *lesson = lesson_create(&error);
    assert_non_null(lesson);
    const LessonQuestion one = {.text = {"One?", "Un ?"}, .choice_count = 2, .right = 1};
    const LessonQuestion two = {.text = {"One?", "Deux ?"}, .choice_count = 3, .right = 0};
    assert_true(lesson_add_question(lesson, &one, 0, &error));
    assert_true(lesson_add_question(lesson, &two, 5, &error));
    assert_true(lesson_add_question(lesson, &one, 7, &error));
    assert_int_equal(lesson_first_asked(lesson, 0), 0);
    assert_int_equal(lesson_first_asked(lesson, 1), 1);
    assert_int_equal(lesson_first_asked(lesson, 2), 0);
    assert_true(lesson->steps[2].kind == LESSON_ASK && lesson->steps[2].action == 2);
    assert_int_equal(lesson->steps[2].time, 7);
    const LessonStep explain = {.kind = LESSON_EXPLAIN, .time = 7, .action = 2};
    assert_true(lesson_add(lesson, &explain, &error));
    assert_int_equal(lesson_panel_number(lesson, lesson->count), 3);
    int asked;
    const int answers[LESSON_QUESTIONS_MAXIMUM] = {2, 2, 0};
    assert_int_equal(lesson_panel_score(lesson, answers, &asked), 1);
    assert_int_equal(asked, 2);
    while (lesson->question_count < LESSON_QUESTIONS_MAXIMUM) {
        assert_true(lesson_add_question(lesson, &one, 7, &error));
    }
    assert_false(lesson_add_question(lesson, &one, 7, &error));
    assert_string_equal(error.message, "a lesson may have at most 64 questions");
    lesson_destroy(lesson);
}

/** A lesson is told from a scene by its text, comments and strings left out. */
static void test_lesson_files(void **state) {
    (void)state;
    static const char *const lessons[] = {
        "lesson { scene = 'a.lua' }", "-- a lesson\nlocal a = 'x'\nlesson\n{ scene = a }",
        "--[[ long ]] lesson(t)", "local s = [==[ ]] ]==] lesson {"};
    static const char *const scenes[] = {"",
                                         "-- lesson { scene = 'a.lua' }",
                                         "--[[ lesson { ]] sphere {}",
                                         "print('lesson { }') sphere {}",
                                         "local t = [[ lesson { ]] box {}",
                                         "lessons { } my_lesson { } lesson = 3",
                                         "'lesson {",
                                         "--[["};
    for (size_t i = 0; i < sizeof lessons / sizeof *lessons; i++) {
        assert_true(lesson_file_is_text(lessons[i]));
    }
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        assert_false(lesson_file_is_text(scenes[i]));
    }
    assert_true(lesson_file_is("scenes/lessons/01-shadows.lua"));
    assert_false(lesson_file_is("scenes/lessons/mirror-and-ball.lua"));
    assert_false(lesson_file_is("scenes/none.lua") || lesson_file_is("scenes"));
    char next[PATH_MAX];
    assert_true(lesson_file_next("scenes/lessons/01-shadows.lua", next));
    assert_string_equal(next, "scenes/lessons/02-mirrors.lua");
    assert_false(lesson_file_next("scenes/lessons/09-costs.lua", next));
}

/** Recorded text is Lua. */
static void test_text(void **state) {
    (void)state;
    char step[128], *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    lesson_writer_wait(file, 0);
    lesson_writer_wait(file, 3599999);
    lesson_writer_wait(file, 3600017);
    lesson_writer_caption(step, sizeof step, "a \"b\" \\ \n1");
    fclose(file);
    assert_string_equal(text, "wait(3599.999)\nwait(3600)\nwait(0.017)\n");
    assert_string_equal(step, "caption { en = \"a \\\"b\\\" \\\\ \\0101\", wait = true }");
    free(text);
}

/** Words of what is done to the window, to rays and to objects, with all that they say. */
static void test_steps(void **state) {
    static const char text[] = "lesson { scene = \"box.lua\" }\n"
                               "size(320, 240.5)\n"
                               "pixel(0.25, 0.75)\n"
                               "ray(2)\n"
                               "mark(0.5, 1)\n"
                               "move(\"sphere\", 3, 0.5, -1, 2)\n"
                               "move(\"sphere\", 3, 0.5, -1, 2, true)\n"
                               "set(\"sphere\", 3, \"radius\", 1.5)\n"
                               "press \"deeper\"\n"
                               "press(\"deeper\", true)\n";
    static const char *const wrong[][2] = {
        {"size(320)", "size(WIDTH, HEIGHT)"},
        {"size(0, 10)", "size must be at least 1"},
        {"ray(-1)", "ray must be at least 0"},
        {"mark(0.5)", "mark(X, Y)"},
        {"mark(1.5, 0)", "mark must be at least 0 and at most 1, not 1.5"},
        {"move(\"spher\", 1, 0, 0, 0)", "there is no object `spher`; did you mean `sphere`?"},
        {"set(\"sphere\", 1, \"radus\", 1)",
         "sphere has no field `radus`; did you mean `radius`?"}};
    const char *names[VIEW_ACTIONS_MAXIMUM];
    const ActionNames actions = {names, view_actions(names)};
    Error error = {0};
    write_file(fixture_path(state, "box.lua"), "camera {}\n", strlen("camera {}\n"));
    const char *path = fixture_path(state, "steps.lua");
    write_file(path, text, strlen(text));
    Lesson *lesson = script_load_lesson(path, &actions, &error);
    if (!lesson) {
        fail_msg("%s", error.message);
    }
    assert_int_equal(lesson->count, 9);
    const LessonStep *steps = lesson->steps;
    assert_int_equal(steps[0].kind, LESSON_SIZE);
    assert_true(steps[0].x == 320 && steps[0].y == 240);
    assert_int_equal(steps[1].kind, LESSON_PIXEL);
    assert_true(steps[1].x == 0.25 && steps[1].y == 0.75);
    assert_int_equal(steps[2].kind, LESSON_RAY);
    assert_int_equal(steps[2].action, 2);
    assert_int_equal(steps[3].kind, LESSON_MARK);
    assert_true(steps[3].x == 0.5 && steps[3].y == 1);
    for (int i = 4; i < 6; i++) {
        assert_int_equal(steps[i].kind, LESSON_MOVE);
        assert_int_equal(steps[i].action, 3);
        assert_int_equal(steps[i].keyword, scene_object_keyword_find("sphere"));
        assert_true(steps[i].x == 0.5 && steps[i].y == -1 && steps[i].z == 2);
        assert_int_equal(steps[i].continues, i == 5);
    }
    assert_int_equal(steps[6].kind, LESSON_SET);
    assert_int_equal(steps[6].row, scene_object_row_find(steps[6].keyword, "radius"));
    assert_true(steps[6].x == 1.5);
    for (int i = 7; i < 9; i++) {
        assert_int_equal(steps[i].kind, LESSON_PRESS);
        assert_int_equal(steps[i].action, steps[7].action);
        assert_int_equal(steps[i].continues, i == 8);
    }
    lesson_destroy(lesson);
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char line[256];
        snprintf(line, sizeof line, "lesson { scene = \"box.lua\" }\n%s\n", wrong[i][0]);
        write_file(path, line, strlen(line));
        assert_null(script_load_lesson(path, &actions, &error));
        if (!strstr(error.message, wrong[i][1]) || !strstr(error.message, "steps.lua:2")) {
            fail_msg("%s: '%s'", wrong[i][0], error.message);
        }
    }
}

/** @return Whether a step before an explanation takes what it explains off the screen. */
static bool hides_answer(const LessonStep *step, const char *const *names, bool *shows_rays) {
    if (step->kind == LESSON_PIXEL) {
        *shows_rays = true;
    }
    if (step->kind != LESSON_PRESS) {
        return false;
    }
    const char *name = names[step->action];
    bool closes_rays = strcmp(name, "rays") == 0 && *shows_rays;
    *shows_rays ^= strcmp(name, "rays") == 0;
    return closes_rays || strcmp(name, "home") == 0 || strcmp(name, "as at first") == 0;
}

/** In all lessons that come with dioptre, what was asked about is on the screen until the answer is
 *  explained. */
static void test_explained_in_view(void **state) {
    (void)state;
    const char *names[VIEW_ACTIONS_MAXIMUM];
    const ActionNames actions = {names, view_actions(names)};
    char path[PATH_MAX] = "scenes/lessons/01-shadows.lua", next[PATH_MAX];
    int explanations = 0;
    bool has_next = true;
    while (has_next) {
        Error error = {0};
        Lesson *lesson = script_load_lesson(path, &actions, &error);
        if (!lesson) {
            fail_msg("%s", error.message);
        }
        bool is_open = false, shows_rays = false;
        for (size_t i = 0; i < lesson->count; i++) {
            const LessonStep *step = &lesson->steps[i];
            bool hides = hides_answer(step, names, &shows_rays);
            if (is_open && hides) {
                fail_msg("%s: step %zu hides what question %d is about", path, i + 1,
                         explanations + 1);
            }
            explanations += step->kind == LESSON_EXPLAIN;
            is_open = step->kind == LESSON_ASK || (is_open && step->kind != LESSON_EXPLAIN);
        }
        lesson_destroy(lesson);
        has_next = lesson_file_next(path, next);
        memcpy(path, next, sizeof path);
    }
    assert_true(explanations >= 36);
}

/** The scene of a recorded lesson is named as seen from its folder. */
static void test_relative_paths(void **state) {
    (void)state;
    static const char *const cases[][3] = {{"/home/a", "/home/a/box.lua", "box.lua"},
                                           {"/home/a", "/home/a/b/box.lua", "b/box.lua"},
                                           {"/home/a/c", "/home/a/b/box.lua", "../b/box.lua"},
                                           {"/home/ab", "/home/a/box.lua", "../a/box.lua"},
                                           {"/home/a", "/home/ab/box.lua", "../ab/box.lua"},
                                           {"/home/a/c/d", "/home/box.lua", "../../../box.lua"},
                                           {"/srv", "/home/box.lua", "/home/box.lua"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char out[64];
        lesson_writer_relative_path(cases[i][0], cases[i][1], out, sizeof out);
        assert_string_equal(out, cases[i][2]);
    }
}

/** A step may name only what the scene has, unless the scene depends on time. */
static void test_objects(void **state) {
    (void)state;
    Error error = {0};
    Scene *scene = create_empty_scene();
    Lesson *lesson = lesson_create(&error);
    const int sphere = scene_object_keyword_find("sphere");
    const LessonStep steps[] = {
        {.kind = LESSON_SELECT, .keyword = sphere},
        {.kind = LESSON_SELECT, .time = 1500, .keyword = sphere, .action = 1}};
    assert_true(lesson_add(lesson, &steps[0], &error)); // Nothing is selected.
    assert_true(lesson_check_scene(lesson, scene, &error));
    assert_true(lesson_add(lesson, &steps[1], &error));
    assert_false(lesson_check_scene(lesson, scene, &error));
    assert_string_equal(error.message, "the step at 1.5 s names `sphere` number 1, which the scene "
                                       "does not have");
    scene->is_time_dependent = true;
    assert_true(lesson_check_scene(lesson, scene, &error));
    lesson_destroy(lesson);
    scene_destroy(scene);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_step_clock),
        cmocka_unit_test(test_step_clock_next),
        cmocka_unit_test(test_action_names),
        cmocka_unit_test(test_words),
        cmocka_unit_test(test_full),
        cmocka_unit_test(test_text),
        cmocka_unit_test(test_questions),
        cmocka_unit_test_setup_teardown(test_steps, fixture_set_up, fixture_tear_down),
        cmocka_unit_test(test_explained_in_view),
        cmocka_unit_test(test_relative_paths),
        cmocka_unit_test(test_objects),
        cmocka_unit_test(test_lesson_files)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
