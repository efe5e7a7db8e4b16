/**
 * @file
 * @brief A thread pool without threads: its caller runs all tasks, and lets others run between two
 * tiles.
 *
 * It stands in for render/thread_pool.c.
 */
#include "render/thread_pool.h"

#include "render/renderer_internal.h"
#include "web/single/fibers.h"

#include <stdlib.h>

struct ThreadPool {
    bool has_tiles; /**< Whether tasks are tiles: below other tasks is an engine, where no fiber may
                       wait. */
};

/** The pool itself, see #__wrap_render_pass_run_tiles. */
bool __real_render_pass_run_tiles(RenderPass *pass, ShadeTile shade);

ThreadPool *thread_pool_create(int concurrency, Error *error) {
    (void)concurrency;
    ThreadPool *pool = calloc(1, sizeof *pool);
    if (!pool) {
        error_set(error, STATUS_FAILED, "no memory for %d threads", 1);
    }
    return pool;
}

void thread_pool_destroy(ThreadPool *pool) {
    free(pool);
}

void thread_pool_run(ThreadPool *pool, size_t count, ThreadPoolTask task, void *context) {
    bool has_tiles = pool->has_tiles;
    pool->has_tiles = false; // A tile's own tasks are no tiles.
    for (size_t i = 0; i < count; i++) {
        task(context, i);
        if (has_tiles) {
            fibers_yield();
        }
    }
}

/** The question itself, see #__wrap_render_pass_is_stopped. */
bool __real_render_pass_is_stopped(const RenderPass *pass);

/** Lets others run, too, between two parts of a tile: in quad a tile takes seconds. See
 *  #render_pass_is_stopped. */
bool __wrap_render_pass_is_stopped(const RenderPass *pass) {
    fibers_yield();
    return __real_render_pass_is_stopped(pass);
}

/** Shades all tiles of a pass. See #render_pass_run_tiles. */
bool __wrap_render_pass_run_tiles(RenderPass *pass, ShadeTile shade) {
    pass->renderer->thread_pool->has_tiles = true;
    return __real_render_pass_run_tiles(pass, shade);
}
