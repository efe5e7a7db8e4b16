/**
 * @file
 * @brief Tests of image files: BMP, output paths, and the image plugin.
 */
#include "fixtures.h"

#include "assets/images/image_file.h"
#include "assets/images/texture_file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

/** Size of the buffer for small files, bytes. */
enum { SMALL_FILE_SIZE = 4096 };

// --- helpers -------------------------------------------------------------------------------------

/** Reads a small file. @return Number of bytes. */
static size_t read_file_bytes(const char *path, uint8_t bytes[SMALL_FILE_SIZE]) {
    FILE *stream = fopen(path, "rb");
    assert_non_null(stream);
    size_t size = fread(bytes, 1, SMALL_FILE_SIZE, stream);
    fclose(stream);
    return size;
}

/** Counts the files in the folder, to detect leftover temporary files. @return Number of files. */
static int count_files(void **state) {
    Fixture *fixture = *state;
    DIR *folder = opendir(fixture->folder);
    assert_non_null(folder);
    int count = -2; // Do not count `.` and `..`.
    while (readdir(folder)) {
        count++;
    }
    closedir(folder);
    return count;
}

/**
 * Writes a picture, reads it back and compares.
 * @return Largest difference of a channel, 8-bit steps.
 */
static int round_trip(const char *path, int width, int height) {
    Error error = {0};
    Picture picture = make_test_picture(width, height);
    Picture again;
    if (!image_file_write(path, &picture, &error) || !image_file_read(path, &again, &error)) {
        fail_msg("%s", error.message);
    }
    assert_int_equal(again.width, width);
    assert_int_equal(again.height, height);
    int worst = picture_compare(&picture, &again, NULL).max_difference;
    picture_deinit(&picture);
    picture_deinit(&again);
    return worst;
}

// --- BMP -----------------------------------------------------------------------------------------

/** Reads a texture file, with a whole budget. @return Whether it was read. */
static bool read_texture_file(const char *path, Texture **texture, Error *error) {
    AssetFile file;
    AssetBudget budget;
    *texture = NULL;
    asset_budget_init(&budget);
    if (!open_asset(path, &file, error)) {
        return false;
    }
    bool is_read = texture_file_read(&file, &budget, texture, error);
    close(file.descriptor);
    return is_read;
}

/** A BMP round trip is lossless for every row padding. */
static void test_bmp_round_trip(void **state) {
    for (int width = 1; width <= 9; width++) {
        assert_int_equal(round_trip(fixture_path(state, "a.bmp"), width, 10 - width), 0);
        assert_int_equal(round_trip(fixture_path(state, "UPPER.BMP"), width, width), 0);
    }
    assert_int_equal(round_trip(fixture_path(state, "wide.bmp"), IMAGE_SIZE_MAXIMUM, 1), 0);
    assert_int_equal(round_trip(fixture_path(state, "high.bmp"), 1, IMAGE_SIZE_MAXIMUM), 0);
    assert_int_equal(count_files(state), 4);
}

/** The bytes of a BMP file are those of the format. */
static void test_bmp_bytes(void **state) {
    static const uint8_t expected[] = {
        'B', 'M', 62, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0,
        0,                                   // Size of the file, start of the pixels.
        40, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, // Size of the header, width, height.
        1, 0, 24, 0, 0, 0, 0, 0, 8, 0, 0, 0, // Planes, bits, packing, size of the
                                             // rows.
        0x13, 0x0B, 0, 0, 0x13, 0x0B, 0, 0,  // Pixels per metre.
        0, 0, 0, 0, 0, 0, 0, 0,              // No colour table.
        6, 5, 4, 0, 3, 2, 1, 0,              // The lower row first; blue, green, red.
    };
    uint8_t pixels[] = {1, 2, 3, 4, 5, 6};
    Picture picture = {.width = 1, .height = 2, .pixels = pixels};
    uint8_t bytes[SMALL_FILE_SIZE];
    assert_true(image_file_write(fixture_path(state, "a.bmp"), &picture, NULL));
    assert_int_equal(read_file_bytes(fixture_path(state, "a.bmp"), bytes), sizeof expected);
    assert_memory_equal(bytes, expected, sizeof expected);
}

/** Other kinds of BMP are read: 32 bits, channel masks, top row first. */
static void test_bmp_kinds(void **state) {
    uint8_t bytes[78] = {
        'B', 'M', 78, 0, 0, 0,    0,    0,    0,    0, 66, 0,  0, 0, 40, 0, 0,
        0,   1,   0,  0, 0, 0xFE, 0xFF, 0xFF, 0xFF, 1, 0,  32, 0, 3, 0,  0, 0,
    };
    bytes[56] = bytes[59] = bytes[62] = 0xFF; // The masks.
    memcpy(bytes + 66, "\3\2\1x\6\5\4x", 8);
    static const uint8_t expected[] = {1, 2, 3, 4, 5, 6};
    Picture picture;
    write_file(fixture_path(state, "a.bmp"), bytes, sizeof bytes);
    assert_true(image_file_read(fixture_path(state, "a.bmp"), &picture, NULL));
    assert_int_equal(picture.width, 1);
    assert_int_equal(picture.height, 2);
    assert_memory_equal(picture.pixels, expected, sizeof expected);
    picture_deinit(&picture);
}

/** Asserts that a file is refused with a message. */
static void assert_refused(const char *path) {
    Error error = {0};
    Picture picture;
    if (image_file_read(path, &picture, &error)) {
        fail_msg("%s was read", path);
    }
    assert_null(picture.pixels);
    assert_int_equal(error.status, STATUS_SCENE);
    assert_non_null(strstr(error.message, path));
    assert_true(strlen(error.message) > strlen("cannot read '': ") + strlen(path));
}

/** Invalid headers are refused. */
static void test_bmp_hostile(void **state) {
    static const struct {
        size_t at;      /**< Offset of the changed bytes. */
        int32_t number; /**< The 4 bytes written there. */
    } lies[] = {
        {0, 0},          {10, 53},        {10, 55},          {10, -1},
        {10, INT32_MAX}, {14, 0},         {14, 12},          {14, 39},
        {18, 0},         {18, -1},        {18, 16385},       {18, INT32_MAX},
        {18, INT32_MIN}, {22, 0},         {22, 5},           {22, -5},
        {22, 16385},     {22, INT32_MAX}, {22, INT32_MIN},   {22, INT32_MIN + 1},
        {26, 24 << 16},  {26, 1},         {26, 8 << 16 | 1}, {26, 32 << 16 | 1},
        {26, -1},        {30, 1},         {30, 3},           {30, -1},
        {14, 125},       {14, -1},
    };
    uint8_t bytes[SMALL_FILE_SIZE];
    const char *path = fixture_path(state, "a.bmp");
    assert_int_equal(round_trip(path, 4, 4), 0);
    size_t size = read_file_bytes(path, bytes);
    for (size_t i = 0; i < sizeof lies / sizeof *lies; i++) {
        uint8_t lie[SMALL_FILE_SIZE];
        memcpy(lie, bytes, size);
        memcpy(lie + lies[i].at, &lies[i].number, sizeof lies[i].number);
        write_file(path, lie, size);
        assert_refused(path);
    }
}

/** A truncated file is refused, wherever it ends. */
static void test_bmp_truncated(void **state) {
    uint8_t bytes[SMALL_FILE_SIZE];
    const char *path = fixture_path(state, "a.bmp");
    assert_int_equal(round_trip(path, 3, 3), 0);
    size_t size = read_file_bytes(path, bytes);
    for (size_t cut = 0; cut < size; cut++) {
        write_file(path, bytes, cut);
        assert_refused(path);
    }
}

/** Anything that is not an image file is refused at once. */
static void test_read_what_is_no_file(void **state) {
    assert_refused(fixture_path(state, "missing.bmp"));
    assert_int_equal(mkdir(fixture_path(state, "folder.bmp"), 0777), 0);
    assert_refused(fixture_path(state, "folder.bmp"));
    assert_int_equal(mkfifo(fixture_path(state, "fifo.bmp"), 0666), 0);
    assert_refused(fixture_path(state, "fifo.bmp"));
    assert_refused(fixture_path(state, "a.gif"));
    assert_refused(fixture_path(state, "no-ending"));
}

// --- output paths --------------------------------------------------------------------------------

/**
 * Asserts that a picture cannot be written: the check before and the writing both fail, and no file
 * is left.
 * @param status  Expected status.
 * @param words  Expected part of the message.
 */
static void assert_not_written(void **state, const char *path, Status status, const char *words) {
    int files = count_files(state);
    Picture picture = make_test_picture(20, 20);
    Error error = {0};
    assert_false(image_file_check(path, &error));
    assert_int_equal(error.status, status);
    assert_non_null(strstr(error.message, words));
    error = (Error){0};
    assert_false(image_file_write(path, &picture, &error));
    assert_int_equal(error.status, status);
    assert_non_null(strstr(error.message, words));
    picture_deinit(&picture);
    assert_int_equal(count_files(state), files);
}

/** Asserts that a picture can be written. */
static void assert_written(const char *path) {
    Picture picture = make_test_picture(20, 20);
    Error error = {0};
    if (!image_file_check(path, &error) || !image_file_write(path, &picture, &error)) {
        fail_msg("%s", error.message);
    }
    picture_deinit(&picture);
}

/** Names without a known extension are refused, and the message lists the known ones. */
static void test_endings(void **state) {
    assert_not_written(state, fixture_path(state, "a.gif"), STATUS_USAGE, "png, exr");
    assert_not_written(state, fixture_path(state, "bmp"), STATUS_USAGE, ".bmp");
    assert_not_written(state, fixture_path(state, "a.bmp/b"), STATUS_USAGE, ".bmp");
}

/** A new file has the user's permissions; a replaced file keeps its permissions. */
static void test_permissions(void **state) {
    const char *path = fixture_path(state, "a.bmp");
    struct stat found;
    mode_t old = umask(027);
    assert_written(path);
    umask(old);
    assert_int_equal(stat(path, &found), 0);
    assert_int_equal(found.st_mode & 0777, 0640);
    assert_int_equal(chmod(path, 0606), 0);
    assert_written(path);
    assert_int_equal(stat(path, &found), 0);
    assert_int_equal(found.st_mode & 0777, 0606);
    assert_int_equal(count_files(state), 1);
}

/** Without permission, writing fails with a message. */
static void test_no_permission(void **state) {
    Fixture *fixture = *state;
    const uid_t nobody = 65534;
    uid_t me = geteuid();
    assert_int_equal(chmod(fixture->folder, 0555), 0);
    assert_int_equal(me == 0 ? seteuid(nobody) : 0, 0);
    assert_not_written(state, fixture_path(state, "a.bmp"), STATUS_FAILED, strerror(EACCES));
    assert_int_equal(me == 0 ? seteuid(me) : 0, 0);
    assert_int_equal(chmod(fixture->folder, 0777), 0);
    write_file(fixture_path(state, "a.bmp"), "old", 3);
    assert_int_equal(chmod(fixture_path(state, "a.bmp"), 0444), 0);
    assert_int_equal(me == 0 ? seteuid(nobody) : 0, 0);
    assert_not_written(state, fixture_path(state, "a.bmp"), STATUS_FAILED, strerror(EACCES));
    assert_int_equal(me == 0 ? seteuid(me) : 0, 0);
}

/** Missing folders, and folders in place of the file, are refused. */
static void test_wrong_paths(void **state) {
    char name[400];
    memset(name, 'x', sizeof name);
    strcpy(name + sizeof name - 5, ".bmp");
    assert_not_written(state, fixture_path(state, "none/a.bmp"), STATUS_FAILED, strerror(ENOENT));
    assert_int_equal(mkdir(fixture_path(state, "folder.bmp"), 0777), 0);
    assert_not_written(state, fixture_path(state, "folder.bmp"), STATUS_FAILED, strerror(EISDIR));
    assert_not_written(state, fixture_path(state, name), STATUS_FAILED, strerror(ENAMETOOLONG));
    assert_written(fixture_path(state, name + sizeof name - 255)); // 254 bytes: nearly the maximum.
}

/** A symbolic link is kept, and its target is replaced. */
static void test_links(void **state) {
    struct stat found;
    assert_int_equal(mkdir(fixture_path(state, "folder"), 0777), 0);
    assert_int_equal(symlink("folder/a.bmp", fixture_path(state, "link.bmp")), 0);
    assert_int_equal(symlink("link.bmp", fixture_path(state, "second.bmp")), 0);
    assert_written(fixture_path(state, "second.bmp")); // The link is dangling.
    assert_written(fixture_path(state, "second.bmp"));
    assert_int_equal(lstat(fixture_path(state, "link.bmp"), &found), 0);
    assert_true(S_ISLNK(found.st_mode));
    assert_int_equal(lstat(fixture_path(state, "folder/a.bmp"), &found), 0);
    assert_true(S_ISREG(found.st_mode));
    assert_int_equal(symlink("ring.bmp", fixture_path(state, "ring.bmp")), 0);
    assert_not_written(state, fixture_path(state, "ring.bmp"), STATUS_FAILED, strerror(ELOOP));
    assert_int_equal(count_files(state), 4);
}

/** Devices and FIFOs are written to, not replaced. */
static void test_devices(void **state) {
    struct stat found;
    assert_written("/dev/null");
    assert_int_equal(stat("/dev/null", &found), 0);
    assert_true(S_ISCHR(found.st_mode));
    const char *path = fixture_path(state, "fifo.bmp");
    assert_int_equal(mkfifo(path, 0666), 0);
    int reader = open(path, O_RDONLY | O_NONBLOCK);
    uint8_t bytes[SMALL_FILE_SIZE];
    assert_written(path);
    assert_int_equal(read(reader, bytes, sizeof bytes), 54 + 20 * 20 * 3);
    assert_memory_equal(bytes, "BM", 2);
    close(reader);
    assert_int_equal(lstat(path, &found), 0);
    assert_true(S_ISFIFO(found.st_mode));
    Picture picture = make_test_picture(20, 20);
    Error error = {0};
    assert_false(image_file_write("/dev/full", &picture, &error));
    assert_non_null(strstr(error.message, strerror(ENOSPC)));
    picture_deinit(&picture);
}

/** image_file_write_new() never overwrites a file or a link. */
static void test_never_over(void **state) {
    Picture picture = make_test_picture(3, 2);
    Error error = {0};
    bool exists = true;
    assert_true(image_file_write_new(fixture_path(state, "a.bmp"), &picture, &exists, &error));
    assert_false(exists);
    assert_false(image_file_write_new(fixture_path(state, "a.bmp"), &picture, &exists, &error));
    assert_true(exists);
    assert_non_null(strstr(error.message, strerror(EEXIST)));
    assert_int_equal(symlink("nothing", fixture_path(state, "b.bmp")), 0);
    assert_false(image_file_write_new(fixture_path(state, "b.bmp"), &picture, &exists, &error));
    assert_true(exists);
    assert_false(image_file_write_new(fixture_path(state, "no/c.bmp"), &picture, &exists, &error));
    assert_false(exists);
    assert_int_equal(count_files(state), 2);
    picture_deinit(&picture);
}

/**
 * Asserts that a full disk is reported, and that the old file is kept.
 * @param name Name of the file.
 */
static void assert_full_disk_is_reported(void **state, const char *name) {
    const char *path = fixture_path(state, name);
    Picture picture = make_test_picture(200, 200);
    Error error = {0};
    struct rlimit limit;
    assert_written(path); // The old file; this loads the plugin, too.
    struct stat old;
    assert_int_equal(stat(path, &old), 0);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &limit), 0);
    struct rlimit small = {.rlim_cur = 1000, .rlim_max = limit.rlim_max};
    signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    bool is_written = image_file_write(path, &picture, &error);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &limit), 0);
    assert_false(is_written);
    assert_int_equal(error.status, STATUS_FAILED);
    assert_non_null(strstr(error.message, strerror(EFBIG)));
    struct stat now;
    assert_int_equal(stat(path, &now), 0);
    assert_int_equal(now.st_ino, old.st_ino);
    assert_int_equal(now.st_size, old.st_size);
    picture_deinit(&picture);
}

/** A full disk is reported, and no file is damaged. */
static void test_full_disk(void **state) {
    assert_full_disk_is_reported(state, "a.bmp");
    assert_int_equal(count_files(state), 1);
}

// --- the image plugin ----------------------------------------------------------------------------

/** A missing or invalid plugin is reported. */
static void test_module_is_missing(void **state) {
    Fixture *fixture = *state;
    Error error = {0};
    assert_null(image_plugin_load_from(fixture->folder, &error));
    assert_int_equal(error.status, STATUS_FAILED);
    assert_non_null(strstr(error.message, "libopenimageio-dev"));
    assert_non_null(strstr(error.message, ".bmp"));
    write_file(fixture_path(state, "dioptre-images.so"), "no library", 10);
    assert_null(image_plugin_load_from(fixture->folder, &error));
    assert_non_null(strstr(error.message, "libopenimageio2.4"));
    assert_non_null(strstr(error.message, ".bmp"));
}

/** A fake plugin that crashes. @return Nothing: it does not return. */
static ImageReader *crashing_plugin_open(int file, const char *format, ImageHeader *header,
                                         ImagePluginMessage *message) {
    (void)file;
    (void)format;
    (void)header;
    (void)message;
    abort();
}

/** A fake plugin that is interrupted by Ctrl-C. @return Nothing: it does not return. */
static ImageReader *interrupting_plugin_open(int file, const char *format, ImageHeader *header,
                                             ImagePluginMessage *message) {
    raise(SIGINT);
    return crashing_plugin_open(file, format, header, message);
}

/** A fake plugin that never ends. @return Nothing: it does not return. */
static ImageReader *hanging_plugin_open(int file, const char *format, ImageHeader *header,
                                        ImagePluginMessage *message) {
    (void)header;
    for (;;) {
        __asm__ volatile("");
    }
    return crashing_plugin_open(file, format, header, message);
}

/**
 * A fake plugin that allocates much memory.
 * @param[out] message  Whether the allocation succeeded.
 * @return NULL.
 */
static ImageReader *greedy_plugin_open(int file, const char *format, ImageHeader *header,
                                       ImagePluginMessage *message) {
    (void)file;
    (void)format;
    (void)header;
    void *volatile much = malloc((size_t)256 << 20);
    strcpy(message->text, much ? "got it" : "got nothing");
    free(much);
    return NULL;
}

/** A fake plugin that returns a header with too large a width. @return A reader. */
static ImageReader *lying_plugin_open(int file, const char *format, ImageHeader *header,
                                      ImagePluginMessage *message) {
    (void)file;
    (void)format;
    (void)message;
    *header = (ImageHeader){.width = IMAGE_SIZE_MAXIMUM + 1, .height = 1, .strip_rows = 1};
    return (ImageReader *)header;
}

/** Reads nothing. @return true */
static bool plugin_read_stub(ImageReader *reader, int first, int count, uint8_t *rgb,
                             ImagePluginMessage *message) {
    (void)reader;
    (void)first;
    (void)count;
    (void)rgb;
    (void)message;
    return true;
}

/** Closes nothing. */
static void plugin_close_stub(ImageReader *reader) {
    (void)reader;
}

/** Has read whole files only. */
static bool plugin_is_damaged_stub(ImageReader *reader) {
    (void)reader;
    return false;
}

/** A fake plugin as a worker task. */
#define MODULE_TASK(name, ...)                                                                     \
    static void name##_task(WorkerJob *job) {                                                      \
        static const ImagePlugin module = {__VA_ARGS__};                                           \
        image_worker_read_with(job, &module);                                                      \
    }
MODULE_TASK(crashing, .open = crashing_plugin_open)
MODULE_TASK(interrupting, .open = interrupting_plugin_open)
MODULE_TASK(hanging, .open = hanging_plugin_open)
MODULE_TASK(greedy, .open = greedy_plugin_open)
MODULE_TASK(lying, .open = lying_plugin_open, .read_encoded = plugin_read_stub,
            .is_damaged = plugin_is_damaged_stub, .close = plugin_close_stub)

/** The worker tasks of this program. */
static const WorkerTask module_tasks[] = {
    {"crashing", crashing_task}, {"interrupting", interrupting_task},
    {"hanging", hanging_task},   {"greedy", greedy_task},
    {"lying", lying_task},       {0}};

/** Reads an image with a plugin of #module_tasks, which must fail. @return The error. */
static Error fail_with_module(const char *task, const ImageReadLimits *limits) {
    const ImageWorker worker = {"/proc/self/exe", task};
    Texture *texture;
    Error error = {0};
    assert_false(
        image_worker_call(&worker, &(ImageSource){"png", 0}, limits, NULL, &texture, &error));
    assert_null(texture);
    return error;
}

/** Resource limits of a fake plugin. */
static const ImageReadLimits small_limits = {
    .time_limit = 10, .memory_limit = 1 << 20, .texture_capacity = 1 << 20};

/** A crash of a plugin does not crash the program. */
static void test_module_crashes(void **state) {
    (void)state;
    Error error = fail_with_module("crashing", &small_limits);
    assert_int_equal(error.status, STATUS_SCENE);
    assert_non_null(strstr(error.message, "crash"));
}

/** Ctrl-C while an image is read is reported, without an error of the file. */
static void test_module_interrupted(void **state) {
    (void)state;
    assert_int_equal(fail_with_module("interrupting", &small_limits).status, STATUS_INTERRUPTED);
}

/** Time, memory and texture size are limited. */
static void test_module_limits(void **state) {
    (void)state;
    static const struct {
        const char *task;       /**< A fake plugin. */
        ImageReadLimits limits; /**< Its limits. */
        const char *words;      /**< Expected part of the message. */
    } cases[] = {
        {"hanging", {0.3, 1 << 20, 1 << 20, false, false}, "more than 0 s"},
        {"greedy", {10, 1 << 20, 1 << 20, false, false}, "got nothing"},
        {"lying", {10, 1 << 20, 1 << 10, false, false}, "more than 0 MiB"},
        {"lying", {10, 1 << 20, 1 << 20, false, false}, "go astray"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Error error = fail_with_module(cases[i].task, &cases[i].limits);
        assert_int_equal(error.status, STATUS_SCENE);
        assert_non_null(strstr(error.message, cases[i].words));
    }
}

/** Links the plugin. Its tests are skipped if it was not built. */
static void require_plugin(void) {
    symlink_plugin("dioptre-images.so");
    Error error = {0};
    if (!image_plugin_load(&error)) {
        print_message("%s\n", error.message);
        skip();
    }
}

/** The formats of the plugin, and the tolerance of a round trip. */
static const struct {
    const char *name; /**< Name of the file. */
    int steps;        /**< Largest difference of a channel, 8-bit steps. */
} module_formats[] = {
    {"a.png", 0}, {"a.tif", 0}, {"a.TIFF", 0}, {"a.exr", 0}, {"a.hdr", 20}, {"a.jpg", 80},
};
/** Number of formats. */
enum { MODULE_FORMATS = sizeof module_formats / sizeof *module_formats };

/** A round trip is exact within the precision of the format. */
static void test_module_round_trip(void **state) {
    require_plugin();
    for (int i = 0; i < MODULE_FORMATS; i++) {
        const char *path = fixture_path(state, module_formats[i].name);
        assert_in_range(round_trip(path, 37, 101), 0, module_formats[i].steps);
        assert_in_range(round_trip(path, 1, 1), 0, module_formats[i].steps);
    }
    assert_int_equal(count_files(state), MODULE_FORMATS);
}

/** Formats of linear light contain the decoded light of a picture, whatever its encoding. */
static void test_module_linear_light(void **state) {
    require_plugin();
    static const char *const names[] = {"a.exr", "a.hdr"};
    Encoder srgb;
    encoder_init(&srgb, ENCODING_SRGB);
    for (int i = 0; i < 4; i++) {
        const char *path = fixture_path(state, names[i / 2]);
        Encoding encoding = i % 2 ? ENCODING_LINEAR : ENCODING_SRGB;
        uint8_t grey[] = {64, 64, 64};
        Picture picture = {.width = 1, .height = 1, .pixels = grey, .encoding = encoding}, again;
        assert_true(image_file_write(path, &picture, NULL));
        assert_true(image_file_read(path, &again, NULL));
        int wanted = encoder_encode(&srgb, (float)encoding_decode(encoding, grey[0]));
        assert_int_equal(again.encoding, ENCODING_SRGB);
        assert_in_range(again.pixels[0], wanted - 1, wanted + 1); // Radiance rounds to 8 bits.
        picture_deinit(&again);
    }
}

/**
 * A picture with linear light is written to formats of linear light without clamping or rounding to
 * 8 bits. Invalid values are corrected.
 */
static void test_module_keeps_light(void **state) {
    require_plugin();
    static const float light[] = {5.5F, 1e-7F, 0.123456789F, NAN, -1, INFINITY};
    const char *path = fixture_path(state, "a.exr");
    Picture picture = make_test_picture(2, 1);
    Texture *texture;
    Error error = {0};
    assert_true(image_file_is_linear(path) && image_file_is_linear("b.HDR"));
    assert_false(image_file_is_linear("a.png") || image_file_is_linear("exr"));
    assert_true(picture_allocate_linear(&picture, &error));
    memcpy(picture.linear, light, sizeof light);
    assert_true(image_file_write(path, &picture, &error));
    assert_true(read_texture_file(path, &texture, &error));
    assert_true(texture->is_hdr && texture->width == 2 && texture->height == 1);
    assert_memory_equal(texture_hdr_texels(texture), light, 3 * sizeof *light);
    assert_true(texture_hdr_texels(texture)[3] == 0 && texture_hdr_texels(texture)[4] == 0);
    assert_true(texture_hdr_texels(texture)[5] == (float)INTENSITY_MAXIMUM);
    texture_release(texture);
    picture_deinit(&picture);
}

/** A BMP file becomes a texture without the plugin. */
static void test_bmp_texture(void **state) {
    const char *path = fixture_path(state, "a.bmp");
    Picture picture = make_test_picture(5, 3);
    Texture *texture;
    Error error = {0};
    assert_true(image_file_write(path, &picture, &error));
    assert_true(texture_file_check(path, &error));
    assert_true(read_texture_file(path, &texture, &error));
    assert_true(!texture->is_hdr && texture->width == 5 && texture->height == 3);
    assert_memory_equal(texture_ldr_texels(texture), picture.pixels, 5 * 3 * 3);
    texture_release(texture);
    picture_deinit(&picture);
    assert_false(texture_file_check("none.txt", &error));
    assert_false(read_texture_file(fixture_path(state, "none.bmp"), &texture, &error));
    assert_null(texture);
}

/** The same picture gives the same bytes at any time. */
static void test_module_same_bytes(void **state) {
    require_plugin();
    uint8_t first[MODULE_FORMATS][SMALL_FILE_SIZE];
    size_t size[MODULE_FORMATS];
    for (int i = 0; i < MODULE_FORMATS; i++) {
        round_trip(fixture_path(state, module_formats[i].name), 10, 10);
        size[i] = read_file_bytes(fixture_path(state, module_formats[i].name), first[i]);
    }
    sleep(1); // Dates in files have a resolution of one second.
    for (int i = 0; i < MODULE_FORMATS; i++) {
        uint8_t again[SMALL_FILE_SIZE];
        round_trip(fixture_path(state, module_formats[i].name), 10, 10);
        assert_int_equal(read_file_bytes(fixture_path(state, module_formats[i].name), again),
                         size[i]);
        assert_memory_equal(again, first[i], size[i]);
    }
}

/** A full disk is reported for every format. */
static void test_module_full_disk(void **state) {
    require_plugin();
    for (int i = 0; i < MODULE_FORMATS; i++) {
        assert_full_disk_is_reported(state, module_formats[i].name);
    }
    assert_int_equal(count_files(state), MODULE_FORMATS);
}

/** A truncated file, or one of a different format than its extension, is refused. */
static void test_module_hostile(void **state) {
    require_plugin();
    uint8_t bytes[SMALL_FILE_SIZE];
    for (int i = 0; i < MODULE_FORMATS; i++) {
        const char *path = fixture_path(state, module_formats[i].name);
        round_trip(path, 16, 16);
        size_t size = read_file_bytes(path, bytes);
        write_file(path, bytes, size / 8);
        assert_refused(path);
        write_file(path, "BM is no picture of this kind", 29);
        assert_refused(path);
        write_file(path, "", 0);
        assert_refused(path);
    }
}

/** Runs the tests. @return Number of failed tests. */
int main(int argc, char **argv) {
    if (worker_is_requested(argc, argv)) {
        worker_main(argv, module_tasks);
    }
    const struct CMUnitTest file_tests[] = {
        cmocka_unit_test_setup_teardown(test_bmp_round_trip, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_bmp_bytes, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_bmp_kinds, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_bmp_hostile, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_bmp_truncated, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_read_what_is_no_file, fixture_set_up,
                                        fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_endings, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_permissions, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_no_permission, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_wrong_paths, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_links, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_devices, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_never_over, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_full_disk, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_bmp_texture, fixture_set_up, fixture_tear_down),
    };
    const struct CMUnitTest module_tests[] = {
        cmocka_unit_test(test_module_crashes),
        cmocka_unit_test(test_module_interrupted),
        cmocka_unit_test(test_module_limits),
        cmocka_unit_test_setup_teardown(test_module_keeps_light, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_module_is_missing, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_module_round_trip, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_module_linear_light, fixture_set_up,
                                        fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_module_same_bytes, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_module_full_disk, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_module_hostile, fixture_set_up, fixture_tear_down),
    };
    return cmocka_run_group_tests(file_tests, NULL, NULL) +
           cmocka_run_group_tests(module_tests, NULL, NULL);
}
