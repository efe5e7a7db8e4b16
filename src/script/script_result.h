/**
 * @file
 * @brief The report of a run: where it is, and what went wrong.
 *
 * The worker sends it at the end, and also when a time limit or a crash ends the run.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_RESULT_H
#define DIOPTRE_SCRIPT_SCRIPT_RESULT_H

#include "base/error.h"

#include <limits.h>
#include <stddef.h>

/** How many files a scene may be made of: the scene file and those that it includes. */
enum { SCRIPT_FILES_MAXIMUM = 256 };

/** Bytes of the name that Lua knows a file by, with its final zero: Lua cuts names at 60. */
enum { CHUNK_NAME_SIZE = 60 };

/** A file that a scene is made of. */
typedef struct ScriptFile {
    char path[PATH_MAX];              /**< As the user knows it. */
    char chunk_name[CHUNK_NAME_SIZE]; /**< `=` and a name short enough for Lua, of no other file. */
} ScriptFile;

/** A place in a scene's text. Starts as #SOURCE_LOCATION_START. */
typedef struct SourceLocation {
    int file; /**< Place in #ScriptResult.files. */
    int line; /**< From 1. */
} SourceLocation;

/** The beginning of the scene file: where an error is that no line is to blame for. */
#define SOURCE_LOCATION_START ((SourceLocation){0, 1})

/** The report of a run. */
typedef struct ScriptResult {
    Error error;             /**< What went wrong; with file and line. */
    SourceLocation location; /**< Where the scene was seen last. */
    int file_count;          /**< How many files it is made of, the scene file first. */
    ScriptFile files[SCRIPT_FILES_MAXIMUM]; /**< Those files. */
} ScriptResult;

/**
 * Makes an empty report.
 * @param path  The scene file, as the user knows it.
 * @return The report, to be given back with #script_result_destroy; NULL without memory.
 */
ScriptResult *script_result_create(const char *path);

/** @return Bytes of a report that are used. */
size_t script_result_size(const ScriptResult *result);

/** Gives a report back. @param result The report, or NULL. */
void script_result_destroy(ScriptResult *result);

/**
 * Notes a file that the scene is made of; once, however often it is included.
 * @param path  The file, as the user knows it; at most PATH_MAX - 1 bytes count.
 * @return The file; NULL when there are SCRIPT_FILES_MAXIMUM already.
 */
const ScriptFile *script_result_add_file(ScriptResult *result, const char *path);

/**
 * Finds a file by the name that Lua calls it.
 * @param name  The name: #ScriptFile.chunk_name without the `=`.
 * @return Its place in #ScriptResult.files; -1 if there is none.
 */
int script_result_find_file(const ScriptResult *result, const char *name);

/**
 * Reads the place that Lua has put before a message: `NAME:LINE: `.
 * @param[out] location  The place; untouched if there is none.
 * @return Bytes of the message that the place takes; 0 if there is none.
 */
size_t script_result_parse_location(const ScriptResult *result, const char *text,
                                    SourceLocation *location);

/** Says a place in words, as `FILE:LINE`, safe to show. */
void script_result_format_location(const ScriptResult *result, SourceLocation location, char *text,
                                   size_t size);

/** Writes down what went wrong, as `FILE:LINE: text`. */
void script_result_fail(ScriptResult *result, SourceLocation location, const char *text,
                        size_t length);

#endif
