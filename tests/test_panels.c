/**
 * @file
 * @brief The panels over the picture in both languages, in small and large windows.
 */
#include "no_thumbnails.h"
#include "window_texts.h"

/** The list of keys begins with that of the scenes and lessons; in a lesson with its own. */
static void check_first_keys(Help *help) {
    HelpList list;
    help_write_list(help, &list);
    const size_t count = list.count;
    assert_string_equal(list.rows[0].text, gettext("Scenes and lessons"));
    assert_string_equal(list.rows[1].label, "F");
    help->is_in_lesson = true;
    help_write_list(help, &list);
    help->is_in_lesson = false;
    assert_int_equal(list.count, count);
    assert_string_equal(list.rows[0].text, gettext("Lesson, while it plays"));
    assert_true(strstr(list.rows[1].label, gettext("Space")));
}

/** Checks the help. */
static void check_help(Fixture *fixture) {
    check_first_keys(&fixture->window.help);
    fixture->window.help.is_open = true;
    check_frame(fixture, "help", 30);
    fixture->window.help.is_open = false;
}

/** @return Where a text of the last frame lies below the upper edge of what shows it; -1: nowhere.
 */
static float depth_of(const Fixture *fixture, const char *words) {
    const GuiText *texts;
    const size_t count = gui_texts(fixture->window.gui, &texts);
    for (size_t i = 0; i < count; i++) {
        if (strcmp(texts[i].text, words) == 0) {
            return texts[i].rect.y - texts[i].clip.y;
        }
    }
    return -1;
}

/** The help that was scrolled begins at its top when it is opened again. */
static void check_help_again(Fixture *fixture) {
    Help *help = &fixture->window.help;
    HelpList list;
    help_write_list(help, &list);
    const char *first = list.rows[0].text;
    float depths[2];
    for (int i = 0; i < 2; i++) {
        assert_true(help_toggle(help));
        check_frame(fixture, "help", 30);
        depths[i] = depth_of(fixture, first);
        assert_true(depths[i] >= 0);
        help_handle_key(help, SDLK_END);
        check_frame(fixture, "end of the help", 3);
        assert_true(depth_of(fixture, first) < depths[i]);
        assert_true(help_toggle(help));
        window_present(&fixture->window);
    }
    assert_true(depths[1] == depths[0]);
}

/** Checks the legends of all layers. */
static void check_layers(Fixture *fixture) {
    Window *window = &fixture->window;
    RenderStats *report = &window->viewports[0].report;
    for (int layer = 0; layer < LAYER_COUNT; layer++) {
        report->layer.layer = (Layer)layer;
        report->layer.pixel_count = 480000;
        report->layer.artifact_pixels = report->layer.leak_pixels = 17000;
        report->is_finished = true;
        window_invalidate_text(window);
        check_frame(fixture, layer_name((Layer)layer), 4);
    }
    report->layer.layer = LAYER_SHADED;
}

/** Checks the settings and the legends of all layers. */
static void check_legends(Fixture *fixture) {
    Window *window = &fixture->window;
    window->shows_settings = true;
    check_layers(fixture);
    window->shows_settings = false;
    window_invalidate_text(window);
}

/** Checks the legends of all layers beside the inspector of a thing at the left, and at the right.
 */
static void check_legends_beside(Fixture *fixture) {
    Window *window = &fixture->window;
    EditHistory edits = {0};
    bool is_light_moved[8] = {0};
    const SceneObject object = scene_object_of_shape(fixture->scene, 0);
    window->state.edits = &edits;
    window->state.is_light_moved = is_light_moved;
    window->ray_view.y = 0.5;
    for (int is_right = 0; is_right < 2; is_right++) {
        window->ray_view.x = is_right ? 0.9 : 0.1;
        window->object_inspector = (ObjectInspector){
            .keyword = object.keyword, .number = object.origin->number, .has_pixel = true};
        check_layers(fixture);
    }
    window->object_inspector = (ObjectInspector){0};
    edit_history_deinit(&edits);
}

/** Checks captions, at both edges. */
static void check_captions(Fixture *fixture) {
    Caption *caption = &fixture->window.caption;
    const char *text =
        "From the eye a ray goes through each pixel. Where it meets something, we ask: does "
        "light come here? A second ray goes to the lamp; if anything is in its way, the "
        "point lies in the shadow.";
    *caption = (Caption){.text = {text, text}, .hint = N_("Caption: type, then Enter")};
    check_frame(fixture, "caption", 2);
    notice_set(&fixture->window.notice,
               "scenes/box.lua:12: sphere has no field `radios`; did you mean `radius`?");
    check_frame(fixture, "notice", 3);
    notice_set(&fixture->window.notice, "");
    caption_close(caption);
}

/** @return Number of scenes and lessons that are found with some words. */
static size_t found_with(Browser *browser, const char *words) {
    BrowserOrder order;
    SDL_strlcpy(browser->filter, words, sizeof browser->filter);
    browser_order(browser, &order);
    return order.count;
}

/** Words are found as they are read on a thumbnail: with spaces, without accents, in any case. */
static void check_search(Browser *browser) {
    assert_true(found_with(browser, "glass sphere") > 0);
    assert_int_equal(found_with(browser, "glass sphere"), found_with(browser, "glass-sphere"));
    assert_int_equal(found_with(browser, "Glass_Sphere"), found_with(browser, "glass-sphere"));
    assert_int_equal(found_with(browser, "boite"), found_with(browser, "boîte"));
    assert_int_equal(found_with(browser, "EPEE"), found_with(browser, "Épée"));
    assert_int_equal(found_with(browser, "glass  sphere"), 0);
    browser_erase_word(browser);
    assert_string_equal(browser->filter, "glass  ");
    browser_erase_word(browser);
    assert_string_equal(browser->filter, "");
    browser_erase_word(browser);
    assert_string_equal(browser->filter, "");
    if (language_is_french()) {
        assert_true(found_with(browser, "verite") + found_with(browser, "lumiere") > 0);
        // By the French name, and by that of the file.
        assert_int_equal(found_with(browser, "sphere de verre"), 1);
        assert_int_equal(found_with(browser, "glass sphere"), 1);
        assert_int_equal(found_with(browser, "figure 7 : couleurs"), 1);
        // With the signs of a keyboard, where the title has those of print.
        assert_int_equal(found_with(browser, "d'echecs dans un jardin : le"), 1);
        assert_int_equal(found_with(browser, "d’échecs"), 1);
    }
}

/** Tab goes from the lessons to the scenes and back. */
static void check_parts(Browser *browser) {
    BrowserOrder order;
    browser->filter[0] = '\0';
    browser_order(browser, &order);
    browser->selected = order.indices[2];
    browser_key(browser, SDLK_TAB);
    assert_int_equal(browser->selected, order.indices[order.lessons]);
    browser_key(browser, SDLK_TAB);
    assert_int_equal(browser->selected, order.indices[0]);
    SDL_strlcpy(browser->filter, "menger", sizeof browser->filter); // No lesson has the word.
    browser_order(browser, &order);
    assert_true(order.lessons == 0 && order.count > 0);
    browser_key(browser, SDLK_TAB);
    assert_int_equal(browser->selected, order.indices[0]);
}

/** Closed and opened again, the list has the thumbnails that it had, but of files that were
 *  modified. Here no new one can be drawn. */
static void check_kept(Browser *browser, const ViewSettings *settings) {
    const size_t count = browser->list.count;
    uint8_t *first = browser->list.scenes[0].picture.pixels;
    browser->list.scenes[1].modified.tv_nsec ^= 1;
    browser_close(browser);
    assert_true(browser_open(browser, settings, 0, "scenes/box.lua"));
    while (scene_list_is_busy(&browser->list)) {
        SDL_Delay(1);
    }
    assert_int_equal(browser->list.count, count);
    assert_ptr_equal(browser->list.scenes[0].picture.pixels, first);
    for (size_t i = 0; i < count; i++) {
        assert_true(browser->list.scenes[i].is_loaded);
        assert_int_equal(browser->list.scenes[i].picture.pixels != NULL, i != 1);
    }
    browser_close(browser);
}

/** Opened from a scene in another folder, the list has the lessons of the program, too. */
static void check_other_folder(Browser *browser, const ViewSettings *settings) {
    assert_true(browser_open(browser, settings, 0, "tests/scenes/bubbles.lua"));
    while (scene_list_is_busy(&browser->list)) {
        SDL_Delay(1);
    }
    assert_string_equal(browser->list.scenes[0].path, "tests/scenes/bright-panel.lua");
    size_t lessons = 0;
    for (size_t i = 0; i < browser->list.count; i++) {
        lessons += browser->list.scenes[i].is_lesson;
    }
    assert_true(lessons > 0);
    browser_close(browser);
}

/** The footer says how long a lesson is, and how it begins. */
static void check_footer(Fixture *fixture, Browser *browser) {
    const GuiText *texts;
    const SceneEntry *lesson = &browser->list.scenes[0];
    char wanted[64], begin[16];
    bool is_found = false;
    assert_true(lesson->is_lesson && lesson->summary.steps > lesson->summary.questions);
    browser->selected = 0;
    browser->follows_mouse = false;
    check_frame(fixture, "footer", 6);
    snprintf(wanted, sizeof wanted,
             ngettext("%d question", "%d questions", (unsigned long)lesson->summary.questions),
             lesson->summary.questions);
    snprintf(begin, sizeof begin, "%.8s", lesson->summary.first_words); // A record is short.
    const size_t count = gui_texts(fixture->window.gui, &texts);
    for (size_t i = 0; i < count; i++) {
        const char *words = strstr(texts[i].text, wanted);
        is_found = is_found || (words && strstr(words, begin));
    }
    assert_true(is_found);
}

/** @return Whether a text is the title of a lesson. */
static bool is_lesson_title(const Browser *browser, const GuiText *text) {
    for (size_t i = 0; i < browser->list.count; i++) {
        char words[GUI_RECORD_SIZE]; // A record is short.
        SDL_strlcpy(words, browser->list.scenes[i].title, sizeof words);
        if (browser->list.scenes[i].is_lesson && text->scrolls && strcmp(words, text->text) == 0) {
            return true;
        }
    }
    return false;
}

/** @return Where what is seen of a text ends. */
static float seen_end(const GuiText *text) {
    return text->clip.y + text->clip.height;
}

/** Below its picture the title of each lesson is whole, in as many lines as it needs, unless the
 *  list itself ends there. */
static void check_titles(Fixture *fixture, const Browser *browser) {
    const GuiText *texts;
    const size_t count = gui_texts(fixture->window.gui, &texts);
    float list_end = 0;
    for (size_t i = 0; i < count; i++) {
        if (is_lesson_title(browser, &texts[i])) {
            list_end = SDL_max(list_end, seen_end(&texts[i]));
        }
    }
    assert_true(list_end > 0);
    for (size_t i = 0; i < count; i++) {
        const GuiText *text = &texts[i];
        if (is_lesson_title(browser, text) && seen_end(text) + ROUNDING < list_end &&
            text->rect.y + text->rect.height > seen_end(text) + ROUNDING) {
            fault(fixture, "list", "the title '%s' is cut", text->text);
        }
    }
}

/** Checks the list of scenes. */
static void check_list(Fixture *fixture) {
    static const ViewSettings settings = {.preview = load_nothing};
    Browser *browser = &fixture->window.browser;
    assert_true(browser_open(browser, &settings, 0, "scenes/box.lua"));
    while (scene_list_is_busy(&browser->list)) {
        SDL_Delay(1);
    }
    assert_true(browser->list.count > 20);
    for (size_t i = 0; i < browser->list.count; i++) {
        SceneEntry *scene = &browser->list.scenes[i];
        // The list has those that it was closed with.
        assert_true(scene->picture.pixels || picture_init(&scene->picture, 4, 3, NULL));
        scene_title_read(scene->path, scene->is_lesson, language_is_french(), scene->title);
    }
    check_frame(fixture, "list", 6);
    browser_key(browser, SDLK_HOME); // Where the lessons are.
    check_frame(fixture, "list of lessons", 6);
    check_titles(fixture, browser);
    check_footer(fixture, browser);
    browser_type(browser, "GLA");
    check_frame(fixture, "list with words", 3);
    check_search(browser);
    check_parts(browser);
    check_kept(browser, &settings);
    check_other_folder(browser, &settings);
}

/** The help. */
static void test_help(void **state) {
    in_all_windows(state, check_help);
    in_all_windows(state, check_help_again);
}

/** Places of the window whose colours are read, in each direction. */
enum { READ_PLACES = 40 };

/** @return The colour that most of the places of the window have. */
static uint32_t usual_color(SDL_Renderer *renderer, int width, int height) {
    uint32_t colors[READ_PLACES * READ_PLACES];
    int most = 0;
    uint32_t usual = 0;
    for (int i = 0; i < READ_PLACES * READ_PLACES; i++) {
        SDL_Rect place = {(i % READ_PLACES * 2 + 1) * width / (2 * READ_PLACES),
                          (i / READ_PLACES * 2 + 1) * height / (2 * READ_PLACES), 1, 1};
        assert_int_equal(SDL_RenderReadPixels(renderer, &place, SDL_PIXELFORMAT_ARGB8888,
                                              &colors[i], sizeof colors[i]),
                         0);
        int same = 0;
        for (int j = 0; j <= i; j++) {
            same += colors[j] == colors[i];
        }
        if (same > most) {
            most = same;
            usual = colors[i];
        }
    }
    return usual;
}

/** A panel has its colour however large the window is: for large triangles SDL's software renderer
 *  reads beside the texture of the letters. */
static void test_large_panels(void **state) {
    static const int large[][2] = {{640, 480}, {3840, 2160}, {8000, 4000}};
    if (!*state) {
        skip();
    }
    Window *window = &((Fixture *)*state)->window;
    uint32_t colors[COUNT(large)];
    for (size_t i = 0; i < COUNT(large); i++) {
        set_size(window, large[i][0], large[i][1]);
        window->help.is_open = true;
        for (int frame = 0; frame < 3; frame++) {
            window_present(window);
        }
        colors[i] = usual_color(window->sdl.renderer, large[i][0], large[i][1]);
        window->help.is_open = false;
        assert_int_equal(colors[i], colors[0]);
    }
    set_size(window, 640, 480);
}

/** Settings and legends. */
static void test_legends(void **state) {
    in_all_windows(state, check_legends);
    in_all_windows(state, check_legends_beside);
}

/** Captions and notices. */
static void test_captions(void **state) {
    in_all_windows(state, check_captions);
}

/** The list of scenes. */
static void test_list(void **state) {
    in_all_windows(state, check_list);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_help),    cmocka_unit_test(test_large_panels),
        cmocka_unit_test(test_legends), cmocka_unit_test(test_captions),
        cmocka_unit_test(test_list),
    };
    return cmocka_run_group_tests(tests, open_window, close_window);
}
