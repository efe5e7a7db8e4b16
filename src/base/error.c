/**
 * @file
 * @brief Errors as values.
 */
#include "base/error.h"

#include "base/language.h"

#include <errno.h>
#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool error_set(Error *error, Status status, const char *format, ...) {
    if (error) {
        va_list arguments;
        va_start(arguments, format);
        error->status = status;
        error->line = 0;
        vsnprintf(error->message, sizeof error->message, gettext(format), arguments);
        va_end(arguments);
    }
    return false;
}

bool error_set_line(Error *error, size_t line) {
    if (error) {
        error->line = line;
    }
    return false;
}

bool error_prefix(Error *error, const char *format, ...) {
    if (error) {
        char message[ERROR_MESSAGE_SIZE];
        memcpy(message, error->message, sizeof message);
        va_list arguments;
        va_start(arguments, format);
        int length = vsnprintf(error->message, sizeof error->message, gettext(format), arguments);
        va_end(arguments);
        if (length >= 0 && (size_t)length < sizeof error->message) {
            size_t size_left = sizeof error->message - (size_t)length;
            snprintf(error->message + length, size_left, "%.*s", (int)size_left - 1, message);
        }
    }
    return false;
}

/** An error of the system, with a message that is translated. */
typedef struct SystemError {
    int code;         /**< Its `errno`. */
    const char *text; /**< Its message in English. */
} SystemError;

const char *error_errno_text(int code) {
    static const SystemError known[] = {
        {EACCES, N_("Permission denied")},
        {EEXIST, N_("File exists")},
        {EFBIG, N_("File too large")},
        {EIO, N_("Input/output error")},
        {EISDIR, N_("Is a directory")},
        {ELOOP, N_("Too many levels of symbolic links")},
        {EMFILE, N_("Too many open files")},
        {ENAMETOOLONG, N_("File name too long")},
        {ENOENT, N_("No such file or directory")},
        {ENOMEM, N_("Cannot allocate memory")},
        {ENOSPC, N_("No space left on device")},
        {ENOTDIR, N_("Not a directory")},
        {EPIPE, N_("Broken pipe")},
        {EROFS, N_("Read-only file system")},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (known[i].code == code) {
            return gettext(known[i].text);
        }
    }
    return strerror(code);
}

bool error_set_errno(Error *error, int code) {
    bool is_short = code == ENOMEM || code == EMFILE || code == ENFILE || code == EAGAIN;
    return error_set(error, is_short ? STATUS_FAILED : STATUS_SCENE, "%s", error_errno_text(code));
}
