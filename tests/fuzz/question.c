/**
 * @file
 * @brief Fuzz target: what a worker that runs a scene asks for. Whatever it asks, it gets no file
 * outside the folder of the scene.
 */
#include "fuzz.h"

#include "script/script_question.h"

#include <unistd.h>

/** The folder of the scene. */
static const char FOLDER[] = "scenes/lessons";

/** Fails unless a path lies in the folder. */
static void check_path(const char *path) {
    static char folder[PATH_MAX];
    if (!folder[0]) {
        FUZZ_REQUIRE(realpath(FOLDER, folder));
    }
    size_t length = strlen(folder);
    FUZZ_REQUIRE(strncmp(path, folder, length) == 0 && path[length] == '/');
    FUZZ_REQUIRE(!strstr(path, "/../"));
}

/** Checks the descriptor of an answer, and closes it. */
static void check_file(int file) {
    char link[64], path[PATH_MAX];
    snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    ssize_t length = readlink(link, path, sizeof path - 1);
    FUZZ_REQUIRE(length > 0);
    path[length] = '\0';
    check_path(path);
    close(file);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    FuzzInput input = {data, size};
    const unsigned flags = fuzz_take_byte(&input);
    const ScriptRequest request = {.path = "scenes/lessons/fuzz.lua",
                                   .base_dir = flags % 2 ? FOLDER : NULL};
    ScriptResponder *responder = calloc(1, sizeof *responder);
    ScriptQuestion *question = calloc(1, sizeof *question);
    WorkerResponse response = {0};
    FUZZ_REQUIRE(responder && question);
    responder->request = &request;
    responder->is_lesson = flags / 2 % 2;
    question->kind = fuzz_take_byte(&input) % 6;
    fuzz_take(&input, question->text, sizeof question->text);
    // The text is printed on this process's terminal, escaped: of no interest here.
    if (question->kind != SCRIPT_ASK_PRINT &&
        script_question_answer(responder, question, sizeof *question, &response)) {
        const ScriptAnswer *answer = response.bytes;
        FUZZ_REQUIRE(answer && response.size == sizeof *answer);
        FUZZ_REQUIRE(responder->is_lesson == (question->kind == SCRIPT_ASK_SCENE));
        if (response.file > 0) {
            FUZZ_REQUIRE(question->kind == SCRIPT_ASK_INCLUDE);
            check_file(response.file);
        }
        if (answer->error.status == STATUS_OK && question->kind == SCRIPT_ASK_ASSET) {
            check_path(answer->real_path);
        }
    }
    free(question);
    free(responder);
    return 0;
}
