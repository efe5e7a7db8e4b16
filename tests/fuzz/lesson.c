/**
 * @file
 * @brief Fuzz target: lesson files. What is accepted plays in order, and names known actions only.
 */
#include "shared/script_target.h"

#include "script/lesson_functions.h"

#include <math.h>

/** Some actions of the window; the first two are moves. */
static const char *const names[] = {"camera left", "light up", "home", "accept", NULL};
/** Number of #names. */
enum { NAME_COUNT = sizeof names / sizeof *names - 1, MOVE_COUNT = 2 };

/** Checks that a text of a lesson lies within its memory, and ends there. */
static void check_text(const Lesson *lesson, const char *text) {
    if (text) {
        const char *end = lesson->text + lesson->text_used;
        FUZZ_REQUIRE(text >= lesson->text && text < end);
        FUZZ_REQUIRE(memchr(text, '\0', (size_t)(end - text)));
    }
}

/** Checks the questions of a lesson. */
static void check_questions(const Lesson *lesson) {
    FUZZ_REQUIRE(lesson->question_count <= LESSON_QUESTIONS_MAXIMUM);
    FUZZ_REQUIRE(lesson->learnt_count <= LESSON_LEARNT_MAXIMUM);
    for (size_t i = 0; i < lesson->question_count; i++) {
        const LessonQuestion *question = &lesson->questions[i];
        FUZZ_REQUIRE(question->choice_count >= LESSON_CHOICES_MINIMUM);
        FUZZ_REQUIRE(question->choice_count <= LESSON_CHOICES_MAXIMUM);
        FUZZ_REQUIRE(question->right >= 0 && question->right < question->choice_count);
        FUZZ_REQUIRE(lesson_first_asked(lesson, i) <= i);
        for (int j = 0; j < question->choice_count; j++) {
            check_text(lesson, question->choices[j].english);
            check_text(lesson, question->choices[j].french);
        }
        check_text(lesson, question->because.english);
        check_text(lesson, question->because.french);
    }
}

/** Checks an accepted lesson. */
static void check_lesson(const Lesson *lesson) {
    FUZZ_REQUIRE(memchr(lesson->scene, '\0', sizeof lesson->scene) && lesson->scene[0]);
    FUZZ_REQUIRE(lesson->count <= LESSON_STEPS_MAXIMUM);
    FUZZ_REQUIRE(lesson->text_used <= LESSON_TEXT_MAXIMUM);
    int64_t time = 0;
    for (size_t i = 0; i < lesson->count; i++) {
        const LessonStep *step = &lesson->steps[i];
        bool has_question = step->kind == LESSON_ASK || step->kind == LESSON_EXPLAIN;
        FUZZ_REQUIRE(!has_question || (size_t)step->action < lesson->question_count);
        bool has_action = step->kind == LESSON_PRESS || step->kind == LESSON_RELEASE;
        FUZZ_REQUIRE(step->kind <= LESSON_SNAPSHOT && step->time >= time);
        FUZZ_REQUIRE(!has_action || (step->action >= 0 && step->action < NAME_COUNT));
        FUZZ_REQUIRE(isfinite(step->x) && isfinite(step->y));
        check_text(lesson, step->text.english);
        check_text(lesson, step->text.french);
        time = step->time;
    }
    check_questions(lesson);
    check_text(lesson, lesson->title.english);
    check_text(lesson, lesson->title.french);
    check_text(lesson, lesson->initial_settings.engine);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Error error = {0};
    FuzzRun run;
    Lesson *lesson = lesson_create(&error);
    FUZZ_REQUIRE(lesson);
    if (fuzz_run_init(&run, data, size)) {
        const ActionNames actions = {.names = names, .move_count = MOVE_COUNT};
        LessonBuilder builder = {.lesson = lesson, .actions = &actions};
        run.request.base_dir = "scenes/lessons";
        run.run.dialect = &lesson_dialect;
        run.run.lesson_builder = &builder;
        if (fuzz_run_execute(&run, script_run_execute)) {
            check_lesson(lesson);
        }
    }
    fuzz_run_deinit(&run);
    lesson_destroy(lesson);
    return 0;
}
