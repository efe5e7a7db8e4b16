/**
 * @file
 * @brief What lies over the picture or in its place, in both languages, in small and large windows:
 *        rays, a lesson, the inspector, the magnifier, the chart, a presentation.
 */
#define FIXTURE_SCENE "scenes/glass-sphere.lua"
#include "window_texts.h"

#include "fontconfig_leak.h"

#include "dioptre/script.h"
#include "dioptre/view.h"

/** Seconds that the first picture may take. */
static const double PICTURE_SECONDS = 60;

/** Runs the window's loop once. */
static void update(Fixture *fixture) {
    Window *window = &fixture->window;
    Error error = {0};
    SDL_Event event;
    assert_true(window_update(window, fixture->scene, clock_now_seconds(), &error));
    while (SDL_PollEvent(&event)) {
        if (event.type == window->pass_event) {
            window_on_pass(window, &event);
        }
    }
}

/** Runs the window until a picture of its size is on screen. */
static void wait_for_picture(Fixture *fixture) {
    Viewport *viewport = &fixture->window.viewports[0];
    double end = clock_now_seconds() + PICTURE_SECONDS;
    SDL_Rect picture = window_picture_rect(&fixture->window);
    window_invalidate(&fixture->window);
    do {
        update(fixture);
        SDL_Delay(1);
    } while ((viewport->awaits_first_frame || viewport->texture.width != picture.w) &&
             clock_now_seconds() < end);
    assert_int_equal(viewport->texture.width, picture.w);
}

/** @return A text of the last frame that begins with some words; NULL: there is none. */
static const GuiText *find_text(const Fixture *fixture, const char *words) {
    const GuiText *texts;
    const size_t count = gui_texts(fixture->window.gui, &texts);
    for (size_t i = 0; i < count; i++) {
        if (strncmp(texts[i].text, words, strlen(words)) == 0) {
            return &texts[i];
        }
    }
    return NULL;
}

/** Checks that the formulas of a chosen ray are seen from their heading on, below a row of buttons
 *  that stays where it was. */
static void check_chosen(const Fixture *fixture, size_t ray) {
    static GuiRect first;
    char heading[64];
    snprintf(heading, sizeof heading, gettext("Ray %zu: %s"), ray, "");
    const GuiText *title = find_text(fixture, heading),
                  *button = find_text(fixture, gettext("next ray"));
    assert_non_null(title);
    assert_non_null(button);
    assert_true(title->rect.y + ROUNDING >= title->clip.y);
    if (ray == 0) {
        first = button->rect;
    }
    assert_true(button->rect.x == first.x && button->rect.y == first.y);
    assert_true(button->rect.y + button->rect.height <= title->rect.y);
}

/** Notes each text of a list of which a line is seen in part. */
static void check_whole_lines(Fixture *fixture, const char *what) {
    const GuiText *texts;
    const size_t count = gui_texts(fixture->window.gui, &texts);
    for (size_t i = 0; i < count; i++) {
        const GuiText *text = &texts[i];
        const float lines = seen(text).height / text->size;
        if (text->scrolls && lines > 0 && fabsf(lines - roundf(lines)) * text->size > ROUNDING) {
            fault(fixture, what, "%g lines of '%s' are seen", (double)lines, text->text);
        }
    }
}

/** Checks the view of rays: each drawing beside it, some rays of it. */
static void check_rays(Fixture *fixture) {
    static const char *const panes[] = {"rays", "rays and plan", "rays and march",
                                        "rays and microscope"};
    RayView *rays = &fixture->window.ray_view;
    wait_for_picture(fixture);
    for (RayPane pane = RAY_PANE_NONE; pane < RAY_PANE_COUNT; pane++) {
        ray_view_pick(rays, 0.45, 0.5);
        rays->pane = pane;
        for (size_t ray = 0; ray < 3; ray++) {
            ray_view_choose_ray(rays, ray);
            update(fixture);
            assert_true(rays->ray_tree.count > 4);
            check_frame(fixture, panes[pane], 8);
            check_chosen(fixture, ray);
            check_whole_lines(fixture, panes[pane]);
        }
    }
    ray_view_reset(rays);
}

/** @return A lesson. */
static Lesson *load_lesson(void) {
    const char *names[VIEW_ACTIONS_MAXIMUM];
    const ActionNames actions = {names, view_actions(names)};
    Error error = {0};
    Lesson *lesson = script_load_lesson("scenes/lessons/03-glass.lua", &actions, &error);
    assert_non_null(lesson);
    return lesson;
}

/** Checks the steps of a lesson: captions, questions, what is right and why; its end card. */
static void check_lesson_panel(Fixture *fixture) {
    Lesson *lesson = load_lesson();
    int answers[LESSON_QUESTIONS_MAXIMUM] = {0};
    int before[2], after[2];
    SDL_GetWindowSize(fixture->window.sdl.window, &before[0], &before[1]);
    LessonPanel panel = {.lesson = lesson, .answers = answers};
    for (size_t i = 0; i < lesson->count; i++) {
        panel.stop = i;
        panel.is_waiting = lesson->steps[i].kind == LESSON_CAPTION;
        panel.is_asking = lesson->steps[i].kind == LESSON_ASK;
        if (lesson->steps[i].kind == LESSON_EXPLAIN) {
            answers[lesson->steps[i].action] = 1;
        }
        if (lesson_panel_lists(&lesson->steps[i]) || lesson->steps[i].kind == LESSON_EXPLAIN) {
            window_set_lesson_panel(&fixture->window, &panel);
            check_frame(fixture, "lesson", 4);
            assert_non_null(find_text(fixture, gettext("✕ leave"))); // By the mouse, too.
        }
    }
    for (size_t i = 0; i < lesson->question_count; i++) {
        answers[i] = 1 + (int)i % 2;
    }
    panel.is_finished = panel.has_next = true;
    window_set_lesson_panel(&fixture->window, &panel);
    check_frame(fixture, "end card", 5);
    for (size_t i = 0; i < lesson->question_count; i++) {
        const char *question =
            lesson_text_localized(&lesson->questions[i].text, language_is_french());
        char words[GUI_RECORD_SIZE];
        SDL_strlcpy(words, question, sizeof words);
        assert_non_null(find_text(fixture, words)); // Each is told, with its answer.
    }
    window_set_lesson_panel(&fixture->window, &(LessonPanel){0});
    SDL_GetWindowSize(fixture->window.sdl.window, &after[0], &after[1]);
    assert_memory_equal(before, after, sizeof before); // A class would see it jump.
    lesson_destroy(lesson);
}

/** Checks the inspector of each shape and light of the scene. */
static void check_inspector(Fixture *fixture) {
    Window *window = &fixture->window;
    EditHistory edits = {0};
    bool is_light_moved[8] = {0};
    window->state.edits = &edits;
    window->state.is_light_moved = is_light_moved;
    for (int i = 0; i < (int)(fixture->scene->shape_count + fixture->scene->light_count); i++) {
        size_t shapes = fixture->scene->shape_count, index = (size_t)i;
        if (index > 0 && index < shapes &&
            fixture->scene->shapes[index].class_index ==
                fixture->scene->shapes[index - 1].class_index) {
            continue;
        }
        SceneObject object = index < shapes ? scene_object_of_shape(fixture->scene, index)
                                            : scene_object_of_light(fixture->scene, index - shapes);
        window->object_inspector = (ObjectInspector){
            .keyword = object.keyword, .number = object.origin->number, .has_pixel = true};
        check_frame(fixture, "inspector", 8);
    }
    window->object_inspector = (ObjectInspector){0};
    edit_history_deinit(&edits);
}

/** Checks that the inspector lies beside what was clicked, and the chart beside the inspector. */
static void check_places(Fixture *fixture) {
    Window *window = &fixture->window;
    EditHistory edits = {0};
    bool is_light_moved[8] = {0};
    const SceneObject object = scene_object_of_shape(fixture->scene, 0);
    const SDL_Rect picture = window_to_units(window, window_picture_rect(window));
    static const double clicks[] = {0.9, 0.1, 0.95, 0.05};
    int width = 0;
    SDL_GetWindowSize(window->sdl.window, &width, NULL);
    window->state.edits = &edits;
    window->state.is_light_moved = is_light_moved;
    for (size_t i = 0; i < sizeof clicks / sizeof *clicks; i++) {
        window->ray_view.x = clicks[i];
        window->ray_view.y = 0.5;
        window->object_inspector = (ObjectInspector){
            .keyword = object.keyword, .number = object.origin->number, .has_pixel = true};
        window_present(window);
        window_present(window);
        GuiRect rect = gui_inspector_rect();
        float clicked = (float)(picture.x + clicks[i] * picture.w);
        bool is_clear = clicked < rect.x || clicked > rect.x + rect.width;
        if (!is_clear && 2 * rect.width < (float)width) {
            fault(fixture, "inspector", "it lies from %g on a click at %g", (double)rect.x,
                  (double)clicked);
        }
    }
    window->object_inspector = (ObjectInspector){0};
    edit_history_deinit(&edits);
}

/** Checks the magnifier in all corners of the picture. */
static void check_magnifier(Fixture *fixture) {
    Window *window = &fixture->window;
    wait_for_picture(fixture);
    magnifier_toggle(&window->magnifier);
    for (int corner = 0; corner < 4; corner++) {
        PixelPosition mouse = {corner % 2 ? window->viewports[0].width - 1 : 0,
                               corner / 2 ? window->viewports[0].height - 1 : 0};
        window->magnifier.pixel = mouse;
        window->magnifier.has_place = true;
        check_frame(fixture, "magnifier", 1);
    }
    magnifier_toggle(&window->magnifier);
}

/** Checks the chart with some points. */
static void check_chart(Fixture *fixture) {
    SettingsChartPanel *panel = &fixture->window.settings_chart;
    panel->is_open = true;
    panel->has_failed = true; // Nothing is measured behind the test's back.
    Error error = {0};
    const RenderSettings settings[] = {
        {.engine = engine_find("f32x4", &error), .samples = 16, .trace = {.depth = 3}},
        {.engine = engine_find("f64x1", &error),
         .samples = 16,
         .trace = {.depth = 8, .offset = OFFSET_BOUND}},
        {.engine = engine_find("f128x1", &error),
         .samples = 128,
         .trace = {.depth = 8, .offset = OFFSET_BOUND}}};
    settings_chart_add(&panel->chart, &settings[0], 0.0123, 4.5);
    settings_chart_add(&panel->chart, &settings[1], 0.0321, 0.00125);
    settings_chart_add(&panel->chart, &settings[2], 12.5, 0);
    check_frame(fixture, "chart", 5);
    panel->is_open = false;
}

/** Checks a presentation: large letters, the name of a layer. */
static void check_presentation(Fixture *fixture) {
    Window *window = &fixture->window;
    wait_for_picture(fixture);
    window_toggle_presentation(window);
    window_set_layer(window, LAYER_NORMALS);
    window_set_toast(window, "saved glass-sphere-1.bmp");
    window->shows_settings = true;
    window_invalidate_text(window);
    check_frame(fixture, "presentation", 4);
    window->shows_settings = false;
    window->layer_name.text[0] = window->toast.text[0] = '\0';
    window_set_layer(window, LAYER_SHADED);
    window_toggle_presentation(window);
}

/** @return The height of the window. */
static int height_of(const Fixture *fixture) {
    int height = 0;
    SDL_GetWindowSize(fixture->window.sdl.window, NULL, &height);
    return height;
}

/** Checks that a toolbar that is hidden and shown again gives the window its size back, to the
 *  unit: alone, in a lesson, around a presentation. */
static void check_toolbar_changes(Fixture *fixture) {
    Window *window = &fixture->window;
    Lesson *lesson = load_lesson();
    int answers[LESSON_QUESTIONS_MAXIMUM] = {0};
    const LessonPanel panel = {.lesson = lesson, .answers = answers};
    const int tall = height_of(fixture);
    assert_false(window->toolbar.is_folded);
    for (int is_lesson = 0; is_lesson < 2; is_lesson++) {
        window_set_lesson_panel(window, is_lesson ? &panel : &(LessonPanel){0});
        window_toggle_toolbar(window);
        assert_true(window->toolbar.is_folded);
        window_toggle_toolbar(window);
        assert_int_equal(height_of(fixture), tall);
    }
    window_set_lesson_panel(window, &(LessonPanel){0});
    lesson_destroy(lesson);
    window_toggle_toolbar(window);
    const int low = height_of(fixture);
    assert_true(low < tall);
    window_toggle_presentation(window);
    assert_int_equal(height_of(fixture), low); // It has no toolbar either.
    window_toggle_presentation(window);
    assert_false(window->toolbar.is_folded);
    assert_int_equal(height_of(fixture), tall);
}

/** The rays of a pixel of glass. */
static void test_rays(void **state) {
    in_all_windows(state, check_rays);
}

/** A lesson. */
static void test_lesson_panel(void **state) {
    in_all_windows(state, check_lesson_panel);
}

/** The inspector. */
static void test_inspector(void **state) {
    in_all_windows(state, check_inspector);
    in_all_windows(state, check_places);
}

/** The magnifier. */
static void test_magnifier(void **state) {
    in_all_windows(state, check_magnifier);
}

/** The chart. */
static void test_chart(void **state) {
    in_all_windows(state, check_chart);
}

/** A presentation. */
static void test_presentation(void **state) {
    in_all_windows(state, check_presentation);
}

/** The toolbar is hidden and shown. */
static void test_toolbar_changes(void **state) {
    if (!*state) {
        skip();
    }
    set_size(&((Fixture *)*state)->window, 800, 600);
    check_toolbar_changes(*state);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_toolbar_changes), cmocka_unit_test(test_rays),
        cmocka_unit_test(test_lesson_panel),    cmocka_unit_test(test_inspector),
        cmocka_unit_test(test_magnifier),       cmocka_unit_test(test_chart),
        cmocka_unit_test(test_presentation),
    };
    return cmocka_run_group_tests(tests, open_window, close_window);
}
