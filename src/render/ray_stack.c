/**
 * @file
 * @brief Threads whose stack is large enough for the deepest ray.
 */
#include "render/ray_stack.h"

#include <sys/resource.h>

int ray_thread_create(pthread_t *thread, void *(*function)(void *context), void *context) {
    pthread_attr_t attributes;
    int code = pthread_attr_init(&attributes);
    if (code != 0) {
        return code;
    }
    code = pthread_attr_setstacksize(&attributes, RAY_STACK_SIZE);
    if (code == 0) {
        code = pthread_create(thread, &attributes, function, context);
    }
    pthread_attr_destroy(&attributes);
    return code;
}

/**
 * Lets the stack of the first thread grow far enough; the system looks at the limit when it grows.
 * @return false if the hard limit forbids it.
 */
static bool raise_limit(void) {
    struct rlimit limit;
    if (getrlimit(RLIMIT_STACK, &limit) != 0) {
        return false;
    }
    if (limit.rlim_cur != RLIM_INFINITY && limit.rlim_cur < RAY_STACK_SIZE) {
        limit.rlim_cur = RAY_STACK_SIZE;
        return limit.rlim_max >= RAY_STACK_SIZE && setrlimit(RLIMIT_STACK, &limit) == 0;
    }
    return true;
}

/** A call in a thread. */
typedef struct StackCall {
    void (*function)(void *context); /**< The function. */
    void *context;                   /**< Its argument. */
} StackCall;

/** Runs a call. See pthread_create. @return NULL */
static void *run_call(void *argument) {
    const StackCall *call = argument;
    call->function(call->context);
    return NULL;
}

bool ray_stack_run(void (*function)(void *context), void *context, Error *error) {
    StackCall call = {function, context};
    pthread_t thread;
    if (raise_limit()) {
        function(context);
        return true;
    }
    int code = ray_thread_create(&thread, run_call, &call);
    if (code != 0) {
        return error_set(error, STATUS_FAILED, "cannot start a thread: %s", error_errno_text(code));
    }
    pthread_join(thread, NULL);
    return true;
}
