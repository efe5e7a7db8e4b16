/**
 * @file
 * @brief What all fuzz targets share. A target is one function, which libFuzzer calls with bytes.
 *
 * `make fuzz` builds and runs them; tests/fuzz.sh names them. A target ends the process where a
 * promise is broken, which libFuzzer reports with the bytes.
 */
#ifndef DIOPTRE_TESTS_FUZZ_H
#define DIOPTRE_TESTS_FUZZ_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/**
 * Runs a target once. libFuzzer calls it.
 * @param data  The bytes.
 * @param size  Number of bytes.
 * @return 0
 */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/** Ends the process unless a promise holds. */
#define FUZZ_REQUIRE(condition)                                                                    \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: broken promise: %s\n", __FILE__, __LINE__, #condition);        \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

/** Bytes from which a target takes its values, from front to back. */
typedef struct FuzzInput {
    const uint8_t *next; /**< The next byte. */
    size_t size;         /**< Number of bytes left. */
} FuzzInput;

/** Takes bytes; those that are missing become zero. */
static inline void fuzz_take(FuzzInput *input, void *out, size_t size) {
    size_t count = size < input->size ? size : input->size;
    memset(out, 0, size);
    if (count > 0) {
        memcpy(out, input->next, count);
        input->next += count;
        input->size -= count;
    }
}

/** Takes a byte. @return It; 0 at the end. */
static inline uint8_t fuzz_take_byte(FuzzInput *input) {
    uint8_t byte;
    fuzz_take(input, &byte, sizeof byte);
    return byte;
}

/**
 * Checks an error of a file: it has a reason, which no terminal takes for a command.
 * @param error  The error.
 */
static inline void fuzz_check_error(const Error *error) {
    const char *message = error->message;
    FUZZ_REQUIRE(error->status != STATUS_OK);
    FUZZ_REQUIRE(message[0] != '\0' && memchr(message, '\0', sizeof error->message));
    for (const unsigned char *c = (const unsigned char *)message; *c; c++) {
        FUZZ_REQUIRE((*c >= ' ' && *c != 0x7F) || *c == '\n' || *c == '\t');
        FUZZ_REQUIRE(!(c[0] == 0xC2 && c[1] >= 0x80 && c[1] < 0xA0));
    }
}

#endif
