/**
 * @file
 * @brief Questions of a running scene or lesson to the program: both sides.
 */
#include "script/script_question.h"

#include "assets/process/worker_main.h"
#include "assets/process/worker_protocol.h"
#include "base/sanitize.h"
#include "script/asset_path.h"

#include <assert.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static_assert(sizeof(ScriptQuestion) <= WORKER_QUESTION_MAXIMUM, "a question must fit");

// --- in the program ------------------------------------------------------------------------------

/** Writes to standard error; write errors are ignored. */
static void write_error(const char *text, size_t length) {
    while (length > 0) {
        ssize_t count = write(STDERR_FILENO, text, length);
        if (count <= 0 && errno != EINTR) {
            return;
        }
        text += count > 0 ? count : 0;
        length -= count > 0 ? (size_t)count : 0;
    }
}

/** Prints text of a scene, sanitized again. @return false if the run has printed too much. */
static bool print_text(ScriptResponder *responder, const char *text) {
    /** An escaped byte takes four characters. */
    char sanitized[4 * PATH_MAX];
    sanitize_text(sanitized, sizeof sanitized, text, strlen(text));
    size_t length = strlen(sanitized);
    responder->bytes_printed += length;
    // The worker says itself that more is left out; then a piece and a sentence more come.
    if (responder->bytes_printed > SCRIPT_PRINT_MAXIMUM + sizeof sanitized) {
        return false;
    }
    if (!responder->request->is_quiet) {
        write_error(sanitized, length);
    }
    return true;
}

/** @return Whether what runs may ask for such a file: a taken-over worker asks for any. */
static bool may_ask(const ScriptResponder *responder, int kind) {
    bool is_file_of_scene = kind == SCRIPT_ASK_INCLUDE || kind == SCRIPT_ASK_ASSET;
    return responder->is_lesson ? kind == SCRIPT_ASK_SCENE && !responder->has_scene
                                : is_file_of_scene;
}

/** Finds a file of a scene, and keeps it open if it is to be included. */
static void find_file(ScriptResponder *responder, const ScriptQuestion *question,
                      WorkerResponse *response) {
    struct stat info;
    ScriptAnswer *answer = &responder->answer;
    int file = asset_path_open(responder->request, question->text, answer->display_path,
                               answer->real_path, &info, &answer->error);
    if (file >= 0 && question->kind == SCRIPT_ASK_INCLUDE) {
        response->file = file;
    } else if (file >= 0) {
        close(file); // It is opened again to be read, once the file of the scene has run.
    }
}

/** Finds the scene of a lesson, relative to the folder of the lesson. */
static void find_scene(ScriptResponder *responder, const char *name) {
    ScriptAnswer *answer = &responder->answer;
    responder->has_scene = true;
    const char *path = responder->request->path, *slash = strrchr(path, '/');
    int dir_length = slash && name[0] != '/' ? (int)(slash + 1 - path) : 0;
    // The name - means standard input elsewhere.
    const char *here = dir_length == 0 && strcmp(name, "-") == 0 ? "./" : "";
    int length = snprintf(answer->real_path, PATH_MAX, "%.*s%s%s", dir_length, path, here, name);
    if (length >= PATH_MAX || access(answer->real_path, R_OK) != 0) {
        error_set_errno(&answer->error, length >= PATH_MAX ? ENAMETOOLONG : errno);
    }
}

bool script_question_answer(void *context, const void *bytes, size_t size,
                            WorkerResponse *response) {
    ScriptResponder *responder = context;
    ScriptQuestion question;
    if (size != sizeof question) {
        return false;
    }
    memcpy(&question, bytes, sizeof question);
    if (!memchr(question.text, '\0', sizeof question.text)) {
        return false;
    }
    responder->answer = (ScriptAnswer){0};
    response->bytes = &responder->answer;
    response->size = sizeof responder->answer;
    if (question.kind == SCRIPT_ASK_PRINT) {
        return print_text(responder, question.text);
    }
    if (!may_ask(responder, question.kind)) {
        return false;
    }
    if (question.kind == SCRIPT_ASK_SCENE) {
        find_scene(responder, question.text);
    } else {
        find_file(responder, &question, response);
    }
    responder->is_system_short =
        responder->is_system_short || responder->answer.error.status == STATUS_FAILED;
    return true;
}

// --- in the worker -------------------------------------------------------------------------------

/** Asks a question. @return The answer. @param[out] file Descriptor sent along; -1: none. */
static ScriptAnswer ask(ScriptQuestionKind kind, const char *text, int *file) {
    ScriptQuestion question = {.kind = (int)kind};
    ScriptAnswer answer;
    snprintf(question.text, sizeof question.text, "%s", text);
    WorkerAnswer received = worker_job_ask(&question, sizeof question);
    if (received.size != sizeof answer) {
        _Exit(EXIT_FAILURE);
    }
    memcpy(&answer, received.bytes, sizeof answer);
    free(received.bytes);
    *file = received.file;
    return answer;
}

bool script_question_ask(ScriptQuestionKind kind, const char *name, ScriptAnswer *answer,
                         int *file) {
    int found = -1;
    if (strlen(name) >= PATH_MAX) {
        return error_set_errno(&answer->error, ENAMETOOLONG);
    }
    *answer = ask(kind, name, &found);
    if (file) {
        *file = found;
    } else if (found >= 0) {
        close(found);
    }
    return answer->error.status == STATUS_OK;
}

void script_question_print(const char *text) {
    int none;
    ask(SCRIPT_ASK_PRINT, text, &none);
}
