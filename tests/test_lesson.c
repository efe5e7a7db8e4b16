/**
 * @file
 * @brief Tests of lessons without a screen: clock, names, texts. tests/lesson.sh contains the
 *        others.
 */
#include "testing.h"

#include "dioptre/lesson.h"
#include "view/commands/commands.h"
#include "view/commands/recorder.h"
#include "view/lesson/player.h"
#include "view/state/clocks.h"

#include <stdlib.h>

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
    assert_true(step_clock_next_tick(&step_clock) == INT64_MAX);
    held_keys_press(&step_clock.held_keys, move("camera up"), step_clock_seconds(&step_clock));
    assert_int_equal(step_clock_next_tick(&step_clock), 112);
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

/** Texts are broken at spaces, by characters and not by bytes. */
static void test_rows(void **state) {
    (void)state;
    char words[] = "été après été\nneu unteilbaresWort x";
    PanelRow rows[8];
    assert_int_equal(word_wrap(words, 9, rows, 8), 5);
    static const char *const expected[] = {"été après", "été", "neu", "unteilbaresWort", "x"};
    for (size_t i = 0; i < 5; i++) {
        assert_string_equal(rows[i].text, expected[i]);
    }
    char more[] = "a b c";
    assert_int_equal(word_wrap(more, 1, rows, 2), 2);
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

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_step_clock),   cmocka_unit_test(test_step_clock_next),
        cmocka_unit_test(test_action_names), cmocka_unit_test(test_rows),
        cmocka_unit_test(test_words),        cmocka_unit_test(test_full),
        cmocka_unit_test(test_text)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
