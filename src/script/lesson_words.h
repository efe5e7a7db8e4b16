/**
 * @file
 * @brief The words of lessons.
 */
#ifndef SCRIPT_LESSON_WORDS_H
#define SCRIPT_LESSON_WORDS_H

#include "script/run.h"

/** A lesson that is being read. */
struct LessonRun {
    Lesson *lesson;             /**< What the text adds to; shared with the parent. */
    const ActionNames *actions; /**< What can be done. */
    int64_t time;               /**< When the next step is, milliseconds. */
};

/** What a lesson may say. */
extern const Vocabulary lesson_vocabulary;

#endif
