/**
 * @file
 * @brief Errors as values: a message and an exit status.
 */
#ifndef DIOPTRE_BASE_ERROR_H
#define DIOPTRE_BASE_ERROR_H

#include <stdbool.h>
#include <stddef.h>

/** Size of a message, with its final zero: sufficient for two paths and a sentence. */
enum { ERROR_MESSAGE_SIZE = 1024 };

/** Exit statuses of the program. */
typedef enum {
    STATUS_OK = 0,           /**< Success. */
    STATUS_FAILED = 1,       /**< The task could not be completed: disk full, no memory. */
    STATUS_USAGE = 2,        /**< The command line is wrong. */
    STATUS_SCENE = 3,        /**< A scene, or a file that it names, is invalid; or the sizes of
                                pictures to compare differ. */
    STATUS_UNREADABLE = 4,   /**< A picture to compare cannot be read. */
    STATUS_INTERRUPTED = 130 /**< Interrupted by SIGINT; completed output is kept. */
} Status;

/** An error: a status and a message. Initialised to `{0}`: no error. */
typedef struct Error {
    Status status;                    /**< Status; #STATUS_OK: no error. */
    size_t line;                      /**< Line of the file that is wrong; 0: the whole file. */
    char message[ERROR_MESSAGE_SIZE]; /**< Message, without a final newline. */
} Error;

/**
 * Sets an error.
 * @param[out] error  The error; NULL: none is stored.
 * @param status      Exit status of the program.
 * @param format      The message in English, as for printf, translated here; cut at
 *                    #ERROR_MESSAGE_SIZE - 1 bytes.
 * @return false, always, so that a function can end with `return error_set(...)`.
 */
bool error_set(Error *error, Status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/**
 * Sets the line of an error, for those who know the file.
 * @param[in,out] error  An error that is set; may be NULL.
 * @param line           The line, from 1; 0: the whole file.
 * @return false, always.
 */
bool error_set_line(Error *error, size_t line);

/**
 * Inserts text before the message of an error, such as file and line.
 * @param[in,out] error  An error that is set; may be NULL.
 * @param format         The text in English, as for printf, translated here.
 * @return false, always.
 */
bool error_prefix(Error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

/**
 * Sets the error of a system call that should have read a file.
 * @param[out] error  The error; NULL: none is stored. #STATUS_FAILED where the system is short of
 *                    memory, descriptors or threads, which is no fault of the file; else
 *                    #STATUS_SCENE.
 * @param code        The `errno`.
 * @return false, always.
 */
bool error_set_errno(Error *error, int code);

/**
 * @return The message of a system error, translated.
 * @param code  The `errno`.
 */
const char *error_errno_text(int code);

#endif
