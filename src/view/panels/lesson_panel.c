/**
 * @file
 * @brief The panel of a lesson, and its end card.
 */
#include "view/panels/lesson_panel.h"

#include "base/language.h"
#include "view/gui/gui.h"

#include <libintl.h>
#include <stdio.h>

/** Bytes of a line of the panel with the final zero; a longer one is cut. */
enum { LINE_SIZE = 1024 };

/** @return A text of the lesson in the chosen language. */
static const char *localized(const LessonText *text) {
    return lesson_text_localized(text, language_is_french());
}

/** Requests something. */
static void request(LessonPanel *panel, LessonRequestKind kind, size_t index) {
    panel->request = (LessonRequest){kind, index};
}

bool lesson_panel_lists(const LessonStep *step) {
    return step->kind == LESSON_CAPTION || step->kind == LESSON_ASK;
}

size_t lesson_panel_number(const Lesson *lesson, size_t end) {
    size_t count = 0;
    for (size_t i = 0; i < end && i < lesson->count; i++) {
        count += lesson_panel_lists(&lesson->steps[i]);
    }
    return count;
}

int lesson_panel_score(const Lesson *lesson, const int *answers, int *asked) {
    int right = 0;
    *asked = 0;
    for (size_t i = 0; i < lesson->question_count; i++) {
        *asked += answers[i] > 0;
        right += answers[i] == lesson->questions[i].right + 1;
    }
    return right;
}

/* --- the panel -------------------------------------------------------------------------------- */

/** @return The text of a step of the list. */
static const char *step_text(const Lesson *lesson, const LessonStep *step) {
    return localized(step->kind == LESSON_ASK ? &lesson->questions[step->action].text
                                              : &step->text);
}

/** Shows the list of steps. */
static void show_list(LessonPanel *panel) {
    const Lesson *lesson = panel->lesson;
    char line[LINE_SIZE];
    size_t present = lesson_panel_number(lesson, panel->stop + 1), number = 0;
    snprintf(line, sizeof line, "%zu/%zu \xe2\x96\xbe", panel->stop < lesson->count ? present : 0,
             lesson_panel_number(lesson, lesson->count));
    gui_same_line(line);
    if (!gui_step_list_begin(line, gettext("all steps"))) {
        return;
    }
    for (size_t i = 0; i < lesson->count; i++) {
        const LessonStep *step = &lesson->steps[i];
        if (!lesson_panel_lists(step)) {
            continue;
        }
        number++;
        snprintf(line, sizeof line, "%zu  %s%s", number, step->kind == LESSON_ASK ? "? " : "",
                 step_text(lesson, step));
        if (gui_step_list_entry(i, line, panel->stop < lesson->count && number == present)) {
            request(panel, LESSON_REQUEST_GO_TO, i);
        }
    }
    gui_step_list_end();
}

/** @return Whether it waits for an answer to a question that was asked before: at the end, so that
 *  the class sees what it has learnt. */
static bool is_asked_again(const LessonPanel *panel) {
    const Lesson *lesson = panel->lesson;
    if (!panel->is_asking || panel->stop >= lesson->count) {
        return false;
    }
    size_t question = (size_t)lesson->steps[panel->stop].action;
    return lesson_first_asked(lesson, question) < question;
}

const char *lesson_panel_state(const LessonPanel *panel) {
    return gettext(is_asked_again(panel)      ? N_("Same question: what do you predict now?")
                   : panel->is_asking         ? N_("What do you predict?")
                   : panel->is_waiting        ? N_("go on (Space)")
                   : panel->is_before_verdict ? N_("the answer (Space)")
                                              : N_("hold (Space)"));
}

/** Shows what the lesson waits for. */
static void show_state(LessonPanel *panel) {
    const char *label = lesson_panel_state(panel);
    gui_same_line(label);
    if (panel->is_asking) {
        gui_heading(label);
    } else if (gui_step_button(label, NULL, true, panel->is_waiting || panel->is_before_verdict)) {
        request(panel, LESSON_REQUEST_RESUME, 0);
    }
}

/** Shows the button that leaves the lesson: a question, too, is left by the mouse. */
static void show_leave(LessonPanel *panel) {
    const char *label = gettext("✕ leave");
    gui_same_line(label);
    if (gui_step_button(label, gettext("leave the lesson — Esc"), true, false)) {
        request(panel, LESSON_REQUEST_CLOSE, 0);
    }
}

/** Shows buttons, and the title unless a question needs the room. */
static void show_controls(LessonPanel *panel) {
    static const char back[] = "\xe2\x97\x80", on[] = "\xe2\x96\xb6\xe2\x96\xb6";
    const char *title = localized(&panel->lesson->title);
    if (gui_step_button(back, gettext("the step before"), true, false)) {
        request(panel, LESSON_REQUEST_BACK, 0);
    }
    gui_same_line(on);
    if (gui_step_button(on, gettext("the next step, at once"), true, false)) {
        request(panel, LESSON_REQUEST_ON, 0);
    }
    show_list(panel);
    show_leave(panel);
    show_state(panel);
    if (!panel->is_asking) { // There it would push the answers out of sight.
        gui_same_line(title);
        gui_heading(title);
    }
}

/** Shows the answers to a question. @param is_explained Whether the right one is shown. */
static void show_answers(LessonPanel *panel, const LessonQuestion *question, int answer,
                         bool is_explained) {
    const char *texts[LESSON_CHOICES_MAXIMUM];
    for (int i = 0; i < question->choice_count; i++) {
        texts[i] = localized(&question->choices[i]);
    }
    int clicked = gui_answers(&(GuiAnswers){.texts = texts,
                                            .count = question->choice_count,
                                            .chosen = panel->is_asking ? -1 : answer - 1,
                                            .right = is_explained ? question->right : -1,
                                            .is_open = panel->is_asking});
    if (clicked >= 0) {
        request(panel, LESSON_REQUEST_ANSWER, (size_t)clicked);
    }
}

const char *lesson_panel_verdict(const LessonQuestion *question, int answer) {
    return answer == 0                     ? ""
           : answer == question->right + 1 ? gettext("Right.")
                                           : gettext("Not what you predicted.");
}

/** Shows a question, or what is right and why. */
static void show_question(LessonPanel *panel, const LessonStep *step) {
    const LessonQuestion *question = &panel->lesson->questions[step->action];
    int answer = panel->answers[step->action];
    char line[LINE_SIZE];
    if (step->kind == LESSON_ASK) {
        gui_paragraph(localized(&question->text), GUI_COLOR_TEXT, 1);
    } else {
        const char *verdict = lesson_panel_verdict(question, answer);
        gui_paragraph(localized(&question->text), GUI_COLOR_FAINT, 1);
        snprintf(line, sizeof line, "%s%s%s", verdict, *verdict ? " " : "",
                 localized(&question->because));
        gui_paragraph(line, GUI_COLOR_TEXT, 1);
    }
    show_answers(panel, question, answer, step->kind == LESSON_EXPLAIN);
}

/* --- the end card ----------------------------------------------------------------------------- */

/** Shows the answer to a question. @param when Before it: when it was asked; empty: it was asked
 *  once. */
static void show_answer(const LessonPanel *panel, size_t index, const char *when) {
    const LessonQuestion *question = &panel->lesson->questions[index];
    char line[LINE_SIZE];
    int answer = panel->answers[index];
    bool is_right = answer == question->right + 1;
    snprintf(line, sizeof line, "%s%s%s%s", when, *when ? " " : "",
             answer == 0 ? "\xe2\x80\x93"
             : is_right  ? "\xe2\x9c\x93 "
                         : "\xe2\x9c\x97 ",
             answer > 0 && answer <= question->choice_count
                 ? localized(&question->choices[answer - 1])
                 : "");
    gui_item(line);
}

/** @return The question that asks again what another has asked; that one: there is none. */
static size_t asked_last(const Lesson *lesson, size_t first) {
    size_t last = first;
    for (size_t i = first + 1; i < lesson->question_count; i++) {
        last = lesson_first_asked(lesson, i) == first ? i : last;
    }
    return last;
}

/** Shows a question with what was answered, before and now if it was asked twice, and what is right
 *  unless the last answer was. */
static void show_answered(const LessonPanel *panel, size_t first, size_t last) {
    const LessonQuestion *question = &panel->lesson->questions[last];
    char line[LINE_SIZE];
    gui_paragraph(localized(&question->text), GUI_COLOR_TEXT, 1);
    show_answer(panel, first, first < last ? gettext("before:") : "");
    if (first < last) {
        show_answer(panel, last, gettext("now:"));
    }
    if (panel->answers[last] != question->right + 1) {
        snprintf(line, sizeof line, "%s %s", gettext("right is:"),
                 localized(&question->choices[question->right]));
        gui_item(line);
    }
}

void lesson_panel_write_score(const LessonPanel *panel, char *line, size_t size) {
    int asked = 0, right = lesson_panel_score(panel->lesson, panel->answers, &asked);
    line[0] = '\0';
    if (asked > 0) {
        snprintf(line, size, gettext("predictions right: %d of %d"), right, asked);
    }
}

/** Shows how many predictions were right, and each question with its answers. */
static void show_score(const LessonPanel *panel) {
    char line[LINE_SIZE];
    lesson_panel_write_score(panel, line, sizeof line);
    if (line[0] != '\0') {
        gui_heading(line);
    }
    for (size_t i = 0; i < panel->lesson->question_count; i++) {
        size_t last = asked_last(panel->lesson, i);
        bool is_first = lesson_first_asked(panel->lesson, i) == i;
        if (is_first && (panel->answers[i] > 0 || panel->answers[last] > 0)) {
            show_answered(panel, i, last);
        }
    }
}

LessonRequestKind lesson_panel_card_default(const LessonPanel *panel) {
    return panel->has_next ? LESSON_REQUEST_NEXT : LESSON_REQUEST_AGAIN;
}

/** Shows the buttons of the end card. */
static void show_card_buttons(LessonPanel *panel) {
    const LessonRequestKind usual = lesson_panel_card_default(panel);
    const char *again = gettext("2  again"), *close = gettext("3  close (Esc)");
    if (panel->has_next) {
        if (gui_step_button(gettext("1  next lesson"), NULL, true, usual == LESSON_REQUEST_NEXT)) {
            request(panel, LESSON_REQUEST_NEXT, 0);
        }
        gui_same_line(again);
    }
    if (gui_step_button(again, NULL, true, usual == LESSON_REQUEST_AGAIN)) {
        request(panel, LESSON_REQUEST_AGAIN, 0);
    }
    gui_same_line(close);
    if (gui_step_button(close, NULL, true, false)) {
        request(panel, LESSON_REQUEST_CLOSE, 0);
    }
}

/** Shows the end card. */
static void show_card(LessonPanel *panel) {
    gui_card_begin("end of lesson");
    gui_heading(localized(&panel->lesson->title));
    for (size_t i = 0; i < panel->lesson->learnt_count; i++) {
        gui_item(localized(&panel->lesson->learnt[i]));
    }
    show_score(panel);
    show_card_buttons(panel);
    gui_panel_end();
}

void lesson_panel_show(LessonPanel *panel, const SDL_Rect *rect) {
    const Lesson *lesson = panel->lesson;
    const LessonStep *step = panel->stop < lesson->count ? &lesson->steps[panel->stop] : NULL;
    gui_panel_begin("lesson",
                    &(GuiRect){(float)rect->x, (float)rect->y, (float)rect->w, (float)rect->h});
    if (!panel->is_finished) {
        show_controls(panel);
        if (step && step->kind == LESSON_CAPTION) {
            gui_paragraph(localized(&step->text), GUI_COLOR_TEXT, 1);
        } else if (step) {
            show_question(panel, step);
        }
    }
    gui_panel_end();
    if (panel->is_finished) {
        show_card(panel);
    }
}
