/**
 * @file
 * @brief Reads pictures in a child process, out of harm's way.
 */
#include "assets/images_child.h"

#include "assets/child.h"

#include <libintl.h>
#include <signal.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/** What child and parent share, but for the texture. */
typedef struct Handover {
    bool is_done; /**< Whether the child came to the end of its work. */
    Error error;  /**< What is wrong, if anything. */
} Handover;

/** What a child is asked. */
typedef struct Question {
    ImagesRequest request; /**< What to read. */
    size_t memory;         /**< Bytes that the libraries may take. */
    Handover *handover;    /**< What both share. */
    Texture *texture;      /**< Where the child leaves the picture; shared, too. */
} Question;

/** Is the child: reads the picture. See #child_run. @param context A #Question. */
static void answer(void *context) {
    const Question *question = context;
    Handover *handover = question->handover;
    child_withdraw(question->memory);
    handover->is_done = images_read(&question->request, question->texture, &handover->error);
}

/**
 * Says why a child left no picture.
 * @param handover    What it left.
 * @param end         How it ended.
 * @param detail      The signal or the errno.
 * @param limits      What it might take.
 * @param[out] error  Where it is said.
 * @return false, always.
 */
static bool explain(const Handover *handover, ChildEnd end, int detail, const ImagesLimits *limits,
                    Error *error) {
    if (end == CHILD_UNSTARTED) {
        return error_set(error, STATUS_FAILED, "no process to read a picture in: %s",
                         error_system(detail));
    }
    if (end == CHILD_LATE) {
        return error_set(error, STATUS_SCENE, "it takes more than %.0f s to read", limits->seconds);
    }
    if (end == CHILD_CRASHED && detail == SIGINT) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    const Error *said = &handover->error;
    if (end == CHILD_ENDED && said->status != STATUS_DONE) {
        return error_set(error, said->status, "%.*s", ERROR_MESSAGE_SIZE - 1, said->message);
    }
    return error_set(error, STATUS_SCENE, "it makes the libraries that read it crash (%s)",
                     detail ? strsignal(detail) : gettext("it ended early"));
}

/**
 * Makes a texture of what a child left, which may be anything if a file has got hold of it, and
 * gives the rest of the room back.
 * @param left        What it left.
 * @param room        Bytes that it lies in.
 * @param[out] error  What is wrong.
 * @return Whether it is one.
 */
static bool accept(Texture *left, size_t room, Error *error) {
    bool has_size = left->width >= 1 && left->width <= IMAGE_SIZE_MAXIMUM && left->height >= 1 &&
                    left->height <= IMAGE_SIZE_MAXIMUM;
    if (!has_size || texture_size(left) > room) {
        return error_set(error, STATUS_SCENE, "it makes the libraries that read it go astray");
    }
    size_t page = (size_t)sysconf(_SC_PAGESIZE);
    size_t kept = (texture_size(left) + page - 1) / page * page;
    if (kept < room) {
        munmap((char *)left + kept, room - kept);
    }
    atomic_store(&left->owners, 1);
    texture_tame(left);
    return true;
}

/**
 * Asks a child.
 * @param question    What is asked.
 * @param limits      What it may take.
 * @param[out] error  What is wrong.
 * @return Whether the picture is there.
 */
static bool ask(Question *question, const ImagesLimits *limits, Error *error) {
    int detail;
    ChildEnd end = child_run(answer, question, limits->seconds, &detail);
    bool is_good = end == CHILD_ENDED && question->handover->is_done;
    return is_good ? accept(question->texture, limits->room, error)
                   : explain(question->handover, end, detail, limits, error);
}

bool images_child_read(const ImagesModule *module, const char *format, const char *path,
                       const ImagesLimits *limits, Texture **texture, Error *error) {
    Question question = {.request = {module, format, path, limits->room}, .memory = limits->memory};
    question.handover = child_share_memory(sizeof *question.handover);
    question.texture = child_share_memory(limits->room);
    bool has_memory = question.handover && question.texture;
    bool is_read = has_memory ? ask(&question, limits, error)
                              : error_set(error, STATUS_FAILED, "no memory for a picture");
    if (question.texture && !is_read) {
        munmap(question.texture, limits->room);
    }
    if (question.handover) {
        munmap(question.handover, sizeof *question.handover);
    }
    *texture = is_read ? question.texture : NULL;
    return is_read;
}
