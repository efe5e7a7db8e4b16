/**
 * @file
 * @brief The text of a scene file.
 */
#include "script/source.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/** What Windows puts before a text in UTF-8. */
static const char byte_order_mark[] = "\xEF\xBB\xBF";

/**
 * Says whether an open file may be read as a scene.
 * @param file        The file.
 * @param[out] error  Why not.
 * @return Whether it is a regular file.
 */
static bool check_kind(int file, Error *error) {
    struct stat found;
    if (fstat(file, &found) != 0) {
        return error_set(error, STATUS_SCENE, "%s", error_system(errno));
    }
    if (S_ISDIR(found.st_mode)) {
        return error_set(error, STATUS_SCENE, "this is a folder, not a scene file");
    }
    if (!S_ISREG(found.st_mode)) {
        return error_set(error, STATUS_SCENE,
                         "not a regular file (to read from a pipe, name the scene -)");
    }
    return true;
}

/**
 * Opens a scene file, without waiting.
 * @param path        Where it is; `-` is standard input.
 * @param[out] error  What is wrong.
 * @return A file descriptor; -1 if it cannot be opened or is no regular file.
 */
static int open_file(const char *path, Error *error) {
    if (strcmp(path, "-") == 0) {
        return STDIN_FILENO;
    }
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (file < 0) {
        error_set(error, STATUS_SCENE, "%s", error_system(errno));
        return -1;
    }
    if (!check_kind(file, error)) {
        close(file);
        return -1;
    }
    return file;
}

/**
 * Makes room for more of a file, twice as much each time.
 * @param[in,out] source    What was read so far.
 * @param[in,out] capacity  Bytes that fit.
 * @param[out] error        What is wrong.
 * @return false when it is too long already, or without memory.
 */
static bool grow(Source *source, size_t *capacity, Error *error) {
    /** Bytes at first: most scenes fit. */
    const size_t first_capacity = 16384;
    if (source->size > SOURCE_MAXIMUM) {
        return error_set(error, STATUS_SCENE, "longer than %zu MiB", SOURCE_MAXIMUM >> 20);
    }
    size_t wanted = *capacity ? 2 * *capacity : first_capacity;
    char *larger = realloc(source->text, wanted);
    if (!larger) {
        return error_set(error, STATUS_FAILED, "no memory for a scene file");
    }
    source->text = larger;
    *capacity = wanted;
    return true;
}

/**
 * Reads an open file to its end.
 * @param[in,out] source  What was read; grows.
 * @param file            The file.
 * @param[out] error      What is wrong.
 * @return Whether it was read whole.
 */
static bool read_all(Source *source, int file, Error *error) {
    size_t capacity = 0;
    for (;;) {
        if (source->size == capacity && !grow(source, &capacity, error)) {
            return false;
        }
        ssize_t count = read(file, source->text + source->size, capacity - source->size);
        if (count == 0) {
            return source->size <= SOURCE_MAXIMUM || grow(source, &capacity, error);
        }
        if (count < 0 && errno != EINTR) {
            return error_set(error, STATUS_SCENE, "%s", error_system(errno));
        }
        source->size += count > 0 ? (size_t)count : 0;
    }
}

bool source_read(Source *source, const char *path, Error *error) {
    *source = (Source){0};
    int file = open_file(path, error);
    if (file < 0) {
        return false;
    }
    bool is_read = read_all(source, file, error);
    if (!is_read) {
        source_release(source);
    }
    if (file != STDIN_FILENO) {
        close(file);
    }
    return is_read;
}

/**
 * @return The number of the line that a byte of a file is in, from 1.
 * @param source  The file.
 * @param byte    One of its bytes.
 */
static int line_of(const Source *source, const char *byte) {
    int line = 1;
    for (const char *at = source->text; at < byte; at++) {
        line += *at == '\n';
    }
    return line;
}

bool source_check_text(const Source *source, int *line, Error *error) {
    /** First byte of all compiled Lua (LUA_SIGNATURE). */
    const char compiled = '\x1B';
    size_t size;
    const char *text = source_text(source, &size);
    const char *zero = size ? memchr(text, '\0', size) : NULL;
    bool is_compiled = size > 0 && text[0] == compiled;
    if (line) {
        *line = zero && !is_compiled ? line_of(source, zero) : 1;
    }
    if (is_compiled) {
        return error_set(error, STATUS_SCENE,
                         "this is compiled Lua, which is not run; a scene is a text");
    }
    if (zero) {
        return error_set(error, STATUS_SCENE,
                         "this is not text in UTF-8 (there is a zero byte in it)");
    }
    return true;
}

const char *source_text(const Source *source, size_t *size) {
    const size_t mark = strlen(byte_order_mark);
    bool is_marked = source->size >= mark && memcmp(source->text, byte_order_mark, mark) == 0;
    size_t start = is_marked ? mark : 0;
    if (start < source->size && source->text[start] == '#') {
        while (start < source->size && source->text[start] != '\n') {
            start++;
        }
    }
    *size = source->size - start;
    return source->text + start;
}

void source_release(Source *source) {
    free(source->text);
    *source = (Source){0};
}
