/**
 * @file
 * @brief Tests of the window's commands, as keys and buttons run them: what each changes, in the
 * settings, in the picture, in what lies over it.
 */
#include "app_window.h"
#include "no_thumbnails.h"

#include "view/commands/recorder.h"
#include "view/gui/typeface.h"

/** A scene with two lights, glass, a mirror and a field that is marched to. */
static const char SCENE[] =
    "camera { position = {0, 0, 6}, look_at = {0, 0, 0} }\n"
    "light { position = {1, 2, 3} }\n"
    "light { position = {-1, 2, 3} }\n"
    "sphere { center = {0, 0, 0}, radius = 1, material = material { reflectivity = 0.5 } }\n"
    "sdf { (distance.sphere { radius = 0.5 }):translate { 2, 0, 0 } }\n";

/** Opens the window, which has its widgets after the first picture. @return 0 if it is open. */
static int set_up(void **state) {
    (void)state;
    return open_app_window(SCENE, "");
}

/** Runs a command, and waits for the picture. */
static void run_and_settle(const char *name) {
    run(name);
    assert_true(settle());
}

/** @return The settings that are asked for. */
static RenderSettings requested(void) {
    return window_requested_settings(&opened.app.window);
}

/** Runs the window until something is so; fails after a minute. */
#define until(condition)                                                                           \
    do {                                                                                           \
        double start_ = clock_now_seconds();                                                       \
        while (!(condition)) {                                                                     \
            settle();                                                                              \
            assert_true(clock_now_seconds() - start_ < 60);                                        \
        }                                                                                          \
    } while (0)

/** A scene that is opened begins with its own settings: what was changed for the one before, and
 * what was opened for it, is gone. A scene that is loaded again keeps all. */
static void test_other_scene(void **state) {
    (void)state;
    App *app = &opened.app;
    Window *window = &app->window;
    const RenderSettings first = requested();
    char path[PATH_MAX];
    static const char *const commands[] = {"offset",        "deeper",    "split",
                                           "layer normals", "magnifier", "chart"};
    for (size_t i = 0; i < COUNT(commands); i++) {
        run_and_settle(commands[i]);
    }
    current_scene_reload(app);
    assert_true(settle());
    assert_int_equal(window->viewports[0].settings.trace.depth, first.trace.depth + 1);
    assert_true(window->magnifier.is_on && window->settings_chart.is_open);
    assert_int_equal(window_viewport_count(window), 2);
    assert_int_equal(window_active_viewport(window)->layer, LAYER_NORMALS);
    run_and_settle("rays");
    strcpy(path, write_text("other.lua", "camera {}\n"));
    current_scene_open(app, path);
    assert_true(settle());
    RenderSettings other = window->viewports[0].settings;
    assert_true(other.trace.offset == first.trace.offset && other.trace.depth == first.trace.depth);
    assert_true(requested().trace.depth == first.trace.depth);
    assert_int_equal(window_viewport_count(window), 1);
    assert_int_equal(window->viewports[0].layer, LAYER_SHADED);
    assert_false(window->magnifier.is_on || window->settings_chart.is_open ||
                 window->ray_view.is_open || window->shows_settings);
}

/** Settings change by steps, there and back; all are reset at once. */
static void test_settings(void **state) {
    (void)state;
    const RenderSettings first = requested();
    static const char *const pairs[][2] = {
        {"offset", "offset back"},         {"engine", "engine back"},
        {"light mode", "light mode back"}, {"deeper", "less deep"},
        {"samples twice", "samples half"}, {"methods", "methods back"},
        {"epsilon half", "epsilon twice"}, {"epsilon ten times", "epsilon tenth"},
        {"pixel corners", "pixel corners"}};
    for (size_t i = 0; i < COUNT(pairs); i++) {
        run_and_settle(pairs[i][0]);
        RenderSettings changed = requested();
        bool is_changed = changed.engine != first.engine || changed.samples != first.samples ||
                          changed.lighting != first.lighting ||
                          changed.trace.depth != first.trace.depth ||
                          changed.trace.offset != first.trace.offset ||
                          changed.trace.epsilon != first.trace.epsilon ||
                          changed.trace.pixel_point != first.trace.pixel_point;
        if (!is_changed) {
            fail_msg("%s changes nothing", pairs[i][0]);
        }
        run_and_settle(pairs[i][1]);
        run("as at first");
        assert_true(settle());
        changed = requested();
        assert_ptr_equal(changed.engine, first.engine);
        assert_int_equal(changed.samples, first.samples);
        assert_int_equal(changed.trace.depth, first.trace.depth);
        assert_true(changed.trace.epsilon == first.trace.epsilon);
    }
    run("deeper");
    assert_int_equal(requested().trace.depth, first.trace.depth + 1);
    run("samples twice");
    assert_int_equal(requested().samples, 2 * first.samples);
    run("pixel corners");
    assert_status("rays go ");
}

/** @return Whether what is chosen of the pictures is another than before. */
static bool is_other_than(const PictureChoice *before) {
    const PictureChoice now = window_choice(&opened.app.window);
    return !picture_choice_is_same(before, &now, &opened.app.window.base_settings);
}

/** Each command that changes settings, layer or pictures is taken back by one undo, and done again.
 */
static void test_undo_choices(void **state) {
    (void)state;
    const PictureChoice first = window_choice(&opened.app.window);
    for (const Command *row = command_table; command_is_row(row); row++) {
        if (!(row->flags & COMMAND_CHOICE) || command_is(row, "as at first") ||
            command_is(row, "layer light")) { // They are so already.
            continue;
        }
        run_and_settle(row->name);
        const PictureChoice then = window_choice(&opened.app.window);
        if (!is_other_than(&first)) {
            // One sample is the fewest.
            assert_string_equal(row->name, "samples half");
            continue;
        }
        run_and_settle("undo");
        if (is_other_than(&first)) {
            fail_msg("%s is not undone", row->name);
        }
        assert_string_equal(opened.app.title.status_text, ""); // It named the setting of before.
        run_and_settle("redo");
        assert_false(is_other_than(&then));
        run("as at first");
        assert_false(is_other_than(&first));
        run_and_settle("undo");
        assert_false(is_other_than(&then));
        run_and_settle("as at first");
    }
}

/** What a held key or a slider changes is one step; key presses are one each; a second picture and
 *  the one that keys change come back, too. */
static void test_undo_gesture(void **state) {
    (void)state;
    App *app = &opened.app;
    const RenderSettings first = requested();
    const Command *twice = command_find(command_table, "epsilon twice");
    for (int gesture = 0; gesture < 2; gesture++) {
        command_issue(app, twice, clock_now_seconds());
        command_continue(app, twice, clock_now_seconds());
        command_continue(app, twice, clock_now_seconds());
    }
    assert_true(requested().trace.epsilon == 64 * first.trace.epsilon);
    run_and_settle("undo");
    assert_true(requested().trace.epsilon == 8 * first.trace.epsilon);
    run_and_settle("undo");
    assert_true(requested().trace.epsilon == first.trace.epsilon);
    assert_int_equal(requested().trace.offset, first.trace.offset);
    run("deeper");
    run("deeper");
    run_and_settle("undo");
    assert_int_equal(requested().trace.depth, first.trace.depth + 1);
    run_and_settle("split");
    run_and_settle("samples twice"); // Of the right picture.
    run("other side");
    run_and_settle("undo");
    assert_int_equal(app->window.split.active, 1);
    assert_int_equal(requested().samples, first.samples);
    run_and_settle("undo");
    assert_int_equal(window_viewport_count(&app->window), 1);
}

/** Settings, moves and changes of objects are taken back in the order in which they were made. */
static void test_undo_order(void **state) {
    (void)state;
    App *app = &opened.app;
    const RenderSettings first = requested();
    const double fov = app->scene->camera.fov;
    const int sphere = scene_object_keyword_find("sphere");
    const SceneOverride wider = {sphere, 1, scene_object_row_find(sphere, "radius"), {2}};
    run("deeper");
    edits_set(app, &wider, false);
    assert_true(settle());
    run("deeper");
    app_zoom(app, 1);
    run("layer normals");
    assert_true(settle());
    const Viewport *viewport = &app->window.viewports[0];
    run_and_settle("undo");
    assert_int_equal(viewport->layer, LAYER_SHADED);
    assert_true(app->scene->camera.fov < fov);
    run_and_settle("undo");
    assert_true(app->scene->camera.fov == fov);
    assert_int_equal(requested().trace.depth, first.trace.depth + 2);
    run_and_settle("undo");
    assert_int_equal(requested().trace.depth, first.trace.depth + 1);
    assert_int_equal(edit_history_in_force(&app->edits), 1);
    run_and_settle("undo");
    assert_int_equal(edit_history_in_force(&app->edits), 0);
    run_and_settle("undo");
    assert_int_equal(requested().trace.depth, first.trace.depth);
    run("undo");
    assert_status("there is nothing to undo");
    for (int i = 0; i < 5; i++) {
        run_and_settle("redo");
    }
    assert_int_equal(requested().trace.depth, first.trace.depth + 2);
    assert_int_equal(edit_history_in_force(&app->edits), 1);
    assert_int_equal(viewport->layer, LAYER_NORMALS);
    assert_true(app->scene->camera.fov < fov);
    // The file is written anew: no change of an object is left to be undone before the others.
    SDL_Delay(20);
    write_text("scene.lua", SCENE);
    current_scene_on_file_event(app);
    assert_true(settle());
    run_and_settle("undo");
    assert_int_equal(viewport->layer, LAYER_SHADED);
    run_and_settle("undo");
    run_and_settle("undo");
    run_and_settle("undo");
    assert_int_equal(requested().trace.depth, first.trace.depth);
}

/** Once a setting is changed after an undo, what was undone cannot be done again. */
static void test_undone_is_forgotten(void **state) {
    (void)state;
    App *app = &opened.app;
    const int sphere = scene_object_keyword_find("sphere");
    const SceneOverride wider = {sphere, 1, scene_object_row_find(sphere, "radius"), {2}};
    edits_set(app, &wider, false);
    assert_true(settle());
    run_and_settle("undo");
    run_and_settle("deeper");
    run("redo");
    assert_status("there is nothing to do again");
    assert_int_equal(edit_history_in_force(&app->edits), 0);
}

/** The inspector that appears asks for the frames that show it: its first one finds its size. */
static void test_inspector_appears(void **state) {
    (void)state;
    Window *window = &opened.app.window;
    if (!typeface_find()) {
        skip();
    }
    for (int i = 0; i < 8 && gui_needs_frame(window->gui); i++) {
        window_present(window);
    }
    assert_false(gui_needs_frame(window->gui));
    run("next thing");
    assert_true(window->object_inspector.number > 0);
    assert_true(gui_needs_frame(window->gui));
}

/** @return How many texts of the last frame contain some words. */
static size_t count_texts(const char *words) {
    const GuiText *texts;
    const size_t count = gui_texts(opened.app.window.gui, &texts);
    size_t found = 0;
    for (size_t i = 0; i < count; i++) {
        found += strstr(texts[i].text, words) != NULL;
    }
    return found;
}

/** Has the window drawn until all of it is where it belongs. */
static void draw(void) {
    for (int i = 0; i < 4; i++) {
        window_present(&opened.app.window);
    }
}

/** All things are listed: camera, lights, shapes; what is chosen is selected, and Esc leads back to
 *  the list before it closes that. */
static void test_things(void **state) {
    (void)state;
    App *app = &opened.app;
    ObjectInspector *inspector = &app->window.object_inspector;
    if (!typeface_find()) {
        skip();
    }
    gui_record_texts(app->window.gui, true);
    SDL_SetWindowSize(app->window.sdl.window, 640, 480);
    assert_true(settle());
    run("things");
    draw();
    assert_true(inspector->lists && !object_inspector_has_thing(inspector));
    assert_int_equal(count_texts("camera"), 1);
    assert_int_equal(count_texts("lamp 1 (line 2)"), 1);
    assert_int_equal(count_texts("sphere 1 (line 4)"), 1);
    for (size_t i = 0; i < 5; i++) {
        static const char *const keywords[] = {NULL, "light", "light", "sphere", "sdf"};
        inspector->request = INSPECTOR_CHOOSE;
        inspector->chosen = i;
        edits_handle_requests(app);
        draw();
        assert_true(object_inspector_has_thing(inspector));
        assert_int_equal(inspector->is_camera, i == 0);
        assert_true(i == 0 || inspector->keyword == scene_object_keyword_find(keywords[i]));
        assert_int_equal(inspector->number, i == 2 ? 2 : i > 0);
        assert_int_equal(app->selected_light, i >= 2); // The one that was chosen stays so.
        assert_true(count_texts(i == 0 ? "field of view" : "write into the file") > 0);
        run("leave");
        assert_true(inspector->lists && !object_inspector_has_thing(inspector));
    }
    run("leave");
    assert_false(object_inspector_is_open(inspector) || app->exit.is_requested);
    // From a thing its button leads to the list; once more closes it.
    edits_click(app, 0.5, 0.5);
    inspector->request = INSPECTOR_THINGS;
    edits_handle_requests(app);
    assert_true(inspector->lists && !object_inspector_has_thing(inspector));
    run("things");
    assert_false(object_inspector_is_open(inspector));
}

/** A key goes down or up. @param type SDL_KEYDOWN or SDL_KEYUP. @param modifiers SDL's. */
static void key_event(Uint32 type, SDL_Keycode key, Uint16 modifiers) {
    SDL_Event event = {.key = {.type = type,
                               .timestamp = SDL_GetTicks(),
                               .keysym = {SDL_GetScancodeFromKey(key), key, modifiers, 0}}};
    input_handle_event(&opened.app, &event);
}

/** Presses a key, and lets it up. */
static void press(SDL_Keycode key) {
    key_event(SDL_KEYDOWN, key, 0);
    key_event(SDL_KEYUP, key, 0);
}

/** A mouse button goes down or up. @param type SDL_MOUSEBUTTONDOWN or SDL_MOUSEBUTTONUP. */
static void button_event(Uint32 type, Uint8 button, int x, int y) {
    SDL_Event event = {.button = {.type = type,
                                  .button = button,
                                  .state = type == SDL_MOUSEBUTTONDOWN ? SDL_PRESSED : SDL_RELEASED,
                                  .x = x,
                                  .y = y}};
    input_handle_event(&opened.app, &event);
}

/** A key that moves something stops when it goes up, whatever other key has made of it, and whoever
 *  has the keyboard by then; while it is held it is no other command. */
static void test_keys_go_up(void **state) {
    (void)state;
    App *app = &opened.app;
    const HeldKeys *held_keys = &app->input.held_keys;
    const Move down = command_find(command_table, "light down")->move;
    const Move up = command_find(command_table, "camera up")->move;
    const Move nearer = command_find(command_table, "light nearer")->move;
    key_event(SDL_KEYDOWN, SDLK_s, 0);
    assert_true(held_keys_is_down(held_keys, down));
    key_event(SDL_KEYUP, SDLK_s, KMOD_LCTRL); // Ctrl and S writes an object.
    assert_false(held_keys_is_down(held_keys, down));
    key_event(SDL_KEYDOWN, SDLK_UP, 0);
    assert_true(held_keys_is_down(held_keys, up));
    run("things");
    draw();
    key_event(SDL_KEYUP, SDLK_UP, 0);
    assert_false(held_keys_is_down(held_keys, up));
    run("leave");
    // A repeated key is still the move.
    app_zoom(app, 1);
    const double fov = app->scene->camera.fov;
    key_event(SDL_KEYDOWN, SDLK_z, 0);
    SDL_Event repeated = {
        .key = {.type = SDL_KEYDOWN,
                .repeat = 1,
                .keysym = {SDL_GetScancodeFromKey(SDLK_z), SDLK_z, KMOD_LCTRL, 0}}};
    input_handle_event(app, &repeated);
    assert_true(app->scene->camera.fov == fov);
    assert_true(held_keys_is_down(held_keys, nearer));
    key_event(SDL_KEYUP, SDLK_z, 0);
    assert_false(held_keys_is_down(held_keys, nearer));
}

/** Each mouse button lets go of what it holds, and of nothing else. */
static void test_two_buttons(void **state) {
    (void)state;
    App *app = &opened.app;
    InputState *input = &app->input;
    input->is_light_dragged = true; // As if the left button held a lamp.
    button_event(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_RIGHT, 20, 20);
    assert_int_equal(input->camera_drag, CAMERA_IS_TURNED);
    button_event(SDL_MOUSEBUTTONUP, SDL_BUTTON_LEFT, 20, 20);
    assert_false(input->is_light_dragged);
    assert_int_equal(input->camera_drag, CAMERA_IS_TURNED);
    button_event(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_MIDDLE, 20, 20);
    button_event(SDL_MOUSEBUTTONUP, SDL_BUTTON_MIDDLE, 20, 20);
    assert_int_equal(input->camera_drag, CAMERA_IS_TURNED);
    button_event(SDL_MOUSEBUTTONUP, SDL_BUTTON_RIGHT, 20, 20);
    assert_int_equal(input->camera_drag, CAMERA_IS_FREE);
}

/** A caption that is typed is accepted by a click and by the end of the recording. */
static void test_caption_accepted(void **state) {
    (void)state;
    App *app = &opened.app;
    Error error = {0};
    for (int ends = 0; ends < 2; ends++) {
        assert_true(recorder_begin(app, &error));
        recorder_begin_caption(app);
        SDL_Event typed = {.text = {.type = SDL_TEXTINPUT, .text = "words"}};
        input_handle_event(app, &typed);
        if (!ends) {
            button_event(SDL_MOUSEBUTTONDOWN, SDL_BUTTON_LEFT, 20, 20);
            assert_false(app->recorder.is_entering_caption);
            button_event(SDL_MOUSEBUTTONUP, SDL_BUTTON_LEFT, 20, 20);
        }
        assert_true(recorder_end(app, &error));
        assert_false(caption_is_open(&app->window.caption) || SDL_IsTextInputActive());
        const char *lesson = file_text(ends ? "scene-lesson-0002.lua" : "scene-lesson-0001.lua");
        assert_non_null(strstr(lesson, "caption { en = \"words\""));
    }
}

/** What a tool does is said on the picture when it is chosen, and no longer once it is gone. */
static void test_tools_explained(void **state) {
    (void)state;
    const Toast *toast = &opened.app.window.toast;
    static const struct {
        const char *command, *words;
    } steps[] = {{"split", "T: the other one"},     {"split", "left minus right"},
                 {"magnifier", "Ctrl and arrows"},  {"magnifier", NULL},
                 {"presentation", "F5: as before"}, {"presentation", NULL}};
    for (size_t i = 0; i < COUNT(steps); i++) {
        run_and_settle(steps[i].command);
        if (steps[i].words) {
            assert_non_null(strstr(toast->text, steps[i].words));
        } else {
            assert_string_equal(toast->text, "");
        }
    }
}

/** Opens a window on a scene with very many things. @return 0 if it is open. */
static int set_up_many(void **state) {
    (void)state;
    return open_app_window("camera { position = {0, 0, 6} }\nlight {}\n"
                           "for i = 1, 20000 do sphere { center = {i, 0, 0}, radius = 0.1 } end\n",
                           "");
}

/** Very many things of one line share a row, which unfolds and folds; then only those in sight are
 *  written; the list stays in a window that becomes smaller. */
static void test_many_things(void **state) {
    (void)state;
    App *app = &opened.app;
    ObjectInspector *inspector = &app->window.object_inspector;
    if (!typeface_find()) {
        skip();
    }
    gui_record_texts(app->window.gui, true);
    SDL_SetWindowSize(app->window.sdl.window, 800, 600);
    assert_true(settle());
    run("things");
    draw();
    SDL_SetWindowSize(app->window.sdl.window, 640, 480);
    assert_true(settle());
    draw();
    const GuiRect list = gui_inspector_rect();
    assert_true(list.height > 100 && list.y + list.height <= 480);
    assert_int_equal(count_texts("▶ sphere × 20000 (line 3)"), 1);
    assert_int_equal(count_texts("sphere"), 1);
    for (int i = 0; i < 3; i++) {
        press(SDLK_DOWN);
        draw();
    }
    press(SDLK_SPACE);
    draw();
    assert_int_equal(count_texts("▼ sphere × 20000 (line 3)"), 1);
    assert_int_equal(count_texts("sphere 1 (line 3)"), 1);
    assert_true(count_texts("sphere") > 5 && count_texts("sphere") < 40);
    press(SDLK_SPACE);
    draw();
    assert_int_equal(count_texts("sphere"), 1);
    // It leads back to the thing that was chosen.
    inspector->request = INSPECTOR_CHOOSE;
    inspector->has_chosen = true;
    inspector->chosen = 2 + 9999;
    edits_handle_requests(app);
    draw();
    assert_int_equal(inspector->number, 10000);
    run("leave");
    draw();
    assert_int_equal(count_texts("sphere 10000 (line 3)"), 1);
    assert_true(count_texts("sphere") < 40);
}

/** Settings that change are shown for a while, but not over the toolbar's own. */
static void test_shown_settings(void **state) {
    (void)state;
    Window *window = &opened.app.window;
    window->toolbar.is_folded = false;
    run_and_settle("offset");
    assert_false(window->shows_settings);
    run_and_settle("split");
    run_and_settle("offset");
    assert_true(window->shows_settings);
    run_and_settle("settings");
    run_and_settle("settings");
    assert_false(window->shows_settings);
    run_and_settle("as at first");
    assert_int_equal(window_viewport_count(window), 1);
    window->toolbar.is_folded = true;
    run_and_settle("offset");
    assert_true(window->shows_settings);
}

/** Each layer is drawn when its key asks for it; Esc leaves it. */
static void test_layers(void **state) {
    (void)state;
    static const struct {
        const char *name; /**< Of the command. */
        Layer layer;      /**< What it shows. */
    } layers[] = {{"layer normals", LAYER_NORMALS}, {"layer distance", LAYER_DISTANCE},
                  {"layer shapes", LAYER_SHAPES},   {"layer places", LAYER_UV},
                  {"layer rays", LAYER_RAYS},       {"layer steps", LAYER_STEPS},
                  {"layer time", LAYER_TIME},       {"layer rounding", LAYER_ROUNDING}};
    Viewport *viewport = &opened.app.window.viewports[0];
    for (size_t i = 0; i < COUNT(layers); i++) {
        run(layers[i].name);
        until(window_is_finished(&opened.app.window));
        assert_int_equal(viewport->layer, layers[i].layer);
        assert_int_equal(viewport->report.layer.layer, layers[i].layer);
    }
    run("leave");
    until(window_is_finished(&opened.app.window));
    assert_int_equal(viewport->report.layer.layer, LAYER_SHADED);
    assert_false(opened.app.exit.is_requested);
}

/** Two pictures, their bar and sides, their difference, one picture. */
static void test_split(void **state) {
    (void)state;
    Window *window = &opened.app.window;
    const SplitView *split = &window->split;
    run_and_settle("split");
    assert_int_equal(split->mode, SPLIT_BAR);
    assert_int_equal(window_viewport_count(window), 2);
    size_t active = split->active;
    run("other side");
    assert_int_equal(split->active, 1 - active);
    double place = split->bar_position;
    run("bar right");
    assert_true(split->bar_position > place);
    run("bar left");
    assert_at_most(fabs(split->bar_position - place), 1e-12, "the bar is back");
    run("samples twice"); // On one side only.
    assert_true(settle());
    assert_int_not_equal(window->viewports[0].settings.samples,
                         window->viewports[1].settings.samples);
    run_and_settle("split");
    assert_int_equal(split->mode, SPLIT_DIFFERENCE);
    until(window_is_finished(window));
    run("leave");
    run("leave");
    assert_true(settle());
    assert_int_equal(split->mode, SPLIT_NONE);
    assert_int_equal(window_viewport_count(window), 1);
}

/** The difference of two pictures of a layer is one of its numbers; the screen shows it. */
static void test_difference_of_layers(void **state) {
    (void)state;
    Window *window = &opened.app.window;
    static const char *const layers[] = {"layer distance", "layer shapes", "layer places",
                                         "layer normals"};
    run_and_settle("split");
    for (size_t i = 0; i < COUNT(layers); i++) {
        run(layers[i]);
        run("other side");
        run(layers[i]);
        run("other side");
        until(window_is_finished(window));
        run_and_settle("split");
        assert_int_equal(window->split.mode, SPLIT_DIFFERENCE);
        until(window_is_finished(window));
        settle();
        // Both sides are drawn alike: nothing differs.
        assert_false(window->split.difference.is_of_two_layers);
        assert_int_equal(window->split.difference.pixel_count, 64 * 48);
        assert_true(window->split.difference.max_difference == 0);
        run("snapshot of the screen");
        assert_status("saved ");
        run_and_settle("split back"); // Two pictures again.
    }
    assert_int_equal(window->split.mode, SPLIT_BAR);
}

/** The buttons of the inspector do what its keys do. */
static void test_inspector_buttons(void **state) {
    (void)state;
    App *app = &opened.app;
    ObjectInspector *inspector = &app->window.object_inspector;
    int sphere = scene_object_keyword_find("sphere");
    edits_click(app, 0.5, 0.5);
    assert_int_equal(inspector->number, 1);
    inspector->edit = (SceneOverride){sphere, 1, scene_object_row_find(sphere, "radius"), {2}};
    inspector->has_edit = true;
    edits_handle_requests(app);
    assert_false(inspector->has_edit);
    assert_true(settle());
    const InspectorRequest requests[] = {INSPECTOR_WRITE, INSPECTOR_COPY, INSPECTOR_UNDO,
                                         INSPECTOR_REDO};
    for (size_t i = 0; i < COUNT(requests); i++) {
        inspector->request = requests[i];
        edits_handle_requests(app);
        assert_true(settle());
        assert_int_equal(edit_history_in_force(&app->edits) > 0, requests[i] != INSPECTOR_UNDO);
    }
    assert_non_null(strstr(file_text("scene.lua"), "radius = 2"));
    inspector->request = INSPECTOR_RAYS;
    edits_handle_requests(app);
    assert_true(app->window.ray_view.is_open);
    run("rays");
    inspector->request = INSPECTOR_CLOSE;
    edits_handle_requests(app);
    assert_int_equal(inspector->number, 0);
}

/** The chart measures the settings that are drawn while it is open, each once. */
static void test_chart(void **state) {
    (void)state;
    SettingsChartPanel *panel = &opened.app.window.settings_chart;
    run("chart");
    assert_true(panel->is_open);
    until(panel->chart.count == 1);
    run("samples twice");
    until(panel->chart.count == 2);
    assert_true(panel->chart.points[0].error > 0 && panel->chart.points[0].seconds > 0);
    assert_false(settings_have_same_name(&panel->chart.points[0].settings,
                                         &panel->chart.points[1].settings));
    run("samples half");
    until(window_is_finished(&opened.app.window));
    settle();
    assert_int_equal(panel->chart.count, 2);
    run("light mode"); // Another picture: its points would be compared with those of this one.
    until(panel->chart.count == 1);
    run("leave");
    assert_false(panel->is_open);
}

/** Rays of a pixel, which is chosen, moved to the pixel beside, seen from elsewhere. */
static void test_rays(void **state) {
    (void)state;
    App *app = &opened.app;
    RayView *rays = &app->window.ray_view;
    app_pick_pixel(app, 0.5, 0.5);
    assert_true(settle());
    assert_true(rays->is_open && rays->ray_tree.count >= 3); // Light, light, mirror.
    const Vec3d camera = app->scene->camera.position;
    app_move(app, (Movement){0}, (Movement){.right = 1});
    app_turn(app, 10, 5);
    app_orbit(app, 10, 5, (Vec3d){0, 0, 0});
    app_zoom(app, 1);
    app_pan(app, 1, 1);
    assert_true(settle());
    assert_memory_equal(&app->scene->camera.position, &camera, sizeof camera);
    run("ray on");
    run("ray on");
    run("ray back");
    run("fly ray");
    command_choose_ray(app, 1);
    for (int i = 0; i < 5; i++) {
        run_and_settle("arrows");
    }
    static const char *const panes[] = {"ray plan", "ray march", "hit microscope"};
    for (size_t i = 0; i < COUNT(panes); i++) {
        run_and_settle(panes[i]);
        assert_int_not_equal(rays->pane, RAY_PANE_NONE);
        run_and_settle(panes[i]);
        assert_int_equal(rays->pane, RAY_PANE_NONE);
    }
    static const char *const kinds[] = {"camera rays", "shadow rays", "mirrored rays",
                                        "refracted rays"};
    for (size_t i = 0; i < 2 * COUNT(kinds); i++) {
        run_and_settle(kinds[i % COUNT(kinds)]);
    }
    app_step_pixel(app, 1, 0);
    assert_true(settle());
    run("leave");
    assert_false(rays->is_open);
}

/** Camera and lights move, walk, come back; the time of a still scene does not run. */
static void test_moves(void **state) {
    (void)state;
    App *app = &opened.app;
    const Vec3d light = app->scene->lights[0].position;
    app_move(app, (Movement){.up = 0.5}, (Movement){.forward = 0.5});
    assert_true(settle());
    assert_true(vec3d_length(vec3d_subtract(app->scene->lights[0].position, light)) > 0.4);
    assert_true(app->scene->camera.position.z < 6);
    run_and_settle("undo");
    run_and_settle("redo");
    assert_true(app->scene->camera.position.z < 6);
    run_and_settle("home");
    assert_true(app->scene->camera.position.z == 6);
    run("next light");
    assert_int_equal(app->selected_light, 1);
    run("next light");
    assert_int_equal(app->selected_light, 0);
    run("walk");
    assert_int_equal(app->input.camera_motion, MOTION_WALK);
    assert_status("walking");
    run("walk");
    assert_int_equal(app->input.camera_motion, MOTION_FLY);
    run("time");
    assert_false(app->timeline.is_running);
    app_zoom(app, 1);
    double view = app->scene->camera.fov;
    app_zoom(app, -2);
    assert_true(app->scene->camera.fov > view);
    app_zoom(app, -100);
    assert_true(app->scene->camera.fov == 100); // As wide as things keep their shapes.
    app->scene->camera.fov = 120;
    app_zoom(app, -1);
    assert_true(app->scene->camera.fov == 120); // The scene's own is wider.
}

/** A change that was taken back can be done again after the camera has moved; what was moved is
 *  taken back before what was changed earlier. */
static void test_redo_after_move(void **state) {
    (void)state;
    App *app = &opened.app;
    const double fov = app->scene->camera.fov;
    const int sphere = scene_object_keyword_find("sphere");
    const SceneOverride wider = {sphere, 1, scene_object_row_find(sphere, "radius"), {2}};
    edits_set(app, &wider, false);
    assert_true(settle());
    run_and_settle("undo");
    app_zoom(app, 1);
    assert_true(settle());
    run_and_settle("redo");
    assert_int_equal(edit_history_in_force(&app->edits), 1);
    assert_true(app->scene->camera.fov < fov);
    run_and_settle("undo");
    assert_int_equal(edit_history_in_force(&app->edits), 0);
    assert_true(app->scene->camera.fov < fov);
    run_and_settle("undo");
    assert_true(app->scene->camera.fov == fov);
}

/** What lies over the picture opens and closes; Esc closes the topmost. */
static void test_panels(void **state) {
    (void)state;
    App *app = &opened.app;
    Window *window = &app->window;
    if (!typeface_find()) {
        skip();
    }
    run("help");
    assert_true(window->help.is_open);
    assert_true(settle());
    run("leave");
    assert_false(window->help.is_open);
    run("settings");
    assert_true(window->shows_settings);
    run("settings");
    assert_false(window->shows_settings);
    run("magnifier");
    assert_true(window->magnifier.is_on);
    app_step_pixel(app, 3, 2);
    assert_true(settle());
    run("leave");
    assert_false(window->magnifier.is_on);
    run("next thing");
    assert_int_equal(window->object_inspector.number, 1);
    run("inspector keys");
    assert_true(settle());
    run("leave");
    assert_int_equal(window->object_inspector.number, 0);
    run("text larger");
    assert_true(window->text_scale > 1);
    run("text smaller");
    run("text smaller");
    assert_true(window->text_scale < 1);
    run("presentation");
    assert_true(window->is_presenting);
    run("presentation");
    assert_false(window->is_presenting);
    run("full screen");
    assert_true(SDL_GetWindowFlags(window->sdl.window) & SDL_WINDOW_FULLSCREEN_DESKTOP);
    assert_true(settle());
    run("leave");
    assert_false(SDL_GetWindowFlags(window->sdl.window) & SDL_WINDOW_FULLSCREEN_DESKTOP);
    assert_false(app->exit.is_requested);
    run("leave");
    assert_true(app->exit.is_requested);
}

/** Letters do what they do while the inspector has the keyboard, which uses none of them; arrows
 * are the inspector's. */
static void test_letters_in_inspector(void **state) {
    (void)state;
    Window *window = &opened.app.window;
    if (!typeface_find()) {
        skip();
    }
    const int depth = window_active_viewport(window)->settings.trace.depth;
    run("next thing");
    run("inspector keys");
    assert_true(settle());
    press(SDLK_b);
    assert_true(settle());
    assert_int_equal(window_active_viewport(window)->settings.trace.depth, depth + 1);
    const Vec3d place = opened.app.scene->camera.position;
    press(SDLK_RIGHT);
    assert_true(settle());
    assert_true(vec3d_length(vec3d_subtract(opened.app.scene->camera.position, place)) <= 0);
    run("leave");
}

/** F1 shows the help over the list of scenes, where no key reaches the list; closed, the list is
 *  there again. */
static void test_help_over_list(void **state) {
    (void)state;
    Window *window = &opened.app.window;
    if (!typeface_find()) {
        skip();
    }
    opened.settings.preview = load_nothing;
    const SDL_Keycode keys[] = {SDLK_F1, SDLK_ESCAPE};
    for (size_t i = 0; i < COUNT(keys); i++) {
        run("scenes");
        press(SDLK_F1);
        assert_true(window->help.is_open && window->browser.is_open);
        press(SDLK_o);
        SDL_Event typed = {.text = {.type = SDL_TEXTINPUT, .text = "o"}};
        input_handle_event(&opened.app, &typed);
        assert_string_equal(window->browser.filter, "");
        press(keys[i]);
        assert_true(!window->help.is_open && window->browser.is_open);
        press(SDLK_F1);
        run(i == 0 ? "scenes" : "lessons"); // Its button: the list that the help has covered.
        assert_true(!window->help.is_open && window->browser.is_open);
        press(SDLK_ESCAPE);
        assert_false(window->browser.is_open || opened.app.exit.is_requested);
    }
}

/** @return The name in the newest message, "saved NAME in FOLDER"; until the next call. */
static const char *saved_name(void) {
    static char name[STATUS_TEXT_SIZE];
    assert_int_equal(sscanf(opened.app.title.status_text, "saved %s in ", name), 1);
    return name;
}

/** View and pictures are copied and saved. */
static void test_saved(void **state) {
    (void)state;
    App *app = &opened.app;
    until(window_is_finished(&app->window));
    run("copy");
    char *text = SDL_GetClipboardText();
    assert_non_null(strstr(text, "camera {"));
    assert_non_null(strstr(text, "light {"));
    SDL_free(text);
    run("snapshot of the screen");
    assert_status("saved ");
    assert_memory_equal(file_text(saved_name()), "\x89PNG", 4);
    assert_true(app_save_picture(app, app_folder(), "shot", &(Error){0}));
    assert_memory_equal(file_text(saved_name()), "BM", 2);
    opened.settings.snapshot_dir = "/none";
    run("snapshot of the screen");
    assert_status("/none");
}

/** A window that is hidden draws nothing; one whose graphics card was reset shows its picture. */
static void test_window_events(void **state) {
    (void)state;
    App *app = &opened.app;
    SDL_Event reset = {.type = SDL_RENDER_DEVICE_RESET};
    input_handle_event(app, &reset);
    assert_null(app->window.viewports[0].texture.texture);
    assert_true(settle());
    assert_non_null(app->window.viewports[0].texture.texture);
    SDL_HideWindow(app->window.sdl.window);
    SDL_Event event;
    while (SDL_PollEvent(&event)) {
        input_handle_event(app, &event);
    }
    assert_true(app->window.is_hidden);
    assert_false(window_is_ready(&app->window));
    SDL_ShowWindow(app->window.sdl.window);
    while (SDL_PollEvent(&event)) {
        input_handle_event(app, &event);
    }
    assert_false(app->window.is_hidden);
    assert_true(settle());
    SDL_Event keymap = {.type = SDL_KEYMAPCHANGED};
    input_handle_event(app, &keymap);
    SDL_Event quit = {.type = SDL_QUIT};
    input_handle_event(app, &quit);
    assert_true(app->exit.is_requested);
    app->exit = (ExitState){0};
    SDL_Event signal_event = {.type = app->first_event + EVENT_SIGNAL};
    input_handle_event(app, &signal_event);
    assert_int_equal(app->exit.status, STATUS_INTERRUPTED);
}

/** @return 0 if all tests pass. */
/** What a command changes is drawn without an event: a list of the toolbar may have been the last
 *  thing that the mouse did. */
static void test_drawn_without_event(void **state) {
    (void)state;
    App *app = &opened.app;
    const Viewport *viewport = &app->window.viewports[0];
    static const char *const changes[] = {"offset", "layer normals", "deeper", "as at first"};
    double now = clock_now_seconds();
    for (size_t i = 0; i < COUNT(changes); i++) {
        assert_true(viewport_timeout(viewport, now) > 0);
        run(changes[i]);
        assert_true(viewport_timeout(viewport, now) == 0);
        assert_true(settle());
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_other_scene, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_settings, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_undo_choices, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_undo_gesture, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_undo_order, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_undone_is_forgotten, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_shown_settings, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_inspector_appears, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_things, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_many_things, set_up_many, close_app_window),
        cmocka_unit_test_setup_teardown(test_layers, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_split, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_difference_of_layers, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_inspector_buttons, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_chart, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_rays, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_moves, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_redo_after_move, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_panels, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_tools_explained, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_letters_in_inspector, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_drawn_without_event, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_help_over_list, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_saved, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_window_events, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_keys_go_up, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_two_buttons, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_caption_accepted, set_up, close_app_window),
    };
    return cmocka_run_group_tests_name("commands", tests, NULL, NULL);
}
