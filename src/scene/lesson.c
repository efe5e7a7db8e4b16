/**
 * @file
 * @brief Lessons as plain data.
 */
#include "dioptre/lesson.h"

#include "base/untrusted.h"
#include "dioptre/scene_override.h"

#include <string.h>
#include <sys/mman.h>

Lesson *lesson_create(Error *error) {
    return lesson_create_at(NULL, error);
}

size_t lesson_block_size(const Lesson *lesson) {
    return offsetof(Lesson, text) + lesson->text_used;
}

Lesson *lesson_create_at(void *address, Error *error) {
    int placement = address ? MAP_FIXED_NOREPLACE : 0;
    Lesson *lesson = mmap(address, sizeof *lesson, PROT_READ | PROT_WRITE,
                          MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | placement, -1, 0);
    if (lesson != MAP_FAILED && address && lesson != address) { // Linux before 4.17.
        munmap(lesson, sizeof *lesson);
        lesson = MAP_FAILED;
    }
    if (lesson == MAP_FAILED) {
        error_set(error, STATUS_FAILED, "no memory for a lesson");
        return NULL;
    }
    lesson->initial_settings = (LessonSettings){.depth = -1, .offset = -1, .epsilon = -1};
    return lesson;
}

/** @return Whether a scene has what a step names: an object or a light. */
static bool check_step_in_scene(const LessonStep *step, const Scene *scene, Error *error) {
    SceneObject object;
    bool is_object =
        step->kind == LESSON_SELECT || step->kind == LESSON_SET || step->kind == LESSON_MOVE;
    if (is_object && step->action > 0 &&
        !scene_object_find(scene, step->keyword, step->action, &object)) {
        return error_set(error, STATUS_SCENE, "`%s` number %d, which the scene does not have",
                         scene_object_keyword(step->keyword)->name, step->action);
    }
    if (step->kind == LESSON_DRAG && (size_t)step->action >= scene->light_count) {
        return error_set(error, STATUS_SCENE, "light number %d, which the scene does not have",
                         step->action + 1);
    }
    return true;
}

bool lesson_check_scene(const Lesson *lesson, const Scene *scene, Error *error) {
    // At other times such a scene may have other objects.
    for (size_t i = 0; i < lesson->count && !scene->is_time_dependent; i++) {
        const LessonStep *step = &lesson->steps[i];
        if (!check_step_in_scene(step, scene, error)) {
            return error_prefix(error, "the step at %g s names ",
                                (double)step->time / MILLISECONDS_PER_SECOND);
        }
    }
    return true;
}

void lesson_destroy(Lesson *lesson) {
    if (lesson) {
        munmap(lesson, sizeof *lesson);
    }
}

bool lesson_add(Lesson *lesson, const LessonStep *step, Error *error) {
    if (lesson->count == LESSON_STEPS_MAXIMUM) {
        return error_set(error, STATUS_SCENE, "a lesson may have at most %d steps",
                         LESSON_STEPS_MAXIMUM);
    }
    lesson->steps[lesson->count++] = *step;
    return true;
}

bool lesson_add_question(Lesson *lesson, const LessonQuestion *question, int64_t time,
                         Error *error) {
    LessonStep step = {.kind = LESSON_ASK, .time = time, .action = (int)lesson->question_count};
    if (lesson->question_count == LESSON_QUESTIONS_MAXIMUM) {
        return error_set(error, STATUS_SCENE, "a lesson may have at most %d questions",
                         LESSON_QUESTIONS_MAXIMUM);
    }
    lesson->questions[lesson->question_count++] = *question;
    return lesson_add(lesson, &step, error);
}

/** @return Whether two texts are equal, or both missing. */
static bool is_same_text(const char *a, const char *b) {
    return a && b ? strcmp(a, b) == 0 : a == b;
}

size_t lesson_first_asked(const Lesson *lesson, size_t question) {
    const LessonText *text = &lesson->questions[question].text;
    size_t first = 0;
    while (first < question &&
           !(is_same_text(lesson->questions[first].text.english, text->english) &&
             is_same_text(lesson->questions[first].text.french, text->french))) {
        first++;
    }
    return first;
}

const char *lesson_store_text(Lesson *lesson, const char *text, Error *error) {
    size_t size = strlen(text) + 1;
    if (size > LESSON_TEXT_MAXIMUM - lesson->text_used) {
        error_set(error, STATUS_SCENE, "the words of a lesson may take at most %d bytes",
                  LESSON_TEXT_MAXIMUM);
        return NULL;
    }
    char *copy = lesson->text + lesson->text_used;
    memcpy(copy, text, size);
    lesson->text_used += size;
    return copy;
}

const char *lesson_text_localized(const LessonText *text, bool is_french) {
    const char *wanted = is_french ? text->french : text->english;
    const char *other = wanted ? wanted : text->english ? text->english : text->french;
    return other ? other : "";
}

/* --- lessons of another process --------------------------------------------------------------- */

/** Largest absolute number of a step: degrees, pixels, notches, factors. */
#define STEP_VALUE_MAXIMUM 1e6
/** Largest time of the scene of a lesson, seconds. */
#define TIME_VALUE_MAXIMUM 1e15

/** @return Whether a text is NULL, or lies in the texts of a lesson, the last of which ends. */
static bool check_text(const Lesson *lesson, const char *text) {
    return !text || untrusted_lies_in(lesson->text, lesson->text_used, text, 1);
}

/** @return Whether a text in the languages of the program is valid. See #check_text. */
static bool check_texts(const Lesson *lesson, const LessonText *text) {
    return check_text(lesson, text->english) && check_text(lesson, text->french);
}

/** @return Whether a number of the settings is unset or in range. */
static bool check_setting(int value, int unset, int maximum) {
    return value >= unset && value <= maximum;
}

/** @return Whether the settings of a lesson are valid. */
static bool check_settings(const Lesson *lesson) {
    const LessonSettings *settings = &lesson->initial_settings;
    return check_setting(settings->samples, 0, SAMPLES_MAXIMUM) &&
           check_setting(settings->depth, -1, DEPTH_MAXIMUM) &&
           check_setting(settings->offset, -1, OFFSET_BOUND) &&
           check_setting(settings->width, 0, IMAGE_SIZE_MAXIMUM) &&
           check_setting(settings->height, 0, IMAGE_SIZE_MAXIMUM) &&
           fabs(settings->epsilon) <= LENGTH_MAXIMUM &&
           fabs(settings->time) <= TIME_VALUE_MAXIMUM && settings->move_speed >= 0 &&
           settings->move_speed <= LENGTH_MAXIMUM && check_text(lesson, settings->engine);
}

/** @return Whether a question is valid. */
static bool check_question(const Lesson *lesson, const LessonQuestion *question) {
    int count = question->choice_count;
    bool is_valid = count >= LESSON_CHOICES_MINIMUM && count <= LESSON_CHOICES_MAXIMUM &&
                    question->right >= 0 && question->right < count &&
                    check_texts(lesson, &question->text) && check_texts(lesson, &question->because);
    for (int i = 0; is_valid && i < count; i++) {
        is_valid = check_texts(lesson, &question->choices[i]);
    }
    return is_valid;
}

/** @return Whether the questions of a lesson, and the sentences about it, are valid. */
static bool check_questions(const Lesson *lesson) {
    bool is_valid = lesson->question_count <= LESSON_QUESTIONS_MAXIMUM &&
                    lesson->learnt_count <= LESSON_LEARNT_MAXIMUM;
    for (size_t i = 0; is_valid && i < lesson->question_count; i++) {
        is_valid = check_question(lesson, &lesson->questions[i]);
    }
    for (size_t i = 0; is_valid && i < lesson->learnt_count; i++) {
        is_valid = check_texts(lesson, &lesson->learnt[i]);
    }
    return is_valid;
}

/** A step of this kind names nothing by its action. */
static const size_t NO_ACTION = SIZE_MAX;

/** @return Number of things of which a step of a kind names one by its action; or #NO_ACTION. */
static size_t action_count_of(const Lesson *lesson, LessonStepKind kind, int command_count) {
    switch (kind) {
    case LESSON_PRESS:
    case LESSON_RELEASE:
        return (size_t)command_count;
    case LESSON_DRAG:
        return LESSON_LIGHTS_MAXIMUM;
    case LESSON_RAY:
        return LESSON_RAYS_MAXIMUM;
    case LESSON_ASK:
    case LESSON_EXPLAIN:
        return lesson->question_count;
    default:
        return NO_ACTION;
    }
}

/** @return Whether the action of a step is one of those that its kind may name. */
static bool check_action(const Lesson *lesson, const LessonStep *step, int command_count) {
    size_t count = action_count_of(lesson, step->kind, command_count);
    return count == NO_ACTION || (step->action >= 0 && (size_t)step->action < count);
}

/** @return Whether the numbers of a step are valid. */
static bool check_numbers(const LessonStep *step) {
    const double numbers[PARAMETER_NUMBERS_MAXIMUM] = {step->x, step->y, step->z};
    const Parameter *row = scene_object_row(step->keyword, step->row);
    if (step->kind == LESSON_SET) {
        return row && step->action > 0 && parameter_check_numbers(row, numbers, NULL);
    }
    bool is_object = step->kind == LESSON_SELECT || step->kind == LESSON_MOVE;
    bool is_length = step->kind == LESSON_DRAG || step->kind == LESSON_PAN || is_object;
    double maximum = is_length ? LENGTH_MAXIMUM : STEP_VALUE_MAXIMUM;
    for (int i = 0; i < 3; i++) {
        if (!(fabs(step->center[i]) <= LENGTH_MAXIMUM)) {
            return false;
        }
    }
    return fabs(step->x) <= maximum && fabs(step->y) <= maximum && fabs(step->z) <= maximum &&
           (!is_object || (step->action >= 0 && scene_object_keyword(step->keyword)));
}

/** @return Whether a step is valid. @param time Time of the step before. */
static bool check_step(const Lesson *lesson, const LessonStep *step, int64_t time,
                       int action_count) {
    return step->kind <= LESSON_SNAPSHOT && step->time >= time &&
           check_action(lesson, step, action_count) && check_numbers(step) &&
           untrusted_is_bool(&step->continues) && check_texts(lesson, &step->text) &&
           untrusted_is_bool(&step->waits_for_viewer);
}

bool lesson_validate(const Lesson *lesson, size_t size, int action_count, Error *error) {
    bool is_valid = size >= offsetof(Lesson, text) && lesson->text_used <= LESSON_TEXT_MAXIMUM &&
                    lesson_block_size(lesson) == size && lesson->count <= LESSON_STEPS_MAXIMUM &&
                    memchr(lesson->scene, '\0', sizeof lesson->scene) &&
                    (lesson->text_used == 0 || lesson->text[lesson->text_used - 1] == '\0') &&
                    check_texts(lesson, &lesson->title) && check_settings(lesson) &&
                    check_questions(lesson);
    int64_t time = 0;
    for (size_t i = 0; is_valid && i < lesson->count; i++) {
        is_valid = check_step(lesson, &lesson->steps[i], time, action_count);
        time = lesson->steps[i].time;
    }
    return is_valid || error_set(error, STATUS_SCENE, "the lesson is damaged");
}
