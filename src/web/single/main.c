/**
 * @file
 * @brief The start of a program of fibers: main() is one, too.
 */
#include "render/ray_stack.h"

#include <emscripten.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** main() of src/cli/main.c, renamed by the Makefile. */
int dioptre_main(int argc, char **argv);

/** A command line. */
typedef struct CommandLine {
    int count;    /**< Number of words. */
    char **words; /**< The words, owned. */
} CommandLine;

/** Runs the program, and tells the page its status. @param context A #CommandLine, freed. @return
 * NULL */
static void *run_program(void *context) {
    CommandLine *line = context;
    int status = dioptre_main(line->count, line->words);
    fflush(NULL);
    EM_ASM({ Module['onExit'] && Module['onExit']($0); }, status);
    return NULL;
}

/** @return The fiber of the program is started: 0; the browser calls it. */
int main(int argc, char **argv) {
    pthread_t thread;
    CommandLine *line = calloc(1, sizeof *line);
    line->words = calloc((size_t)argc + 1, sizeof *line->words);
    line->count = argc;
    for (int i = 0; i < argc; i++) {
        line->words[i] = strdup(argv[i]);
    }
    return ray_thread_create(&thread, run_program, line);
}
