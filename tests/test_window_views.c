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
#include "render/renderer_internal.h"

#include <math.h>

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
            // Letters are 1/30 of what is below the toolbar: its words are for the last row of a
            // class.
            assert_true(30 * window_text_size(&fixture->window) >=
                        (float)before[1] - fixture->window.toolbar.height);
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
    window->object_inspector = (ObjectInspector){.lists = true};
    check_frame(fixture, "all things", 8);
    window->object_inspector = (ObjectInspector){.lists = true, .is_camera = true};
    check_frame(fixture, "camera", 8);
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
    assert_int_equal(window->light_marks.count, 0);
    window_toggle_presentation(window);
    assert_int_equal(height_of(fixture), low); // It has no toolbar either.
    assert_int_equal(window->light_marks.count, 0);
    window_toggle_presentation(window);
    assert_true(window->toolbar.is_folded); // As it was.
    assert_int_equal(height_of(fixture), low);
    window_toggle_toolbar(window);
    assert_int_equal(height_of(fixture), tall);
    for (int is_by_toolbar = 0; is_by_toolbar < 2; is_by_toolbar++) {
        window_toggle_presentation(window);
        assert_true(window->is_presenting && window->toolbar.is_folded);
        assert_true(window->light_marks.count > 0); // Who shows a class a light wants to see it.
        if (is_by_toolbar) {
            window_toggle_toolbar(window); // Who wants it wants no presentation.
        } else {
            window_toggle_presentation(window);
        }
        assert_false(window->is_presenting || window->toolbar.is_folded);
        assert_int_equal(height_of(fixture), tall);
    }
}

/* --- the bar ---------------------------------------------------------------------------------- */

/** Buttons of the bar whose words stay, in English. */
static const char *const fixed_buttons[] = {"scenes", "costs", "chart", "magnifier", "photo"};

/** Finds where the buttons of the bar lie whose words stay. */
static void find_buttons(Fixture *fixture, GuiRect places[COUNT(fixed_buttons)]) {
    window_present(&fixture->window);
    window_present(&fixture->window);
    for (size_t i = 0; i < COUNT(fixed_buttons); i++) {
        const GuiText *text = find_text(fixture, gettext(fixed_buttons[i]));
        assert_non_null(text);
        places[i] = text->rect;
    }
}

/** Checks that no button of the bar has moved. @param what What has changed. */
static void check_buttons(Fixture *fixture, const char *what,
                          const GuiRect before[COUNT(fixed_buttons)]) {
    GuiRect after[COUNT(fixed_buttons)];
    find_buttons(fixture, after);
    for (size_t i = 0; i < COUNT(fixed_buttons); i++) {
        if (before[i].x != after[i].x || before[i].y != after[i].y) {
            fault(fixture, what, "'%s' goes from %g %g to %g %g", fixed_buttons[i],
                  (double)before[i].x, (double)before[i].y, (double)after[i].x, (double)after[i].y);
        }
    }
}

/** Checks that the buttons of the bar stay where they are, whatever its values are. */
static void check_still_bar(Fixture *fixture) {
    static const int numbers[] = {1, 2, 9, 16, 17, 128, 1000, 1024};
    Window *window = &fixture->window;
    const RenderSettings settings = window->base_settings;
    const WindowState state = window->state;
    GuiRect places[COUNT(fixed_buttons)];
    if (window->toolbar.is_folded) {
        return; // A window that is too small for it.
    }
    window->state.is_animated = true;
    find_buttons(fixture, places);
    window->state.is_running = true;
    check_buttons(fixture, "running", places);
    window->state.can_undo = window->state.can_redo = window->state.is_playing = true;
    check_buttons(fixture, "played", places);
    for (size_t i = 0; i < COUNT(numbers); i++) {
        window->base_settings.samples = numbers[i];
        window->base_settings.trace.depth = SDL_min(numbers[i], KEY_DEPTH_MAXIMUM);
        window->base_settings.trace.epsilon = pow(10, -(double)i * 2);
        window->base_settings.trace.offset = (OffsetStrategy)(i % (OFFSET_BOUND + 1));
        window->base_settings.lighting = (LightingMode)(i % LIGHTING_MODE_COUNT);
        window->viewports[0].layer = (Layer)(i % LAYER_COUNT);
        check_buttons(fixture, "values", places);
    }
    window->viewports[0].layer = LAYER_SHADED;
    window->base_settings = settings;
    window->state = state;
}

/** @return Whether a picture of the window takes seconds, and shows no more than a small one. */
static bool is_large(const Window *window) {
    return window_picture_rect(window).w > 1000;
}

/* --- one pixel -------------------------------------------------------------------------------- */

/** Rays that were traced for a pixel. */
static int traced;

/** Counts the rays of pixels. See #Engine.trace_primary. */
static void count_primary(const Tracer *tracer, const PixelGrid *grid, int *shapes,
                          double *distances) {
    traced++;
    engine_find("auto", NULL)->trace_primary(tracer, grid, shapes, distances);
}

/** Checks that a frame traces one ray for the pixel that it names, and that what it says of it lies
 *  neither on that pixel nor on the picture's edge there. */
static void check_readout(Fixture *fixture) {
    Window *window = &fixture->window;
    const Readout *readout = &window->readout;
    if (is_large(window)) {
        return;
    }
    wait_for_picture(fixture);
    Renderer *renderer = window->viewports[0].renderer;
    const Engine *engine = renderer->settings.engine;
    static Engine counting;
    counting = *engine;
    counting.trace_primary = count_primary;
    renderer->settings.engine = &counting;
    magnifier_toggle(&window->magnifier);
    window->magnifier.has_place = true;
    for (double start = clock_now_seconds();
         !readout->is_read && clock_now_seconds() - start < PICTURE_SECONDS;) {
        update(fixture); // The whole first pass.
        window_present(window);
    }
    const int width = window->viewports[0].width, height = window->viewports[0].height;
    for (int place = 0; place < 9; place++) {
        window->magnifier.pixel =
            (PixelPosition){place % 3 * (width - 1) / 2, place / 3 * (height - 1) / 2};
        traced = 0;
        window_present(window);
        assert_int_equal(traced, 1);
        check_frame(fixture, "readout", 1);
        assert_true(readout->is_shown);
        const GuiPoint point = window_pixel_place(window, &window->magnifier.pixel);
        const GuiRect *rect = &readout->rect;
        const bool is_below = place / 3 == 2 && place % 3 == 0;
        if (point.x >= rect->x && point.x < rect->x + rect->width && point.y >= rect->y &&
            point.y < rect->y + rect->height) {
            fault(fixture, "readout", "it lies on the pixel %g %g", (double)point.x,
                  (double)point.y);
        }
        if (place / 3 < 2 ? readout->is_above : is_below && !readout->is_above) {
            fault(fixture, "readout", "at %g %g it lies at the wrong edge", (double)point.x,
                  (double)point.y);
        }
    }
    // Nor on the pixel that a lesson marks, at the lower edge.
    window->magnifier.pixel = (PixelPosition){width / 2, height / 2};
    ray_view_mark(&window->ray_view, 0, 1 - 0.5 / height);
    window_present(window);
    assert_true(readout->is_above);
    ray_view_mark(&window->ray_view, 0, 0);
    window_present(window);
    assert_false(readout->is_above);
    window->ray_view.is_marked = window->ray_view.has_pixel = false;
    magnifier_toggle(&window->magnifier);
    renderer->settings.engine = engine;
}

/** Number of names of lamps that #check_lamp_names has found. */
static int lamp_names;

/** Checks that the name of a lamp right of the picture lies left of the arrow to it. */
static void check_lamp_names(Fixture *fixture) {
    Window *window = &fixture->window;
    char name[GUI_RECORD_SIZE];
    wait_for_picture(fixture);
    window_present(window);
    snprintf(name, sizeof name, gettext("lamp %d"), 2);
    const GuiText *text = find_text(fixture, name);
    if (text) {
        const SDL_Rect picture = window_to_units(window, window_picture_rect(window));
        // The arrow's tip is 0.3 letters from the edge, its base 1.2 from the tip; it is a little
        // aslant.
        const float base = (float)(picture.x + picture.w) - 1.4F * window_text_size(window);
        assert_true(text->rect.x + text->rect.width <= base);
        lamp_names++;
    }
}

/** Checks that the legends of two pictures side by side leave most of each to be seen. */
static void check_two_legends(Fixture *fixture) {
    Window *window = &fixture->window;
    Error error = {0};
    if (is_large(window)) {
        return;
    }
    window->split.mode = SPLIT_BAR;
    assert_true(window_update_renderers(window, fixture->scene, &error));
    assert_int_equal(window_viewport_count(window), 2);
    wait_for_picture(fixture);
    const GuiRect area = window_area_units(window);
    for (int layer = 1; layer < LAYER_COUNT; layer++) {
        for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
            RenderStats *report = &window->viewports[i].report;
            report->layer = (LayerStats){.layer = (Layer)layer,
                                         .pixel_count = 480000,
                                         .artifact_pixels = 17000,
                                         .leak_pixels = 17000,
                                         .reference = "f64x4"};
            report->is_finished = true;
        }
        check_frame(fixture, layer_name((Layer)layer), area.width >= 640 ? 4 : 2);
        const GuiRect *left = &window->legend_rects[0], *right = &window->legend_rects[1];
        assert_true(left->x + left->width <= right->x + ROUNDING);
        for (size_t i = 0; i < WINDOW_VIEWPORTS && area.width >= 640; i++) {
            const GuiRect *rect = &window->legend_rects[i];
            const bool has_names = layer == LAYER_SHAPES; // Narrow, they may be too high.
            if (rect->height <= 0 || (rect->width > 0.3F * area.width && !has_names)) {
                fault(fixture, layer_name((Layer)layer), "legend %zu is %g wide, of %g", i,
                      (double)rect->width, (double)area.width);
            }
        }
    }
    window->split.mode = SPLIT_NONE;
    assert_true(window_update_renderers(window, fixture->scene, &error));
}

/* --- where the rays are ----------------------------------------------------------------------- */

/** @return The area of a rectangle that lies in another one; fails if it does not. */
static int part_of(const SDL_Rect *rect, const SDL_Rect *area) {
    SDL_Rect both;
    assert_true(rect->w == 0 || rect->h == 0 ||
                (SDL_IntersectRect(rect, area, &both) && both.w == rect->w && both.h == rect->h));
    return rect->w * rect->h;
}

/** The parts of the view of rays fill it without a gap, whatever its shape and that of the picture
 *  are; a picture of the view's own shape leaves no room beside itself. */
static void test_ray_layout(void **state) {
    static const int shapes[][2] = {{640, 480},   {800, 600}, {1280, 800}, {1920, 1080},
                                    {1819, 1023}, {600, 900}, {3000, 500}, {333, 333}};
    (void)state;
    for (size_t i = 0; i < COUNT(shapes) * COUNT(shapes) * 2; i++) {
        const int *size = shapes[i / 2 % COUNT(shapes)], *picture = shapes[i / 2 / COUNT(shapes)];
        const SDL_Rect area = {10, 20, size[0], size[1]};
        const RayView rays = {.width = picture[0],
                              .height = picture[1],
                              .pane = i % 2 ? RAY_PANE_PLAN : RAY_PANE_NONE};
        const RayViewLayout layout = ray_view_layout(&rays, &area);
        const SDL_Rect *const parts[] = {&layout.buttons, &layout.formulas, &layout.view,
                                         &layout.pane,    &layout.list,     &layout.inset_room};
        int covered = 0;
        for (size_t part = 0; part < COUNT(parts); part++) {
            covered += part_of(parts[part], &area);
            for (size_t other = 0; other < part; other++) {
                assert_false(SDL_HasIntersection(parts[part], parts[other]));
            }
        }
        assert_int_equal(covered, area.w * area.h);
        part_of(&layout.inset, &layout.inset_room);
        if (size == picture) {
            assert_int_equal(layout.inset.w, layout.inset_room.w);
            assert_int_equal(layout.inset.h, layout.inset_room.h);
        }
        assert_true(layout.view.w >= area.w / 4 && layout.list.w >= 3 * area.w / 10);
    }
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

/** The bar, whose values change. */
static void test_still_bar(void **state) {
    in_all_windows(state, check_still_bar);
}

/** What a pixel shows. */
static void test_readout(void **state) {
    in_all_windows(state, check_readout);
}

/** Beside the panel of a lesson, its lines end where the panel begins. */
static void test_readout_beside_lesson(void **state) {
    Fixture *fixture = *state;
    if (!fixture) {
        skip();
    }
    Window *window = &fixture->window;
    const Readout *readout = &window->readout;
    Lesson *lesson = load_lesson();
    int answers[LESSON_QUESTIONS_MAXIMUM] = {0};
    set_size(window, 1000, 480);
    window_set_lesson_panel(window, &(LessonPanel){.lesson = lesson, .answers = answers});
    wait_for_picture(fixture);
    magnifier_toggle(&window->magnifier);
    window->magnifier.has_place = true;
    window->magnifier.pixel =
        (PixelPosition){window->viewports[0].width / 2, window->viewports[0].height / 2};
    for (double start = clock_now_seconds();
         !readout->is_read && clock_now_seconds() - start < PICTURE_SECONDS;) {
        update(fixture); // The whole first pass.
        window_present(window);
    }
    const GuiRect area = window_area_units(window);
    int width = 0;
    SDL_GetWindowSize(window->sdl.window, &width, NULL);
    assert_true(readout->is_shown && area.width < (float)width);
    assert_true(readout->rect.x + readout->rect.width <= area.x + area.width);
    magnifier_toggle(&window->magnifier);
    window_set_lesson_panel(window, &(LessonPanel){0});
    lesson_destroy(lesson);
    set_size(window, sizes[0][0], sizes[0][1]);
}

/** The names of lamps outside the picture. */
static void test_lamp_names(void **state) {
    lamp_names = 0;
    in_all_windows(state, check_lamp_names);
    assert_true(lamp_names > 2);
}

/** The legends of two pictures. */
static void test_two_legends(void **state) {
    in_all_windows(state, check_two_legends);
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

/** Checks that letters and bar of a window agree after some frames, and stay as they are. */
static void check_settled(Fixture *fixture, int width, int height) {
    /** Frames in which they settle, and frames in which they must not change. */
    enum { SETTLING = 16, SETTLED = 6 };
    Window *window = &fixture->window;
    SDL_SetWindowSize(window->sdl.window, width, height);
    SDL_PumpEvents();
    window_on_resize(window);
    window->toolbar.is_folded = false;
    for (int i = 0; i < SETTLING; i++) {
        window_present(window);
    }
    const SDL_Rect picture = window_picture_rect(window);
    const float letters = window_text_size(window);
    for (int i = 0; i < SETTLED; i++) {
        window_present(window);
        const SDL_Rect now = window_picture_rect(window);
        assert_memory_equal(&now, &picture, sizeof picture);
        assert_true(window_text_size(window) == letters);
    }
}

/** In no size of the window do bar and picture change for ever. */
static void test_settling(void **state) {
    Fixture *fixture = *state;
    if (!fixture) {
        skip();
    }
    for (int language = 0; language < 2; language++) {
        language_toggle();
        for (int height = 500; height <= 900; height += 61) {
            for (int width = 780; width <= 1500; width += 80) {
                check_settled(fixture, width, height);
            }
        }
    }
    set_size(&fixture->window, sizes[0][0], sizes[0][1]);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_toolbar_changes), cmocka_unit_test(test_rays),
        cmocka_unit_test(test_lesson_panel),    cmocka_unit_test(test_inspector),
        cmocka_unit_test(test_magnifier),       cmocka_unit_test(test_chart),
        cmocka_unit_test(test_presentation),    cmocka_unit_test(test_ray_layout),
        cmocka_unit_test(test_still_bar),       cmocka_unit_test(test_readout),
        cmocka_unit_test(test_two_legends),     cmocka_unit_test(test_lamp_names),
        cmocka_unit_test(test_settling),        cmocka_unit_test(test_readout_beside_lesson),
    };
    return cmocka_run_group_tests(tests, open_window, close_window);
}
