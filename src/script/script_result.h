/**
 * @file
 * @brief The report of a run: its current line, and its error.
 *
 * The worker sends it at the end, and also when a time limit or a crash ends the run.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_RESULT_H
#define DIOPTRE_SCRIPT_SCRIPT_RESULT_H

#include "base/error.h"

#include <limits.h>
#include <stddef.h>

/** Largest number of files of a scene, with those that it includes. */
enum { SCRIPT_FILES_MAXIMUM = 256 };

/** Size of a chunk name of Lua, with its final zero: Lua cuts names at 60 (LUA_IDSIZE). */
enum { CHUNK_NAME_SIZE = 60 };

/** A file of a scene. */
typedef struct ScriptFile {
    char path[PATH_MAX];              /**< Path for messages. */
    char chunk_name[CHUNK_NAME_SIZE]; /**< `=` and a short unique name, by which Lua's messages name
                                         the file. A scene can read it, so it does not tell in
                                         which folder the scene lies. */
} ScriptFile;

/** A line of a scene. Initialised to #SOURCE_LOCATION_START. */
typedef struct SourceLocation {
    int file; /**< Index in #ScriptResult.files. */
    int line; /**< Line, from 1. */
} SourceLocation;

/** First line of the scene file, for errors without a known line. */
#define SOURCE_LOCATION_START ((SourceLocation){0, 1})

/** The report of a run. */
typedef struct ScriptResult {
    Error error;                            /**< Error of the run, with file and line. */
    SourceLocation location;                /**< Last known line of the run. */
    int file_count;                         /**< Number of files of the scene. */
    ScriptFile files[SCRIPT_FILES_MAXIMUM]; /**< The files; the first is the scene file. */
} ScriptResult;

/**
 * Creates an empty report.
 * @param path  Path of the scene file, for messages.
 * @return The report, to be freed with #script_result_destroy; NULL without memory.
 */
ScriptResult *script_result_create(const char *path);

/**
 * Makes a report valid that another process has sent: a script may have got hold of it. Texts end,
 * indices are in range, the message cannot control a terminal.
 * @param[in,out] result  The report.
 * @param path            Path of the scene file.
 */
void script_result_repair(ScriptResult *result, const char *path);

/** @return Bytes of a report that are in use. @param result The report. */
size_t script_result_size(const ScriptResult *result);

/** Frees a report. @param result The report, or NULL. */
void script_result_destroy(ScriptResult *result);

/**
 * Adds a file of the scene, unless it is there.
 * @param result  The report.
 * @param path    Path of the file, for messages; cut at PATH_MAX - 1 bytes.
 * @param name    Its name in the folder of the scene.
 * @return The file; NULL if there are #SCRIPT_FILES_MAXIMUM already.
 */
const ScriptFile *script_result_add_file(ScriptResult *result, const char *path, const char *name);

/**
 * Finds a file by its chunk name.
 * @param result  The report.
 * @param name    #ScriptFile.chunk_name without the `=`.
 * @return Its index in #ScriptResult.files; -1: none.
 */
int script_result_find_file(const ScriptResult *result, const char *name);

/**
 * Parses the location that Lua puts in front of a message: `NAME:LINE: `.
 * @param result         The report.
 * @param text           The message.
 * @param[out] location  The location; unchanged if there is none.
 * @return Bytes of the location; 0 if there is none.
 */
size_t script_result_parse_location(const ScriptResult *result, const char *text,
                                    SourceLocation *location);

/**
 * Formats a location as `FILE:LINE`, sanitized.
 * @param result     The report.
 * @param location   The location.
 * @param[out] text  The result, with a final zero.
 * @param size       Its size in bytes.
 */
void script_result_format_location(const ScriptResult *result, SourceLocation location, char *text,
                                   size_t size);

/**
 * Sets the error of a report, as `FILE:LINE: text`.
 * @param result    The report.
 * @param location  Where the error occurred.
 * @param text      Description of the error.
 * @param length    Bytes of the description.
 */
void script_result_fail(ScriptResult *result, SourceLocation location, const char *text,
                        size_t length);

#endif
