/**
 * @file
 * @brief A library to preload: one call of the program fails, as it does on a full disk, without
 * memory, or at a limit of the system.
 *
 * The environment says which: FAULT_PROGRAM is the name of the program, FAULT_KIND a kind of call
 * (see below), FAULT_NUMBER its number, from 1. When the call fails, the first byte of the file
 * FAULT_MARK becomes 1: through a mapping, as a worker may not open files. Only calls of the
 * program itself, of libc and of Lua are counted: what the large libraries do with a failure is no
 * matter of dioptre, which runs them in a worker.
 */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <pthread.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

// The allocator of glibc, by names that need no look-up, which would allocate.
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *block, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

/** Kinds of calls, in the words of FAULT_KIND; tests/faults.sh reads this list. */
#define KINDS(X)                                                                                   \
    X(malloc) X(mmap) X(open) X(read) X(write) X(pipe) X(thread) X(spawn) X(rename) X(close) X(sync)
/** A kind as a constant, and as a word. */
#define KIND_CONSTANT(word) KIND_##word,
#define KIND_WORD(word) #word,
/** A kind of calls. */
typedef enum { KIND_none, KINDS(KIND_CONSTANT) KIND_COUNT } Kind;

/** The words of #Kind, in its order. */
static const char *const kind_words[] = {"none", KINDS(KIND_WORD)};

/** A loaded object whose calls are counted. */
typedef struct Range {
    uintptr_t start; /**< Its first address. */
    uintptr_t end;   /**< Behind its last address. */
} Range;

/** What fails, and what was counted so far. */
static struct {
    Kind kind;          /**< Which calls; #KIND_none: none. */
    int number;         /**< The call that fails. */
    atomic_int calls;   /**< Calls so far. */
    char *mark;         /**< The first byte of the file, in memory. */
    Range ranges[8];    /**< Objects whose calls are counted. */
    size_t range_count; /**< Number of these. */
} plan;

/** Adds an object whose calls are counted. See dl_iterate_phdr. @return 0 to go on. */
static int add_range(struct dl_phdr_info *object, size_t size, void *context) {
    bool *is_first = context;
    (void)size;
    bool is_counted =
        *is_first || strstr(object->dlpi_name, "/libc.so") || strstr(object->dlpi_name, "/liblua");
    *is_first = false;
    for (int i = 0; is_counted && i < object->dlpi_phnum; i++) {
        const ElfW(Phdr) *part = &object->dlpi_phdr[i];
        bool is_code = part->p_type == PT_LOAD && (part->p_flags & PF_X);
        if (is_code && plan.range_count < sizeof plan.ranges / sizeof *plan.ranges) {
            uintptr_t start = object->dlpi_addr + part->p_vaddr;
            plan.ranges[plan.range_count++] = (Range){start, start + part->p_memsz};
        }
    }
    return 0;
}

/** @return The kind of a word. */
static Kind kind_of(const char *word) {
    for (Kind kind = KIND_none + 1; word && kind < KIND_COUNT; kind++) {
        if (strcmp(word, kind_words[kind]) == 0) {
            return kind;
        }
    }
    return KIND_none;
}

/** Reads the environment, once the program is loaded. */
__attribute__((constructor)) static void init_plan(void) {
    char path[4096];
    const char *program = getenv("FAULT_PROGRAM"), *number = getenv("FAULT_NUMBER");
    const char *mark = getenv("FAULT_MARK");
    ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);
    path[length > 0 ? length : 0] = '\0';
    const char *slash = strrchr(path, '/');
    if (program && number && mark && slash && strcmp(slash + 1, program) == 0) {
        bool is_first = true;
        int file = (int)syscall(SYS_openat, AT_FDCWD, mark, O_RDWR | O_CLOEXEC);
        plan.mark = mmap(NULL, 1, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        syscall(SYS_close, file);
        if (plan.mark == MAP_FAILED) {
            abort();
        }
        dl_iterate_phdr(add_range, &is_first);
        plan.number = atoi(number);
        plan.kind = kind_of(getenv("FAULT_KIND"));
    }
}

/**
 * Counts a call.
 * @param kind    Its kind.
 * @param caller  The address that it returns to.
 * @param reason  The `errno` if it fails.
 * @return Whether it fails; errno is set then.
 */
static bool fails(Kind kind, const void *caller, int reason) {
    bool is_counted = false;
    for (size_t i = 0; plan.kind == kind && i < plan.range_count; i++) {
        uintptr_t at = (uintptr_t)caller;
        is_counted = is_counted || (at >= plan.ranges[i].start && at < plan.ranges[i].end);
    }
    if (!is_counted || atomic_fetch_add(&plan.calls, 1) + 1 != plan.number) {
        return false;
    }
    *plan.mark = '1';
    errno = reason;
    return true;
}

/** The next function of a name: that of libc. */
#define REAL(type, name, ...) ((type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, name))
/** Returns a value if the call fails. */
#define FAIL(kind, reason, value)                                                                  \
    if (fails(kind, __builtin_return_address(0), reason)) {                                        \
        return value;                                                                              \
    }

// --- memory --------------------------------------------------------------------------------------

void *malloc(size_t size) {
    FAIL(KIND_malloc, ENOMEM, NULL)
    return __libc_malloc(size);
}

void *calloc(size_t count, size_t size) {
    FAIL(KIND_malloc, ENOMEM, NULL)
    return __libc_calloc(count, size);
}

void *realloc(void *block, size_t size) {
    FAIL(KIND_malloc, ENOMEM, NULL)
    return __libc_realloc(block, size);
}

void *aligned_alloc(size_t alignment, size_t size) {
    FAIL(KIND_malloc, ENOMEM, NULL)
    return __libc_memalign(alignment, size);
}

FILE *open_memstream(char **bytes, size_t *size) {
    FAIL(KIND_malloc, ENOMEM, NULL)
    return REAL(FILE *, "open_memstream", char **, size_t *)(bytes, size);
}

void *mmap(void *address, size_t size, int rights, int flags, int file, off_t start) {
    FAIL(KIND_mmap, ENOMEM, MAP_FAILED)
    return (void *)syscall(SYS_mmap, address, size, rights, flags, file, start); // NOLINT
}

// --- files ---------------------------------------------------------------------------------------

int open(const char *path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    int mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(arguments, int) : 0;
    va_end(arguments);
    FAIL(KIND_open, EMFILE, -1)
    return (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

int openat(int folder, const char *path, int flags, ...) {
    va_list arguments;
    va_start(arguments, flags);
    int mode = flags & (O_CREAT | __O_TMPFILE) ? va_arg(arguments, int) : 0;
    va_end(arguments);
    FAIL(KIND_open, EMFILE, -1)
    return (int)syscall(SYS_openat, folder, path, flags, mode);
}

FILE *fopen(const char *path, const char *mode) {
    FAIL(KIND_open, EMFILE, NULL)
    return REAL(FILE *, "fopen", const char *, const char *)(path, mode);
}

FILE *fdopen(int file, const char *mode) {
    FAIL(KIND_open, ENOMEM, NULL)
    return REAL(FILE *, "fdopen", int, const char *)(file, mode);
}

ssize_t read(int file, void *bytes, size_t size) {
    FAIL(KIND_read, EIO, -1)
    return syscall(SYS_read, file, bytes, size);
}

ssize_t pread(int file, void *bytes, size_t size, off_t start) {
    FAIL(KIND_read, EIO, -1)
    return syscall(SYS_pread64, file, bytes, size, start);
}

ssize_t recv(int file, void *bytes, size_t size, int flags) {
    FAIL(KIND_read, EIO, -1)
    return syscall(SYS_recvfrom, file, bytes, size, flags, NULL, NULL);
}

ssize_t recvmsg(int file, struct msghdr *message, int flags) {
    FAIL(KIND_read, EIO, -1)
    return syscall(SYS_recvmsg, file, message, flags);
}

size_t fread(void *bytes, size_t size, size_t count, FILE *stream) {
    FAIL(KIND_read, EIO, 0)
    return REAL(size_t, "fread", void *, size_t, size_t, FILE *)(bytes, size, count, stream);
}

// What _FORTIFY_SOURCE makes of it.
size_t __fread_chk(void *bytes, size_t capacity, size_t size, size_t count, FILE *stream) {
    FAIL(KIND_read, EIO, 0)
    return REAL(size_t, "__fread_chk", void *, size_t, size_t, size_t, FILE *)(bytes, capacity,
                                                                               size, count, stream);
}

ssize_t write(int file, const void *bytes, size_t size) {
    FAIL(KIND_write, ENOSPC, -1)
    return syscall(SYS_write, file, bytes, size);
}

ssize_t send(int file, const void *bytes, size_t size, int flags) {
    FAIL(KIND_write, EIO, -1)
    return syscall(SYS_sendto, file, bytes, size, flags, NULL, 0);
}

ssize_t sendmsg(int file, const struct msghdr *message, int flags) {
    FAIL(KIND_write, EIO, -1)
    return syscall(SYS_sendmsg, file, message, flags);
}

/** Marks a stream as failed, as a write that failed does. */
static void set_failed(FILE *stream) {
    const int error_seen = 0x20; // _IO_ERR_SEEN of glibc, which no public header names.
    stream->_flags |= error_seen;
}

size_t fwrite(const void *bytes, size_t size, size_t count, FILE *stream) {
    if (fails(KIND_write, __builtin_return_address(0), ENOSPC)) {
        set_failed(stream);
        return 0;
    }
    return REAL(size_t, "fwrite", const void *, size_t, size_t, FILE *)(bytes, size, count, stream);
}

int fclose(FILE *stream) {
    bool is_failing = fails(KIND_close, __builtin_return_address(0), ENOSPC);
    int status = REAL(int, "fclose", FILE *)(stream);
    if (is_failing) {
        errno = ENOSPC;
    }
    return is_failing ? EOF : status;
}

int fflush(FILE *stream) {
    FAIL(KIND_close, ENOSPC, EOF)
    return REAL(int, "fflush", FILE *)(stream);
}

int fsync(int file) {
    FAIL(KIND_sync, EIO, -1)
    return (int)syscall(SYS_fsync, file);
}

int rename(const char *from, const char *to) {
    FAIL(KIND_rename, EACCES, -1)
    return (int)syscall(SYS_rename, from, to);
}

int renameat2(int from_folder, const char *from, int to_folder, const char *to,
              unsigned int flags) {
    FAIL(KIND_rename, EACCES, -1)
    return (int)syscall(SYS_renameat2, from_folder, from, to_folder, to, flags);
}

int link(const char *from, const char *to) {
    FAIL(KIND_rename, EACCES, -1)
    return (int)syscall(SYS_link, from, to);
}

// --- threads and processes -----------------------------------------------------------------------

int pipe2(int ends[2], int flags) {
    FAIL(KIND_pipe, EMFILE, -1)
    return (int)syscall(SYS_pipe2, ends, flags);
}

int socketpair(int domain, int type, int protocol, int ends[2]) {
    FAIL(KIND_pipe, EMFILE, -1)
    return (int)syscall(SYS_socketpair, domain, type, protocol, ends);
}

int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                   void *context) {
    FAIL(KIND_thread, EAGAIN, EAGAIN)
    return REAL(int, "pthread_create", pthread_t *, const pthread_attr_t *, void *(*)(void *),
                void *)(thread, attributes, run, context);
}

/** Defines a function of the C library that starts a process. */
#define DEFINE_SPAWN(name)                                                                         \
    int name(pid_t *process, const char *path, const posix_spawn_file_actions_t *actions,          \
             const posix_spawnattr_t *attributes, char *const arguments[],                         \
             char *const environment[]) {                                                          \
        FAIL(KIND_spawn, EAGAIN, EAGAIN)                                                           \
        return REAL(int, #name, pid_t *, const char *, const posix_spawn_file_actions_t *,         \
                    const posix_spawnattr_t *, char *const *,                                      \
                    char *const *)(process, path, actions, attributes, arguments, environment);    \
    }
DEFINE_SPAWN(posix_spawn)
DEFINE_SPAWN(posix_spawnp)
