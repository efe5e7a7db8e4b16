/**
 * @file
 * @brief Tests of changes of objects: selecting, undo and redo, the object as text, its values
 * written into the scene file, copies of the file, and all reasons why not.
 *
 * The window is SDL's dummy one. The scene is loaded anew as the window does it.
 */
#include "app_window.h"

/** The scene file: the third and the fourth sphere come of one line, the fifth of another file. */
static const char SCENE[] = "-- a comment that stays\n"
                            "camera { position = {0, 0, 6}, look_at = {0, 0, 0} }\n"
                            "light { position = {1, 2, 3} }\n"
                            "material { color = {1, 0, 0} }\n"
                            "sphere { center = {0, 0, 0}, radius = 1 }\n"
                            "sphere { center = {3, 0, 0}, radius = 1 } -- right\n"
                            "for i = 1, 2 do sphere { center = {i, 2, 0}, radius = 0.25 } end\n"
                            "include \"part.lua\"\n"
                            "sdf { field = distance.sphere { radius = 0.1 } }\n";

/** @return The x of a sphere's centre, or another number of a field. */
static double number_of(int sphere, const char *field) {
    double numbers[PARAMETER_NUMBERS_MAXIMUM];
    SceneObject object;
    int keyword = scene_object_keyword_find("sphere");
    assert_true(scene_object_find(opened.app.scene, keyword, sphere, &object));
    scene_object_get(&object, scene_object_row_find(keyword, field), numbers);
    return numbers[0];
}

/** Opens the window. @return 0 if it is open. */
static int set_up(void **state) {
    (void)state;
    return open_app_window(SCENE, "sphere { center = {-3, 0, 0}, radius = 1 }\n");
}

/** Selects an object. */
static void choose(const char *keyword, int number) {
    edits_select(&opened.app, scene_object_keyword_find(keyword), number, NULL);
}

/** Gives a sphere a radius. */
static void set_radius(int sphere, double radius) {
    int keyword = scene_object_keyword_find("sphere");
    const SceneOverride edit = {
        keyword, sphere, scene_object_row_find(keyword, "radius"), {radius}};
    edits_set(&opened.app, &edit, false);
}

/** What the picture shows is selected; the next and the one before, in the file's order. */
static void test_select(void **state) {
    (void)state;
    App *app = &opened.app;
    const ObjectInspector *inspector = &app->window.object_inspector;
    int sphere = scene_object_keyword_find("sphere");
    Vec3d point;
    edits_click(app, 0.5, 0.5);
    assert_int_equal(inspector->keyword, sphere);
    assert_int_equal(inspector->number, 1);
    assert_true(edits_point_at(app, 0.5, 0.5, &point));
    assert_at_most(fabs(point.z - 1), 1e-2, "where the sphere is hit");
    assert_true(edits_grab(app, 0.5, 0.5, &point));
    edits_select_next(app, 1);
    assert_int_equal(inspector->number, 2);
    assert_false(edits_grab(app, 0.5, 0.5, &point));
    edits_select_next(app, -1);
    edits_select_next(app, -1);
    assert_false(scene_object_is_shape(inspector->keyword)); // Round the list: the light.
    edits_click(app, 0.01, 0.01);
    assert_int_equal(inspector->number, 0);
    assert_false(edits_close(app));
    edits_select_next(app, 1);
    assert_int_equal(inspector->number, 1); // What is in the middle.
    assert_true(edits_close(app));
    edits_click_light(app, 0);
    assert_false(scene_object_is_shape(inspector->keyword));
    assert_int_equal(inspector->number, 1);
}

/** A change is seen in the scene, taken back, and done again; a wrong one is refused. */
static void test_undo(void **state) {
    (void)state;
    App *app = &opened.app;
    edits_undo(app);
    assert_status("there is nothing to undo");
    edits_redo(app);
    assert_status("there is nothing to do again");
    set_radius(2, 0.5);
    assert_true(settle());
    assert_true(number_of(2, "radius") == 0.5);
    edits_undo(app);
    assert_true(settle());
    assert_true(number_of(2, "radius") == 1);
    edits_redo(app);
    assert_true(settle());
    assert_true(number_of(2, "radius") == 0.5);
    set_radius(2, -1);
    assert_status("radius");
    assert_true(settle());
    assert_true(number_of(2, "radius") == 0.5);
    set_radius(9, 1);
    assert_status("there is no such object");
    edits_move(app, scene_object_keyword_find("sphere"), 1, (Vec3d){0.25, 0, 0}, false);
    assert_true(settle());
    assert_true(number_of(1, "center") == 0.25);
}

/** What is dragged moves in steps that one undo takes back. */
static void test_drag(void **state) {
    (void)state;
    App *app = &opened.app;
    choose("sphere", 2);
    edits_drag(app, (Vec3d){0.5, 0, 0}, false);
    edits_drag(app, (Vec3d){0.5, 0, 0}, true);
    assert_true(settle());
    assert_true(number_of(2, "center") == 4);
    edits_undo(app);
    assert_true(settle());
    assert_true(number_of(2, "center") == 3);
}

/** The selected object is copied as text of the scene language. */
static void test_copy(void **state) {
    (void)state;
    App *app = &opened.app;
    edits_copy(app);
    assert_status("nothing is selected");
    choose("sphere", 2);
    edits_copy(app);
    char *text = SDL_GetClipboardText();
    assert_non_null(strstr(text, "sphere {"));
    assert_non_null(strstr(text, "center = {3, 0, 0}"));
    SDL_free(text);
    choose("sdf", 1);
    edits_copy(app);
    assert_status("a distance field is a program");
}

/** Values are written at the object's line; all else of the file stays. */
static void test_write(void **state) {
    (void)state;
    App *app = &opened.app;
    edits_write(app);
    assert_status("nothing is selected");
    choose("sphere", 2);
    edits_write(app);
    assert_status("nothing of it has changed");
    set_radius(2, 0.5);
    assert_true(settle());
    edits_write(app);
    assert_status("1 value written into");
    char expected[sizeof SCENE + 16];
    strcpy(expected, SCENE);
    char *place = strstr(expected, "radius = 1 } -- right");
    memmove(place + strlen("radius = 0.5"), place + strlen("radius = 1"),
            strlen(place + strlen("radius = 1")) + 1);
    memcpy(place, "radius = 0.5", strlen("radius = 0.5"));
    assert_string_equal(file_text("scene.lua"), expected);
    assert_true(settle());
    assert_true(number_of(2, "radius") == 0.5);
    // Undo leads back to the file's first value.
    edits_undo(app);
    assert_true(settle());
    assert_true(number_of(2, "radius") == 1);
    edits_write(app);
    assert_status("1 value written into");
    assert_string_equal(file_text("scene.lua"), SCENE);
}

/** Leaving asks once where objects were changed; a pupil presses Esc once too often. */
static void test_leave(void **state) {
    (void)state;
    App *app = &opened.app;
    choose("sphere", 2);
    set_radius(2, 0.5);
    assert_true(settle());
    run("leave");
    run("leave");
    assert_status("leave again to lose them");
    assert_false(app->exit.is_requested);
    run("leave");
    assert_true(app->exit.is_requested);
}

/** What cannot be written is said, and the file stays as it is. */
static void test_not_written(void **state) {
    (void)state;
    App *app = &opened.app;
    set_radius(3, 0.5);
    assert_true(settle());
    choose("sphere", 3);
    edits_write(app);
    assert_status("line 7 makes 2 objects");
    edits_undo(app);
    set_radius(5, 0.5);
    assert_true(settle());
    choose("sphere", 5);
    edits_write(app);
    assert_status("sphere 5 is made in an included file");
    assert_string_equal(file_text("scene.lua"), SCENE);
    edits_undo(app);
    set_radius(2, 0.5);
    assert_true(settle());
    choose("sphere", 2);
    strcpy(app->source.path, "-");
    edits_write(app);
    assert_status("a scene from standard input has no file");
    edits_save_copy(app);
    assert_status("a scene from standard input has no file");
    strcpy(app->source.path, opened.path);
    struct stat info;
    assert_int_equal(stat(opened.path, &info), 0);
    assert_int_equal(truncate(opened.path, info.st_size - 1), 0); // Its last newline.
    edits_write(app);
    assert_status("the file has changed");
    assert_int_equal(strlen(file_text("scene.lua")), sizeof SCENE - 2);
}

/** While a faulty text cannot be shown, objects on screen stand at lines of an older one: nothing
 * is written at these, into the file or a copy. */
static void test_faulty_text(void **state) {
    (void)state;
    static const char faulty[] = "sphere { radius = 2 }\nsphere {\n";
    App *app = &opened.app;
    write_text("scene.lua", faulty);
    current_scene_on_file_event(app);
    assert_false(settle());
    choose("sphere", 2);
    set_radius(2, 0.5);
    settle();
    edits_write(app);
    assert_status("the file has changed");
    edits_save_copy(app);
    assert_status("the file has changed");
    assert_string_equal(file_text("scene.lua"), faulty);
    write_text("scene.lua", SCENE);
    current_scene_on_file_event(app);
    assert_true(settle());
    set_radius(2, 0.5);
    assert_true(settle());
    edits_write(app);
    assert_status("1 value written into");
}

/** A change that is refused takes nothing from what can be done again. */
static void test_refused_keeps_redo(void **state) {
    (void)state;
    App *app = &opened.app;
    const double fov = app->scene->camera.fov;
    app_zoom(app, 1);
    edits_undo(app);
    assert_true(app->scene->camera.fov == fov);
    set_radius(2, -1);
    edits_redo(app);
    assert_true(app->scene->camera.fov < fov);
}

/** A copy of the file has the changes of all objects, and the file none; copies are numbered. */
static void test_save_copy(void **state) {
    (void)state;
    App *app = &opened.app;
    set_radius(1, 0.75);
    set_radius(2, 0.5);
    assert_true(settle());
    edits_save_copy(app);
    assert_status("2 values written into");
    assert_string_equal(file_text("scene.lua"), SCENE);
    const char *copy = strrchr(app->title.status_text, '/');
    assert_non_null(copy);
    char name[64];
    snprintf(name, sizeof name, "%s", copy + 1);
    assert_non_null(strstr(file_text(name), "sphere { center = {0, 0, 0}, radius = 0.75 }\n"));
    assert_non_null(strstr(file_text(name), "radius = 0.5 } -- right\n"));
    edits_save_copy(app);
    assert_string_not_equal(strrchr(app->title.status_text, '/') + 1, name);
    opened.settings.snapshot_dir = "/none";
    edits_save_copy(app);
    assert_status("not written: ");
    opened.settings.snapshot_dir = app_folder();
    set_radius(4, 0.5);
    assert_true(settle());
    edits_save_copy(app);
    assert_status("line 7 makes 2 objects");
}

/** A file that becomes wrong leaves the last scene; when it is right again, it is shown. */
static void test_faulty_file(void **state) {
    (void)state;
    App *app = &opened.app;
    Scene *before = app->scene;
    write_text("scene.lua", "camera {}\nspher {}\n");
    current_scene_on_file_event(app);
    assert_false(settle());
    assert_true(app->scene == before && app->source.has_load_error);
    write_text("scene.lua", "camera {}\nlight {}\nsphere { radius = 2 }\n");
    current_scene_on_file_event(app);
    assert_true(settle());
    assert_false(app->source.has_load_error);
    assert_true(number_of(1, "radius") == 2);
    // Another file has its own objects.
    char other[PATH_MAX];
    strcpy(other, write_text("other.lua", "camera {}\nlight {}\nsphere { radius = 3 }\n"));
    choose("sphere", 1);
    current_scene_open(app, other);
    assert_true(settle());
    assert_true(number_of(1, "radius") == 3);
    assert_int_equal(app->window.object_inspector.number, 0);
    assert_string_equal(app->source.path, other);
    current_scene_open(app, "/none/scene.lua");
    assert_false(settle());
    assert_string_equal(app->source.failed_path, "/none/scene.lua");
    assert_true(number_of(1, "radius") == 3);
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_select, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_undo, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_drag, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_copy, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_write, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_leave, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_not_written, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_save_copy, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_faulty_file, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_faulty_text, set_up, close_app_window),
        cmocka_unit_test_setup_teardown(test_refused_keeps_redo, set_up, close_app_window),
    };
    return cmocka_run_group_tests_name("changes of objects", tests, NULL, NULL);
}
