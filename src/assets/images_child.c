/**
 * @file
 * @brief Reads pictures in a child process, out of harm's way.
 */
#include "assets/images_child.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/** Seconds that reading a picture may take: the largest take some. */
enum { SECONDS_MAXIMUM = 60 };
/** Bytes a pixel in a #Picture. */
enum { CHANNELS = 3 };

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
 * Sends bytes through a pipe.
 * @param pipe   Its end to be written to.
 * @param bytes  The bytes.
 * @param size   How many.
 * @return Whether all were sent.
 */
static bool send_bytes(int pipe, const void *bytes, size_t size) {
    const char *next = bytes;
    while (size > 0) {
        ssize_t sent = write(pipe, next, size);
        if (sent <= 0) {
            return false;
        }
        next += sent;
        size -= (size_t)sent;
    }
    return true;
}

/**
 * Receives bytes through a pipe.
 * @param pipe        Its end to be read from.
 * @param[out] bytes  The bytes.
 * @param size        How many.
 * @return Whether all came.
 */
static bool receive_bytes(int pipe, void *bytes, size_t size) {
    char *next = bytes;
    while (size > 0) {
        ssize_t received = read(pipe, next, size);
        if (received < 0 && errno == EINTR) {
            continue;
        }
        if (received <= 0) {
            return false;
        }
        next += received;
        size -= (size_t)received;
    }
    return true;
}

/** Makes this process a child that lives for so long only, dies with its parent, and is silent. */
static void withdraw(void) {
    struct rlimit nothing = {.rlim_cur = 0, .rlim_max = 0};
    setrlimit(RLIMIT_CORE, &nothing);
    signal(SIGALRM, SIG_DFL);
    alarm(SECONDS_MAXIMUM);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    int silence = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (silence >= 0) {
        dup2(silence, STDERR_FILENO);
    }
}

/**
 * Is the child: reads the picture, sends it and ends.
 * @param module  The module.
 * @param format  The format.
 * @param path    The file.
 * @param pipe    Where the answer goes.
 */
static _Noreturn void serve(const ImagesModule *module, const char *format, const char *path,
                            int pipe) {
    Reply reply = {0};
    Picture picture;
    withdraw();
    images_read(module, format, path, &picture, &reply.error);
    reply.width = picture.width;
    reply.height = picture.height;
    if (send_bytes(pipe, &reply, sizeof reply)) {
        send_bytes(pipe, picture.pixels, pixels_size(&picture));
    }
    _exit(0); // The parent counts the bytes that came.
}

/**
 * Receives what the child answers first. A child that a file has got hold of may answer anything.
 * @param pipe        Where it comes from.
 * @param[out] reply  The answer.
 * @return Whether it came and makes sense.
 */
static bool receive_reply(int pipe, Reply *reply) {
    if (!receive_bytes(pipe, reply, sizeof *reply)) {
        return false;
    }
    reply->error.message[ERROR_MESSAGE_SIZE - 1] = '\0';
    bool has_size = reply->width >= 1 && reply->width <= IMAGE_SIZE_MAXIMUM && reply->height >= 1 &&
                    reply->height <= IMAGE_SIZE_MAXIMUM;
    return has_size || reply->error.status != STATUS_DONE;
}

/**
 * Receives the child's answer.
 * @param pipe          Where it comes from.
 * @param[out] picture  The picture.
 * @param[out] error    What is wrong.
 * @return Whether all of the picture came; otherwise it is empty.
 */
static bool receive(int pipe, Picture *picture, Error *error) {
    Reply reply;
    bool is_answered = receive_reply(pipe, &reply);
    if (is_answered && reply.error.status != STATUS_DONE) {
        return error_set(error, reply.error.status, "%s", reply.error.message);
    }
    if (is_answered && !picture_init(picture, reply.width, reply.height, error)) {
        return false;
    }
    if (!is_answered || !receive_bytes(pipe, picture->pixels, pixels_size(picture))) {
        picture_release(picture);
        return error_set(error, STATUS_SCENE, "it makes the libraries that read it crash");
    }
    return true;
}

/**
 * Waits for the child to end.
 * @param child       The child.
 * @param[out] error  Said here if it took too long; otherwise untouched.
 */
static void wait_for(pid_t child, Error *error) {
    int end = 0;
    while (waitpid(child, &end, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(end) && WTERMSIG(end) == SIGALRM) {
        error_set(error, STATUS_SCENE, "it takes more than %d seconds", SECONDS_MAXIMUM);
    }
}

bool images_child_read(const ImagesModule *module, const char *format, const char *path,
                       Picture *picture, Error *error) {
    *picture = (Picture){0};
    int pipe[2];
    if (pipe2(pipe, O_CLOEXEC) != 0) {
        return error_set(error, STATUS_FAILED, "%s", strerror(errno));
    }
    pid_t child = fork();
    if (child == 0) {
        serve(module, format, path, pipe[1]);
    }
    close(pipe[1]);
    bool is_read = child > 0 ? receive(pipe[0], picture, error)
                             : error_set(error, STATUS_FAILED, "%s", strerror(errno));
    close(pipe[0]);
    if (child > 0) {
        wait_for(child, error);
    }
    return is_read;
}
