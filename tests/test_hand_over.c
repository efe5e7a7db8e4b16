/**
 * @file
 * @brief Tests of what a worker hands over that a stranger's file has got hold of: scenes, lessons,
 *        reports, pictures. This program is its own worker.
 */
#include "fixtures.h"
#include "load_scene.h"

#include "assets/images/image_file.h"
#include "assets/images/image_worker.h"
// cmocka has a type of the same name.
#define SourceLocation ReportLocation
#include "script/script_question.h"
#include "script/script_result.h"
#undef SourceLocation

#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

/* --- scenes ----------------------------------------------------------------------------------- */

/** A scene with all that a block can hold. */
static const char SCENE[] =
    "camera { position = {0, 1, 6}, look_at = {0, 0, 0} }\n"
    "image { width = 8, height = 6, depth = 3 }\n"
    "sky { image = 'a.bmp' } ambient(0.1)\n"
    "light { position = {3, 4, 5} } sun { direction = {1, -1, 0} }\n"
    "local m = material { color = 0.5, reflectivity = 0.2, texture = 'a.bmp' }\n"
    "sphere { radius = 1, material = m } sphere { center = {2, 0, 0}, scale = 2 }\n"
    "cylinder { top = {0, 2, 0}, capped = true }\n"
    "triangle { a = {0, 0, 0}, b = {1, 0, 0}, c = {0, 1, 0} }\n"
    "sdf { distance.union(distance.box {}, distance.torus {}:translate{1, 0, 0}) }\n"
    "sdf { function(x, y, z) return x * x + y * y + z * z - 1 end }\n"
    "if t > 1 then box {} end\n";

/** A scene, and its bytes as the worker sent them. */
typedef struct SentScene {
    Scene *scene; /**< The scene. */
    char *bytes;  /**< A copy of its block. */
    size_t size;  /**< Bytes of both. */
} SentScene;

/** Restores the bytes of a scene. */
static void sent_scene_reset(SentScene *sent) {
    memcpy(sent->scene, sent->bytes, sent->size);
}

/** Loads the scene, and takes its picture away again. @return It. */
static SentScene sent_scene_create(void **state) {
    Picture picture = {0};
    Error error = {0};
    assert_true(picture_init(&picture, 2, 2, &error));
    assert_true(image_file_write(fixture_path(state, "a.bmp"), &picture, &error));
    picture_deinit(&picture);
    write_file(fixture_path(state, "s.lua"), SCENE, sizeof SCENE - 1);
    SentScene sent = {.scene = load_scene(fixture_path(state, "s.lua"))};
    sent.size = scene_block_size(sent.scene);
    for (size_t i = 0; i < sent.scene->texture_count; i++) {
        texture_release(sent.scene->textures[i].texture);
        sent.scene->textures[i].texture = NULL;
    }
    sent.bytes = malloc(sent.size);
    assert_non_null(sent.bytes);
    memcpy(sent.bytes, sent.scene, sent.size);
    assert_true(scene_validate(sent.scene, sent.size, scene_shape_keywords, &error));
    return sent;
}

/** Frees a scene. */
static void sent_scene_destroy(SentScene *sent) {
    sent_scene_reset(sent);
    scene_destroy(sent->scene);
    free(sent->bytes);
}

/** Asserts that the scene as it is now is refused, and restores it. */
static void assert_refused(SentScene *sent, const char *what) {
    Error error = {0};
    if (scene_validate(sent->scene, sent->size, scene_shape_keywords, &error)) {
        fail_msg("%s is not refused", what);
    }
    assert_int_equal(error.status, STATUS_SCENE);
    assert_int_equal(sent->scene->mesh_count + sent->scene->texture_count, 0);
    sent_scene_reset(sent);
}

/** Changes an expression of a sent scene, which must then be refused. */
#define REFUSED(sent, lvalue, value)                                                               \
    do {                                                                                           \
        (lvalue) = (value);                                                                        \
        assert_refused(sent, #lvalue " = " #value);                                                \
    } while (0)

/** @return A pointer to a byte of a bool, which may then get any value. */
static unsigned char *byte_of(const bool *flag) {
    return (unsigned char *)(uintptr_t)flag;
}

/** Every index, pointer, flag and number that leads astray is refused. */
static void test_scene_fields(void **state) {
    SentScene sent = sent_scene_create(state);
    Scene *scene = sent.scene;
    SphereParameters *sphere = (void *)(uintptr_t)scene->shapes[0].parameters;
    CylinderParameters *cylinder = (void *)(uintptr_t)scene->shapes[2].parameters;
    SdfShapeParameters *field = (void *)(uintptr_t)scene->shapes[4].parameters;
    Sdf *sdf = (void *)(uintptr_t)field->field;
    assert_ptr_equal(scene, sent.scene);
    REFUSED(&sent, scene->shapes[0].class_index, SIZE_MAX);
    REFUSED(&sent, scene->shapes[0].class_index, 10);
    REFUSED(&sent, scene->shapes[0].material_index, scene->material_count);
    REFUSED(&sent, scene->shapes[0].parameters, NULL);
    REFUSED(&sent, scene->shapes[0].parameters, &sent);
    REFUSED(&sent, scene->shapes[0].parameters, (char *)scene + 8);
    REFUSED(&sent, scene->shapes[0].parameters, scene);
    REFUSED(&sent, scene->shapes[0].parameters, scene->shapes[1].parameters);
    REFUSED(&sent, scene->shapes[0].parameters, (const char *)sphere + 8);
    REFUSED(&sent, scene->shapes[0].parameters, (char *)scene + sent.size - 8);
    REFUSED(&sent, scene->shapes[1].transform, (const Transform *)(void *)scene->lights);
    REFUSED(&sent, ((Transform *)(uintptr_t)scene->shapes[1].transform)->matrix[1][1], (double)NAN);
    REFUSED(&sent, ((Transform *)(uintptr_t)scene->shapes[1].transform)->scale.x, 1e9);
    REFUSED(&sent, scene->shapes[0].origin.number, -1);
    REFUSED(&sent, scene->shapes[0].origin.line, -1);
    REFUSED(&sent, scene->lights[0].origin.number, -1);
    REFUSED(&sent, scene->materials[1].origin.line, -1);
    REFUSED(&sent, scene->shapes, NULL);
    REFUSED(&sent, scene->shapes, scene->shapes + 1);
    REFUSED(&sent, scene->shape_count, SIZE_MAX / 2);
    REFUSED(&sent, scene->shape_count, scene->shape_count + 1000);
    REFUSED(&sent, scene->lights, (SceneLight *)(void *)scene->shapes);
    REFUSED(&sent, scene->lights[0].class_index, 99);
    REFUSED(&sent, scene->lights[0].intensity, (double)NAN);
    REFUSED(&sent, scene->lights[0].own[7], HUGE_VAL);
    REFUSED(&sent, scene->lights[0].falloff, -1);
    REFUSED(&sent, scene->material_count, 0);
    REFUSED(&sent, scene->materials[1].texture_id, 2);
    REFUSED(&sent, scene->materials[1].color.green, (double)NAN);
    REFUSED(&sent, scene->materials[1].color.green, 7);
    REFUSED(&sent, scene->sky.texture_id, SIZE_MAX);
    REFUSED(&sent, scene->camera.position.x, (double)NAN);
    REFUSED(&sent, scene->camera.target_distance, HUGE_VAL);
    REFUSED(&sent, scene->camera.fov, 180);
    REFUSED(&sent, scene->image.width, 0);
    REFUSED(&sent, scene->image.height, 1 << 30);
    REFUSED(&sent, scene->image.encoding, 77);
    REFUSED(&sent, scene->image.depth, 257);
    REFUSED(&sent, scene->ambient.blue, (double)NAN);
    REFUSED(&sent, *byte_of(&scene->has_camera), 2);
    REFUSED(&sent, *byte_of(&scene->is_time_dependent), 255);
    REFUSED(&sent, *byte_of(&cylinder->capped), 2);
    REFUSED(&sent, sphere->radius, -1);
    REFUSED(&sent, sphere->radius, (double)NAN);
    REFUSED(&sent, field->field, NULL);
    REFUSED(&sent, field->field, (const Sdf *)(void *)&sent);
    REFUSED(&sent, field->max_steps, -1);
    REFUSED(&sent, sdf->node_count, 1 << 20);
    REFUSED(&sent, sdf->node_count, -1);
    REFUSED(&sent, *byte_of(&sdf->is_exact), 3);
    REFUSED(&sent, sdf->low.x, (double)NAN);
    REFUSED(&sent, sdf->depth, 1000);
    REFUSED(&sent, sdf->nodes[0].op, SDF_ROUND);
    REFUSED(&sent, sdf->nodes[1].body_count, 4000);
    REFUSED(&sent, scene->textures[0].texture, (Texture *)(void *)scene->lights);
    REFUSED(&sent, scene->textures[0].file.path, (const char *)&sent);
    REFUSED(&sent, scene->textures[0].file.name, NULL);
    REFUSED(&sent, *(char *)(uintptr_t)scene->textures[0].file.location, '\33');
    REFUSED(&sent, scene->texture_count, 2);
    REFUSED(&sent, scene->mesh_count, 1);
    REFUSED(&sent, scene->note_count, scene->note_count + 1000);
    // A string to the end of the block.
    memset((char *)(uintptr_t)scene->textures[0].file.location, 'x',
           sent.size - (size_t)(scene->textures[0].file.location - (const char *)scene));
    assert_refused(&sent, "a string without an end");
    size_t size = sent.size;
    for (sent.size = 0; sent.size < size; sent.size += size / 7 + 1) {
        Error error = {0};
        assert_false(scene_validate(scene, sent.size, scene_shape_keywords, &error));
        memcpy(scene, sent.bytes, size);
    }
    sent.size = size;
    assert_true(scene_validate(scene, sent.size, scene_shape_keywords, NULL));
    sent_scene_destroy(&sent);
}

/** Uses all of a scene that was found valid; only the sanitizers can object. */
static void use_scene(Scene *scene, Texture *texture) {
    double rgb[3 * 4];
    Error error = {0};
    RayCounts counts = {0};
    const Engine *engine = engine_find("f64x1", &error);
    const TraceSettings settings = {.depth = 2, .samples = 1, .offset = OFFSET_BOUND};
    const PixelGrid grid = {.columns = 2, .rows = 2, .stride = 1};
    for (size_t i = 0; i < scene->texture_count; i++) {
        scene->textures[i].texture = texture_retain(texture);
    }
    Tracer *tracer = engine ? engine->create_tracer(scene, &settings, &error) : NULL;
    if (tracer) {
        engine->set_view(tracer, scene, 2, 2);
        engine->trace(tracer, &grid, rgb, &counts);
        engine->destroy(tracer);
    }
    for (size_t i = 0; i < scene->texture_count; i++) {
        texture_release(texture);
    }
}

/** Whatever word of a scene is changed: it is refused, or can be used. */
static void test_scene_words(void **state) {
    /** Every how many of the valid scenes are drawn; all are too slow with sanitizers. */
    const int interval = 5;
    SentScene sent = sent_scene_create(state);
    Error error = {0};
    Texture *texture = texture_create(2, 2, false, &error);
    const uint64_t start = (uint64_t)(uintptr_t)sent.scene;
    const uint64_t values[] = {0,
                               1,
                               2,
                               UINT64_MAX,
                               INT32_MAX,
                               (uint64_t)INT32_MAX << 32,
                               0x7FF8000000000000,
                               0x7FEFFFFFFFFFFFFF,
                               0x0202020202020202,
                               start,
                               start + 4096,
                               start + sent.size - 16,
                               start + sent.size};
    int refused = 0, valid = 0;
    for (size_t offset = 0; offset + sizeof *values <= sent.size; offset += sizeof *values) {
        for (size_t i = 0; i < sizeof values / sizeof *values; i++) {
            memcpy((char *)sent.scene + offset, &values[i], sizeof *values);
            if (!scene_validate(sent.scene, sent.size, scene_shape_keywords, &error)) {
                refused++;
            } else if (valid++ % interval == 0) {
                use_scene(sent.scene, texture);
            }
            sent_scene_reset(&sent);
        }
    }
    print_message("%d refused, %d valid\n", refused, valid);
    assert_true(refused > 1000 && valid > 1000);
    texture_release(texture);
    sent_scene_destroy(&sent);
}

/* --- lessons and reports ---------------------------------------------------------------------- */

/** Every index, text, flag and number of a lesson that leads astray is refused. */
static void test_lessons(void **state) {
    (void)state;
    enum { ACTIONS = 3 };
    Error error = {0};
    Lesson *lesson = lesson_create(&error);
    assert_non_null(lesson);
    strcpy(lesson->scene, "box.lua");
    lesson->title.english = lesson_store_text(lesson, "Title", &error);
    LessonStep caption = {.kind = LESSON_CAPTION, .time = 5};
    caption.text.french = lesson_store_text(lesson, "Légende", &error);
    const LessonStep press = {.kind = LESSON_PRESS, .action = 2};
    LessonQuestion question = {.choice_count = 2, .right = 1};
    question.text.english = lesson_store_text(lesson, "Which?", &error);
    question.choices[0].english = question.choices[1].french = question.text.english;
    question.because.english = lesson_store_text(lesson, "So", &error);
    lesson->learnt[0] = question.because;
    lesson->learnt_count = 1;
    const LessonStep drag = {
        .kind = LESSON_DRAG, .time = 5, .x = 2e6, .y = -LENGTH_MAXIMUM, .z = 1};
    const LessonStep select = {.kind = LESSON_SELECT, .time = 8, .action = 1};
    const LessonStep set = {.kind = LESSON_SET, .time = 8, .action = 1, .row = 1, .x = 2};
    assert_true(lesson_add(lesson, &press, &error) && lesson_add(lesson, &caption, &error) &&
                lesson_add(lesson, &drag, &error));
    assert_true(lesson_add_question(lesson, &question, 6, &error));
    const size_t chosen = lesson->count;
    assert_true(lesson_add(lesson, &select, &error) && lesson_add(lesson, &set, &error));
    const size_t size = lesson_block_size(lesson);
    Lesson *copy = malloc(sizeof *copy);
    assert_non_null(copy);
    memcpy(copy, lesson, sizeof *copy);
    assert_true(lesson_validate(lesson, size, ACTIONS, &error));
    assert_false(lesson_validate(lesson, size - 1, ACTIONS, &error));
    assert_false(lesson_validate(lesson, 0, ACTIONS, &error));
    assert_false(lesson_validate(lesson, size, 2, &error));
#define LESSON_REFUSED(lvalue, value)                                                              \
    do {                                                                                           \
        (lvalue) = (value);                                                                        \
        if (lesson_validate(lesson, size, ACTIONS, &error)) {                                      \
            fail_msg(#lvalue " = " #value " is not refused");                                      \
        }                                                                                          \
        memcpy(lesson, copy, sizeof *copy);                                                        \
    } while (0)
    LESSON_REFUSED(lesson->steps[0].center[2], NAN);
    LESSON_REFUSED(lesson->steps[0].center[0], -2 * LENGTH_MAXIMUM);
    LESSON_REFUSED(lesson->initial_settings.move_speed, -1);
    LESSON_REFUSED(lesson->initial_settings.move_speed, NAN);
    LESSON_REFUSED(lesson->count, LESSON_STEPS_MAXIMUM + 1);
    LESSON_REFUSED(lesson->count, SIZE_MAX);
    LESSON_REFUSED(lesson->text_used, SIZE_MAX);
    LESSON_REFUSED(lesson->text[lesson->text_used - 1], 'x');
    LESSON_REFUSED(lesson->title.english, "outside");
    LESSON_REFUSED(lesson->title.french, lesson->text + lesson->text_used);
    LESSON_REFUSED(lesson->steps[1].text.french, (const char *)lesson);
    LESSON_REFUSED(*byte_of(&lesson->steps[1].waits_for_viewer), 2);
    LESSON_REFUSED(lesson->steps[1].kind, (LessonStepKind)77);
    LESSON_REFUSED(lesson->steps[1].time, -1);
    LESSON_REFUSED(lesson->steps[chosen].keyword, -1);
    LESSON_REFUSED(lesson->steps[chosen].keyword, 1000);
    LESSON_REFUSED(lesson->steps[chosen].action, -1);
    LESSON_REFUSED(lesson->steps[chosen + 1].keyword, 1000);
    LESSON_REFUSED(lesson->steps[chosen + 1].row, -1);
    LESSON_REFUSED(lesson->steps[chosen + 1].row, 1000);
    LESSON_REFUSED(lesson->steps[chosen + 1].action, 0);
    LESSON_REFUSED(lesson->steps[chosen + 1].x, -1);
    LESSON_REFUSED(lesson->steps[chosen + 1].x, (double)NAN);
    LESSON_REFUSED(*byte_of(&lesson->steps[chosen + 1].continues), 2);
    LESSON_REFUSED(lesson->steps[0].time, 6);
    LESSON_REFUSED(lesson->steps[0].action, ACTIONS);
    LESSON_REFUSED(lesson->steps[0].action, -1);
    LESSON_REFUSED(lesson->steps[0].x, (double)NAN);
    LESSON_REFUSED(lesson->steps[0].y, 1e300);
    LESSON_REFUSED(lesson->steps[2].action, -1);
    LESSON_REFUSED(lesson->steps[2].action, LESSON_LIGHTS_MAXIMUM);
    LESSON_REFUSED(lesson->steps[2].x, 2 * LENGTH_MAXIMUM);
    LESSON_REFUSED(lesson->steps[2].z, -2 * LENGTH_MAXIMUM);
    LESSON_REFUSED(lesson->steps[2].z, (double)NAN);
    LESSON_REFUSED(lesson->steps[3].action, 1);
    LESSON_REFUSED(lesson->steps[3].action, -1);
    LESSON_REFUSED(lesson->steps[3].kind, (LessonStepKind)-1);
    LESSON_REFUSED(lesson->question_count, 0);
    LESSON_REFUSED(lesson->question_count, LESSON_QUESTIONS_MAXIMUM + 1);
    LESSON_REFUSED(lesson->questions[0].choice_count, 1);
    LESSON_REFUSED(lesson->questions[0].choice_count, LESSON_CHOICES_MAXIMUM + 1);
    LESSON_REFUSED(lesson->questions[0].right, 2);
    LESSON_REFUSED(lesson->questions[0].right, -1);
    LESSON_REFUSED(lesson->questions[0].text.french, "outside");
    LESSON_REFUSED(lesson->questions[0].choices[1].english, (const char *)lesson);
    LESSON_REFUSED(lesson->questions[0].because.french, lesson->text + lesson->text_used);
    LESSON_REFUSED(lesson->learnt_count, LESSON_LEARNT_MAXIMUM + 1);
    LESSON_REFUSED(lesson->learnt[0].english, "outside");
    LESSON_REFUSED(lesson->initial_settings.engine, "f32x8");
    LESSON_REFUSED(lesson->initial_settings.samples, -1);
    LESSON_REFUSED(lesson->initial_settings.depth, 1000);
    LESSON_REFUSED(lesson->initial_settings.offset, 3);
    LESSON_REFUSED(lesson->initial_settings.width, 1 << 20);
    LESSON_REFUSED(lesson->initial_settings.epsilon, (double)NAN);
    LESSON_REFUSED(lesson->initial_settings.time, HUGE_VAL);
    memset(lesson->scene, 'x', sizeof lesson->scene);
    assert_false(lesson_validate(lesson, size, ACTIONS, &error));
    free(copy);
    lesson_destroy(lesson);
}

/** @return Whether the program answers a question. */
static bool is_answered(ScriptResponder *responder, ScriptQuestionKind kind, const char *name) {
    ScriptQuestion question = {.kind = (int)kind};
    WorkerResponse response = {0};
    snprintf(question.text, sizeof question.text, "%s", name);
    bool is_valid = script_question_answer(responder, &question, sizeof question, &response);
    if (response.file > 0) {
        close(response.file);
    }
    return is_valid;
}

/** A worker learns of no other files than what it runs may name. */
static void test_questions(void **state) {
    (void)state;
    const ScriptRequest request = {.path = "scenes/box.lua"};
    ScriptResponder *scene = calloc(1, sizeof *scene), *lesson = calloc(1, sizeof *lesson);
    assert_true(scene && lesson);
    *scene = (ScriptResponder){.request = &request};
    *lesson = (ScriptResponder){.request = &request, .is_lesson = true};
    assert_true(is_answered(scene, SCRIPT_ASK_ASSET, "pictures/die.png"));
    assert_true(is_answered(scene, SCRIPT_ASK_INCLUDE, "box.lua"));
    assert_int_equal(scene->answer.error.status, STATUS_OK);
    assert_true(is_answered(scene, SCRIPT_ASK_INCLUDE, "/etc/passwd"));
    assert_int_equal(scene->answer.error.status, STATUS_SCENE);
    assert_false(is_answered(scene, SCRIPT_ASK_SCENE, "/etc/passwd"));
    assert_false(is_answered(scene, (ScriptQuestionKind)77, "box.lua"));
    assert_false(is_answered(lesson, SCRIPT_ASK_ASSET, "pictures/die.png"));
    assert_false(is_answered(lesson, SCRIPT_ASK_INCLUDE, "box.lua"));
    assert_true(is_answered(lesson, SCRIPT_ASK_SCENE, "box.lua"));
    assert_false(is_answered(lesson, SCRIPT_ASK_SCENE, "/etc/passwd"));
    free(lesson);
    free(scene);
}

/** A report of any bytes becomes one whose line can be printed. */
static void test_reports(void **state) {
    (void)state;
    for (int byte = 1; byte < 256; byte += 127) {
        char text[ERROR_MESSAGE_SIZE];
        ScriptResult *result = script_result_create("s.lua");
        assert_non_null(result);
        memset(result, byte, sizeof *result);
        script_result_repair(result, "s.lua");
        assert_true(result->error.status == STATUS_SCENE || result->error.status == STATUS_FAILED);
        assert_true(strlen(result->error.message) < ERROR_MESSAGE_SIZE);
        assert_null(strpbrk(result->error.message, "\33\1\a"));
        script_result_format_location(result, result->location, text, sizeof text);
        assert_string_equal(text, "s.lua:1");
        script_result_destroy(result);
    }
}

/* --- pictures --------------------------------------------------------------------------------- */

/** The report of the picture worker, see image_worker.c. */
typedef struct PictureReport {
    int is_done; /**< Whether there is a picture. */
    Error error; /**< What is wrong. */
} PictureReport;

/** A picture of floats that a worker hands over, followed by its texels. */
static struct {
    Texture head;    /**< Its head. */
    float texels[6]; /**< Two texels. */
} handed;

/** Prepares a picture of two texels. */
static void hand_over(WorkerJob *job, int width, int height, unsigned char is_hdr) {
    static PictureReport report = {.is_done = 0x02020202};
    handed.head.width = width;
    handed.head.height = height;
    handed.head.reference_count = 77;
    memcpy(&handed.head.is_hdr, &is_hdr, sizeof is_hdr);
    const float texels[] = {NAN, -1, 1e30F, HUGE_VALF, 0.5F, -HUGE_VALF};
    memcpy(handed.texels, texels, sizeof texels);
    job->report = &report;
    job->report_size = sizeof report;
    job->block = &handed;
    job->block_size = sizeof handed.head + sizeof handed.texels;
    worker_job_ready();
}

/** Hands over a picture with numbers that are none. */
static void numbers_task(WorkerJob *job) {
    hand_over(job, 2, 1, 1);
}

/** Hands over a picture with a flag that is no bool. */
static void flag_task(WorkerJob *job) {
    hand_over(job, 2, 1, 2);
}

/** Hands over a picture that is larger than its bytes. */
static void large_task(WorkerJob *job) {
    hand_over(job, 3, 1, 1);
}

/** Hands over a picture of which the number of bytes overflows. */
static void negative_task(WorkerJob *job) {
    hand_over(job, -2, -1, 1);
}

/** Hands over a piece of a head. */
static void short_task(WorkerJob *job) {
    hand_over(job, 2, 1, 1);
    job->block_size = 3;
}

/** Hands over nothing, and says that it did. */
static void nothing_task(WorkerJob *job) {
    hand_over(job, 2, 1, 1);
    job->block_size = 0;
}

/** Reports an error of any bytes. */
static void error_task(WorkerJob *job) {
    static PictureReport report;
    memset(&report.error, 'x', sizeof report.error);
    job->report = &report;
    job->report_size = sizeof report;
    worker_job_ready();
}

/** The tasks of this program. */
static const WorkerTask tasks[] = {{"numbers", numbers_task}, {"flag", flag_task},
                                   {"large", large_task},     {"negative", negative_task},
                                   {"short", short_task},     {"nothing", nothing_task},
                                   {"error", error_task},     {0}};

/** A picture is refused unless its head agrees with its bytes; its numbers are made valid. */
static void test_pictures(void **state) {
    (void)state;
    const ImageReadLimits limits = {
        .time_limit = 10, .memory_limit = 1 << 20, .texture_capacity = 1 << 20};
    const ImageSource source = {.format = "png"};
    for (const WorkerTask *task = tasks; task->name; task++) {
        const ImageWorker worker = {"/proc/self/exe", task->name};
        Texture *texture;
        Error error = {0};
        bool is_read = image_worker_call(&worker, &source, &limits, NULL, &texture, &error);
        assert_int_equal(is_read, task == tasks);
        assert_int_equal(error.status, is_read ? STATUS_OK : STATUS_SCENE);
        assert_true(strlen(error.message) < ERROR_MESSAGE_SIZE);
        if (is_read) {
            const float *texels = texture_hdr_texels(texture);
            for (int i = 0; i < 6; i++) {
                assert_true(texels[i] >= 0 && texels[i] <= (float)INTENSITY_MAXIMUM);
            }
            texture_release(texture);
        }
    }
}

/** Runs the tests. @return 0 if all pass. */
int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_scene_fields, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_scene_words, fixture_set_up, fixture_tear_down),
        cmocka_unit_test(test_lessons),
        cmocka_unit_test(test_questions),
        cmocka_unit_test(test_reports),
        cmocka_unit_test(test_pictures),
    };
    if (worker_is_requested(argc, argv)) {
        worker_main(argv, tasks);
    }
    return cmocka_run_group_tests_name("hand-over", tests, NULL, NULL);
}
