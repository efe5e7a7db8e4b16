/**
 * @file
 * @brief Tables of comma-separated values that say how they came about.
 *
 * The lines before the first row begin with `#`: what it is, and the compiler, its flags, the
 * processor and the number types that it was found with. No date: the same program on the same
 * machine writes the same figures.
 */
#ifndef DIOPTRE_LAB_CHARTS_CSV_H
#define DIOPTRE_LAB_CHARTS_CSV_H

#include "base/atomic_file.h"

/** A table that is being written. */
typedef struct Csv {
    AtomicFile file;  /**< Where to. */
    const char *path; /**< Its place, for errors. */
    bool is_in_row;   /**< Whether something stands in the newest row. */
} Csv;

/**
 * Begins a table.
 * @param[out] csv    The table, to be ended with #csv_commit or #csv_discard.
 * @param path        Its place; must live as long.
 * @param title       What it is, in one line.
 * @param[out] error  Why it cannot be written (#STATUS_FAILED).
 * @return Whether it is begun; otherwise there is nothing to end.
 */
bool csv_begin(Csv *csv, const char *path, const char *title, Error *error);

/** Adds a word to the newest row. */
void csv_text(Csv *csv, const char *word);

/** Adds a number to the newest row. @param number It; NaN: an empty cell. */
void csv_number(Csv *csv, double number);

/** Ends the newest row. */
void csv_end_row(Csv *csv);

/**
 * Ends a table.
 * @param[out] error  What is wrong, such as a full disk.
 * @return Whether all of it is in its place; else nothing is.
 */
bool csv_commit(Csv *csv, Error *error);

/** Gives a table up: nothing is left of it. */
void csv_discard(Csv *csv);

#endif
