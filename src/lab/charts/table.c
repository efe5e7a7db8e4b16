/**
 * @file
 * @brief Tables on the terminal.
 */
#include "lab/charts/table.h"

#include "base/language.h"

#include <libintl.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

Table table_make(size_t columns, size_t words) {
    return (Table){.columns = columns, .text_columns = words};
}

/** Makes room for a cell. @return false without memory. */
static bool make_room(Table *table) {
    if (table->count < table->capacity) {
        return true;
    }
    size_t capacity = table->capacity ? 2 * table->capacity : 256;
    void *cells = realloc(table->cells, capacity * sizeof *table->cells);
    if (cells) {
        table->cells = cells;
        table->capacity = capacity;
    }
    return cells != NULL;
}

void table_cell(Table *table, const char *format, ...) {
    if (make_room(table)) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(table->cells[table->count++], TABLE_CELL_SIZE, format, arguments);
        va_end(arguments);
    }
}

void table_number(Table *table, double number) {
    if (isnan(number)) {
        table_cell(table, "-");
    } else {
        table_cell(table, "%.3g", number);
    }
}

void table_heading(Table *table, const char *const *columns) {
    for (size_t i = 0; i < table->columns; i++) {
        table_cell(table, "%s", columns[i][0] ? gettext(columns[i]) : "");
    }
}

/** @return The width of a column, characters. */
static int column_width(const Table *table, size_t column) {
    int width = 0;
    for (size_t i = column; i < table->count; i += table->columns) {
        int length = language_text_width(table->cells[i]);
        width = length > width ? length : width;
    }
    return width;
}

void table_print(const Table *table, FILE *stream) {
    for (size_t i = 0; i < table->count; i++) {
        size_t column = i % table->columns;
        bool is_last = column == table->columns - 1;
        // printf counts bytes; a minus sign makes it fill up on the right.
        int bytes = (int)strlen(table->cells[i]) - language_text_width(table->cells[i]);
        int width = column_width(table, column) + bytes;
        fprintf(stream, "%*s%s", column < table->text_columns ? -width : width, table->cells[i],
                is_last ? "\n" : "  ");
    }
}

void table_deinit(Table *table) {
    free(table->cells);
    *table = (Table){0};
}
