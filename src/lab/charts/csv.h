/**
 * @file
 * @brief Tables of comma-separated values with a header of their origin.
 *
 * The lines before the first row begin with `#`: the title, the compiler, its flags, the processor
 * and the number types. There is no date: the same program on the same machine writes the same
 * file.
 */
#ifndef DIOPTRE_LAB_CHARTS_CSV_H
#define DIOPTRE_LAB_CHARTS_CSV_H

#include "base/atomic_file.h"

/** A table that is being written. */
typedef struct Csv {
    AtomicFile file;  /**< The file. */
    const char *path; /**< Its path, for errors. */
    bool is_in_row;   /**< Whether the last row has a cell. */
} Csv;

/**
 * Begins a table.
 * @param[out] csv    The table, to be ended with #csv_commit.
 * @param path        Its path; must live as long.
 * @param title       One line.
 * @param[out] error  Why it cannot be written (#STATUS_FAILED).
 * @return Whether it is begun; otherwise there is nothing to end.
 */
bool csv_begin(Csv *csv, const char *path, const char *title, Error *error);

/** Adds a cell of text to the row. */
void csv_text(Csv *csv, const char *text);

/** Adds a cell with a number to the row; NaN: an empty one. */
void csv_number(Csv *csv, double number);

/** Ends the row. */
void csv_end_row(Csv *csv);

/** Adds cells with numbers to the row, and ends it. */
void csv_numbers(Csv *csv, const double *numbers, size_t count);

/** Adds a row of column names. */
void csv_heading(Csv *csv, const char *const *columns, size_t count);

/**
 * Ends a table.
 * @param[out] error  What is wrong, such as a full disk.
 * @return Whether the whole file is written; otherwise an old one stays.
 */
bool csv_commit(Csv *csv, Error *error);

#endif
