/**
 * @file
 * @brief Lesson files, from the path to the finished lesson.
 */
#include "dioptre/script.h"
#include "script/script_worker.h"

/** @return Number of names of actions. */
static int action_count(const ActionNames *actions) {
    int count = 0;
    while (actions->names[count]) {
        count++;
    }
    return count;
}

Lesson *script_load_lesson(const char *path, const ActionNames *actions, Error *error) {
    const ScriptRequest request = {
        .path = path, .time_limit = SCRIPT_TIME_LIMIT, .memory_limit = SCRIPT_MEMORY_LIMIT};
    ScriptText text;
    if (!script_text_load(path, &text, error)) {
        return NULL;
    }
    Lesson *lesson = lesson_create(error);
    const ScriptCall call = {.request = &request,
                             .task = SCRIPT_LESSON_TASK,
                             .text = &text,
                             .actions = actions,
                             .block = lesson,
                             .capacity = sizeof *lesson};
    size_t size = 0;
    if (!lesson || !script_worker_run(&call, &size, error) ||
        !lesson_validate(lesson, size, action_count(actions), error)) {
        lesson_destroy(lesson);
        lesson = NULL;
    }
    script_text_deinit(&text);
    return lesson;
}
