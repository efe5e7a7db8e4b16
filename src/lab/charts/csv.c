/**
 * @file
 * @brief Tables of comma-separated values with a header of their origin.
 */
#include "lab/charts/csv.h"

#include <float.h>
#include <math.h>
#include <string.h>

/** Finds what the processor is called. @param[out] name Its name, or that it is not known. */
static void find_cpu_name(char *name, size_t size) {
    char line[256];
    FILE *file = fopen("/proc/cpuinfo", "re");
    snprintf(name, size, "not known");
    while (file && fgets(line, sizeof line, file)) {
        const char *colon = strchr(line, ':');
        if (strncmp(line, "model name", strlen("model name")) == 0 && colon) {
            snprintf(name, size, "%.*s", (int)strcspn(colon + 1, "\n"), colon + 1);
            break;
        }
    }
    if (file) {
        fclose(file);
    }
}

/** @return The name of the compiler, before its version. */
static const char *compiler_name(void) {
#if defined(__clang__)
    return ""; // Its version names it.
#else
    return "gcc ";
#endif
}

bool csv_begin(Csv *csv, const char *path, const char *title, Error *error) {
    char processor[256];
    *csv = (Csv){.path = path};
    if (!atomic_file_open(&csv->file, path, ATOMIC_REPLACE, error)) {
        return error_prefix(error, "cannot write '%s': ", path);
    }
    find_cpu_name(processor, sizeof processor);
    fprintf(csv->file.stream,
            "# dioptre %s: %s\n# compiler: %s%s; flags: %s\n# processor:%s; LDBL_MANT_DIG %d; "
            "FLT_EVAL_METHOD %d\n",
            DIOPTRE_VERSION, title, compiler_name(), __VERSION__, DIOPTRE_FLAGS, processor,
            LDBL_MANT_DIG, FLT_EVAL_METHOD);
    return true;
}

/** Puts a comma where a row has begun. @return Where to write. */
static FILE *next_cell(Csv *csv) {
    if (csv->is_in_row) {
        fputc(',', csv->file.stream);
    }
    csv->is_in_row = true;
    return csv->file.stream;
}

void csv_text(Csv *csv, const char *text) {
    fputs(text, next_cell(csv));
}

void csv_number(Csv *csv, double number) {
    FILE *stream = next_cell(csv);
    if (!isnan(number)) {
        fprintf(stream, "%.6g", number);
    }
}

void csv_end_row(Csv *csv) {
    fputc('\n', csv->file.stream);
    csv->is_in_row = false;
}

void csv_numbers(Csv *csv, const double *numbers, size_t count) {
    for (size_t i = 0; i < count; i++) {
        csv_number(csv, numbers[i]);
    }
    csv_end_row(csv);
}

void csv_heading(Csv *csv, const char *const *columns, size_t count) {
    for (size_t i = 0; i < count; i++) {
        csv_text(csv, columns[i]);
    }
    csv_end_row(csv);
}

bool csv_commit(Csv *csv, Error *error) {
    return atomic_file_commit(&csv->file, error) ||
           error_prefix(error, "cannot write '%s': ", csv->path);
}
