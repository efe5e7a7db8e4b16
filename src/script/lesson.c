/**
 * @file
 * @brief Lesson files, from the path to the finished lesson.
 */
#include "dioptre/script.h"
#include "script/launch.h"
#include "script/lesson_words.h"

/**
 * Makes the lesson that a text describes.
 * @param run         What to run, but for its report.
 * @param[out] error  What is wrong.
 * @return Whether it is complete.
 */
static bool run_lesson(Run *run, Error *error) {
    run->report = report_create(run->request->path, error);
    bool is_good = run->report && launch_run(run, error);
    report_destroy(run->report);
    return is_good;
}

Lesson *script_load_lesson(const char *path, const ActionNames *actions, Error *error) {
    const ScriptRequest request = {
        .path = path, .seconds = SCRIPT_SECONDS, .memory = SCRIPT_MEMORY};
    Source source;
    if (!launch_read(path, &source, error)) {
        return NULL;
    }
    LessonRun lesson = {.lesson = lesson_create(error), .actions = actions};
    Run run = {.request = &request,
               .vocabulary = &lesson_vocabulary,
               .source = &source,
               .lesson = &lesson};
    if (!lesson.lesson || !run_lesson(&run, error)) {
        lesson_destroy(lesson.lesson);
        lesson.lesson = NULL;
    }
    source_release(&source);
    return lesson.lesson;
}
