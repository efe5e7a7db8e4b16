/**
 * @file
 * @brief What the panel of a lesson says, as text: the page gives it to readers of screens, for
 * whom the window is a picture.
 */
#include "base/language.h"
#include "view/panels/lesson_panel.h"
#include "view/window.h"

#include <emscripten.h>
#include <libintl.h>
#include <stdio.h>
#include <stdlib.h>

/** Bytes of the line of the score with the final zero. */
enum { SCORE_SIZE = 128 };

/** Writes a text of the lesson as a line. */
static void write_line(FILE *out, const LessonText *text) {
    fprintf(out, "%s\n", lesson_text_localized(text, language_is_french()));
}

/** Writes a question with its choices; once it is explained, whether the answer was right, and why.
 */
static void write_question(FILE *out, const LessonPanel *panel, const LessonStep *step) {
    const LessonQuestion *question = &panel->lesson->questions[step->action];
    write_line(out, &question->text);
    for (int i = 0; i < question->choice_count; i++) {
        fprintf(out, "%d: ", i + 1);
        write_line(out, &question->choices[i]);
    }
    if (step->kind == LESSON_EXPLAIN) {
        fprintf(out, "%s %d. ", lesson_panel_verdict(question, panel->answers[step->action]),
                question->right + 1);
        write_line(out, &question->because);
    }
}

/** Writes the end card. */
static void write_card(FILE *out, const LessonPanel *panel) {
    char score[SCORE_SIZE];
    for (size_t i = 0; i < panel->lesson->learnt_count; i++) {
        write_line(out, &panel->lesson->learnt[i]);
    }
    lesson_panel_write_score(panel, score, sizeof score);
    if (score[0] != '\0') {
        fprintf(out, "%s\n", score);
    }
    if (panel->has_next) {
        fprintf(out, "%s\n", gettext("1  next lesson"));
    }
    fprintf(out, "%s\n%s\n", gettext("2  again"), gettext("3  close (Esc)"));
}

/** Writes what the panel says. @return The text, to be freed; empty: no lesson plays. NULL without
 *  memory. */
static char *panel_text(const LessonPanel *panel) {
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out) {
        return NULL;
    }
    if (panel->lesson) {
        const Lesson *lesson = panel->lesson;
        const LessonStep *step = panel->stop < lesson->count ? &lesson->steps[panel->stop] : NULL;
        write_line(out, &lesson->title);
        if (panel->is_finished) {
            write_card(out, panel);
        } else if (step && step->kind == LESSON_CAPTION) {
            write_line(out, &step->text);
        } else if (step) {
            write_question(out, panel, step);
        }
        if (panel->is_asking || panel->is_waiting) {
            fprintf(out, "%s\n", lesson_panel_state(panel));
        }
    }
    fclose(out);
    return text;
}

/** The window's own function. */
void __real_window_set_lesson_panel(Window *window, const LessonPanel *panel);

/** Shows another state of the lesson, and tells the page. See #window_set_lesson_panel. */
void __wrap_window_set_lesson_panel(Window *window, const LessonPanel *panel) {
    __real_window_set_lesson_panel(window, panel);
    char *text = panel_text(panel);
    MAIN_THREAD_EM_ASM({ Module['onLesson'] && Module['onLesson'](UTF8ToString($0)); },
                       text ? text : "");
    free(text);
}
