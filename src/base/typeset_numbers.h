/**
 * @file
 * @brief Numbers as they are printed in books: with a true minus, powers of ten, groups of digits.
 */
#ifndef DIOPTRE_BASE_TYPESET_NUMBERS_H
#define DIOPTRE_BASE_TYPESET_NUMBERS_H

#include <stddef.h>

/** Longest text that is set, bytes with the final zero. */
enum { TYPESET_TEXT_SIZE = 1024 };

/**
 * Sets the numbers of a text for readers: as #language_localize_numbers does, then with the minus
 * sign U+2212, 1.2e-05 as 1.2 × 10⁻⁵, and in French five digits and more in groups of three. For
 * texts that are read only: what is typed, copied or parsed keeps the signs of the keyboard.
 * @param[in,out] text  The text, UTF-8. One that is too long, set or not, keeps its signs.
 * @param size          Bytes that it may have with the final zero.
 */
void typeset_numbers(char *text, size_t size);

#endif
