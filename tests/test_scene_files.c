/**
 * @file
 * @brief Tests of the sources of scenes: files, included files, standard input.
 */
#include "scene_files.h"

#include "assets/images/image_file.h"

#include <fcntl.h>
#include <unistd.h>

/** Folder of the scene files of these tests, relative to the project. */
#define SCRIPTS "tests/scripts/"

/** A scene file can include files in its folder. */
static void test_include(void **state) {
    (void)state;
    ScriptRequest request = script_request_for(SCRIPTS "room.lua");
    Error error = {0};
    Scene *scene = script_load(&request, &error);
    assert_string_equal(error.message, "");
    assert_non_null(scene);
    assert_int_equal(scene->shape_count, 3);
    assert_int_equal(scene->shapes[2].material_index, 1);
    assert_color(scene->materials[1].color, 1, 0, 0);
    scene_destroy(scene);
}

/** An error is reported in the included file that contains it; circular includes are refused. */
static void test_wrong_includes(void **state) {
    (void)state;
    ScriptRequest request = script_request_for(SCRIPTS "wrong-part.lua");
    assert_scene_refused(&request, SCRIPTS "parts/wrong.lua:2: ", "radius must be");
    request = script_request_for(SCRIPTS "ring.lua");
    assert_scene_refused(&request, SCRIPTS "ring.lua:3: ", "more than 32 deep");
}

/**
 * Only text files inside the scene's folder can be included. A file outside is refused with the
 * words for one that does not exist, so that a script cannot look for files.
 */
static void test_include_stays_inside(void **state) {
    const Fixture *fixture = *state;
    char path[192], outside[192], text[256];
    snprintf(outside, sizeof outside, "%s-outside.lua", fixture->folder);
    write_text(outside, "ambient(1)");
    snprintf(path, sizeof path, "%s/link.lua", fixture->folder);
    assert_int_equal(symlink(outside, path), 0);
    snprintf(path, sizeof path, "%s/fifo.lua", fixture->folder);
    assert_int_equal(mkfifo(path, 0600), 0);
    snprintf(path, sizeof path, "%s/compiled.lua", fixture->folder);
    write_text(path, "\x1BLua");
    snprintf(text, sizeof text, "\ninclude '../%s'", strrchr(outside, '/') + 1);
    assert_text_refused(fixture, text, 2, "No such file in the scene's folder", NULL);
    snprintf(text, sizeof text, "\ninclude '%s'", outside);
    assert_text_refused(fixture, text, 2, "from the scene file", NULL);
    static const InvalidScene cases[] = {
        {"\ninclude 'link.lua'", 2,
         "cannot include `link.lua`: No such file in the scene's folder"},
        {"\ninclude '/etc/passwd'", 2, "from the scene file"},
        {"\ninclude 'none.lua'", 2,
         "cannot include `none.lua`: No such file in the scene's folder"},
        {"\ninclude '.'", 2, "this is a folder"},
        {"\ninclude ''", 2, "No such file in the scene's folder"},
        {"\ninclude 'fifo.lua'", 2, "not a regular file"},
        {"\ninclude 'compiled.lua'", 2, "compiled Lua"},
        {"\ninclude 'a\\0b'", 2, "zero byte"},
        {"\ninclude {}", 2, "bad argument #1 to 'include'"},
        {"\ninclude(('x'):rep(1e5))", 2, "cannot include"},
    };
    assert_all_refused(state, cases, COUNT(cases));
    unlink(outside);
}

/** Includes that fail in pcall do not count towards the depth. */
static void test_include_depth_is_given_back(void **state) {
    const Fixture *fixture = *state;
    char path[128];
    snprintf(path, sizeof path, "%s/broken.lua", fixture->folder);
    write_text(path, "error('broken')");
    Scene *scene =
        load_valid_scene(fixture, "camera {}\nfor i = 1, 99 do pcall(include, 'broken.lua') end\n"
                                  "assert(not pcall(include, 'broken.lua'))");
    scene_destroy(scene);
}

/** Anything that is not a regular file is refused without waiting. */
static void test_no_scene_files(void **state) {
    const Fixture *fixture = *state;
    ScriptRequest request = script_request_for("no/such/file.lua");
    assert_scene_refused(&request, "no/such/file.lua: ", "No such file or directory");
    request.path = fixture->folder;
    assert_scene_refused(&request, fixture->folder, ": this is a folder");
    request.path = "/dev/zero";
    assert_scene_refused(&request, "/dev/zero: ", "not a regular file");
    char path[128];
    snprintf(path, sizeof path, "%s/fifo", fixture->folder);
    assert_int_equal(mkfifo(path, 0600), 0);
    request.path = path;
    assert_scene_refused(&request, path, ": not a regular file");
    assert_text_refused(fixture, "\x1BLuaS\n\n", 1, "compiled Lua", NULL);
    request.path = fixture->path;
    write_file(fixture->path, "camera {}\n\nx = '\0'", 18);
    char location[PATH_MAX + 32];
    snprintf(location, sizeof location, "%s:3: ", fixture->path);
    assert_scene_refused(&request, location, "not text");
    assert_int_equal(truncate(fixture->path, 17 << 20), 0);
    assert_scene_refused(&request, fixture->path, ": longer than 16 MiB");
    if (geteuid() != 0 && chmod(fixture->path, 0) == 0) {
        assert_scene_refused(&request, fixture->path, ": Permission denied");
        chmod(fixture->path, 0600);
    }
}

/** Messages contain the whole path, although Lua cuts chunk names at 60 bytes. */
static void test_long_paths(void **state) {
    static const char *const texts[] = {"\nsphere { radius = -1 }", "\n= 1", "\nlocal x = nil + 1",
                                        "\ninclude 'part.lua'"};
    const Fixture *fixture = *state;
    char folder[400], path[420], part[420], location[430];
    snprintf(folder, sizeof folder, "%s/%0*d", fixture->folder, 200, 0);
    assert_int_equal(mkdir(folder, 0700), 0);
    snprintf(path, sizeof path, "%s/s.lua", folder);
    snprintf(part, sizeof part, "%s/part.lua", folder);
    write_text(part, "\nsphere { radius = -1 }");
    for (size_t i = 0; i < COUNT(texts); i++) {
        write_text(path, texts[i]);
        ScriptRequest request = script_request_for(path);
        snprintf(location, sizeof location, "%s:2: ", i == 3 ? part : path);
        assert_scene_refused(&request, location, "");
    }
}

/** Messages contain only the end of a path that would fill them. */
static void test_endless_paths(void **state) {
    (void)state;
    char path[1500];
    memset(path, 'x', sizeof path);
    path[sizeof path - 1] = '\0';
    ScriptRequest request = script_request_for(path);
    assert_scene_refused(&request, "...xxx", "xxx: File name too long");
}

/** A scene can be read from standard input. */
static void test_standard_input(void **state) {
    const Fixture *fixture = *state;
    write_text(fixture->path, "camera {} include 'parts/balls.lua'\nballs(2, nil)\nballs(1, 2)");
    int saved_fd = dup(STDIN_FILENO), file = open(fixture->path, O_RDONLY);
    dup2(file, STDIN_FILENO);
    ScriptRequest request = script_request_for("-");
    request.base_dir = SCRIPTS;
    assert_scene_refused(&request, SCRIPTS "/parts/balls.lua:3: ", "material must be");
    lseek(STDIN_FILENO, 0, SEEK_SET);
    request.base_dir = NULL;
    assert_scene_refused(&request, "-:1: ", "cannot include `parts/balls.lua`");
    dup2(saved_fd, STDIN_FILENO);
    close(saved_fd);
    close(file);
}

/** The scene records whether its script uses the time. */
static void test_time(void **state) {
    static const char *const texts[] = {"camera {}", "camera {} local t = 1; local x = t",
                                        "camera {} t = 2; local x = t", "camera {} local x = t",
                                        "camera {} local x = _ENV['t']"};
    for (size_t i = 0; i < COUNT(texts); i++) {
        Scene *scene = load_valid_scene(*state, texts[i]);
        assert_int_equal(scene->is_time_dependent, i >= 3);
        scene_destroy(scene);
    }
}

/** @return A scene loaded with an asset cache. */
static Scene *load_with_cache(const char *path, double time, AssetCache *cache) {
    ScriptRequest request = script_request_for(path);
    Error error = {0};
    request.time = time;
    request.cache = cache;
    Scene *scene = script_load(&request, &error);
    assert_string_equal(error.message, "");
    return scene;
}

/**
 * Assets that do not depend on the time are read once and shared; assets no longer named are
 * released.
 */
static void test_asset_cache(void **state) {
    const Fixture *fixture = *state;
    char path[192];
    Picture picture;
    Error error = {0};
    snprintf(path, sizeof path, "%s/p.bmp", fixture->folder);
    assert_true(picture_init(&picture, 2, 1, &error));
    assert_true(image_file_write(path, &picture, &error));
    picture_deinit(&picture);
    write_text(fixture->path, "camera { position = {t, 0, 5} }\n"
                              "if t ~= 2 then sky { image = 'p.bmp' } end");
    AssetCache *cache = asset_cache_create(&error);
    Scene *first = load_with_cache(fixture->path, 0, cache);
    unlink(fixture->path);
    Scene *second = load_with_cache(fixture->path, 1, cache);
    Texture *texture = second->textures[0].texture;
    assert_ptr_equal(first->textures[0].texture, texture);
    assert_true(second->camera.position.x == 1);
    scene_destroy(first);
    assert_int_equal(texture->reference_count, 2);
    scene_destroy(load_with_cache(fixture->path, 2, cache));
    assert_int_equal(texture->reference_count, 1);
    asset_cache_destroy(cache);
    assert_int_equal(texture->width, 2);
    scene_destroy(second);
}

/** Loading stops on request, long before its time limit. */
static void test_stop(void **state) {
    const Fixture *fixture = *state;
    atomic_bool stop = true;
    ScriptRequest request = script_request_for(fixture->path);
    request.stop = &stop;
    write_text(fixture->path, "while true do end");
    Error error = {0};
    alarm(5);
    assert_null(script_load(&request, &error));
    alarm(0);
    assert_int_equal(error.status, STATUS_INTERRUPTED);
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_include),
        cmocka_unit_test(test_wrong_includes),
        cmocka_unit_test(test_include_stays_inside),
        cmocka_unit_test(test_include_depth_is_given_back),
        cmocka_unit_test(test_no_scene_files),
        cmocka_unit_test(test_long_paths),
        cmocka_unit_test(test_endless_paths),
        cmocka_unit_test(test_standard_input),
        cmocka_unit_test(test_time),
        cmocka_unit_test(test_asset_cache),
        cmocka_unit_test(test_stop),
    };
    return cmocka_run_group_tests_name("scene_files", tests, scene_fixture_set_up,
                                       fixture_tear_down);
}
