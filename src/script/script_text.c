/**
 * @file
 * @brief The text of a scene file.
 */
#include "script/script_text.h"

#include "base/regular_file.h"
#include "base/sanitize.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** Byte order mark of UTF-8; some editors on Windows write it. */
static const char byte_order_mark[] = "\xEF\xBB\xBF";

/** @return Whether an open file is a regular file. */
static bool check_regular(int file, Error *error) {
    struct stat info;
    if (fstat(file, &info) != 0) {
        return error_set_errno(error, errno);
    }
    if (S_ISDIR(info.st_mode)) {
        return error_set(error, STATUS_SCENE, "this is a folder, not a scene file");
    }
    if (!S_ISREG(info.st_mode)) {
        return error_set(error, STATUS_SCENE,
                         "not a regular file (to read from a pipe, name the scene -)");
    }
    return true;
}

/**
 * Opens a scene file, without blocking.
 * @param path        Its path; `-`: standard input.
 * @param[out] error  What is wrong.
 * @return A file descriptor; -1 if it cannot be opened or is no regular file.
 */
static int open_script(const char *path, Error *error) {
    if (strcmp(path, "-") == 0) {
        return STDIN_FILENO;
    }
    int file = open(path, REGULAR_FILE_FLAGS);
    if (file < 0) {
        error_set_errno(error, errno);
        return -1;
    }
    if (!check_regular(file, error)) {
        close(file);
        return -1;
    }
    return file;
}

/**
 * Doubles the memory for a file.
 * @param[in,out] script    The bytes read so far.
 * @param[in,out] capacity  Size of the memory.
 * @param[out] error        What is wrong.
 * @return false if the file is too long, or without memory.
 */
static bool grow(ScriptText *script, size_t *capacity, Error *error) {
    /** First size in bytes; sufficient for most scenes. */
    const size_t first_capacity = 16384;
    if (script->size > SCRIPT_TEXT_MAXIMUM) {
        return error_set(error, STATUS_SCENE, "longer than %zu MiB", SCRIPT_TEXT_MAXIMUM >> 20);
    }
    size_t new_capacity = *capacity ? 2 * *capacity : first_capacity;
    char *larger = realloc(script->text, new_capacity);
    if (!larger) {
        return error_set(error, STATUS_FAILED, "no memory for a scene file");
    }
    script->text = larger;
    *capacity = new_capacity;
    return true;
}

/** Reads an open file to its end. @return Whether all of it was read. */
static bool read_all(ScriptText *script, int file, Error *error) {
    size_t capacity = 0;
    for (;;) {
        if (script->size == capacity && !grow(script, &capacity, error)) {
            return false;
        }
        ssize_t count = read(file, script->text + script->size, capacity - script->size);
        if (count == 0) {
            return script->size <= SCRIPT_TEXT_MAXIMUM || grow(script, &capacity, error);
        }
        if (count < 0 && errno != EINTR) {
            return error_set_errno(error, errno);
        }
        script->size += count > 0 ? (size_t)count : 0;
    }
}

bool script_text_read_open(ScriptText *script, int file, Error *error) {
    *script = (ScriptText){0};
    bool is_read = read_all(script, file, error);
    if (!is_read) {
        script_text_deinit(script);
    }
    return is_read;
}

bool script_text_read(ScriptText *script, const char *path, Error *error) {
    *script = (ScriptText){0};
    int file = open_script(path, error);
    if (file < 0) {
        return false;
    }
    bool is_read = script_text_read_open(script, file, error);
    if (file != STDIN_FILENO) {
        close(file);
    }
    return is_read;
}

/**
 * @return Line number of a byte, from 1.
 * @param script  The file.
 * @param byte    One of its bytes.
 */
static int line_number_of(const ScriptText *script, const char *byte) {
    int line = 1;
    for (const char *c = script->text; c < byte; c++) {
        line += *c == '\n';
    }
    return line;
}

bool script_text_check(const ScriptText *script, int *line, Error *error) {
    /** First byte of all compiled Lua (LUA_SIGNATURE). */
    const char bytecode_signature = '\x1B';
    size_t size;
    const char *text = script_text_body(script, &size);
    const char *zero = size ? memchr(text, '\0', size) : NULL;
    bool is_bytecode = size > 0 && text[0] == bytecode_signature;
    if (line) {
        *line = zero && !is_bytecode ? line_number_of(script, zero) : 1;
    }
    if (is_bytecode) {
        return error_set(error, STATUS_SCENE,
                         "this is compiled Lua, which is not run; a scene is a text");
    }
    if (zero) {
        return error_set(error, STATUS_SCENE,
                         "this is not text in UTF-8 (there is a zero byte in it)");
    }
    return true;
}

bool script_text_load(const char *path, ScriptText *text, Error *error) {
    char display_path[SANITIZED_PATH_SIZE];
    sanitize_path(display_path, path);
    if (!script_text_read(text, path, error)) {
        return error_prefix(error, "%s: ", display_path);
    }
    int line;
    if (!script_text_check(text, &line, error)) {
        script_text_deinit(text);
        return error_prefix(error, "%s:%d: ", display_path, line);
    }
    return true;
}

const char *script_text_body(const ScriptText *script, size_t *size) {
    const size_t mark_length = strlen(byte_order_mark);
    bool is_marked =
        script->size >= mark_length && memcmp(script->text, byte_order_mark, mark_length) == 0;
    size_t start = is_marked ? mark_length : 0;
    if (start < script->size && script->text[start] == '#') {
        while (start < script->size && script->text[start] != '\n') {
            start++;
        }
    }
    *size = script->size - start;
    return script->text + start;
}

void script_text_deinit(ScriptText *script) {
    free(script->text);
    *script = (ScriptText){0};
}
