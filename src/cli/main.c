/**
 * @file
 * @brief The program: the table of commands, their help, and the choice among them.
 */
#include "assets/process/worker_process.h"
#include "base/language.h"
#include "base/sanitize.h"
#include "base/scene_name.h"
#include "base/standard_streams.h"
#include "base/suggest.h"
#include "cli/commands.h"
#include "render/ray_stack.h"

#include <ctype.h>
#include <libintl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/** All commands; a new command is a row here, a #CommandId and a function. */
static const Command commands[] = {
    {COMMAND_VIEW, "view", N_("SCENE"), N_("shows a scene in a window and moves camera and light"),
     .arguments = 1, .optional_arguments = 1, .run = cli_view},
    {COMMAND_RENDER, "render", N_("SCENE -o FILE"), N_("draws one picture, without a window"),
     .arguments = 1, .run = cli_render},
    {COMMAND_ANIMATE, "animate", N_("SCENE|FRAMES -o FILM|FRAMES"),
     N_("draws a film, or its numbered frames"), .arguments = 1, .run = cli_animate},
    {COMMAND_PROBE, "probe", N_("SCENE X Y"),
     N_("tells the rays of one pixel, and how they add up to it"), .arguments = 3,
     .run = cli_probe},
    {COMMAND_INFO, "info", N_("SCENE"), N_("says what a scene uses and what the tracer leaves out"),
     .arguments = 1, .run = cli_info},
    {COMMAND_COMPARE, "compare", N_("A B"), N_("says how two pictures differ"), .arguments = 2,
     .run = cli_compare},
    {COMMAND_BENCH, "bench", N_("SCENE"), N_("times the drawing of a scene"), .arguments = 1,
     .run = cli_bench},
    {COMMAND_NEEDS, "needs", N_("SCENE"),
     N_("says the cheapest settings whose error nobody can see"), .arguments = 1, .run = cli_needs},
    {COMMAND_CHART, "chart", N_("SCENE... --out DIR"),
     N_("says what settings cost and what errors they leave"), .arguments = 0,
     .accepts_more_arguments = true, .run = cli_chart},
    {COMMAND_LAB, "lab", N_("[TEST...] --out DIR"), N_("says where each method fails"),
     .arguments = 0, .accepts_more_arguments = true, .run = cli_lab},
};

/** Number of commands. */
enum { COMMAND_COUNT = sizeof commands / sizeof *commands };

/** Width of the column of usages in the help, letters. */
static const int USAGE_WIDTH = 28;

/** Prints the help of the program. */
static void print_help(void) {
    fputs(gettext("dioptre: a ray tracer to teach with\n\n"
                  "usage: dioptre COMMAND ...\n"
                  "       dioptre SCENE     the same as dioptre view SCENE\n"
                  "       dioptre           shows the list of scenes\n\n"),
          stdout);
    for (int i = 0; i < COMMAND_COUNT; i++) {
        printf("  %-8s ", commands[i].name);
        print_padded(gettext(commands[i].usage), USAGE_WIDTH);
        printf(" %s\n", gettext(commands[i].help));
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
    for (int i = 0; i < COMMAND_COUNT; i++) {
        if (strcmp(name, commands[i].name) == 0) {
            return &commands[i];
        }
    }
    return NULL;
}

/** @return Whether a message has a place, `FILE:LINE: `, and not only the name of a file. */
static bool has_place(const char *message) {
    for (const char *end = strstr(message, ": "); end; end = strstr(end + 1, ": ")) {
        const char *line = end;
        while (line > message && isdigit((unsigned char)line[-1])) {
            line--;
        }
        if (line < end && line > message + 1 && line[-1] == ':') {
            return true;
        }
    }
    return false;
}

/** Prints an error: `FILE:LINE: message`, or `dioptre: message`. */
static void print_error(const Error *error) {
    if (error->message[0]) {
        bool begins_with_place = error->status == STATUS_SCENE && has_place(error->message);
        fputs(begins_with_place ? "" : "dioptre: ", stderr);
        sanitize_print(error->message, stderr); // It may quote a name from the command line.
        fputc('\n', stderr);
    }
}

/** Runs a command whose options are parsed. */
static void run_command(const Command *command, const Options *options, Error *error) {
    int more = options->argument_count - command->arguments;
    if (more > 0 && !command->accepts_more_arguments) {
        error_set(error, STATUS_USAGE, "too many arguments: '%s'",
                  options->arguments[command->arguments]);
        return;
    }
    if (more + command->optional_arguments < 0) {
        error_set(error, STATUS_USAGE, "usage: dioptre %s %s (--help says more)", command->name,
                  gettext(command->usage));
        return;
    }
    for (int i = 0; i < options->argument_count; i++) {
        if (!options->arguments[i][0]) {
            error_set(error, STATUS_USAGE, "argument %d of %s is empty", i + 1, command->name);
            return;
        }
    }
    command->run(options, error);
}

/** @return Whether a first word may name a scene: there is such a file, it is standard input, or it
 *  is written as scenes are. */
static bool may_be_scene(const char *word) {
    return access(word, F_OK) == 0 || strcmp(word, "-") == 0 || strchr(word, '/') ||
           scene_format_of(word) != SCENE_FORMAT_NONE;
}

/** Rejects a first word that is neither a command nor a scene. */
static void reject_first_word(const char *word, Error *error) {
    Suggestion suggestion = {.word = word};
    char hint[SUGGEST_HINT_SIZE];
    for (int i = 0; i < COMMAND_COUNT; i++) {
        suggest_try(&suggestion, commands[i].name);
    }
    error_set(error, STATUS_USAGE, "'%s' is neither a command nor a scene file%s", word,
              suggest_hint(&suggestion, hint));
}

/** Parses a command line and runs its command. */
static void parse_and_run(int argc, char **argv, Error *error) {
    const Command *command = argc > 1 ? find_command(argv[1]) : NULL;
    // A first word that is neither a command nor an option is a scene to view.
    bool is_scene = !command && argc > 1 && (argv[1][0] != '-' || argv[1][1] == 0);
    int skip = command ? 1 : 0;
    Options options;
    if (is_scene) {
        if (!may_be_scene(argv[1])) {
            reject_first_word(argv[1], error);
            return;
        }
        command = find_command("view");
    }
    if (!options_parse(command, argc - skip, argv + skip, &options, error)) {
        return;
    }
    if (options.version) {
        printf("dioptre %s\n", DIOPTRE_VERSION);
    } else if (options.help) {
        command ? print_command_help(command) : print_help();
    } else if (command) {
        run_command(command, &options, error);
    } else if (argc > 1 || !cli_browse(&options, error)) {
        error_set(error, STATUS_USAGE, "which command? (--help names them)");
    }
    // The output must arrive: a full disk behind a redirection is an error, too.
    if (fflush(stdout) != 0 && !error->message[0]) {
        error_set(error, STATUS_FAILED, "cannot write to standard output");
    }
}

/** A command line, and its result. */
typedef struct Invocation {
    int argc;     /**< Number of words. */
    char **argv;  /**< The words. */
    Error *error; /**< What is wrong. */
} Invocation;

/** Parses a command line and runs its command. See #ray_stack_run. */
static void invoke(void *context) {
    const Invocation *invocation = context;
    parse_and_run(invocation->argc, invocation->argv, invocation->error);
}

/** Says once that the system did not confine the processes that read files. */
static void print_unfiltered_note(void) {
    if (worker_process_was_unfiltered()) {
        fputs(gettext("dioptre: this system does not filter system calls (seccomp): files were "
                      "read in processes that only have limits of time and memory\n"),
              stderr);
    }
}

/**
 * The program.
 * @param argc  Number of words on the command line.
 * @return The exit status, see #Status.
 */
int main(int argc, char **argv) {
    Error error = {0};
    standard_streams_open();
    interrupt_init();
    language_init();
    // Otherwise a write to a closed pipe, or past the file size limit, kills the program silently.
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN);
    ray_stack_run(invoke, &(Invocation){argc, argv, &error}, &error);
    print_unfiltered_note();
    print_error(&error);
    return (int)error.status;
}
