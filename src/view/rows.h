/**
 * @file
 * @brief Words cut into the rows of a panel.
 */
#ifndef DIOPTRE_VIEW_ROWS_H
#define DIOPTRE_VIEW_ROWS_H

#include "view/panel.h"

/**
 * Cuts words into rows, at blanks and at ends of lines.
 * @param[in,out] words  The words, UTF-8; a zero ends each row.
 * @param letters        Letters of a row at most, unless a word is longer.
 * @param[out] rows      The rows.
 * @param most           How many rows there may be; words beyond them are left out.
 * @return How many there are.
 */
size_t rows_cut(char *words, int letters, PanelRow *rows, size_t most);

#endif
