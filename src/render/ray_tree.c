/**
 * @file
 * @brief The ray tree of one pixel of a renderer's picture.
 */
#include "dioptre/engine.h"

#include "render/renderer_internal.h"

#include <stdlib.h>

void ray_tree_deinit(RayTree *tree) {
    free(tree->nodes);
    free(tree->steps);
    *tree = (RayTree){0};
}

bool renderer_record_ray_tree(const Renderer *renderer, int x, int y, RayTree *tree, Error *error) {
    PixelGrid pixel = {.x = x, .y = y, .columns = 1, .rows = 1, .stride = 1, .ray_tree = tree};
    double color[3];
    RayCounts rays = {0};
    tree->count = tree->step_count = 0;
    tree->is_truncated = false;
    renderer->settings.engine->trace(renderer->tracer, &pixel, color, &rays);
    return !tree->is_truncated ||
           error_set(error, STATUS_FAILED, "no memory for all rays of this pixel");
}
