/**
 * @file
 * @brief Lessons as plain data.
 */
#include "dioptre/lesson.h"

#include "dioptre/scene.h"
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
    uintptr_t start = (uintptr_t)lesson->text;
    return !text || ((uintptr_t)text >= start && (uintptr_t)text - start < lesson->text_used);
}

/** @return Whether a flag has one of the bytes of a bool. */
static bool check_flag(const bool *flag) {
    unsigned char byte;
    memcpy(&byte, flag, sizeof byte);
    return byte <= 1;
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
           fabs(settings->time) <= TIME_VALUE_MAXIMUM && check_text(lesson, settings->engine);
}

/** @return Whether the numbers of a step are valid. */
static bool check_numbers(const LessonStep *step) {
    const double numbers[PARAMETER_NUMBERS_MAXIMUM] = {step->x, step->y, step->z};
    const Parameter *row = scene_object_row(step->keyword, step->row);
    if (step->kind == LESSON_SET) {
        return row && step->action > 0 && parameter_check_numbers(row, numbers, NULL);
    }
    bool is_object = step->kind == LESSON_SELECT || step->kind == LESSON_MOVE;
    double maximum = step->kind == LESSON_DRAG || is_object ? LENGTH_MAXIMUM : STEP_VALUE_MAXIMUM;
    return fabs(step->x) <= maximum && fabs(step->y) <= maximum && fabs(step->z) <= maximum &&
           (!is_object || (step->action >= 0 && scene_object_keyword(step->keyword)));
}

/** @return Whether a step is valid. @param time Time of the step before. */
static bool check_step(const Lesson *lesson, const LessonStep *step, int64_t time,
                       int action_count) {
    bool has_action = step->kind == LESSON_PRESS || step->kind == LESSON_RELEASE;
    return step->kind <= LESSON_SNAPSHOT && step->time >= time &&
           (!has_action || (step->action >= 0 && step->action < action_count)) &&
           check_numbers(step) && check_flag(&step->continues) &&
           check_text(lesson, step->text.english) && check_text(lesson, step->text.french) &&
           check_flag(&step->waits_for_viewer);
}

bool lesson_validate(const Lesson *lesson, size_t size, int action_count, Error *error) {
    bool is_valid = size >= offsetof(Lesson, text) && lesson->text_used <= LESSON_TEXT_MAXIMUM &&
                    lesson_block_size(lesson) == size && lesson->count <= LESSON_STEPS_MAXIMUM &&
                    memchr(lesson->scene, '\0', sizeof lesson->scene) &&
                    (lesson->text_used == 0 || lesson->text[lesson->text_used - 1] == '\0') &&
                    check_text(lesson, lesson->title.english) &&
                    check_text(lesson, lesson->title.french) && check_settings(lesson);
    int64_t time = 0;
    for (size_t i = 0; is_valid && i < lesson->count; i++) {
        is_valid = check_step(lesson, &lesson->steps[i], time, action_count);
        time = lesson->steps[i].time;
    }
    return is_valid || error_set(error, STATUS_SCENE, "the lesson is damaged");
}
