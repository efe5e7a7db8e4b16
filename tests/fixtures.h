/**
 * @file
 * @brief Shared helpers for tests of files: a temporary folder, small files, pictures.
 */
#ifndef DIOPTRE_FIXTURES_H
#define DIOPTRE_FIXTURES_H

#include "testing.h"

#include "assets/asset_budget.h"
#include "base/picture.h"
#include "base/regular_file.h"

#include <errno.h>
#include <ftw.h>
#include <limits.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

/** A temporary folder for a test: empty at first, removed at the end. */
typedef struct Fixture {
    char folder[64];     /**< The folder. */
    char path[PATH_MAX]; /**< The newest path made by #fixture_path. */
} Fixture;

/** Creates the temporary folder of a test or a group of tests. @return 0 on success. */
static inline int fixture_set_up(void **state) {
    Fixture *fixture = calloc(1, sizeof *fixture);
    *state = fixture;
    if (!fixture) {
        return -1;
    }
    strcpy(fixture->folder, "/tmp/dioptre-test-XXXXXX");
    return mkdtemp(fixture->folder) ? 0 : -1;
}

/** Removes one file or folder, for nftw. @return 0 on success. */
static inline int remove_entry(const char *path, const struct stat *info, int type,
                               struct FTW *walk) {
    (void)info;
    (void)type;
    (void)walk;
    return remove(path);
}

/** Removes the folder with its contents. @return 0 on success. */
static inline int fixture_tear_down(void **state) {
    Fixture *fixture = *state;
    int failed = nftw(fixture->folder, remove_entry, 8, FTW_DEPTH | FTW_PHYS);
    free(fixture);
    return failed;
}

/** Opens a file as those of a scene are. @return Whether it is open; close its descriptor. */
static inline bool open_asset(const char *path, AssetFile *file, Error *error) {
    file->path = path;
    file->descriptor = regular_file_open(path, &file->info, error);
    return file->descriptor >= 0;
}

/**
 * Makes the path of a file in the folder.
 * @return The path, valid until the next call; owned by the fixture.
 */
static inline const char *fixture_path(void **state, const char *name) {
    Fixture *fixture = *state;
    snprintf(fixture->path, sizeof fixture->path, "%s/%s", fixture->folder, name);
    return fixture->path;
}

/** Writes a small file. */
static inline void write_file(const char *path, const void *bytes, size_t size) {
    FILE *stream = fopen(path, "wb");
    assert_non_null(stream);
    assert_int_equal(fwrite(bytes, 1, size, stream), size);
    assert_int_equal(fclose(stream), 0);
}

/** Links a plugin of the program beside the test program, which lies one folder below. */
static inline void symlink_plugin(const char *file) {
    char link[PATH_MAX], target[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", link, sizeof link - 1);
    assert_true(length > 0);
    link[length] = '\0';
    char *name = strrchr(link, '/') + 1;
    snprintf(name, sizeof link - (size_t)(name - link), "%s", file);
    snprintf(target, sizeof target, "../%s", file);
    if (symlink(target, link) != 0 && errno != EEXIST) {
        fail_msg("%s: %s", link, strerror(errno));
    }
}

/** Creates a picture of which all bytes differ. @return The picture; owned by the caller. */
static inline Picture make_test_picture(int width, int height) {
    Picture picture;
    assert_true(picture_init(&picture, width, height, NULL));
    for (int i = 0; i < width * height * 3; i++) {
        picture.pixels[i] = (uint8_t)(i * 37 + i / 256);
    }
    return picture;
}

#endif
