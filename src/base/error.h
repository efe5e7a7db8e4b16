/**
 * @file
 * @brief Errors as values: what went wrong, in words, with the exit status it leads to.
 */
#ifndef DIOPTRE_BASE_ERROR_H
#define DIOPTRE_BASE_ERROR_H

#include <stdbool.h>

/** Longest message that is kept, in bytes with its final zero: two paths and a sentence. */
enum { ERROR_MESSAGE_SIZE = 1024 };

/** What a command ends with; the numbers are the program's exit statuses. */
typedef enum {
    STATUS_OK = 0,           /**< All was done. */
    STATUS_FAILED = 1,       /**< It could not be finished: disk full, no memory. */
    STATUS_USAGE = 2,        /**< The command line is wrong. */
    STATUS_SCENE = 3,        /**< Something is wrong with a scene or a file that it names. */
    STATUS_UNREADABLE = 4,   /**< A picture to be compared cannot be read. */
    STATUS_INTERRUPTED = 130 /**< Stopped from outside (SIGINT); what is finished is kept. */
} Status;

/** One error: a status and a sentence for a person. Starts as `{0}`: no error. */
typedef struct Error {
    Status status;                    /**< #STATUS_OK while nothing went wrong. */
    char message[ERROR_MESSAGE_SIZE]; /**< What went wrong, without a final newline. */
} Error;

/**
 * Writes an error down.
 * @param[out] error  Where to; may be NULL, when the caller wants no words.
 * @param status      What the program should end with.
 * @param format      The message in English, as for printf, looked up in the language that the
 * program speaks; cut at #ERROR_MESSAGE_SIZE - 1 bytes.
 * @return false, always, so that a function can end with `return error_set(...)`.
 */
bool error_set(Error *error, Status status, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/**
 * Puts words before an error's message, such as the file and line it belongs to.
 * @param[in,out] error  An error that was set; may be NULL.
 * @param format         The words, as for printf; looked up, too.
 * @return false, always.
 */
bool error_prefix(Error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

/**
 * @return What the system says of an error, in the language that the program speaks.
 * @param code  The error: an `errno`.
 */
const char *error_errno_text(int code);

#endif
