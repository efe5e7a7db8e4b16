/**
 * @file
 * @brief Tests of the list of scenes: names and titles of files, thumbnails that are kept, and what
 *        is selected first.
 */
#include "fixtures.h"

#include "view/panels/browser.h"

#include <SDL.h>

/** Bytes of a name in these tests, with the final zero. */
enum { NAME_SIZE = 12 };

/** Writes a text file into the folder of the test. @return Its path. */
static const char *write_text(void **state, const char *name, const char *text) {
    const char *path = fixture_path(state, name);
    write_file(path, text, strlen(text));
    return path;
}

/** A name is that of its language, without the end of its line, and cut between two characters; a
 *  file without one leaves the name as it was. */
static void test_names(void **state) {
    static const struct {
        const char *text; /**< The file. */
        const char *name; /**< Its French name; before it is read: `glass`. */
    } cases[] = {
        {"-- fr name: verre\n", "verre"},
        {"-- A scene.\r\n-- fr name: verre\r\ncamera {}\r\n", "verre"},
        {"camera {}\n-- fr name: verre", "verre"},
        {"-- fr name: verre\n-- fr name: eau\n", "verre"},
        {"-- fr name: ", ""},
        {"-- en name: water\n-- fr: Du verre.\n--fr name: eau\n x -- fr name: eau\n", "glass"},
        {"", "glass"},
        // 11 bytes fit: the é would need the 12th.
        {"-- fr name: 0123456789\xc3\xa9t\xc3\xa9\n", "0123456789"},
        {"-- fr name: 012345678\xc3\xa9t\xc3\xa9\n", "012345678\xc3\xa9"},
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        char name[NAME_SIZE] = "glass";
        scene_title_read_name(write_text(state, "a.lua", cases[i].text), true, name, sizeof name);
        assert_string_equal(name, cases[i].name);
    }
    char name[NAME_SIZE] = "glass";
    const char *path = write_text(state, "a.lua", "-- fr name: eau\n-- en name: water\n");
    scene_title_read_name(path, false, name, sizeof name);
    assert_string_equal(name, "water");
}

/** A title that is too long is cut between two characters. */
static void test_long_titles(void **state) {
    char text[2 * SCENE_TITLE_SIZE] = "-- fr: ",
                  lesson[2 * SCENE_TITLE_SIZE] = "lesson { title = '";
    char title[SCENE_TITLE_SIZE];
    while (strlen(text) < SCENE_TITLE_SIZE + 16) {
        strcat(text, "\xc3\xa9");
        strcat(lesson, "\xc3\xa9");
    }
    strcat(lesson, "' }");
    // An even number of bytes, of which the last one is the final zero.
    scene_title_read(write_text(state, "a.lua", text), false, true, title);
    assert_int_equal(strlen(title), SCENE_TITLE_SIZE - 2);
    scene_title_read(write_text(state, "b.lua", lesson), true, true, title);
    assert_int_equal(strlen(title), SCENE_TITLE_SIZE - 2);
}

/** A lesson tells its steps, its questions and its first sentence. */
static void test_summaries(void **state) {
    static const struct {
        const char *text;     /**< The file. */
        int steps, questions; /**< Of it. */
        const char *words[2]; /**< Its first sentence in English, in French. */
    } cases[] = {
        {"lesson { scene = 's.lua' }\nlocal asked = 1\ncaption { wait = true,\n  en = \"Is 1.5 so? "
         "Or\",\n"
         "  fr = \"Un. Deux.\" }\nask(q)\n  ask(q)\ncaption { en = 'B.', fr = 'C.' }\nask {}\n",
         4,
         2,
         {"Is 1.5 so?", "Un."}},
        {"caption { en = 'One only', wait = true }\ncaption { fr = 'Deux' }\n",
         2,
         0,
         {"One only", "One only"}},
        {"caption 'Plain.'\nask(q)\n", 2, 1, {"", ""}},
        {"asking = 1 captions = 2\n", 0, 0, {"", ""}},
        {"", 0, 0, {"", ""}},
    };
    for (size_t i = 0; i < COUNT(cases); i++) {
        for (int is_french = 0; is_french < 2; is_french++) {
            LessonSummary summary;
            scene_title_read_summary(write_text(state, "a.lua", cases[i].text), is_french,
                                     &summary);
            assert_int_equal(summary.steps, cases[i].steps);
            assert_int_equal(summary.questions, cases[i].questions);
            assert_string_equal(summary.first_words, cases[i].words[is_french]);
        }
    }
}

/** What is no regular file has neither name nor title, and nobody waits for one to be written. */
static void test_other_files(void **state) {
    char name[NAME_SIZE] = "glass", title[SCENE_TITLE_SIZE] = "glass";
    const char *fifo = fixture_path(state, "fifo.lua");
    assert_int_equal(mkfifo(fifo, 0600), 0);
    scene_title_read_name(fifo, true, name, sizeof name);
    scene_title_read(fifo, false, true, title);
    assert_string_equal(name, "glass");
    assert_string_equal(title, "");
    scene_title_read_name(fixture_path(state, ""), true, name, sizeof name);
    scene_title_read_name(fixture_path(state, "none.lua"), true, name, sizeof name);
    assert_string_equal(name, "glass");
}

/** Loads one scene, `a.lua`. */
typedef struct Previews {
    SceneList *list; /**< The list that asks for it. */
    bool stops;      /**< Whether the list is closed meanwhile. */
    int count;       /**< How many times it was loaded. */
} Previews;

/** @return An empty scene for `a.lua`, else none. See #ViewPreviewLoader. */
static Scene *load_preview(void *context, const char *path, const atomic_bool *stop,
                           RenderSettings *render, Error *error) {
    Previews *previews = context;
    (void)stop;
    if (strcmp(strrchr(path, '/'), "/a.lua") != 0) {
        error_set(error, STATUS_SCENE, "%s", "no picture");
        return NULL;
    }
    Scene *scene = scene_create(error);
    if (scene) {
        *render = render_settings_default(scene);
    }
    if (previews->stops) {
        scene_list_request_stop(previews->list);
    }
    previews->count++;
    return scene;
}

/** @return The entry of `a.lua` once the list is filled, or stopped. */
static const SceneEntry *fill(SceneList *list, const ViewSettings *settings, const char *path) {
    assert_true(scene_list_start(list, settings, 0, path));
    while (scene_list_is_busy(list)) {
        SDL_Delay(1);
    }
    for (size_t i = 0; i < list->count; i++) {
        if (strcmp(list->scenes[i].path, path) == 0) {
            return &list->scenes[i];
        }
    }
    fail_msg("%s is not in the list", path);
    return NULL;
}

/** A thumbnail is drawn once for each time that the file is written; one that was stopped, which
 *  may be half drawn, does not count. A FIFO in the folder does not keep the list. */
static void test_thumbnails(void **state) {
    SceneList list = {0};
    Previews previews = {.list = &list, .stops = true};
    const ViewSettings settings = {.preview = load_preview, .loader_context = &previews};
    assert_int_equal(mkfifo(fixture_path(state, "fifo.lua"), 0600), 0);
    const char *path = write_text(state, "a.lua", "-- en: A.\n");
    assert_false(fill(&list, &settings, path)->is_loaded);
    assert_int_equal(previews.count, 1);
    previews.stops = false;
    assert_non_null(fill(&list, &settings, path)->picture.pixels);
    assert_int_equal(previews.count, 2);
    assert_non_null(fill(&list, &settings, path)->picture.pixels);
    assert_int_equal(previews.count, 2);
    const struct timespec times[2] = {{.tv_sec = 1}, {.tv_sec = 1}};
    assert_int_equal(utimensat(AT_FDCWD, path, times, 0), 0);
    assert_non_null(fill(&list, &settings, path)->picture.pixels);
    assert_int_equal(previews.count, 3);
    scene_list_deinit(&list);
    assert_false(list.is_started);
}

/** @return The first scene as shown: of the program's lessons, which are in each list. */
static size_t first_shown(const Browser *browser) {
    BrowserOrder order;
    browser_order(browser, &order);
    return order.indices[0];
}

/** The scene on screen is selected once all were found: an event that comes before, such as the
 * last one of the previous list, selects nothing. Enter that comes before opens it then. */
static void test_selected_first(void **state) {
    Browser *browser = calloc(1, sizeof *browser);
    Previews previews = {.list = &browser->list};
    const ViewSettings settings = {.preview = load_preview, .loader_context = &previews};
    write_text(state, "a.lua", "-- en: A.\n");
    const char *path = write_text(state, "b.lua", "-- en: B.\n");
    assert_true(browser_open(browser, &settings, 0, path));
    while (scene_list_is_busy(&browser->list)) {
        SDL_Delay(1);
    }
    atomic_store(&browser->list.is_complete, false);
    browser_select_current(browser);
    assert_false(browser->has_selection);
    assert_int_equal(browser_key(browser, SDLK_RETURN), BROWSER_KEEP_OPEN);
    assert_false(browser->is_requested);
    atomic_store(&browser->list.is_complete, true);
    browser_select_current(browser);
    assert_true(browser->is_requested);
    char selected[PATH_MAX];
    assert_true(browser_selected_path(browser, selected));
    assert_string_equal(selected, path);
    assert_int_equal(browser_key(browser, SDLK_RETURN), BROWSER_OPEN_SCENE);
    // What a key has selected stays.
    browser_key(browser, SDLK_HOME);
    browser_select_current(browser);
    assert_int_equal(browser->selected, first_shown(browser));
    // That the first lesson is wanted outlasts the end of the previous list's thread.
    atomic_store(&browser->list.is_running, true);
    assert_true(browser_open(browser, &settings, 0, path));
    browser_begin_at_top(browser);
    atomic_store(&browser->list.is_running, false);
    assert_true(browser_open(browser, &settings, 0, path));
    while (scene_list_is_busy(&browser->list)) {
        SDL_Delay(1);
    }
    browser_select_current(browser);
    assert_true(browser->has_selection);
    assert_int_equal(browser->selected, first_shown(browser));
    // While the previous list's thread ends, its list is shown: keys are for the next one.
    atomic_store(&browser->list.is_running, true);
    assert_true(browser_open(browser, &settings, 0, path));
    browser_select_current(browser);
    browser_key(browser, SDLK_TAB);
    assert_int_equal(browser_key(browser, SDLK_RETURN), BROWSER_KEEP_OPEN);
    atomic_store(&browser->list.is_running, false);
    assert_true(browser_open(browser, &settings, 0, path));
    while (scene_list_is_busy(&browser->list)) {
        SDL_Delay(1);
    }
    browser_select_current(browser);
    assert_int_equal(browser->selected, first_shown(browser));
    assert_true(browser->is_requested);
    // A Tab that comes before the selection goes to the lessons, too.
    assert_true(browser_open(browser, &settings, 0, path));
    while (scene_list_is_busy(&browser->list)) {
        SDL_Delay(1);
    }
    assert_false(browser->has_selection);
    browser_key(browser, SDLK_TAB);
    assert_false(browser->has_selection);
    browser_select_current(browser);
    assert_int_equal(browser->selected, first_shown(browser));
    browser_deinit(browser);
    free(browser);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_names, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_summaries, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_long_titles, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_other_files, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_thumbnails, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_selected_first, fixture_set_up, fixture_tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
