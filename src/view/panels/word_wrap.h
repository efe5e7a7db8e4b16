/**
 * @file
 * @brief Words cut into the rows of a panel.
 */
#ifndef DIOPTRE_VIEW_PANELS_WORD_WRAP_H
#define DIOPTRE_VIEW_PANELS_WORD_WRAP_H

#include "view/panels/panel.h"

/**
 * Cuts words into rows, at blanks and at ends of lines.
 * @param[in,out] text  The words, UTF-8; a zero ends each row.
 * @param characters  Letters of a row at most, unless a word is longer.
 * @param maximum  How many rows there may be; words beyond them are left out.
 * @return How many there are.
 */
size_t word_wrap(char *text, int characters, PanelRow *rows, size_t maximum);

#endif
