/**
 * @file
 * @brief The file that keeps the answers to the questions of lessons: CSV, a line per answer.
 */
#ifndef DIOPTRE_VIEW_LESSON_ANSWER_FILE_H
#define DIOPTRE_VIEW_LESSON_ANSWER_FILE_H

#include "base/error.h"

#include <stddef.h>

/** An answer. It says nothing about who has given it. */
typedef struct AnswerRecord {
    const char *lesson; /**< Name of the lesson. */
    size_t question;    /**< Number of the question, from 1. */
    int answer;         /**< The choice, from 1. */
    bool is_right;      /**< Whether it is right. */
} AnswerRecord;

/**
 * Opens the file, and writes the names of its columns if it is empty.
 * @param path        The file; created if it does not exist.
 * @param[out] error  What is wrong.
 * @return Whether it can be written.
 */
bool answer_file_prepare(const char *path, Error *error);

/**
 * Appends an answer with the time of now. Several programs may write into one file.
 * @param path        The file.
 * @param record      The answer.
 * @param[out] error  What is wrong.
 * @return Whether the whole line is written.
 */
bool answer_file_append(const char *path, const AnswerRecord *record, Error *error);

#endif
