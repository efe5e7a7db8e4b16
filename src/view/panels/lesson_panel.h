/**
 * @file
 * @brief The panel of a lesson beside the picture: captions, questions and steps; its end card.
 *
 * Its buttons request what the keys of a lesson do; the player looks at the request.
 */
#ifndef DIOPTRE_VIEW_PANELS_LESSON_PANEL_H
#define DIOPTRE_VIEW_PANELS_LESSON_PANEL_H

#include "dioptre/lesson.h"

#include <SDL.h>
#include <stdbool.h>

/** What a button of the panel requests. */
typedef enum {
    LESSON_REQUEST_NONE,   /**< Nothing. */
    LESSON_REQUEST_BACK,   /**< The step before. */
    LESSON_REQUEST_ON,     /**< The next step, at once. */
    LESSON_REQUEST_RESUME, /**< The lesson goes on. */
    LESSON_REQUEST_GO_TO,  /**< A step. */
    LESSON_REQUEST_ANSWER, /**< An answer is chosen. */
    LESSON_REQUEST_NEXT,   /**< The next lesson. */
    LESSON_REQUEST_AGAIN,  /**< The same lesson from its beginning. */
    LESSON_REQUEST_CLOSE   /**< The lesson is left, or its end card is closed. */
} LessonRequestKind;

/** A request of the panel. */
typedef struct LessonRequest {
    LessonRequestKind kind; /**< What is requested. */
    size_t index;           /**< Index of a step, or of an answer. */
} LessonRequest;

/** The panel. Starts as `{0}`: closed. */
typedef struct LessonPanel {
    const Lesson *lesson;   /**< The lesson; NULL: closed. */
    const int *answers;     /**< Chosen answers, from 1; 0: none. */
    size_t stop;            /**< Index of the step that it shows; #LESSON_STEPS_MAXIMUM: none. */
    bool is_waiting;        /**< Whether the lesson waits for Space. */
    bool is_asking;         /**< Whether it waits for an answer. */
    bool is_before_verdict; /**< Whether it runs, and shows next which answer is right. */
    bool is_finished;       /**< Whether the end card is shown. */
    bool has_next;          /**< Whether there is a next lesson. */
    LessonRequest request;  /**< What a button has requested; the player clears it. */
} LessonPanel;

/** @return Whether a step is shown in the panel's list: a caption or a question. */
bool lesson_panel_lists(const LessonStep *step);

/** Counts the steps in the panel's list before an index. */
size_t lesson_panel_number(const Lesson *lesson, size_t end);

/** Counts the answers that are right. @param[out] asked Number of answered questions. */
int lesson_panel_score(const Lesson *lesson, const int *answers, int *asked);

/** @return What the lesson waits for, in the chosen language. */
const char *lesson_panel_state(const LessonPanel *panel);

/** @return Whether an answer was right, in the chosen language; empty: none was given. @param
 * answer The choice, from 1; 0: none. */
const char *lesson_panel_verdict(const LessonQuestion *question, int answer);

/** Writes how many predictions were right; nothing if none was asked for. */
void lesson_panel_write_score(const LessonPanel *panel, char *line, size_t size);

/** @return What the highlighted button of the end card requests, and Enter. */
LessonRequestKind lesson_panel_card_default(const LessonPanel *panel);

/** Shows the panel in a rectangle of the window, screen units. */
void lesson_panel_show(LessonPanel *panel, const SDL_Rect *rect);

#endif
