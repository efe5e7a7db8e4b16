/**
 * @file
 * @brief Text files.
 */
#include "base/text_file.h"

#include "base/atomic_file.h"

#include <errno.h>

bool text_file_write_new(const char *path, const char *text, size_t size, bool *exists,
                         Error *error) {
    AtomicFile file;
    bool is_written = false;
    *exists = false;
    if (atomic_file_open(&file, path, ATOMIC_NEW, error)) {
        if (fwrite(text, 1, size, file.stream) == size) {
            is_written = atomic_file_commit(&file, error);
        } else {
            error_set(error, STATUS_FAILED, "%s", error_errno_text(errno));
            atomic_file_discard(&file);
        }
    }
    *exists = !is_written && file.exists;
    return is_written || error_prefix(error, "cannot write '%s': ", path);
}
