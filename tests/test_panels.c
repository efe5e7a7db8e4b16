/**
 * @file
 * @brief Every panel of the window in both languages, in small and large windows: no text is cut,
 *        none lies on another, none is too small, none holds the header of a catalogue.
 *
 * The window is SDL's dummy one; the interface says what it has written, and where.
 */
#include "load_scene.h"
#include "testing.h"

#include "base/language.h"
#include "view/commands/commands.h"
#include "view/gui/typeface.h"
#include "view/window.h"

#include <libintl.h>
#include <stdlib.h>

/** Rounding of places and sizes, units of the window. */
static const float ROUNDING = 1.5F;
/** Rows of text per window, and smallest letters. */
static const float ROWS = 30, TEXT_MINIMUM = 14;
/** Sizes of windows. */
static const int sizes[][2] = {{640, 480}, {3840, 2160}, {320, 240}, {800, 600}};

/** The window under test, and its scene. */
typedef struct Fixture {
    Window window; /**< The window. */
    Scene *scene;  /**< Its scene. */
} Fixture;

/** Fails unless every text of the last frame can be read. @param what What is shown. */
static void check_texts(const Fixture *fixture, const char *what) {
    const GuiText *texts;
    const size_t count = gui_texts(fixture->window.gui, &texts);
    int width = 0, height = 0;
    SDL_GetWindowSize(fixture->window.sdl.window, &width, &height);
    const float least = SDL_max(TEXT_MINIMUM, floorf((float)height / ROWS));
    const char *language = language_is_french() ? "fr" : "en";
    for (size_t i = 0; i < count; i++) {
        const GuiText *a = &texts[i];
        if (strstr(a->text, "Project-Id-Version")) {
            fail_msg("%s %s %dx%d: a catalogue's header", what, language, width, height);
        }
        if (a->size + ROUNDING < least) {
            fail_msg("%s %s %dx%d: '%s' is %g high, not %g", what, language, width, height, a->text,
                     (double)a->size, (double)least);
        }
        bool is_wide = a->rect.x + ROUNDING < a->clip.x ||
                       a->rect.x + a->rect.width > a->clip.x + a->clip.width + ROUNDING;
        bool is_high = a->rect.y + ROUNDING < a->clip.y ||
                       a->rect.y + a->rect.height > a->clip.y + a->clip.height + ROUNDING;
        if (is_wide || (is_high && !a->scrolls)) {
            fail_msg("%s %s %dx%d: '%s' is cut: %g %g %g %g in %g %g %g %g", what, language, width,
                     height, a->text, (double)a->rect.x, (double)a->rect.y, (double)a->rect.width,
                     (double)a->rect.height, (double)a->clip.x, (double)a->clip.y,
                     (double)a->clip.width, (double)a->clip.height);
        }
    }
}

/** @return What can be seen of a text. */
static GuiRect seen(const GuiText *text) {
    float left = SDL_max(text->rect.x, text->clip.x), top = SDL_max(text->rect.y, text->clip.y);
    float right = SDL_min(text->rect.x + text->rect.width, text->clip.x + text->clip.width);
    float bottom = SDL_min(text->rect.y + text->rect.height, text->clip.y + text->clip.height);
    return (GuiRect){left, top, right - left, bottom - top};
}

/** Fails if a text of the last frame lies on another. */
static void check_overlaps(const Fixture *fixture, const char *what) {
    const GuiText *texts;
    const size_t count = gui_texts(fixture->window.gui, &texts);
    for (size_t i = 0; i < count; i++) {
        for (size_t j = i + 1; j < count; j++) {
            GuiRect a = seen(&texts[i]), b = seen(&texts[j]);
            float wide = SDL_min(a.x + a.width, b.x + b.width) - SDL_max(a.x, b.x);
            float high = SDL_min(a.y + a.height, b.y + b.height) - SDL_max(a.y, b.y);
            if (wide > ROUNDING && high > ROUNDING) {
                int width = 0, height = 0;
                SDL_GetWindowSize(fixture->window.sdl.window, &width, &height);
                fail_msg("%s %s %dx%d: '%s' lies on '%s' by %g x %g", what,
                         language_is_french() ? "fr" : "en", width, height, texts[i].text,
                         texts[j].text, (double)wide, (double)high);
            }
        }
    }
}

/** Draws some frames, and checks the last one. @param least Fewest texts. */
static void check_frame(Fixture *fixture, const char *what, size_t least) {
    const GuiText *texts;
    for (int i = 0; i < 3; i++) {
        window_present(&fixture->window);
    }
    assert_true(gui_texts(fixture->window.gui, &texts) >= least);
    check_texts(fixture, what);
    check_overlaps(fixture, what);
}

/** Runs a check in all sizes of the window and in both languages. */
static void in_all_windows(void **state, void check(Fixture *fixture)) {
    if (!*state) {
        skip();
    }
    Fixture *fixture = *state;
    for (int language = 0; language < 2; language++) {
        language_toggle();
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            SDL_SetWindowSize(fixture->window.sdl.window, sizes[i][0], sizes[i][1]);
            SDL_PumpEvents();
            window_relayout_toolbar(&fixture->window);
            check(fixture);
        }
    }
}

/** Checks the help. */
static void check_help(Fixture *fixture) {
    fixture->window.help.is_open = true;
    check_frame(fixture, "help", 30);
    fixture->window.help.is_open = false;
}

/** Checks the settings and the legends of all layers. */
static void check_legends(Fixture *fixture) {
    Window *window = &fixture->window;
    RenderStats *report = &window->viewports[0].report;
    window->shows_settings = true;
    for (int layer = 0; layer < LAYER_COUNT; layer++) {
        report->layer.layer = (Layer)layer;
        report->layer.pixel_count = 480000;
        report->layer.artifact_pixels = report->layer.leak_pixels = 17000;
        report->is_finished = true;
        window_invalidate_text(window);
        check_frame(fixture, layer_name((Layer)layer), 4);
    }
    report->layer.layer = LAYER_SHADED;
    window->shows_settings = false;
    window_invalidate_text(window);
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

/** @return No scene. See #ViewPreviewLoader. */
static Scene *load_nothing(void *context, const char *path, const atomic_bool *stop,
                           RenderSettings *render, Error *error) {
    (void)context;
    (void)path;
    (void)stop;
    (void)render;
    error_set(error, STATUS_SCENE, "%s", "no picture");
    return NULL;
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
        assert_true(picture_init(&scene->picture, 4, 3, NULL));
        scene_title_read(scene->path, scene->is_lesson, language_is_french(), scene->title);
    }
    check_frame(fixture, "list", 6);
    browser_type(browser, "GLA");
    check_frame(fixture, "list with words", 3);
    browser_close(browser);
}

/** The help. */
static void test_help(void **state) {
    in_all_windows(state, check_help);
}

/** Settings and legends. */
static void test_legends(void **state) {
    in_all_windows(state, check_legends);
}

/** Captions and notices. */
static void test_captions(void **state) {
    in_all_windows(state, check_captions);
}

/** The list of scenes. */
static void test_list(void **state) {
    in_all_windows(state, check_list);
}

/** Opens the window. */
static int open_window(void **state) {
    static Fixture fixture;
    Error error = {0};
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    setenv("SDL_RENDER_DRIVER", "software", 1);
    language_init();
    if (!typeface_find()) {
        return 0;
    }
    fixture.scene = load_scene("scenes/box.lua");
    const RenderSettings settings = {.engine = engine_find("auto", &error),
                                     .threads = 1,
                                     .width = 320,
                                     .height = 240,
                                     .samples = 16,
                                     .trace = {.depth = 8, .epsilon = 1e-4}};
    fixture.window.help.commands = command_table;
    fixture.window.state.scene = fixture.scene;
    if (!video_start(&error) || !window_open(&fixture.window, fixture.scene, &settings, "dioptre",
                                             SDL_RegisterEvents(1), &error)) {
        print_error("%s\n", error.message);
        return -1;
    }
    window_open_widgets(&fixture.window);
    window_end_hint(&fixture.window);
    fixture.window.hint.text[0] = '\0';
    gui_record_texts(fixture.window.gui, true);
    *state = &fixture;
    return 0;
}

/** Closes the window. */
static int close_window(void **state) {
    Fixture *fixture = *state;
    if (fixture) {
        window_close(&fixture->window);
        scene_destroy(fixture->scene);
    }
    SDL_Quit();
    return 0;
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_help),
        cmocka_unit_test(test_legends),
        cmocka_unit_test(test_captions),
        cmocka_unit_test(test_list),
    };
    return cmocka_run_group_tests(tests, open_window, close_window);
}
