/**
 * @file
 * @brief The report of a run.
 */
#include "script/script_result.h"

#include "assets/process/worker_process.h"
#include "base/base_name.h"
#include "base/sanitize.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

ScriptResult *script_result_create(const char *path) {
    ScriptResult *result = calloc(1, sizeof *result);
    if (result) {
        result->location = SOURCE_LOCATION_START;
        script_result_add_file(result, path, base_name(path));
    }
    return result;
}

size_t script_result_size(const ScriptResult *result) {
    return offsetof(ScriptResult, files) + (size_t)result->file_count * sizeof *result->files;
}

void script_result_destroy(ScriptResult *result) {
    free(result);
}

void script_result_repair(ScriptResult *result, const char *path) {
    char message[ERROR_MESSAGE_SIZE];
    bool is_valid = result->file_count >= 1 && result->file_count <= SCRIPT_FILES_MAXIMUM &&
                    result->location.file >= 0 && result->location.file < result->file_count;
    for (int i = 0; is_valid && i < result->file_count; i++) {
        ScriptFile *file = &result->files[i];
        is_valid = memchr(file->path, '\0', sizeof file->path) &&
                   memchr(file->chunk_name, '\0', sizeof file->chunk_name);
    }
    if (!is_valid) {
        result->location = SOURCE_LOCATION_START;
        result->file_count = 0;
        script_result_add_file(result, path, base_name(path));
    }
    if (result->error.status != STATUS_OK) {
        size_t length = strnlen(result->error.message, sizeof message - 1);
        sanitize_text(message, sizeof message, result->error.message, length);
        worker_error_set(&result->error, &(Error){.status = result->error.status});
        memcpy(result->error.message, message, sizeof message);
    }
}

/**
 * Makes the chunk name of a file. Lua cuts long names, which could make two files equal; a long
 * name, or one that another file has, is therefore replaced by its number and its end.
 * @param result           The report.
 * @param[out] chunk_name  The name.
 * @param name             Name of the file in the folder of the scene.
 */
static void make_chunk_name(const ScriptResult *result, char chunk_name[CHUNK_NAME_SIZE],
                            const char *name) {
    /** Bytes kept of the end of a long name, for scenes that print it. */
    const size_t tail_length = 40;
    size_t length = strlen(name);
    if (length + 2 <= CHUNK_NAME_SIZE && script_result_find_file(result, name) < 0) {
        snprintf(chunk_name, CHUNK_NAME_SIZE, "=%s", name);
    } else {
        const char *tail = length > tail_length ? name + length - tail_length : name;
        snprintf(chunk_name, CHUNK_NAME_SIZE, "=#%d...%s", result->file_count, tail);
    }
}

const ScriptFile *script_result_add_file(ScriptResult *result, const char *path, const char *name) {
    for (int i = 0; i < result->file_count; i++) {
        if (strcmp(result->files[i].path, path) == 0) {
            return &result->files[i];
        }
    }
    if (result->file_count == SCRIPT_FILES_MAXIMUM) {
        return NULL;
    }
    ScriptFile *file = &result->files[result->file_count];
    snprintf(file->path, sizeof file->path, "%s", path);
    make_chunk_name(result, file->chunk_name, name);
    result->file_count++;
    return file;
}

int script_result_find_file(const ScriptResult *result, const char *name) {
    for (int i = 0; i < result->file_count; i++) {
        if (strcmp(result->files[i].chunk_name + 1, name) == 0) {
            return i;
        }
    }
    return -1;
}

/**
 * Parses `NAME:LINE: ` for one file.
 * @param name       Its name in messages of Lua.
 * @param text       The message.
 * @param[out] line  The line, from 1.
 * @return Number of bytes parsed; 0 if the message does not begin so.
 */
static size_t parse_line(const char *name, const char *text, int *line) {
    size_t length = strlen(name);
    if (strncmp(text, name, length) != 0 || text[length] != ':') {
        return 0;
    }
    const char *digits = text + length + 1;
    char *end;
    long number = strtol(digits, &end, 10);
    if (end == digits || number < 1 || number > INT_MAX || strncmp(end, ": ", 2) != 0) {
        return 0;
    }
    *line = (int)number;
    return (size_t)(end + 2 - text);
}

size_t script_result_parse_location(const ScriptResult *result, const char *text,
                                    SourceLocation *location) {
    for (int i = 0; i < result->file_count; i++) {
        int line;
        size_t length = parse_line(result->files[i].chunk_name + 1, text, &line);
        if (length > 0) {
            *location = (SourceLocation){i, line};
            return length;
        }
    }
    return 0;
}

void script_result_format_location(const ScriptResult *result, SourceLocation location, char *text,
                                   size_t size) {
    char path[SANITIZED_PATH_SIZE];
    sanitize_path(path, result->files[location.file].path);
    snprintf(text, size, "%s:%d", path, location.line);
}

void script_result_fail(ScriptResult *result, SourceLocation location, const char *text,
                        size_t length) {
    char prefix[ERROR_MESSAGE_SIZE], message[ERROR_MESSAGE_SIZE];
    script_result_format_location(result, location, prefix, sizeof prefix);
    sanitize_text(message, sizeof message, text, length);
    error_set(&result->error, STATUS_SCENE, "%s: %s", prefix, message);
}
