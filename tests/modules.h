/**
 * @file
 * @brief What tests of the program's modules share.
 */
#ifndef DIOPTRE_TEST_MODULES_H
#define DIOPTRE_TEST_MODULES_H

#include "testing.h"

#include <errno.h>
#include <limits.h>
#include <unistd.h>

/**
 * Makes a module findable for a test, which lies one folder below the program.
 * @param file  The module's file name.
 */
static inline void modules_link(const char *file) {
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

#endif
