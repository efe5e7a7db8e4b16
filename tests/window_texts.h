/**
 * @file
 * @brief An invisible window, and checks of all that is written in it: no text is cut, none lies on
 *        another, none is too small, none holds the header of a catalogue.
 *
 * The window is SDL's dummy one; the interface says what it has written, and where.
 */
#ifndef DIOPTRE_TESTS_WINDOW_TEXTS_H
#define DIOPTRE_TESTS_WINDOW_TEXTS_H

#include "load_scene.h"
#include "testing.h"

#include "base/language.h"
#include "view/commands/commands.h"
#include "view/gui/typeface.h"
#include "view/window_internal.h"

#include <libintl.h>
#include <limits.h>
#include <stdlib.h>
#include <unistd.h>

#ifndef FIXTURE_SCENE
/** The scene of the window. */
#define FIXTURE_SCENE "scenes/box.lua"
#endif

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
    int faults;    /**< Texts that cannot be read, so far. */
} Fixture;

/** @return Height of the panel of a lesson below the picture. */
static int panel_height(const Window *window) {
    SDL_Rect area = window_area_below_toolbar(window), whole = area;
    window_split_off_panel(window, &area);
    return whole.h - area.h;
}

/** Notes a fault. @param what What is shown. @param format See printf. */
static void fault(Fixture *fixture, const char *what, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void fault(Fixture *fixture, const char *what, const char *format, ...) {
    int width = 0, height = 0;
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    SDL_GetWindowSize(fixture->window.sdl.window, &width, &height);
    print_error("%s %s %dx%d: %s\n", what, language_is_french() ? "fr" : "en", width, height, text);
    fixture->faults++;
}

/** Notes each text of the last frame that cannot be read. @param what What is shown. */
static void check_texts(Fixture *fixture, const char *what) {
    const GuiText *texts;
    const size_t count = gui_texts(fixture->window.gui, &texts);
    int width = 0, height = 0;
    SDL_GetWindowSize(fixture->window.sdl.window, &width, &height);
    // The panel of a lesson makes the window higher; its letters are those of the picture.
    const int panel = fixture->window.lesson_panel.lesson ? panel_height(&fixture->window) : 0;
    const float least = SDL_max(TEXT_MINIMUM, floorf((float)(height - panel) / ROWS));
    for (size_t i = 0; i < count; i++) {
        const GuiText *a = &texts[i];
        if (strstr(a->text, "Project-Id-Version")) {
            fault(fixture, what, "a catalogue's header");
        }
        if (a->size + ROUNDING < least) {
            fault(fixture, what, "'%s' is %g high, not %g", a->text, (double)a->size,
                  (double)least);
        }
        bool is_wide = a->rect.x + ROUNDING < a->clip.x ||
                       a->rect.x + a->rect.width > a->clip.x + a->clip.width + ROUNDING;
        bool is_high = a->rect.y + ROUNDING < a->clip.y ||
                       a->rect.y + a->rect.height > a->clip.y + a->clip.height + ROUNDING;
        if (is_wide || (is_high && !a->scrolls)) {
            fault(fixture, what, "'%s' is cut: %g %g %g %g in %g %g %g %g", a->text,
                  (double)a->rect.x, (double)a->rect.y, (double)a->rect.width,
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

/** Notes each text of the last frame that lies on another. */
static void check_overlaps(Fixture *fixture, const char *what) {
    const GuiText *texts;
    const size_t count = gui_texts(fixture->window.gui, &texts);
    for (size_t i = 0; i < count; i++) {
        for (size_t j = i + 1; j < count; j++) {
            GuiRect a = seen(&texts[i]), b = seen(&texts[j]);
            float wide = SDL_min(a.x + a.width, b.x + b.width) - SDL_max(a.x, b.x);
            float high = SDL_min(a.y + a.height, b.y + b.height) - SDL_max(a.y, b.y);
            if (wide > ROUNDING && high > ROUNDING) {
                fault(fixture, what, "'%s' lies on '%s' by %g x %g", texts[i].text, texts[j].text,
                      (double)wide, (double)high);
            }
        }
    }
}

/** Draws some frames, and checks the last one. @param least Fewest texts. */
static inline void check_frame(Fixture *fixture, const char *what, size_t least) {
    const GuiText *texts;
    for (int i = 0; i < 3; i++) {
        window_present(&fixture->window);
    }
    if (gui_texts(fixture->window.gui, &texts) < least) {
        fault(fixture, what, "fewer than %zu texts", least);
    }
    check_texts(fixture, what);
    check_overlaps(fixture, what);
}

/** Gives the window a size, with the toolbar if it has room for it. */
static void set_size(Window *window, int width, int height) {
    // The bar, when it comes, makes the window higher; the second time there is room for it.
    for (int i = 0; i < 2; i++) {
        SDL_SetWindowSize(window->sdl.window, width, height);
        SDL_PumpEvents();
        window_on_resize(window);
        window_relayout_toolbar(window);
        if (window->toolbar.is_folded) {
            window_toggle_toolbar(window);
            window->toast.text[0] = '\0';
        }
    }
}

/** Binds the catalogues of this build: the program finds them beside itself, a test does not. */
static void bind_catalogues(void) {
    char path[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);
    assert_true(length > 0);
    path[length] = '\0';
    char *folder = strrchr(path, '/');
    snprintf(folder, sizeof path - (size_t)(folder - path), "/../locale");
    bindtextdomain("dioptre", path);
    bool was_french = language_is_french();
    for (int i = 0; i < 2; i++) {
        language_toggle();
        bool is_english = strcmp(gettext("light and ambient"), "light and ambient") == 0;
        assert_true(is_english != language_is_french());
    }
    assert_true(language_is_french() == was_french);
}

/** Runs a check in all sizes of the window and in both languages. */
static inline void in_all_windows(void **state, void check(Fixture *fixture)) {
    if (!*state) {
        skip();
    }
    Fixture *fixture = *state;
    fixture->faults = 0;
    for (int language = 0; language < 2; language++) {
        language_toggle();
        for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
            set_size(&fixture->window, sizes[i][0], sizes[i][1]);
            check(fixture);
        }
    }
    assert_int_equal(fixture->faults, 0);
}

/** Opens the window. */
static int open_window(void **state) {
    static Fixture fixture;
    Error error = {0};
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    setenv("SDL_RENDER_DRIVER", "software", 1);
    language_init();
    bind_catalogues();
    if (!typeface_find()) {
        return 0;
    }
    fixture.scene = load_scene(FIXTURE_SCENE);
    const RenderSettings settings = {.engine = engine_find("auto", &error),
                                     .threads = 1,
                                     .width = 320,
                                     .height = 240,
                                     .samples = 1,
                                     .trace = {.depth = 8, .epsilon = 1e-4}};
    fixture.window.help.commands = command_table;
    fixture.window.state.scene = fixture.scene;
    if (!video_start(&error) || !window_open(&fixture.window, fixture.scene, &settings, "dioptre",
                                             SDL_RegisterEvents(1), &error)) {
        print_error("%s\n", error.message);
        return -1;
    }
    fixture.window.first_present_time = clock_now_seconds(); // Widgets come here, not later.
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

#endif
