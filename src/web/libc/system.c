/**
 * @file
 * @brief Functions of GNU's C library and of Linux that a page lacks.
 */
#include "web/waits.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <linux/openat2.h>
#include <sched.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

/** Says how many processors the browser tells. See sched_getaffinity(2). @return 0 */
int sched_getaffinity(pid_t process, size_t size, cpu_set_t *set) {
    CPU_ZERO_S(size, set);
    for (int i = 0; i < waits_processor_count(); i++) {
        CPU_SET_S(i, size, set);
    }
    return 0;
}

/** The browser's own clock: of the wall alone. */
int __real_clock_gettime(clockid_t clock, struct timespec *time);

/** Says what time it is. A page is not told how long it had a processor: the wall's clock stands
 * in. See clock_gettime(2). */
int __wrap_clock_gettime(clockid_t clock, struct timespec *time) {
    bool is_of_processor = clock == CLOCK_PROCESS_CPUTIME_ID || clock == CLOCK_THREAD_CPUTIME_ID;
    return __real_clock_gettime(is_of_processor ? CLOCK_MONOTONIC : clock, time);
}

/** See CPU_COUNT(3). @return Number of processors in a set. */
int __sched_cpucount(size_t size, const cpu_set_t *set) {
    int count = 0;
    for (size_t i = 0; i < 8 * size; i++) {
        count += CPU_ISSET_S(i, size, set) ? 1 : 0;
    }
    return count;
}

int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags) {
    if ((flags & RENAME_NOREPLACE) && access(to, F_OK) == 0) {
        errno = EEXIST;
        return -1;
    }
    return rename(from, to);
}

/**
 * Opens a file if it lies beneath a folder.
 * @param folder  Descriptor of the folder.
 * @param name    The name, relative to it.
 * @param how     The flags.
 * @return A descriptor; -1 with errno set.
 */
static long open_beneath(int folder, const char *name, const struct open_how *how) {
    char link[32], dir[PATH_MAX], path[2 * PATH_MAX], real_path[PATH_MAX];
    snprintf(link, sizeof link, "/proc/self/fd/%d", folder);
    ssize_t length = readlink(link, dir, sizeof dir - 1);
    if (length < 0) {
        return -1;
    }
    dir[length] = '\0';
    snprintf(path, sizeof path, "%s/%s", dir, name);
    if (!realpath(path, real_path)) {
        return -1;
    }
    bool is_beneath = strncmp(real_path, dir, (size_t)length) == 0 && real_path[length] == '/';
    if (!is_beneath) {
        errno = ENOENT;
        return -1;
    }
    return open(real_path, (int)how->flags);
}

long syscall(long number, ...) {
    if (number != SYS_openat2) {
        errno = ENOSYS;
        return -1;
    }
    va_list arguments;
    va_start(arguments, number);
    int folder = va_arg(arguments, int);
    const char *name = va_arg(arguments, const char *);
    const struct open_how *how = va_arg(arguments, const struct open_how *);
    va_end(arguments);
    return open_beneath(folder, name, how);
}

/** Loads no library: there are none. See dlopen(3). @return NULL */
void *dlopen(const char *file, int mode) {
    return NULL;
}

/** See dlsym(3). @return NULL */
void *dlsym(void *library, const char *name) {
    return NULL;
}

/** See setpriority(2): threads of a page have no priorities. @return 0 */
int setpriority(int which, id_t who, int priority) {
    return 0;
}
