/**
 * @file
 * @brief An open window that plays a lesson, without a screen. See app_window.h.
 */
#ifndef DIOPTRE_TESTS_LESSON_WINDOW_H
#define DIOPTRE_TESTS_LESSON_WINDOW_H

#include "app_window.h"

#include "dioptre/view.h"
#include "view/lesson/player.h"

/** The lesson that plays; owned. */
static Lesson *lesson;

/** Opens a window, and begins a lesson in it. @param scene The scene file, scene.lua. @param text
 *  The lesson. @return 0 if it is open. */
static int open_lesson_window(const char *scene, const char *text) {
    const char *names[VIEW_ACTIONS_MAXIMUM];
    const ActionNames actions = {names, view_actions(names)};
    Error error = {0};
    if (open_app_window(scene, "") != 0) {
        return -1;
    }
    lesson = script_load_lesson(write_text("lesson.lua", text), &actions, &error);
    if (!lesson) {
        print_error("%s\n", error.message);
        return -1;
    }
    opened.settings.lesson = lesson;
    opened.settings.lesson_path = opened.path;
    player_begin(&opened.app);
    return 0;
}

/** Ends the lesson and closes the window. @return 0 */
static int close_lesson_window(void **state) {
    player_end(&opened.app);
    lesson_destroy(lesson);
    return close_app_window(state);
}

#endif
