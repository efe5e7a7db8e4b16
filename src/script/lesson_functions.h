/**
 * @file
 * @brief Functions of lessons.
 */
#ifndef DIOPTRE_SCRIPT_LESSON_FUNCTIONS_H
#define DIOPTRE_SCRIPT_LESSON_FUNCTIONS_H

#include "script/script_run.h"

/** A lesson being read. */
struct LessonBuilder {
    Lesson *lesson;             /**< The lesson to fill. */
    const ActionNames *actions; /**< Names of all actions. */
    int64_t time;               /**< Time of the next step, milliseconds. */
    bool is_asking;             /**< Whether the last question waits for its explanation. */
};

/** The functions that a lesson may use. */
extern const ScriptDialect lesson_dialect;

#endif
