/**
 * @file
 * @brief What the child that runs a scene tells the parent: where it is, and what went wrong.
 *
 * A report lies in memory that both share, so it is readable even when the child was killed in the
 * middle of its work.
 */
#ifndef SCRIPT_REPORT_H
#define SCRIPT_REPORT_H

#include "dioptre/error.h"

#include <limits.h>
#include <stddef.h>

/** How many files a scene may be made of: the scene file and those that it includes. */
enum { REPORT_FILES_MAXIMUM = 256 };

/** Bytes of the name that Lua knows a file by, with its final zero: Lua cuts names at 60. */
enum { REPORT_CHUNK_SIZE = 60 };

/** A file that a scene is made of. */
typedef struct ReportFile {
    char path[PATH_MAX];           /**< As the user knows it. */
    char chunk[REPORT_CHUNK_SIZE]; /**< `=` and a name short enough for Lua, of no other file. */
} ReportFile;

/** A place in a scene's text. Starts as #REPORT_START. */
typedef struct Location {
    int file; /**< Place in #Report.files. */
    int line; /**< From 1. */
} Location;

/** The beginning of the scene file: where an error is that no line is to blame for. */
#define REPORT_START ((Location){0, 1})

/** What the parent learns. */
typedef struct Report {
    Error error;       /**< What went wrong; with file and line. */
    bool is_done;      /**< Whether the child came to the end of its work, well or badly. */
    Location location; /**< Where the scene was seen last. */
    int file_count;    /**< How many files it is made of, the scene file first. */
    ReportFile files[REPORT_FILES_MAXIMUM]; /**< Those files. */
} Report;

/**
 * Makes an empty report in shared memory.
 * @param path        The scene file, as the user knows it.
 * @param[out] error  What is wrong.
 * @return The report, to be given back with #report_destroy; NULL without memory.
 */
Report *report_create(const char *path, Error *error);

/** Gives a report back. @param report The report, or NULL. */
void report_destroy(Report *report);

/**
 * Notes a file that the scene is made of; once, however often it is included.
 * @param[in,out] report  The report.
 * @param path            The file, as the user knows it; at most PATH_MAX - 1 bytes count.
 * @return The file; NULL when there are REPORT_FILES_MAXIMUM already.
 */
const ReportFile *report_add_file(Report *report, const char *path);

/**
 * Finds a file by the name that Lua calls it.
 * @param report  The report.
 * @param name    The name: #ReportFile.chunk without the `=`.
 * @return Its place in #Report.files; -1 if there is none.
 */
int report_find_file(const Report *report, const char *name);

/**
 * Reads the place that Lua has put before a message: `NAME:LINE: `.
 * @param report         The report.
 * @param text           The message.
 * @param[out] location  The place; untouched if there is none.
 * @return Bytes of the message that the place takes; 0 if there is none.
 */
size_t report_read_location(const Report *report, const char *text, Location *location);

/**
 * Says a place in words, as `FILE:LINE`, safe to show.
 * @param report      The report.
 * @param location    The place.
 * @param[out] words  The words.
 * @param size        Bytes that fit.
 */
void report_describe(const Report *report, Location location, char *words, size_t size);

/**
 * Writes down what went wrong, as `FILE:LINE: text`.
 * @param[in,out] report  The report.
 * @param location        Where.
 * @param text            What; any bytes.
 * @param length          How many bytes.
 */
void report_fail(Report *report, Location location, const char *text, size_t length);

#endif
