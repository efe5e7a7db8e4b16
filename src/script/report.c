/**
 * @file
 * @brief What the child that runs a scene tells the parent.
 */
#include "script/report.h"

#include "script/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

Report *report_create(const char *path, Error *error) {
    Report *report = mmap(NULL, sizeof *report, PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (report == MAP_FAILED) {
        error_set(error, STATUS_FAILED, "no memory to run a scene");
        return NULL;
    }
    report->location = REPORT_START;
    report_add_file(report, path);
    return report;
}

void report_destroy(Report *report) {
    if (report) {
        munmap(report, sizeof *report);
    }
}

/**
 * Makes up the name by which Lua knows a file. Lua would cut a long one, and two files could then
 * look the same to us; so a long path is told by its number.
 * @param[out] chunk  The name.
 * @param path        The file.
 * @param number      Its place in #Report.files.
 */
static void name_chunk(char chunk[REPORT_CHUNK_SIZE], const char *path, int number) {
    /** Bytes of a long path's end that are kept, for who prints such a name. */
    const size_t tail = 40;
    size_t length = strlen(path);
    if (length + 2 <= REPORT_CHUNK_SIZE) {
        snprintf(chunk, REPORT_CHUNK_SIZE, "=%s", path);
    } else {
        snprintf(chunk, REPORT_CHUNK_SIZE, "=#%d...%s", number, path + length - tail);
    }
}

const ReportFile *report_add_file(Report *report, const char *path) {
    for (int i = 0; i < report->file_count; i++) {
        if (strcmp(report->files[i].path, path) == 0) {
            return &report->files[i];
        }
    }
    if (report->file_count == REPORT_FILES_MAXIMUM) {
        return NULL;
    }
    ReportFile *file = &report->files[report->file_count];
    snprintf(file->path, sizeof file->path, "%s", path);
    name_chunk(file->chunk, path, report->file_count);
    report->file_count++;
    return file;
}

int report_find_file(const Report *report, const char *name) {
    for (int i = 0; i < report->file_count; i++) {
        if (strcmp(report->files[i].chunk + 1, name) == 0) {
            return i;
        }
    }
    return -1;
}

/**
 * Reads `NAME:LINE: ` of one file.
 * @param name         The name that Lua calls it.
 * @param text         A message.
 * @param[out] line    The line, from 1.
 * @return Bytes read; 0 if the message does not begin so.
 */
static size_t read_line(const char *name, const char *text, int *line) {
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

size_t report_read_location(const Report *report, const char *text, Location *location) {
    for (int i = 0; i < report->file_count; i++) {
        int line;
        size_t length = read_line(report->files[i].chunk + 1, text, &line);
        if (length > 0) {
            *location = (Location){i, line};
            return length;
        }
    }
    return 0;
}

void report_describe(const Report *report, Location location, char *words, size_t size) {
    char path[TEXT_PATH_SIZE];
    text_clean_path(path, report->files[location.file].path);
    snprintf(words, size, "%s:%d", path, location.line);
}

void report_fail(Report *report, Location location, const char *text, size_t length) {
    char where[ERROR_MESSAGE_SIZE], words[ERROR_MESSAGE_SIZE];
    report_describe(report, location, where, sizeof where);
    text_clean(words, sizeof words, text, length);
    error_set(&report->error, STATUS_SCENE, "%s: %s", where, words);
}
