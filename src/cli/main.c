/**
 * @file
 * @brief The program: finds the command and runs it.
 */
#include "base/language.h"
#include "base/suggest.h"
#include "cli/commands.h"

#include <libintl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/** All commands, ended by NULL. */
static const Command *const commands[] = {&view_command,
                                          &render_command,
                                          &animate_command,
                                          &probe_command,
                                          &info_command,
                                          &compare_command,
                                          &bench_command,
                                          &needs_command,
                                          &chart_command,
                                          &lab_command,
                                          NULL};

/** Letters that the column of usages is wide in the help. */
static const int USAGE_WIDTH = 28;

/** Prints the help of the program. */
static void print_help(void) {
    fputs(gettext("dioptre: a ray tracer to teach with\n\n"
                  "usage: dioptre COMMAND ...\n"
                  "       dioptre SCENE     the same as dioptre view SCENE\n\n"),
          stdout);
    for (const Command *const *command = commands; *command; command++) {
        printf("  %-8s ", (*command)->name);
        print_padded(gettext((*command)->usage), USAGE_WIDTH);
        printf(" %s\n", gettext((*command)->help));
    }
    fputs(gettext("\n`dioptre COMMAND --help` names the options. "
                  "`-` as SCENE reads standard input.\n"),
          stdout);
}

/** Prints the help of a command. */
static void print_command_help(const Command *command) {
    printf(gettext("usage: dioptre %s %s\n"), command->name, gettext(command->usage));
    printf("%s\n\n", gettext(command->help));
    options_print(command);
}

/** @return The command of a name, or NULL. */
static const Command *find_command(const char *name) {
    for (const Command *const *command = commands; *command; command++) {
        if (strcmp(name, (*command)->name) == 0) {
            return *command;
        }
    }
    return NULL;
}

/** Says what went wrong; a scene's errors begin with its file. */
static void print_error(const Error *error) {
    if (error->message[0]) {
        const char *prefix = error->status == STATUS_SCENE ? "" : "dioptre: ";
        fprintf(stderr, "%s%s\n", prefix, error->message);
    }
}

/** Runs a command whose options were read. @return The exit status. */
static int run_command(const Command *command, const Options *options, Error *error) {
    int more = options->argument_count - command->arguments;
    if (more > 0 && !command->accepts_more_arguments) {
        error_set(error, STATUS_USAGE, "too many arguments: '%s'",
                  options->arguments[command->arguments]);
        return STATUS_USAGE;
    }
    if (more + command->optional_arguments < 0) {
        error_set(error, STATUS_USAGE, "usage: dioptre %s %s (--help says more)", command->name,
                  gettext(command->usage));
        return STATUS_USAGE;
    }
    int status = command->run(options, error);
    // What was printed must have got out: a full disk behind a redirection is an error too.
    if (fflush(stdout) != 0 && status == STATUS_OK) {
        error_set(error, STATUS_FAILED, "cannot write to standard output");
        return STATUS_FAILED;
    }
    return status;
}

/** @return Whether a first word may name a scene: there is such a file, it is standard input, or it
 *  is written as scenes are. */
static bool may_be_scene(const char *word) {
    const char *ending = strrchr(word, '.');
    return access(word, F_OK) == 0 || strcmp(word, "-") == 0 || strchr(word, '/') ||
           (ending && strcmp(ending, ".lua") == 0);
}

/** Says that a first word is no command. @return The exit status. */
static int refuse_word(const char *word, Error *error) {
    Suggestion suggestion = {.word = word};
    char hint[SUGGEST_HINT_SIZE];
    for (const Command *const *command = commands; *command; command++) {
        suggest_try(&suggestion, (*command)->name);
    }
    error_set(error, STATUS_USAGE, "'%s' is neither a command nor a scene file%s", word,
              suggest_hint(&suggestion, hint));
    return STATUS_USAGE;
}

/** Does what a command line says. @return The exit status. */
static int parse_and_run(int argc, char **argv, Error *error) {
    const Command *command = argc > 1 ? find_command(argv[1]) : NULL;
    // A first word that is neither a command nor an option is a scene to view.
    bool is_scene = !command && argc > 1 && (argv[1][0] != '-' || argv[1][1] == 0);
    int skip = command ? 1 : 0;
    Options options;
    if (is_scene) {
        if (!may_be_scene(argv[1])) {
            return refuse_word(argv[1], error);
        }
        command = &view_command;
    }
    if (!options_parse(command, argc - skip, argv + skip, &options, error)) {
        return STATUS_USAGE;
    }
    if (options.version) {
        printf("dioptre %s\n", DIOPTRE_VERSION);
        return STATUS_OK;
    }
    if (options.help) {
        command ? print_command_help(command) : print_help();
        return STATUS_OK;
    }
    if (!command) {
        return error_set(error, STATUS_USAGE, "which command? (--help names them)"), STATUS_USAGE;
    }
    return run_command(command, &options, error);
}

/**
 * The program.
 * @param argc  Number of words on the command line.
 * @return The exit status, see #Status.
 */
int main(int argc, char **argv) {
    Error error = {0};
    language_init();
    // Without this, writing to a pipe whose reader has gone, or a file larger than the system
    // allows, would kill the program unheard.
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    int status = parse_and_run(argc, argv, &error);
    print_error(&error);
    return status;
}
