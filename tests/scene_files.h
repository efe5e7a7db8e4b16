/**
 * @file
 * @brief What tests of scene files share: a shape of their own, and checks.
 */
#ifndef DIOPTRE_SCENE_FILES_H
#define DIOPTRE_SCENE_FILES_H

#include "fixtures.h"

#include "dioptre/script.h"

/** Number of items of an array. */
#define COUNT(array) (sizeof(array) / sizeof *(array))

// --- a shape of our own, so that these tests do not hang on the tracer --------------------------

/** A shape with a field of every type. */
typedef struct Ball {
    Vector3 center;  /**< A vector. */
    double radius;   /**< A number, above 0. */
    Vector3 axis;    /**< A direction. */
    Color tint;      /**< A colour, 0 to 1. */
    int rings;       /**< A whole number, 0 to 9. */
    bool is_hollow;  /**< A boolean. */
    int finish;      /**< A word. */
    double diameter; /**< Worked out from the radius. */
    Pair spot;       /**< Two numbers. */
} Ball;

/** Words of the field `finish`. */
static const char *const finish_words[] = {"matt", "satin", "glossy", NULL};

/** Fields of the shape; the first is row 0. */
static const Parameter ball_parameters[] = {
    {.name = "center",
     .type = PARAMETER_POINT,
     .offset = offsetof(Ball, center),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM},
    {.name = "radius",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(Ball, radius),
     .maximum = LENGTH_MAXIMUM,
     .above_minimum = true},
    {.name = "axis",
     .type = PARAMETER_DIRECTION,
     .offset = offsetof(Ball, axis),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM},
    {.name = "tint", .type = PARAMETER_COLOR, .offset = offsetof(Ball, tint), .maximum = 1},
    {.name = "rings", .type = PARAMETER_INTEGER, .offset = offsetof(Ball, rings), .maximum = 9},
    {.name = "hollow", .type = PARAMETER_BOOLEAN, .offset = offsetof(Ball, is_hollow)},
    {.name = "finish",
     .type = PARAMETER_WORD,
     .offset = offsetof(Ball, finish),
     .words = finish_words},
    {.name = "spot", .type = PARAMETER_PAIR, .offset = offsetof(Ball, spot), .maximum = 1},
    {0}};

/** A ball as it is when nothing is said. */
static const Ball ball_defaults = {.radius = 1, .axis = {0, 1, 0}, .tint = {1, 1, 1}};

/** Bits of the rows that were given: hollow and rings. */
enum { GIVEN_RINGS = 1 << 4, GIVEN_HOLLOW = 1 << 5 };

/** Works the diameter out; rings do not go with hollow. See #Keyword.finish. @param values A #Ball.
 *  @param given See there. @param error See there. @return See there. */
static inline bool ball_finish(void *values, uint64_t given, Error *error) {
    Ball *ball = values;
    ball->diameter = 2 * ball->radius;
    if ((given & GIVEN_RINGS) && (given & GIVEN_HOLLOW)) {
        return error_set(error, STATUS_SCENE, "sphere takes rings or hollow, not both");
    }
    return true;
}

/** A shape that these tests call sphere. */
static const Keyword ball_keyword = {.name = "sphere",
                                     .parameters = ball_parameters,
                                     .size = sizeof(Ball),
                                     .defaults = &ball_defaults,
                                     .finish = ball_finish};
/** Another, to tell kinds apart. */
static const Keyword other_keyword = {.name = "plane",
                                      .parameters = ball_parameters,
                                      .size = sizeof(Ball),
                                      .defaults = &ball_defaults};
/** What the scenes of these tests can name. */
static const Keyword *const shapes[] = {&other_keyword, &ball_keyword, NULL};

// --- helpers -------------------------------------------------------------------------------------

/** Makes a folder, and the path of a scene file in it. @param[out] state The fixture.
 *  @return 0 when it is there. */
static inline int enter_scene_folder(void **state) {
    bool is_made = enter_folder(state) == 0;
    if (is_made) {
        path_of(state, "scene.lua");
    }
    return is_made ? 0 : -1;
}

/** Writes a text file. @param path Where. @param text What. */
static inline void store_text(const char *path, const char *text) {
    store(path, text, strlen(text));
}

/** @return What to ask for, with limits that are wide enough. @param path The scene file. */
static inline ScriptRequest request_for(const char *path) {
    return (ScriptRequest){
        .path = path, .seconds = SCRIPT_SECONDS, .memory = SCRIPT_MEMORY, .shape_keywords = shapes};
}

/** @return The scene of a text, which must be good. @param fixture Where. @param text The text. */
static inline Scene *load_good(const Fixture *fixture, const char *text) {
    Error error = {0};
    store_text(fixture->path, text);
    ScriptRequest request = request_for(fixture->path);
    Scene *scene = script_load(&request, &error);
    if (!scene) {
        fail_msg("%s\n%s", text, error.message);
    }
    assert_int_equal(error.status, STATUS_DONE);
    return scene;
}

/**
 * Checks that a scene is refused.
 * @param request  What to load.
 * @param place    How the message must begin.
 * @param words    What must be in it.
 */
static inline void assert_refused(const ScriptRequest *request, const char *place,
                                  const char *words) {
    Error error = {0};
    Scene *scene = script_load(request, &error);
    if (scene || error.status != STATUS_SCENE ||
        strncmp(error.message, place, strlen(place)) != 0 || !strstr(error.message, words)) {
        fail_msg("wanted: %s%s\ngot: (%d) %s", place, words, error.status,
                 scene ? "a scene" : error.message);
    }
}

/**
 * Checks that a text is refused.
 * @param fixture  Where to put it.
 * @param text     The text.
 * @param line     The line that must be named.
 * @param words    What must be said.
 * @param limits   Its seconds and memory count; NULL: wide enough.
 */
static inline void assert_text_refused(const Fixture *fixture, const char *text, int line,
                                       const char *words, const ScriptRequest *limits) {
    char place[PATH_MAX + 32];
    ScriptRequest request = request_for(fixture->path);
    if (limits) {
        request.seconds = limits->seconds;
        request.memory = limits->memory;
    }
    store_text(fixture->path, text);
    snprintf(place, sizeof place, "%s:%d: ", fixture->path, line);
    assert_refused(&request, place, words);
}

/** Checks a colour. @param c The colour. @param r Wanted. @param g Wanted. @param b Wanted. */
static inline void assert_color(Color c, double r, double g, double b) {
    assert_true(c.red == r && c.green == g && c.blue == b);
}

/** A wrong scene. */
typedef struct WrongCase {
    const char *text;  /**< The scene. */
    int line;          /**< The line that is to blame. */
    const char *words; /**< What must be said. */
} WrongCase;

/** Each wrong text is refused with its line and the right words. @param state The fixture.
 *  @param cases The texts. @param count How many. */
static inline void assert_all_refused(void **state, const WrongCase *cases, size_t count) {
    for (size_t i = 0; i < count; i++) {
        assert_text_refused(*state, cases[i].text, cases[i].line, cases[i].words, NULL);
    }
}

#endif
