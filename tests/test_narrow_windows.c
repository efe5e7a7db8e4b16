/**
 * @file
 * @brief What must not end the program, though Dear ImGui does not expect it: panels in windows
 * that are too narrow for them, where a row has no width; a thing that is chosen while the keyboard
 * is the inspector's, but the focus is not.
 */
#include "no_thumbnails.h"
#include "window_texts.h"

/** Widest of the narrow windows, pixels: two thumbnails have room beside each other in it. */
enum { NARROW = 160 };
/** Pixels from one width to the next. */
enum { WIDTH_STEP = 9 };

/** Draws what is open in windows of many small widths, and checks that a wide one has texts again.
 */
static void draw_narrow(Fixture *fixture) {
    static const int heights[] = {1, 211, 700};
    Window *window = &fixture->window;
    const GuiText *texts;
    for (int width = 1; width <= NARROW; width += WIDTH_STEP) {
        for (size_t i = 0; i < COUNT(heights); i++) {
            SDL_SetWindowSize(window->sdl.window, width, heights[i]);
            SDL_PumpEvents();
            window_on_resize(window);
            window_present(window);
        }
    }
    set_size(window, sizes[0][0], sizes[0][1]);
    window_present(window);
    assert_true(gui_texts(window->gui, &texts) > 0);
}

/** The help. */
static void test_help(void **state) {
    Fixture *fixture = *state;
    if (!fixture) {
        skip();
    }
    fixture->window.help.is_open = true;
    draw_narrow(fixture);
    fixture->window.help.is_open = false;
}

/** The list of scenes. */
static void test_list(void **state) {
    static const ViewSettings settings = {.preview = load_nothing};
    Fixture *fixture = *state;
    if (!fixture) {
        skip();
    }
    Browser *browser = &fixture->window.browser;
    assert_true(browser_open(browser, &settings, 0, FIXTURE_SCENE));
    draw_narrow(fixture);
    browser_close(browser);
}

/** Opens the inspector of a shape. @param shape Its index. */
static void open_inspector(Fixture *fixture, size_t shape) {
    const SceneObject object = scene_object_of_shape(fixture->scene, shape);
    fixture->window.object_inspector =
        (ObjectInspector){.keyword = object.keyword, .number = object.origin->number};
}

/** Calls a function while the inspector of the first shape is open. */
static void while_inspecting(Fixture *fixture, void (*function)(Fixture *fixture)) {
    Window *window = &fixture->window;
    EditHistory edits = {0};
    bool is_light_moved[8] = {0};
    window->state.edits = &edits;
    window->state.is_light_moved = is_light_moved;
    open_inspector(fixture, 0);
    function(fixture);
    window->object_inspector = (ObjectInspector){0};
    window->state.edits = NULL;
    window->state.is_light_moved = NULL;
    edit_history_deinit(&edits);
}

/** The inspector of a shape, beside a legend. */
static void test_inspector(void **state) {
    Fixture *fixture = *state;
    if (!fixture) {
        skip();
    }
    fixture->window.viewports[0].report.layer.layer = LAYER_ACNE;
    while_inspecting(fixture, draw_narrow);
    fixture->window.viewports[0].report.layer.layer = LAYER_SHADED;
}

/** Gives the inspector the keyboard, and takes the focus away by a click beside all panels; then
 * another shape is chosen. */
static void choose_another(Fixture *fixture) {
    Window *window = &fixture->window;
    window_present(window);
    assert_true(gui_give_keyboard(window->gui, GUI_INSPECTOR));
    window_present(window);
    const SDL_Event click = {.button = {.type = SDL_MOUSEBUTTONDOWN, .button = SDL_BUTTON_LEFT}};
    gui_handle_event(window->gui, &click);
    window_present(window);
    open_inspector(fixture, 1);
    window_present(window);
    gui_take_keyboard(window->gui);
    window_present(window);
}

/** Another thing is chosen while the keyboard is the inspector's, and the focus is not. */
static void test_lost_focus(void **state) {
    Fixture *fixture = *state;
    if (!fixture) {
        skip();
    }
    while_inspecting(fixture, choose_another);
}

/** Questions and explanations of a lesson, and its end card. */
static void test_lesson(void **state) {
    Fixture *fixture = *state;
    if (!fixture) {
        skip();
    }
    const char *names[VIEW_ACTIONS_MAXIMUM];
    const ActionNames actions = {names, view_actions(names)};
    Error error = {0};
    Lesson *lesson = script_load_lesson("scenes/lessons/03-glass.lua", &actions, &error);
    assert_non_null(lesson);
    int answers[LESSON_QUESTIONS_MAXIMUM] = {0};
    LessonPanel panel = {.lesson = lesson, .answers = answers};
    for (size_t i = 0; i < lesson->count; i++) {
        if (lesson->steps[i].kind == LESSON_ASK) {
            panel.stop = i;
            panel.is_asking = true;
            window_set_lesson_panel(&fixture->window, &panel);
            draw_narrow(fixture);
        }
    }
    panel.is_asking = false;
    panel.is_finished = true;
    window_set_lesson_panel(&fixture->window, &panel);
    draw_narrow(fixture);
    window_set_lesson_panel(&fixture->window, &(LessonPanel){0});
    lesson_destroy(lesson);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_help),      cmocka_unit_test(test_list),
        cmocka_unit_test(test_inspector), cmocka_unit_test(test_lost_focus),
        cmocka_unit_test(test_lesson),
    };
    return cmocka_run_group_tests(tests, open_window, close_window);
}
