/**
 * @file
 * @brief Threads of a page without shared memory: fibers that take turns, behind the functions of
 * pthreads.
 *
 * The stack of a fiber is unwound and rewound by what emscripten's Asyncify adds to functions;
 * engines and libraries have it not, so that no fiber may wait below them. The browser calls
 * #web_tick, which runs fibers for a slice.
 */
#include "web/single/fibers.h"

#include "base/clock.h"

#include <emscripten.h>
#include <emscripten/fiber.h>
#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdlib.h>
#include <time.h>

/** Bytes for the local variables of a fiber that waits: some hundred calls deep. */
enum { ASYNCIFY_STACK_SIZE = 256 << 10 };

/** A thread of the program. */
typedef struct Fiber {
    emscripten_fiber_t context;               /**< Where it goes on. */
    void *(*function)(void *argument);        /**< What it runs. */
    void *argument;                           /**< For #function. */
    void *result;                             /**< Of #function, once it has ended. */
    bool has_ended;                           /**< Whether #function has returned. */
    const void *waits_for;                    /**< What ends its waiting; NULL: it can run. */
    double until;                             /**< When its waiting ends in any case. */
    void *stack;                              /**< Its stack; owned. */
    struct Fiber *next;                       /**< In the ring of all fibers. */
    char asyncify_stack[ASYNCIFY_STACK_SIZE]; /**< Its local variables while it waits. */
} Fiber;

/** What all fibers share: of the page, as threads are of a process. */
static struct {
    emscripten_fiber_t root;  /**< The browser's own stack. */
    char root_stack[1 << 12]; /**< For the local variables of #web_tick. */
    bool has_root;            /**< Whether #root is made. */
    Fiber *last;              /**< Which had the last turn, in a ring; NULL: there is none. */
    Fiber *current;           /**< Which has the turn; NULL: the browser. */
    double slice_end;         /**< When the turn of all ends. */
} fibers;

/** Asks the browser for a call of #web_tick. */
EM_JS(void, schedule_tick, (void), {
    if (!Module['wake']) {
        var channel = new MessageChannel(), timer = 0, isPosted = false;
        Module['wake'] = function() {
            if (!isPosted) {
                isPosted = true;
                channel.port2.postMessage(0);
            }
        };
        channel.port1.onmessage = function() {
            isPosted = false;
            clearTimeout(timer);
            Module['_web_tick']();
            var delay = Module['_web_delay']();
            if (delay == 0) {
                Module['wake']();
            } else if (delay > 0) {
                timer = setTimeout(Module['wake'], delay);
            }
        };
    }
    Module['wake']();
});

// --- turns ---------------------------------------------------------------------------------------

/** @return Whether a fiber can run. */
static bool is_runnable(const Fiber *fiber, double now) {
    return !fiber->has_ended && (!fiber->waits_for || fiber->until <= now);
}

/** @return The fiber whose turn it is; NULL: all wait. */
static Fiber *find_runnable(double now) {
    if (!fibers.last) {
        return NULL;
    }
    Fiber *fiber = fibers.last;
    do {
        fiber = fiber->next;
    } while (!is_runnable(fiber, now) && fiber != fibers.last);
    return is_runnable(fiber, now) ? fiber : NULL;
}

/** Runs fibers for a slice. Called by the browser. */
EMSCRIPTEN_KEEPALIVE void web_tick(void) {
    if (!fibers.has_root) {
        emscripten_fiber_init_from_current_context(&fibers.root, fibers.root_stack,
                                                   sizeof fibers.root_stack);
        fibers.has_root = true;
    }
    double now = clock_now_seconds();
    fibers.slice_end = now + FIBERS_SLICE;
    Fiber *fiber = find_runnable(now);
    while (fiber && now < fibers.slice_end) {
        fiber->waits_for = NULL;
        fibers.current = fibers.last = fiber;
        emscripten_fiber_swap(&fibers.root, &fiber->context);
        fibers.current = NULL;
        if (fiber->has_ended) { // Who waits for its end may do so much later.
            free(fiber->stack);
            fiber->stack = NULL;
        }
        now = clock_now_seconds();
        fiber = find_runnable(now);
    }
}

/** @return Milliseconds until a fiber can run; -1: when it is notified. Called by the browser. */
EMSCRIPTEN_KEEPALIVE int web_delay(void) {
    double now = clock_now_seconds(), until = INFINITY;
    Fiber *fiber = fibers.last;
    do {
        if (fiber && is_runnable(fiber, now)) {
            return 0;
        }
        if (fiber && !fiber->has_ended) {
            until = fmin(until, fiber->until);
            fiber = fiber->next;
        } else if (fiber) {
            fiber = fiber->next;
        }
    } while (fiber && fiber != fibers.last);
    return isinf(until) ? -1 : (int)ceil(1e3 * (until - now));
}

/** Gives the turn back to #web_tick. */
static void leave_turn(void) {
    emscripten_fiber_swap(&fibers.current->context, &fibers.root);
}

void fibers_wait(const void *what, double until) {
    fibers.current->waits_for = what;
    fibers.current->until = until;
    leave_turn();
}

void fibers_notify(const void *what) {
    Fiber *fiber = fibers.last;
    do {
        if (fiber && fiber->waits_for == what) {
            fiber->waits_for = NULL;
        }
        fiber = fiber ? fiber->next : NULL;
    } while (fiber && fiber != fibers.last);
    if (!fibers.current) {
        schedule_tick();
    }
}

void fibers_yield(void) {
    if (fibers.current && clock_now_seconds() >= fibers.slice_end) {
        leave_turn();
    }
}

// --- threads -------------------------------------------------------------------------------------

/** Runs the function of a fiber. @param argument The fiber. */
static void fiber_main(void *argument) {
    Fiber *fiber = argument;
    fiber->result = fiber->function(fiber->argument);
    fiber->has_ended = true;
    fibers_notify(fiber);
    leave_turn();
}

/** Stack of a fiber without attributes, bytes: it traces no rays. */
enum { STACK_SIZE = 1 << 20 };

/** Attributes of a fiber, in the memory of pthread's: those of the C library without threads do
 * nothing. */
typedef struct Attributes {
    size_t stack_size; /**< Bytes of its stack. */
} Attributes;

/** See pthread_attr_init(3). @return 0 */
int __wrap_pthread_attr_init(pthread_attr_t *attributes) {
    ((Attributes *)attributes)->stack_size = STACK_SIZE;
    return 0;
}

/** See pthread_attr_setstacksize(3). @return 0 */
int __wrap_pthread_attr_setstacksize(pthread_attr_t *attributes, size_t size) {
    ((Attributes *)attributes)->stack_size = size;
    return 0;
}

/** Starts a fiber. See pthread_create(3). */
int __wrap_pthread_create(pthread_t *thread, const pthread_attr_t *attributes,
                          void *(*function)(void *), void *argument) {
    size_t stack_size = attributes ? ((const Attributes *)attributes)->stack_size : STACK_SIZE;
    Fiber *fiber = calloc(1, sizeof *fiber);
    void *stack = aligned_alloc(16, stack_size);
    if (!fiber || !stack) {
        free(fiber);
        free(stack);
        return EAGAIN;
    }
    fiber->function = function;
    fiber->argument = argument;
    fiber->stack = stack;
    emscripten_fiber_init(&fiber->context, fiber_main, fiber, stack, stack_size,
                          fiber->asyncify_stack, sizeof fiber->asyncify_stack);
    fiber->next = fibers.last ? fibers.last->next : fiber;
    if (fibers.last) {
        fibers.last->next = fiber;
    } else {
        fibers.last = fiber;
    }
    *thread = (pthread_t)fiber;
    schedule_tick();
    return 0;
}

/** Takes a fiber that has ended out of the ring, and frees it. */
static void fiber_destroy(Fiber *fiber) {
    Fiber *previous = fiber;
    while (previous->next != fiber) {
        previous = previous->next;
    }
    previous->next = fiber->next;
    if (fibers.last == fiber) {
        fibers.last = previous == fiber ? NULL : previous;
    }
    free(fiber->stack);
    free(fiber);
}

/** Waits for the end of a fiber. See pthread_join(3). @return 0 */
int __wrap_pthread_join(pthread_t thread, void **result) {
    Fiber *fiber = (Fiber *)thread;
    while (!fiber->has_ended) {
        fibers_wait(fiber, INFINITY);
    }
    if (result) {
        *result = fiber->result;
    }
    fiber_destroy(fiber);
    return 0;
}

/** See pthread_self(3). @return The fiber that has the turn. */
pthread_t __wrap_pthread_self(void) {
    return (pthread_t)fibers.current;
}

// --- mutexes and conditions ----------------------------------------------------------------------

/** A mutex, in the memory of pthread's. Zeros: free. */
typedef struct Mutex {
    const Fiber *owner; /**< Who holds it; NULL: the browser's own stack, if #depth is positive. */
    int depth;          /**< How often. */
} Mutex;

/** Makes a free mutex. See pthread_mutex_init(3). @return 0 */
int __wrap_pthread_mutex_init(pthread_mutex_t *mutex, const pthread_mutexattr_t *attributes) {
    (void)attributes;
    *(Mutex *)mutex = (Mutex){0};
    return 0;
}

/** See pthread_mutex_trylock(3). @return 0, or EBUSY */
int __wrap_pthread_mutex_trylock(pthread_mutex_t *mutex) {
    Mutex *self = (Mutex *)mutex;
    if (self->depth > 0 && self->owner != fibers.current) {
        return EBUSY;
    }
    self->owner = fibers.current;
    self->depth++;
    return 0;
}

/** Takes a mutex. See pthread_mutex_lock(3). @return 0 */
int __wrap_pthread_mutex_lock(pthread_mutex_t *mutex) {
    while (__wrap_pthread_mutex_trylock(mutex) != 0) {
        fibers_wait(mutex, INFINITY);
    }
    return 0;
}

/** Frees a mutex. See pthread_mutex_unlock(3). @return 0 */
int __wrap_pthread_mutex_unlock(pthread_mutex_t *mutex) {
    if (--((Mutex *)mutex)->depth == 0) {
        fibers_notify(mutex);
    }
    return 0;
}

/** Does nothing. See pthread_mutex_destroy(3). @return 0 */
int __wrap_pthread_mutex_destroy(pthread_mutex_t *mutex) {
    (void)mutex;
    return 0;
}

/** Waits for a condition until a time. @param until Of the clock, seconds. @return 0, or ETIMEDOUT
 */
static int wait_until(pthread_cond_t *condition, pthread_mutex_t *mutex, double until) {
    __wrap_pthread_mutex_unlock(mutex);
    fibers_wait(condition, until);
    bool is_late = clock_now_seconds() >= until;
    __wrap_pthread_mutex_lock(mutex);
    return is_late ? ETIMEDOUT : 0;
}

/** See pthread_cond_wait(3). */
int __wrap_pthread_cond_wait(pthread_cond_t *condition, pthread_mutex_t *mutex) {
    return wait_until(condition, mutex, INFINITY);
}

/** See pthread_cond_timedwait(3). */
int __wrap_pthread_cond_timedwait(pthread_cond_t *condition, pthread_mutex_t *mutex,
                                  const struct timespec *time) {
    struct timespec now;
    clock_gettime(CLOCK_REALTIME, &now);
    double delay =
        (double)(time->tv_sec - now.tv_sec) + 1e-9 * (double)(time->tv_nsec - now.tv_nsec);
    return wait_until(condition, mutex, clock_now_seconds() + delay);
}

/** See pthread_cond_signal(3): all that wait look again. @return 0 */
int __wrap_pthread_cond_signal(pthread_cond_t *condition) {
    fibers_notify(condition);
    return 0;
}

/** See pthread_cond_broadcast(3). @return 0 */
int __wrap_pthread_cond_broadcast(pthread_cond_t *condition) {
    fibers_notify(condition);
    return 0;
}
