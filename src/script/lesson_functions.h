/**
 * @file
 * @brief The words of lessons.
 */
#ifndef DIOPTRE_SCRIPT_LESSON_FUNCTIONS_H
#define DIOPTRE_SCRIPT_LESSON_FUNCTIONS_H

#include "script/script_run.h"

/** A lesson that is being read. */
struct LessonBuilder {
    Lesson *lesson;             /**< What the text adds to. */
    const ActionNames *actions; /**< What can be done. */
    int64_t time;               /**< When the next step is, milliseconds. */
};

/** What a lesson may say. */
extern const ScriptDialect lesson_dialect;

#endif
