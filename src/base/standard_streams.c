/**
 * @file
 * @brief The descriptors of standard input, output and error.
 */
#include "base/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

void standard_streams_open(void) {
    int descriptor;
    // open returns the lowest free number, so the loop ends with the first above those three.
    do {
        // Inherited by child processes: their descriptors 0, 1 and 2 must be open, too.
        descriptor = open("/dev/null", O_RDWR); // NOLINT(android-cloexec-open)
    } while (descriptor >= STDIN_FILENO && descriptor <= STDERR_FILENO);
    if (descriptor > STDERR_FILENO) {
        close(descriptor);
    }
}
