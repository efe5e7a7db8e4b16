/**
 * @file
 * @brief Shared helpers for tests of scene files: a test shape, and checks.
 */
#ifndef DIOPTRE_SCENE_FILES_H
#define DIOPTRE_SCENE_FILES_H

#include "fixtures.h"

#include "script/script_worker.h"

// --- a test shape, so that these tests do not depend on the tracer -------------------------------

/** A shape with a field of every type. */
typedef struct TestBall {
    Vec3d center;    /**< A vector. */
    double radius;   /**< A number, above 0. */
    Vec3d axis;      /**< A direction. */
    Rgbd tint;       /**< A colour, each channel 0 to 1. */
    int rings;       /**< A whole number, 0 to 9. */
    bool is_hollow;  /**< A boolean. */
    int finish;      /**< One of #finish_words. */
    double diameter; /**< Derived from the radius. */
    Uvd uv;          /**< Two numbers. */
} TestBall;

/** Words of the field `finish`. */
static const char *const finish_words[] = {"matt", "satin", "glossy", NULL};

/** Fields of the shape; their index is the bit in Keyword::finish. */
static const Parameter ball_parameters[] = {
    {.name = "center",
     .type = PARAMETER_POINT,
     .offset = offsetof(TestBall, center),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM},
    {.name = "radius",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(TestBall, radius),
     .maximum = LENGTH_MAXIMUM,
     .excludes_minimum = true},
    {.name = "axis",
     .type = PARAMETER_DIRECTION,
     .offset = offsetof(TestBall, axis),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM},
    {.name = "tint", .type = PARAMETER_COLOR, .offset = offsetof(TestBall, tint), .maximum = 1},
    {.name = "rings", .type = PARAMETER_INTEGER, .offset = offsetof(TestBall, rings), .maximum = 9},
    {.name = "hollow", .type = PARAMETER_BOOLEAN, .offset = offsetof(TestBall, is_hollow)},
    {.name = "finish",
     .type = PARAMETER_CHOICE,
     .offset = offsetof(TestBall, finish),
     .choices = finish_words},
    {.name = "spot", .type = PARAMETER_UV, .offset = offsetof(TestBall, uv), .maximum = 1},
    {0}};

/** The default parameters. */
static const TestBall ball_defaults = {.radius = 1, .axis = {0, 1, 0}, .tint = {1, 1, 1}};

/** Bits of the fields `rings` and `is_hollow`. */
enum { HAS_RINGS = 1 << 4, HAS_HOLLOW = 1 << 5 };

/**
 * Computes the diameter; refuses rings on a hollow ball. See #Keyword.finish.
 * @return false on error.
 */
static inline bool ball_finish(void *values, uint64_t given, Error *error) {
    TestBall *ball = values;
    ball->diameter = 2 * ball->radius;
    if ((given & HAS_RINGS) && (given & HAS_HOLLOW)) {
        return error_set(error, STATUS_SCENE, "sphere takes rings or hollow, not both");
    }
    return true;
}

/** A shape class with the keyword `sphere`. */
static const Keyword ball_keyword = {.name = "sphere",
                                     .parameters = ball_parameters,
                                     .size = sizeof(TestBall),
                                     .defaults = &ball_defaults,
                                     .finish = ball_finish};
/** A second shape class. */
static const Keyword other_keyword = {.name = "plane",
                                      .parameters = ball_parameters,
                                      .size = sizeof(TestBall),
                                      .defaults = &ball_defaults};
/** The shape classes of these tests. */
static const Keyword *const shapes[] = {&other_keyword, &ball_keyword, NULL};

// --- the worker: this program itself, which alone has these shapes -------------------------------

/** Runs the text of a scene. See #WorkerTask.run. */
static void run_test_scene(WorkerJob *job) {
    script_worker_scene(job, shapes);
}

/** Runs as a worker if this process was started as one; glibc calls it before main. */
__attribute__((constructor)) static void act_as_worker(int argc, char **argv) {
    static const WorkerTask tasks[] = {{SCRIPT_SCENE_TASK, run_test_scene}, {0}};
    if (worker_is_requested(argc, argv)) {
        worker_main(argv, tasks);
    }
}

// --- helpers -------------------------------------------------------------------------------------

/** Creates a folder, and the path of a scene file in it. @return 0 on success. */
static inline int scene_fixture_set_up(void **state) {
    bool is_made = fixture_set_up(state) == 0;
    if (is_made) {
        fixture_path(state, "scene.lua");
    }
    return is_made ? 0 : -1;
}

/** Writes a text file. */
static inline void write_text(const char *path, const char *text) {
    write_file(path, text, strlen(text));
}

/** @return A request with sufficient limits. */
static inline ScriptRequest script_request_for(const char *path) {
    return (ScriptRequest){.path = path,
                           .time_limit = SCRIPT_TIME_LIMIT,
                           .memory_limit = SCRIPT_MEMORY_LIMIT,
                           .shape_keywords = shapes,
                           .worker = "/proc/self/exe"};
}

/** @return The scene of a valid text. */
static inline Scene *load_valid_scene(const Fixture *fixture, const char *text) {
    Error error = {0};
    write_text(fixture->path, text);
    ScriptRequest request = script_request_for(fixture->path);
    Scene *scene = script_load(&request, &error);
    if (!scene) {
        fail_msg("%s\n%s", text, error.message);
    }
    assert_int_equal(error.status, STATUS_OK);
    return scene;
}

/**
 * Asserts that a scene is refused.
 * @param location  Beginning of the message.
 * @param words  A part of the message.
 */
static inline void assert_scene_refused(const ScriptRequest *request, const char *location,
                                        const char *words) {
    Error error = {0};
    Scene *scene = script_load(request, &error);
    if (scene || error.status != STATUS_SCENE ||
        strncmp(error.message, location, strlen(location)) != 0 || !strstr(error.message, words)) {
        fail_msg("wanted: %s%s\ngot: (%d) %s", location, words, error.status,
                 scene ? "a scene" : error.message);
    }
}

/**
 * Asserts that a text is refused.
 * @param fixture  Its folder.
 * @param line  Line in the message.
 * @param limits  Time and memory limits; NULL: sufficient ones.
 */
static inline void assert_text_refused(const Fixture *fixture, const char *text, int line,
                                       const char *words, const ScriptRequest *limits) {
    char location[PATH_MAX + 32];
    ScriptRequest request = script_request_for(fixture->path);
    if (limits) {
        request.time_limit = limits->time_limit;
        request.memory_limit = limits->memory_limit;
    }
    write_text(fixture->path, text);
    snprintf(location, sizeof location, "%s:%d: ", fixture->path, line);
    assert_scene_refused(&request, location, words);
}

/** Asserts the channels of a colour. */
static inline void assert_color(Rgbd c, double r, double g, double b) {
    assert_true(c.red == r && c.green == g && c.blue == b);
}

/** An invalid scene. */
typedef struct InvalidScene {
    const char *text;    /**< The scene. */
    int line;            /**< Expected line of the error. */
    const char *message; /**< Expected message. */
} InvalidScene;

/** Asserts that each invalid text is refused with its line and message. */
static inline void assert_all_refused(void **state, const InvalidScene *cases, size_t count) {
    for (size_t i = 0; i < count; i++) {
        assert_text_refused(*state, cases[i].text, cases[i].line, cases[i].message, NULL);
    }
}

#endif
