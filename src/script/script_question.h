/**
 * @file
 * @brief Questions of a running scene or lesson to the program: both sides.
 *
 * The worker may open no file and has no terminal. It asks the program, which finds and opens the
 * files that a scene names, and prints what it prints. A script may have got hold of the worker, so
 * the program checks each question, and answers only what a script may know.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_QUESTION_H
#define DIOPTRE_SCRIPT_SCRIPT_QUESTION_H

#include "assets/process/worker_process.h"
#include "dioptre/script.h"

#include <limits.h>

/** What is asked. */
typedef enum {
    SCRIPT_ASK_PRINT,   /**< To print text. */
    SCRIPT_ASK_INCLUDE, /**< For a file to include, open. */
    SCRIPT_ASK_ASSET,   /**< For the paths of a mesh or a picture. */
    SCRIPT_ASK_SCENE    /**< Whether the scene of a lesson can be read; for its path. */
} ScriptQuestionKind;

/** A question. */
typedef struct ScriptQuestion {
    int kind;            /**< A #ScriptQuestionKind. */
    char text[PATH_MAX]; /**< The text, or the name of the file. */
} ScriptQuestion;

/** An answer. */
typedef struct ScriptAnswer {
    Error error;                 /**< What is wrong with the file. */
    char display_path[PATH_MAX]; /**< Its path for messages. */
    char real_path[PATH_MAX];    /**< Its absolute path without links. */
} ScriptAnswer;

/** Largest number of bytes that a scene may print; a last line reports the cut. */
enum { SCRIPT_PRINT_MAXIMUM = 65536 };

/** The program's side of the questions of a run. */
typedef struct ScriptResponder {
    const ScriptRequest *request; /**< The request. */
    bool is_lesson;               /**< Whether a lesson runs: it has a scene, and no other file. */
    bool has_scene;               /**< Whether the lesson has asked for its scene: it has one. */
    size_t bytes_printed;         /**< Number of bytes that the run printed. */
    bool is_system_short;         /**< Whether the system lacked memory or descriptors for a file:
                                     no fault of the scene, whatever its worker says. */
    ScriptAnswer answer;          /**< The last answer. */
} ScriptResponder;

/** Answers a question; see #WorkerCall.answer. @param context The #ScriptResponder. */
bool script_question_answer(void *context, const void *question, size_t size,
                            WorkerResponse *response);

/**
 * Asks the program for a file; the worker's side.
 * @param kind           Not #SCRIPT_ASK_PRINT.
 * @param name           The name in the scene.
 * @param[out] answer    The answer.
 * @param[out] file      For #SCRIPT_ASK_INCLUDE: the descriptor, to be closed; NULL: not wanted.
 * @return Whether there is such a file.
 */
bool script_question_ask(ScriptQuestionKind kind, const char *name, ScriptAnswer *answer,
                         int *file);

/** Prints text; the worker's side. @param text The text, sanitized. */
void script_question_print(const char *text);

#endif
