/**
 * @file
 * @brief What the list says of a scene or a lesson: read from its file's text, which is not run.
 */
#ifndef DIOPTRE_VIEW_LOADING_SCENE_TITLE_H
#define DIOPTRE_VIEW_LOADING_SCENE_TITLE_H

#include <stdbool.h>
#include <stddef.h>

/** Bytes of a title with the final zero; a longer one is cut. */
enum { SCENE_TITLE_SIZE = 256 };

/**
 * Reads the title of a scene: its line `-- en: ...` or `-- fr: ...`, else the first sentence of the
 * comment at its beginning; or the title of a lesson.
 * @param path        The file; only a regular one is read.
 * @param is_lesson   Whether it is a lesson.
 * @param is_french   Whether French is wanted; English stands in for it.
 * @param[out] title  The title; empty: there is none.
 */
void scene_title_read(const char *path, bool is_lesson, bool is_french,
                      char title[SCENE_TITLE_SIZE]);

/** What a lesson is about, as far as its file says it without being run. */
typedef struct LessonSummary {
    int steps;                          /**< Its captions and questions: lines that begin so. */
    int questions;                      /**< Its questions. */
    char first_words[SCENE_TITLE_SIZE]; /**< First sentence of its first caption; empty: none. */
} LessonSummary;

/** Reads what a lesson is about. @param path Its file. @param is_french Whether French is wanted;
 *  English stands in for it. */
void scene_title_read_summary(const char *path, bool is_french, LessonSummary *summary);

/**
 * Reads the name of a scene for readers: its line `-- fr name: ...` or `-- en name: ...`.
 * @param path       The file; only a regular one of moderate size is read.
 * @param is_french  Whether French is wanted.
 * @param[out] name  The name, cut to its size; unchanged where the file has none.
 * @param size       Bytes of the name with the final zero.
 */
void scene_title_read_name(const char *path, bool is_french, char *name, size_t size);

#endif
