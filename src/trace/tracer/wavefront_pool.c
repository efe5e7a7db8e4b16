/**
 * @file
 * @brief Wavefronts that wait for the next tile.
 */
#include "trace/tracer/wavefront_pool.h"

#include "trace/tracer/wavefront.h"

#include <stdatomic.h>
#include <stdlib.h>

/** Wavefronts that a pool keeps, at most: more threads than that allocate theirs per tile. */
enum { POOL_CAPACITY = 64 };

struct WavefrontPool {
    _Atomic(Wavefront *) idle[POOL_CAPACITY]; /**< Those that wait; owned; NULL: a free place. */
};

WavefrontPool *wavefront_pool_create(void) {
    return calloc(1, sizeof(WavefrontPool));
}

void wavefront_pool_destroy(WavefrontPool *pool) {
    for (int i = 0; pool && i < POOL_CAPACITY; i++) {
        wavefront_destroy(atomic_load(&pool->idle[i]));
    }
    free(pool);
}

Wavefront *wavefront_pool_take(WavefrontPool *pool) {
    for (int i = 0; i < POOL_CAPACITY; i++) {
        Wavefront *wavefront = atomic_exchange(&pool->idle[i], NULL);
        if (wavefront) {
            return wavefront;
        }
    }
    return wavefront_create();
}

void wavefront_pool_give_back(WavefrontPool *pool, Wavefront *wavefront) {
    for (int i = 0; i < POOL_CAPACITY; i++) {
        Wavefront *expected = NULL;
        if (atomic_compare_exchange_strong(&pool->idle[i], &expected, wavefront)) {
            return;
        }
    }
    wavefront_destroy(wavefront);
}
