/**
 * @file
 * @brief Reads pictures in a child process, out of harm's way.
 */
#include "assets/images_child.h"

#include "assets/child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/** Seconds that reading a picture may take: the largest take some. */
enum { SECONDS_MAXIMUM = 60 };
/** Bytes a pixel in a #Picture. */
enum { CHANNELS = 3 };

/** What a child is asked. */
typedef struct Question {
    const ImagesModule *module; /**< The module. */
    const char *format;         /**< The format. */
    const char *path;           /**< The file. */
    FILE *answer;               /**< A file in memory that both share. */
} Question;

/** What the child answers first; the pixels follow if all is well. */
typedef struct Reply {
    Error error; /**< What is wrong; #STATUS_DONE if nothing is. */
    int width;   /**< Pixels. */
    int height;  /**< Pixels. */
} Reply;

/** @return Bytes of a picture's pixels. @param picture The picture. */
static size_t pixels_size(const Picture *picture) {
    return (size_t)picture->width * (size_t)picture->height * CHANNELS;
}

/**
 * Opens a file in memory. A pipe would have to be emptied while the child still writes.
 * @return The file, to be closed; NULL with errno set.
 */
static FILE *open_memory(void) {
    int file = memfd_create("picture", MFD_CLOEXEC);
    FILE *stream = file >= 0 ? fdopen(file, "w+") : NULL;
    if (file >= 0 && !stream) {
        close(file);
    }
    return stream;
}

/** Keeps what the libraries say of a file away from the program's own words. */
static void fall_silent(void) {
    int silence = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (silence >= 0) {
        dup2(silence, STDERR_FILENO);
    }
}

/**
 * Is the child: reads the picture and writes the answer.
 * @param context  A #Question.
 */
static void answer(void *context) {
    const Question *question = context;
    Reply reply = {0};
    Picture picture;
    fall_silent();
    images_read(question->module, question->format, question->path, &picture, &reply.error);
    reply.width = picture.width;
    reply.height = picture.height;
    fwrite(&reply, sizeof reply, 1, question->answer);
    if (picture.pixels) {
        fwrite(picture.pixels, 1, pixels_size(&picture), question->answer);
    }
    fflush(question->answer); // Whether all of it arrives, the parent sees by its length.
    picture_release(&picture);
}

/**
 * Reads what the child answers first. A child that a file has got hold of may answer anything.
 * @param file        The answer, from its start.
 * @param[out] reply  Its beginning.
 * @return Whether it is there and makes sense.
 */
static bool read_reply(FILE *file, Reply *reply) {
    if (fread(reply, sizeof *reply, 1, file) != 1) {
        return false;
    }
    reply->error.message[ERROR_MESSAGE_SIZE - 1] = '\0';
    bool has_size = reply->width >= 1 && reply->width <= IMAGE_SIZE_MAXIMUM && reply->height >= 1 &&
                    reply->height <= IMAGE_SIZE_MAXIMUM;
    return has_size || reply->error.status != STATUS_DONE;
}

/**
 * Reads the child's answer.
 * @param file          The answer, from its start.
 * @param[out] picture  The picture.
 * @param[out] error    What is wrong.
 * @return Whether all of the picture is there; otherwise it is empty.
 */
static bool read_answer(FILE *file, Picture *picture, Error *error) {
    Reply reply;
    bool is_answered = read_reply(file, &reply);
    if (is_answered && reply.error.status != STATUS_DONE) {
        return error_set(error, reply.error.status, "%s", reply.error.message);
    }
    if (is_answered && !picture_init(picture, reply.width, reply.height, error)) {
        return false;
    }
    size_t size = pixels_size(picture);
    if (!is_answered || fread(picture->pixels, 1, size, file) != size) {
        picture_release(picture);
        return error_set(error, STATUS_SCENE, "it makes the libraries that read it crash");
    }
    return true;
}

/**
 * Looks whether a child that has ended was kept from answering; a crash is seen by its answer.
 * @param end         How it ended.
 * @param detail      The signal or the errno.
 * @param[out] error  What kept it.
 * @return Whether its answer is worth reading.
 */
static bool could_answer(ChildEnd end, int detail, Error *error) {
    if (end == CHILD_UNSTARTED) {
        return error_set(error, STATUS_FAILED, "%s", strerror(detail));
    }
    if (end == CHILD_LATE) {
        return error_set(error, STATUS_SCENE, "it takes more than %d seconds", SECONDS_MAXIMUM);
    }
    if (end == CHILD_CRASHED && detail == SIGINT) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    if (end == CHILD_CRASHED && detail == SIGXFSZ) { // A limit of the user's, files in memory too.
        return error_set(error, STATUS_FAILED, "%s", strerror(EFBIG));
    }
    return true;
}

bool images_child_read(const ImagesModule *module, const char *format, const char *path,
                       Picture *picture, Error *error) {
    *picture = (Picture){0};
    Question question = {.module = module, .format = format, .path = path};
    question.answer = open_memory();
    if (!question.answer) {
        return error_set(error, STATUS_FAILED, "%s", strerror(errno));
    }
    int detail;
    ChildEnd end = child_run(answer, &question, SECONDS_MAXIMUM, &detail);
    rewind(question.answer);
    bool is_read = could_answer(end, detail, error) && read_answer(question.answer, picture, error);
    fclose(question.answer);
    return is_read;
}
