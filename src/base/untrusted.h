/**
 * @file
 * @brief Checks of plain data that another process has made, which a stranger's file may control.
 */
#ifndef DIOPTRE_BASE_UNTRUSTED_H
#define DIOPTRE_BASE_UNTRUSTED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/**
 * @return Whether a flag has one of the two bytes of a bool; to read any other one is undefined.
 * @param flag  Address of the bool.
 */
static inline bool untrusted_is_bool(const void *flag) {
    unsigned char byte;
    memcpy(&byte, flag, sizeof byte);
    return byte <= 1;
}

/**
 * @return Whether an object lies in a block.
 * @param start    The block.
 * @param used     Its bytes in use.
 * @param pointer  Address of the object; any value.
 * @param size     Bytes of the object, at least 1.
 */
static inline bool untrusted_lies_in(const void *start, size_t used, const void *pointer,
                                     size_t size) {
    uintptr_t first = (uintptr_t)start, address = (uintptr_t)pointer;
    return address >= first && address - first < used && size <= used - (address - first);
}

#endif
