/**
 * @file
 * @brief Paths in messages about scenes.
 */
#include "script/sanitize.h"

#include <string.h>

void sanitize_path(char out[SANITIZED_PATH_SIZE], const char *path) {
    static const char ellipsis[] = "...";
    size_t tail_length = SANITIZED_PATH_SIZE - sizeof ellipsis;
    size_t length = strlen(path);
    if (length < SANITIZED_PATH_SIZE) {
        sanitize_line(out, SANITIZED_PATH_SIZE, path);
        return;
    }
    memcpy(out, ellipsis, sizeof ellipsis);
    sanitize_line(out + strlen(ellipsis), tail_length + 1, path + length - tail_length);
}
