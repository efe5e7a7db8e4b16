/**
 * @file
 * @brief Lessons as plain data.
 */
#include "dioptre/lesson.h"

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
