/**
 * @file
 * @brief Tests of lessons' parts that need no screen: the clock, names, words. The whole is tested
 *        by tests/lesson.sh.
 */
#include "testing.h"

#include "dioptre/lesson.h"
#include "view/action.h"
#include "view/lesson_text.h"
#include "view/metronome.h"
#include "view/rows.h"

#include <stdlib.h>

/** What was moved, in the order in which it was. */
typedef struct Way {
    double camera; /**< A number that depends on every movement and on their order. */
    int count;     /**< How many movements led anywhere. */
} Way;

/** Moves a #Way. See #MetronomeMover. @param context It. @param light See there. @param camera See
 *  there. */
static void move(void *context, Movement light, Movement camera) {
    Way *way = context;
    way->camera = way->camera * 1.1 + camera.right + 0.3 * light.up;
    way->count += movement_is_any(camera) || movement_is_any(light);
}

/**
 * Holds two keys for a while, on a machine of some speed.
 * @param frame  Milliseconds from one look at the clock to the next.
 * @return What it comes to.
 */
static Way hold_two(int64_t frame) {
    Way way = {0};
    Metronome metronome = {.move = move, .context = &way, .motion = {.speed = 1}};
    static const struct {
        int64_t time;
        Action action;
        bool is_press;
    } keys[] = {{33, ACTION_CAMERA_RIGHT, true},
                {48, ACTION_LIGHT_UP, true}, // On a beat.
                {411, ACTION_CAMERA_RIGHT, false},
                {412, ACTION_LIGHT_UP, false}};
    size_t next = 0;
    for (int64_t now = frame; now < 1000 + frame; now += frame) {
        for (; next < 4 && keys[next].time <= now; next++) {
            metronome_go(&metronome, keys[next].time);
            (keys[next].is_press ? motion_press : motion_release)(
                &metronome.motion, keys[next].action, metronome_seconds(&metronome));
        }
        metronome_go(&metronome, now);
    }
    return way;
}

/** Whatever the machine's speed, the same is moved, to the bit. @param state Unused. */
static void test_metronome(void **state) {
    (void)state;
    static const int64_t frames[] = {1, 3, 16, 17, 40, 250, 5000};
    Way exact = hold_two(1);
    assert_true(exact.count > 20);
    for (size_t i = 0; i < sizeof frames / sizeof *frames; i++) {
        Way way = hold_two(frames[i]);
        assert_true(way.camera == exact.camera && way.count == exact.count);
    }
}

/** The clock wakes for beats only while a key is held. @param state Unused. */
static void test_metronome_next(void **state) {
    (void)state;
    Way way = {0};
    Metronome metronome = {.move = move, .context = &way, .motion = {.speed = 1}};
    metronome_go(&metronome, 100);
    assert_true(metronome_next(&metronome) == INT64_MAX);
    motion_press(&metronome.motion, ACTION_CAMERA_UP, metronome_seconds(&metronome));
    assert_int_equal(metronome_next(&metronome), 112);
    assert_int_equal(way.count, 0);
}

/** Every action has a name of its own. @param state Unused. */
static void test_action_names(void **state) {
    (void)state;
    const char *const *names = action_names();
    assert_null(names[ACTION_NONE]);
    for (int i = 0; i < ACTION_NONE; i++) {
        assert_non_null(names[i]);
        for (int j = 0; j < i; j++) {
            assert_string_not_equal(names[i], names[j]);
        }
    }
    assert_string_equal(names[ACTION_LIGHT_LEFT], "light left");
    assert_true(action_is_taught(ACTION_HOME) && !action_is_taught(ACTION_LEAVE));
}

/** Words are cut at blanks, by letters and not by bytes. @param state Unused. */
static void test_rows(void **state) {
    (void)state;
    char words[] = "été après été\nneu unteilbaresWort x";
    PanelRow rows[8];
    assert_int_equal(rows_cut(words, 9, rows, 8), 5);
    static const char *const expected[] = {"été après", "été", "neu", "unteilbaresWort", "x"};
    for (size_t i = 0; i < 5; i++) {
        assert_string_equal(rows[i].text, expected[i]);
    }
    char more[] = "a b c";
    assert_int_equal(rows_cut(more, 1, rows, 2), 2);
}

/** Words are in the language that is wanted, else in the other. @param state Unused. */
static void test_words(void **state) {
    (void)state;
    assert_string_equal(lesson_words(&(LessonText){"one", "un"}, true), "un");
    assert_string_equal(lesson_words(&(LessonText){"one", "un"}, false), "one");
    assert_string_equal(lesson_words(&(LessonText){"one", NULL}, true), "one");
    assert_string_equal(lesson_words(&(LessonText){NULL, "un"}, false), "un");
    assert_string_equal(lesson_words(&(LessonText){0}, true), "");
}

/** A full lesson says so. @param state Unused. */
static void test_full(void **state) {
    (void)state;
    Error error = {0};
    Lesson *lesson = lesson_create(&error);
    char *words = calloc(1, LESSON_TEXT_MAXIMUM);
    assert_non_null(lesson);
    memset(words, 'x', LESSON_TEXT_MAXIMUM - 3);
    assert_non_null(lesson_keep(lesson, words, &error));
    assert_string_equal(lesson_keep(lesson, "y", &error), "y");
    assert_null(lesson_keep(lesson, "", &error));
    const LessonStep step = {.kind = LESSON_SNAPSHOT};
    while (lesson->count < LESSON_STEPS_MAXIMUM) {
        assert_true(lesson_add(lesson, &step, &error));
    }
    assert_false(lesson_add(lesson, &step, &error));
    assert_string_equal(error.message, "a lesson may have at most 65536 steps");
    lesson_destroy(lesson);
    free(words);
}

/** What is recorded can be read by Lua. @param state Unused. */
static void test_text(void **state) {
    (void)state;
    char step[128], *text = NULL;
    size_t size;
    FILE *file = open_memstream(&text, &size);
    lesson_text_wait(file, 0);
    lesson_text_wait(file, 3599999);
    lesson_text_wait(file, 3600017);
    lesson_text_caption(step, sizeof step, "a \"b\" \\ \n1");
    fclose(file);
    assert_string_equal(text, "wait(3599.999)\nwait(3600)\nwait(0.017)\n");
    assert_string_equal(step, "caption { en = \"a \\\"b\\\" \\\\ \\0101\", wait = true }");
    free(text);
}

/** Runs the tests. @return How many failed. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_metronome),    cmocka_unit_test(test_metronome_next),
        cmocka_unit_test(test_action_names), cmocka_unit_test(test_rows),
        cmocka_unit_test(test_words),        cmocka_unit_test(test_full),
        cmocka_unit_test(test_text)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
