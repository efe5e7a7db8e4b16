/**
 * @file
 * @brief Tests of files that are written completely or not at all: file systems that cannot rename
 *        without replacing, long names, links, permissions. tests/faults.sh lets each call fail.
 */
#include "testing.h"

#include "base/atomic_file.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

/** The `errno` of renameat2 here; 0: it works. */
static int rename_reason;

/** Stands for the call of the system, which not every file system has. See renameat2. */
int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags);
int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags) {
    (void)from_folder, (void)to_folder;
    if (rename_reason) {
        errno = rename_reason;
        return -1;
    }
    assert_int_equal(flags, RENAME_NOREPLACE);
    return access(to, F_OK) == 0 ? (errno = EEXIST, -1) : rename(from, to);
}

/** A folder for the files of a test. */
static char folder[64];

/** Creates the folder. See cmocka's setup functions. */
static int create_folder(void **state) {
    (void)state;
    snprintf(folder, sizeof folder, "/tmp/dioptre-atomic-XXXXXX");
    rename_reason = 0;
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

/** Counts the files of the folder. @return Their number. */
static int count_files(void) {
    int count = 0;
    DIR *listing = opendir(folder);
    for (const struct dirent *entry; listing && (entry = readdir(listing));) {
        count += entry->d_name[0] != '.';
    }
    closedir(listing);
    return count;
}

/** Removes the folder. See cmocka's teardown functions. */
static int remove_folder(void **state) {
    (void)state;
    char command[128];
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

/** Writes a file. @return Whether it is complete. */
static bool write_file(const char *path, AtomicMode mode, const char *text, AtomicFile *file) {
    Error error = {0};
    bool is_open = atomic_file_open(file, path, mode, &error);
    return is_open && fputs(text, file->stream) >= 0 && atomic_file_commit(file, &error);
}

/** Fails unless a file has this content. */
static void assert_content(const char *path, const char *text) {
    char found[64] = "";
    FILE *stream = fopen(path, "r");
    assert_non_null(stream);
    assert_true(fgets(found, sizeof found, stream) != NULL);
    fclose(stream);
    assert_string_equal(found, text);
}

/** Where the system cannot rename without replacing, the file is linked; an old one is kept. */
static void test_link(void **state) {
    (void)state;
    static const int reasons[] = {0, EINVAL, ENOSYS};
    for (size_t i = 0; i < sizeof reasons / sizeof *reasons; i++) {
        AtomicFile file;
        rename_reason = reasons[i];
        assert_true(write_file("new", ATOMIC_NEW, "first", &file));
        assert_content("new", "first");
        assert_int_equal(count_files(), 1);
        assert_false(write_file("new", ATOMIC_NEW, "second", &file));
        assert_true(file.exists);
        assert_content("new", "first");
        assert_int_equal(count_files(), 1);
        unlink("new");
    }
}

/** A file that appears while another one of its name is written is kept. */
static void test_race(void **state) {
    (void)state;
    static const int reasons[] = {0, EINVAL};
    for (size_t i = 0; i < sizeof reasons / sizeof *reasons; i++) {
        AtomicFile file, other;
        Error error = {0};
        rename_reason = 0;
        assert_true(atomic_file_open(&file, "name", ATOMIC_NEW, &error));
        assert_true(write_file("name", ATOMIC_NEW, "other", &other));
        rename_reason = reasons[i];
        assert_true(fputs("late", file.stream) >= 0);
        assert_false(atomic_file_commit(&file, &error));
        assert_int_equal(error.status, STATUS_FAILED);
        assert_true(file.exists);
        assert_content("name", "other");
        assert_int_equal(count_files(), 1);
        unlink("name");
    }
}

/** Another failure of the rename is no matter of links: nothing is left. */
static void test_no_rename(void **state) {
    (void)state;
    AtomicFile file;
    rename_reason = EIO;
    assert_false(write_file("name", ATOMIC_NEW, "text", &file));
    assert_false(file.exists);
    assert_int_equal(count_files(), 0);
}

/** Names of all lengths can be written, up to the longest that the system has. */
static void test_long_names(void **state) {
    (void)state;
    char name[NAME_MAX + 2];
    for (size_t length = NAME_MAX - 60; length <= NAME_MAX; length++) {
        AtomicFile file;
        memset(name, 'n', sizeof name);
        name[length] = '\0';
        assert_true(write_file(name, ATOMIC_REPLACE, "text", &file));
        assert_content(name, "text");
        assert_true(write_file(name, ATOMIC_REPLACE, "again", &file));
        assert_content(name, "again");
        assert_int_equal(count_files(), 1);
        unlink(name);
    }
    Error error = {0};
    AtomicFile file;
    memset(name, 'n', sizeof name);
    name[NAME_MAX + 1] = '\0';
    bool is_open = atomic_file_open(&file, name, ATOMIC_REPLACE, &error);
    assert_false(is_open && atomic_file_commit(&file, &error));
    assert_int_equal(error.status, STATUS_FAILED);
    assert_int_equal(count_files(), 0);
    char path[PATH_MAX + 10];
    memset(path, '/', sizeof path);
    path[PATH_MAX + 8] = 'x';
    path[PATH_MAX + 9] = '\0';
    assert_false(atomic_file_open(&file, path, ATOMIC_REPLACE, &error));
    assert_false(atomic_file_open(&file, path, ATOMIC_NEW, &error));
}

/** A link is followed, unless the file must be new; permissions stay. */
static void test_links(void **state) {
    (void)state;
    AtomicFile file;
    struct stat found;
    assert_int_equal(symlink("target", "link"), 0);
    assert_false(write_file("link", ATOMIC_NEW, "text", &file));
    assert_true(file.exists);
    assert_true(write_file("target", ATOMIC_NEW, "text", &file));
    assert_int_equal(chmod("target", 0640), 0);
    assert_true(write_file("link", ATOMIC_REPLACE, "other", &file));
    assert_content("target", "other");
    assert_int_equal(stat("target", &found), 0);
    assert_int_equal(found.st_mode & 0777, 0640);
    assert_int_equal(lstat("link", &found), 0);
    assert_true(S_ISLNK(found.st_mode));
    assert_int_equal(count_files(), 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_link, create_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_race, create_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_no_rename, create_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_long_names, create_folder, remove_folder),
        cmocka_unit_test_setup_teardown(test_links, create_folder, remove_folder)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
