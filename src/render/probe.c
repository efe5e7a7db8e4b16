/**
 * @file
 * @brief The tree of rays of one pixel of a renderer's picture.
 */
#include "dioptre/probe.h"

#include "render/renderer.h"

#include <stdlib.h>

void probe_release(Probe *probe) {
    free(probe->rays);
    *probe = (Probe){0};
}

bool renderer_probe(const Renderer *renderer, int x, int y, Probe *probe, Error *error) {
    PixelGrid pixel = {.x = x, .y = y, .columns = 1, .rows = 1, .stride = 1, .probe = probe};
    double light[3];
    RayCounts rays = {0};
    probe->count = 0;
    probe->is_short = false;
    renderer->settings.engine->trace(renderer->tracer, &pixel, light, &rays);
    return !probe->is_short ||
           error_set(error, STATUS_FAILED, "no memory for all rays of this pixel");
}
