/**
 * @file
 * @brief Errors as values.
 */
#include "dioptre/error.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

bool error_set(Error *error, Status status, const char *format, ...) {
    if (error) {
        va_list arguments;
        va_start(arguments, format);
        error->status = status;
        vsnprintf(error->message, sizeof error->message, format, arguments);
        va_end(arguments);
    }
    return false;
}

bool error_prefix(Error *error, const char *format, ...) {
    if (error) {
        char message[ERROR_MESSAGE_SIZE];
        memcpy(message, error->message, sizeof message);
        va_list arguments;
        va_start(arguments, format);
        int length = vsnprintf(error->message, sizeof error->message, format, arguments);
        va_end(arguments);
        if (length >= 0 && (size_t)length < sizeof error->message) {
            size_t room = sizeof error->message - (size_t)length;
            snprintf(error->message + length, room, "%.*s", (int)room - 1, message);
        }
    }
    return false;
}
