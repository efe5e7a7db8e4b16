/**
 * @file
 * @brief Lesson files, from the path to the finished lesson.
 */
#include "dioptre/script.h"
#include "script/lesson_functions.h"
#include "script/sandboxed_run.h"

/**
 * Makes the lesson that a text describes.
 * @param run  What to run, but for its report.
 * @return Whether it is complete.
 */
static bool run_lesson(ScriptRun *run, Error *error) {
    run->result = script_result_create(run->request->path, error);
    bool is_good = run->result && script_run_sandboxed(run, error);
    script_result_destroy(run->result);
    return is_good;
}

Lesson *script_load_lesson(const char *path, const ActionNames *actions, Error *error) {
    const ScriptRequest request = {
        .path = path, .time_limit = SCRIPT_TIME_LIMIT, .memory_limit = SCRIPT_MEMORY_LIMIT};
    ScriptText text;
    if (!script_text_load(path, &text, error)) {
        return NULL;
    }
    LessonBuilder builder = {.lesson = lesson_create(error), .actions = actions};
    ScriptRun run = {
        .request = &request, .dialect = &lesson_dialect, .text = &text, .lesson_builder = &builder};
    if (!builder.lesson || !run_lesson(&run, error)) {
        lesson_destroy(builder.lesson);
        builder.lesson = NULL;
    }
    script_text_deinit(&text);
    return builder.lesson;
}
