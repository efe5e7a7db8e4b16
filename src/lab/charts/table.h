/**
 * @file
 * @brief Tables on the terminal: text is aligned left, numbers right.
 */
#ifndef DIOPTRE_LAB_CHARTS_TABLE_H
#define DIOPTRE_LAB_CHARTS_TABLE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/** Longest text of a cell, bytes with its final zero. */
enum { TABLE_CELL_SIZE = 48 };

/** A table that is being filled. */
typedef struct Table {
    char (*cells)[TABLE_CELL_SIZE]; /**< Row by row, the heading first; owned. */
    size_t columns;                 /**< Number of columns. */
    size_t text_columns;            /**< Number of leading columns of text. */
    size_t count;                   /**< Cells so far. */
    size_t capacity;                /**< Cells that fit in. */
} Table;

/**
 * @return A table without cells, to be released with #table_deinit.
 * @param words  Number of leading columns of text.
 */
Table table_make(size_t columns, size_t words);

/** Adds a cell, unless memory is short. @param format Its text, as for printf. */
void table_cell(Table *table, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Adds a number with three digits; NaN: a dash. */
void table_number(Table *table, double number);

/** Adds a row of column names, translated; an empty name stays empty. */
void table_heading(Table *table, const char *const *columns);

/** Prints a table. */
void table_print(const Table *table, FILE *stream);

/** Releases the cells. */
void table_deinit(Table *table);

#endif
