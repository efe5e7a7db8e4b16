/**
 * @file
 * @brief The digits with which a number is written so that it can be read back exactly.
 */
#ifndef DIOPTRE_BASE_EXACT_DIGITS_H
#define DIOPTRE_BASE_EXACT_DIGITS_H

/** @return The fewest significant digits that give a number back exactly: for `%.*g`.
 *  @param least  Fewest digits to try. */
int exact_digits(double value, int least);

#endif
