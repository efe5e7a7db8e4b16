/**
 * @file
 * @brief Threads whose stack is large enough for the deepest ray, whatever the limits of the shell.
 */
#ifndef DIOPTRE_RENDER_RAY_STACK_H
#define DIOPTRE_RENDER_RAY_STACK_H

#include "base/error.h"
#include "dioptre/scene.h"

#include <pthread.h>

#ifdef __SANITIZE_ADDRESS__
/** Factor for the stack of a build with sanitizers, whose frames have gaps. */
#define RAY_STACK_FACTOR 2
#else
/** Factor for the stack of a build without sanitizers. */
#define RAY_STACK_FACTOR 1
#endif

/**
 * Stack for each level of recursion, bytes. The largest engine, f32x16, needs up to 38 KiB
 * (tests/test_thread_stack.c measures it).
 */
#define RAY_STACK_PER_LEVEL ((size_t)60 << 10)

/** Stack for what is no recursion, bytes: shapes, lights and the renderer around them. */
#define RAY_STACK_BASE ((size_t)1 << 20)

/**
 * Stack of a thread that traces rays, bytes: 16 MiB of addresses, of which only what is used is
 * memory.
 */
#define RAY_STACK_SIZE ((RAY_STACK_BASE + DEPTH_MAXIMUM * RAY_STACK_PER_LEVEL) * RAY_STACK_FACTOR)

/** Starts a thread that may trace rays. @return As pthread_create. */
int ray_thread_create(pthread_t *thread, void *(*function)(void *context), void *context);

/**
 * Calls a function on a stack that suffices for rays: that of this thread, the first of the
 * program, if it may grow so far; else that of a thread.
 * @param function    The function.
 * @param context     Its argument.
 * @param[out] error  What is wrong.
 * @return false if no thread can be started; the function is not called then.
 */
bool ray_stack_run(void (*function)(void *context), void *context, Error *error);

#endif
