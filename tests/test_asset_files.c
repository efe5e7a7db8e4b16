/**
 * @file
 * @brief Tests of the files that a scene names: that none lies outside its folder, even if links
 *        are swapped meanwhile, and that all together keep to one budget.
 */
#include "refused_call.h"
#include "scene_files.h"

#include "assets/images/image_file.h"
#include "assets/images/texture_file.h"
#include "assets/meshes/mesh_file.h"
#include "script/asset_path.h"

#include <fcntl.h>
#include <signal.h>
#include <stddef.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

/** A name that a scene may not read: outside, or nowhere. */
#define REFUSED "No such file in the scene's folder"

/** Size of a path of these tests. */
enum { PATH_SIZE = 192 };

// --- helpers -------------------------------------------------------------------------------------

/** Makes the path of a file in the folder of the test. */
static void copy_path(void **state, const char *name, char path[PATH_SIZE]) {
    const Fixture *fixture = *state;
    snprintf(path, PATH_SIZE, "%s/%s", fixture->folder, name);
}

/** Makes the folder `scene` with a file, and a file outside it. */
static void make_files(void **state) {
    assert_int_equal(mkdir(fixture_path(state, "scene"), 0700), 0);
    assert_int_equal(mkdir(fixture_path(state, "scene/sub"), 0700), 0);
    write_text(fixture_path(state, "scene/inside"), "in");
    write_text(fixture_path(state, "scene/sub/inside"), "in");
    write_text(fixture_path(state, "secret"), "out");
}

/** Creates a folder with the files of these tests. @return 0 on success. */
static int asset_fixture_set_up(void **state) {
    symlink_plugin("dioptre-meshes.so");
    symlink_plugin("dioptre-images.so");
    bool is_made = fixture_set_up(state) == 0;
    if (is_made) {
        make_files(state);
    }
    return is_made ? 0 : -1;
}

/** Creates a link in the folder of the scene. */
static void link_in_scene(void **state, const char *target, const char *name) {
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "scene/%s", name);
    assert_int_equal(symlink(target, fixture_path(state, path)), 0);
}

/** Opens a file that a scene names. @return Its descriptor, or -1. */
static int open_name(void **state, const char *name, Error *error) {
    char folder[PATH_SIZE], display[PATH_MAX], real[PATH_MAX];
    struct stat info;
    copy_path(state, "scene", folder);
    const ScriptRequest request = {.path = "-", .base_dir = folder};
    return asset_path_open(&request, name, display, real, &info, error);
}

/** @return The text of a file that a scene names; empty if it is refused as if it did not exist. */
static const char *text_of(void **state, const char *name) {
    static char text[16];
    Error error = {0};
    int file = open_name(state, name, &error);
    memset(text, 0, sizeof text);
    if (file >= 0) {
        assert_true(read(file, text, sizeof text - 1) > 0);
        close(file);
    } else if (!strstr(error.message, REFUSED)) {
        fail_msg("%s: %s", name, error.message);
    }
    return text;
}

/** Makes openat2 fail as on an old kernel, in this process. */
static void forbid_openat2(void) {
    assert_true(refuse_call(SYS_openat2));
    assert_int_equal(syscall(SYS_openat2, AT_FDCWD, ".", NULL, 0), -1);
    assert_int_equal(errno, ENOSYS);
}

/** A check, with and without openat2. */
typedef void CheckFunction(void **state);

/** Runs a check, then once more in a process without openat2. */
static void check_twice(void **state, CheckFunction *check) {
    check(state);
    pid_t child = fork();
    if (child == 0) {
        forbid_openat2();
        check(state);
        _exit(0);
    }
    int status = -1;
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
}

// --- paths ---------------------------------------------------------------------------------------

/** Names that lead into the folder are opened, all others look like missing files. */
static void check_names(void **state) {
    static const char *const inside[] = {"inside",        "./inside",      "sub/inside",
                                         "sub/../inside", "relative",      "absolute",
                                         "sub/up",        "folder/inside", "../scene/inside"};
    static const char *const outside[] = {
        "../secret", "sub/../../secret", "out",      "absolute-out", "folder-out/secret",
        "none",      "../none",          "dangling", "ring",         "out/none",
        "",          "inside/none",      "../..",    "proc",         "../scene-twin/secret",
        "none/..",   "root/etc/passwd",  "sub/none"};
    for (size_t i = 0; i < COUNT(inside); i++) {
        assert_string_equal(text_of(state, inside[i]), "in");
    }
    for (size_t i = 0; i < COUNT(outside); i++) {
        assert_string_equal(text_of(state, outside[i]), "");
    }
}

/** Only files beneath the folder are opened, and nothing is told about others. */
static void test_names(void **state) {
    char path[PATH_SIZE];
    assert_int_equal(mkdir(fixture_path(state, "scene-twin"), 0700), 0);
    write_text(fixture_path(state, "scene-twin/secret"), "out");
    link_in_scene(state, "inside", "relative");
    copy_path(state, "scene/inside", path);
    link_in_scene(state, path, "absolute");
    link_in_scene(state, "../inside", "sub/up");
    link_in_scene(state, "sub", "folder");
    link_in_scene(state, "../secret", "out");
    copy_path(state, "secret", path);
    link_in_scene(state, path, "absolute-out");
    link_in_scene(state, "..", "folder-out");
    link_in_scene(state, "../none", "dangling");
    link_in_scene(state, "ring", "ring");
    link_in_scene(state, "/proc/self/exe", "proc");
    link_in_scene(state, "/", "root");
    check_twice(state, check_names);
}

/** Swaps a file in the folder and a link to the file outside, until it is killed. */
static pid_t start_swapper(void **state) {
    char name[PATH_SIZE], link[PATH_SIZE];
    copy_path(state, "scene/raced", name);
    copy_path(state, "scene/raced-link", link);
    pid_t child = fork();
    while (child == 0) {
        syscall(SYS_renameat2, AT_FDCWD, name, AT_FDCWD, link, 2 /* RENAME_EXCHANGE */);
    }
    return child;
}

/** A name that changes between a file inside and one outside never opens the latter. */
static void check_race(void **state) {
    enum { ATTEMPTS = 5000, ATTEMPTS_MAXIMUM = 10000000 };
    bool is_opened = false, is_refused = false;
    pid_t swapper = start_swapper(state);
    for (int i = 0; i < ATTEMPTS || (i < ATTEMPTS_MAXIMUM && !(is_opened && is_refused)); i++) {
        const char *text = text_of(state, "raced");
        is_opened = is_opened || strcmp(text, "in") == 0;
        is_refused = is_refused || text[0] == '\0';
        if (strcmp(text, "out") == 0) {
            kill(swapper, SIGKILL);
            fail_msg("the file outside was opened, attempt %d", i);
        }
    }
    kill(swapper, SIGKILL);
    waitpid(swapper, NULL, 0);
    assert_true(is_opened && is_refused);
}

/** See #check_race. */
static void test_race(void **state) {
    write_text(fixture_path(state, "scene/raced"), "in");
    link_in_scene(state, "../secret", "raced-link");
    check_twice(state, check_race);
}

/** Writes a picture of one colour. */
static void write_picture(const char *path, uint8_t code) {
    Picture picture;
    Error error = {0};
    assert_true(picture_init(&picture, 2, 1, &error));
    memset(picture.pixels, code, 6);
    assert_true(image_file_write(path, &picture, &error));
    picture_deinit(&picture);
}

/**
 * Loads a scene that names a picture, and then waits until that name is another file.
 * @param target  Target of the link that replaces the picture.
 * @return The scene; NULL if it is refused.
 */
static Scene *load_with_swap(void **state, const char *target, Error *error) {
    // The scene cannot wait, but it can see files of its folder appear.
    const char *text = "camera {}\nsky { image = 'x.bmp' }\ninclude 'named.lua'\n"
                       "while not pcall(include, 'go.lua') do end";
    char folder[PATH_SIZE], scene[2 * PATH_SIZE];
    copy_path(state, "scene", folder);
    snprintf(scene, sizeof scene, "%s/s.lua", folder);
    write_text(scene, text);
    unlink(fixture_path(state, "scene/x.bmp"));
    write_picture(fixture_path(state, "scene/x.bmp"), 1);
    unlink(fixture_path(state, "scene/go.lua"));
    write_text(fixture_path(state, "scene/named.lua"), "print('named')");
    // What the scene prints tells this process that it has named the picture.
    int ends[2], saved = dup(STDERR_FILENO);
    assert_int_equal(pipe(ends), 0);
    dup2(ends[1], STDERR_FILENO);
    pid_t swapper = fork();
    if (swapper == 0) {
        char byte;
        close(ends[1]);
        close(STDERR_FILENO);
        if (chdir(folder) != 0 || read(ends[0], &byte, 1) != 1 || unlink("x.bmp") != 0 ||
            symlink(target, "x.bmp") != 0) {
            _exit(1);
        }
        write_text("go.lua", "");
        _exit(0);
    }
    ScriptRequest request = script_request_for(scene);
    Scene *loaded = script_load(&request, error);
    int status = -1;
    dup2(saved, STDERR_FILENO);
    close(saved);
    close(ends[0]);
    close(ends[1]);
    assert_int_equal(waitpid(swapper, &status, 0), swapper);
    if (status != 0) {
        fail_msg("the scene did not name its picture: %s", error->message);
    }
    return loaded;
}

/** A picture that becomes a link after the scene has named it shows nothing from outside. */
static void test_swap_after_check(void **state) {
    Error error = {0};
    write_picture(fixture_path(state, "secret.bmp"), 200);
    write_picture(fixture_path(state, "scene/other.bmp"), 100);
    assert_null(load_with_swap(state, "../secret.bmp", &error));
    assert_non_null(strstr(error.message, "s.lua:2: x.bmp: " REFUSED));
    // A link within the folder is as good as any.
    Scene *scene = load_with_swap(state, "other.bmp", &error);
    assert_non_null(scene);
    assert_int_equal(texture_ldr_texels(scene->textures[0].texture)[0], 100);
    scene_destroy(scene);
}

// --- budget --------------------------------------------------------------------------------------

/** A model of one triangle. */
static const char triangle[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/** @return A whole budget. */
static AssetBudget whole_budget(void) {
    AssetBudget budget;
    asset_budget_init(&budget);
    return budget;
}

/** Asserts that a file is refused for want of a budget. */
static void assert_over_budget(const char *path, AssetBudget budget, const char *words) {
    AssetFile file;
    Mesh *mesh = NULL;
    Texture *texture = NULL;
    Error error = {0};
    assert_true(open_asset(path, &file, &error));
    bool is_read = mesh_file_check(path, NULL)
                       ? mesh_file_read(&file, &budget, NULL, &mesh, &error)
                       : texture_file_read(&file, &budget, &texture, &error);
    close(file.descriptor);
    if (is_read || mesh || texture || error.status != STATUS_SCENE ||
        !strstr(error.message, words)) {
        fail_msg("%s: wanted: %s, got: (%d) %s", path, words, error.status, error.message);
    }
}

/** What is left of memory and time limits each file; its own limits are not named then. */
static void test_budget_of_a_file(void **state) {
    static const char *const names[] = {"m.obj", "p.bmp", "p.png"};
    write_text(fixture_path(state, names[0]), triangle);
    write_picture(fixture_path(state, names[1]), 7);
    write_picture(fixture_path(state, names[2]), 7);
    for (size_t i = 0; i < COUNT(names); i++) {
        AssetBudget budget = whole_budget();
        const char *path = fixture_path(state, names[i]);
        budget.memory = 10;
        assert_over_budget(path, budget, "take more than 2048 MiB of memory together");
        budget = whole_budget();
        budget.seconds = 0;
        if (i != 1) { // A BMP file is read by the program, as fast as it is copied.
            assert_over_budget(path, budget, "take more than 120 s of processor time together");
        }
    }
}

/** What a file has taken is not left for the next. */
static void test_budget_is_spent(void **state) {
    AssetBudget budget = whole_budget();
    AssetFile file;
    Mesh *mesh;
    Texture *texture;
    Error error = {0};
    write_text(fixture_path(state, "m.obj"), triangle);
    assert_true(open_asset(fixture_path(state, "m.obj"), &file, &error));
    assert_true(mesh_file_read(&file, &budget, NULL, &mesh, &error));
    assert_int_equal(budget.memory, ASSET_MEMORY_LIMIT - mesh_block_size(mesh));
    assert_true(budget.seconds < ASSET_TIME_LIMIT && budget.seconds > ASSET_TIME_LIMIT - 10);
    close(file.descriptor);
    mesh_release(mesh);
    budget = whole_budget();
    write_picture(fixture_path(state, "p.png"), 7);
    assert_true(open_asset(fixture_path(state, "p.png"), &file, &error));
    assert_true(texture_file_read(&file, &budget, &texture, &error));
    assert_int_equal(budget.memory, ASSET_MEMORY_LIMIT - texture_block_size(texture));
    assert_true(budget.seconds < ASSET_TIME_LIMIT && budget.seconds > ASSET_TIME_LIMIT - 10);
    close(file.descriptor);
    texture_release(texture);
}

/** Loads a scene in the folder `scene`. @return The scene; NULL if it is refused. */
static Scene *load_in_folder(void **state, const char *text, AssetCache *cache, Error *error) {
    char path[PATH_SIZE];
    copy_path(state, "scene/s.lua", path);
    write_text(path, text);
    ScriptRequest request = script_request_for(path);
    request.cache = cache;
    return script_load(&request, error);
}

/** One file is read once, by whatever names: hard links share its content, also with a cache. */
static void test_hard_links(void **state) {
    const char *text = "camera {}\nmaterial { texture = 'a.bmp' }\nmaterial { texture = 'b.bmp' }\n"
                       "material { texture = 'c.bmp' }\nif t then sky { image = 'a.bmp' } end";
    char first[PATH_SIZE];
    Error error = {0};
    copy_path(state, "scene/a.bmp", first);
    write_picture(first, 9);
    assert_int_equal(link(first, fixture_path(state, "scene/b.bmp")), 0);
    write_picture(fixture_path(state, "scene/c.bmp"), 9);
    AssetCache *cache = asset_cache_create(&error);
    for (int i = 0; i < 3; i++) {
        Scene *scene = load_in_folder(state, text, i ? cache : NULL, &error);
        assert_string_equal(error.message, "");
        assert_int_equal(scene->texture_count, 3);
        assert_ptr_equal(scene->textures[0].texture, scene->textures[1].texture);
        assert_ptr_not_equal(scene->textures[0].texture, scene->textures[2].texture);
        scene_destroy(scene);
    }
    asset_cache_destroy(cache);
}

/** The budget is that of the whole scene: its error names line, file and limit. */
static void test_budget_of_a_scene(void **state) {
    Error error = {0};
    const char *path = fixture_path(state, "scene/big.bmp");
    write_text(path, "BM");
    assert_int_equal(truncate(path, (off_t)3 << 30), 0);
    assert_null(load_in_folder(state, "camera {}\n\nsky { image = 'big.bmp' }", NULL, &error));
    assert_non_null(strstr(error.message, "s.lua:3: big.bmp: the scene's models and pictures are "
                                          "files of more than 2048 MiB together"));
    char name[PATH_SIZE];
    write_picture(fixture_path(state, "scene/n0.bmp"), 1);
    copy_path(state, "scene/n0.bmp", name);
    for (int i = 1; i <= ASSET_COUNT_LIMIT; i++) {
        char other[32];
        snprintf(other, sizeof other, "scene/n%d.bmp", i);
        assert_int_equal(link(name, fixture_path(state, other)), 0);
    }
    char text[128];
    snprintf(text, sizeof text,
             "camera {}\nfor i = 0, %d do material { texture = 'n' .. i .. '.bmp' } end",
             ASSET_COUNT_LIMIT);
    assert_null(load_in_folder(state, text, NULL, &error));
    assert_non_null(strstr(error.message, "s.lua:2: n4096.bmp: a scene may name at most 4096"));
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_names),
        cmocka_unit_test(test_race),
        cmocka_unit_test(test_swap_after_check),
        cmocka_unit_test(test_budget_of_a_file),
        cmocka_unit_test(test_budget_is_spent),
        cmocka_unit_test(test_hard_links),
        cmocka_unit_test(test_budget_of_a_scene),
    };
    return cmocka_run_group_tests_name("asset_files", tests, asset_fixture_set_up,
                                       fixture_tear_down);
}
