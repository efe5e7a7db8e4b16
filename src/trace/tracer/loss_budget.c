/**
 * @file
 * @brief The budget of losses.
 */
#include "trace/tracer/loss_budget.h"

#include <stdlib.h>

/** Throughput at which a ray ends in any case: its colours underflow in float. */
#define LEAST_THROUGHPUT 0x1p-126

/** Least throughput of the first pass; later passes are begun only where they are needed. */
#define LEAST_FIRST_THROUGHPUT 1e-6

bool loss_budget_init(LossBudget *budget, const Scene *scene, const TraceSettings *settings) {
    // Where no ray ends for its weight, what the guard of the recursion ends is measured as usual.
    double steps = settings->cutoff > 0 ? settings->cutoff : CUTOFF_DEFAULT;
    *budget = (LossBudget){.ambient = scene->ambient,
                           .cutoff = settings->cutoff,
                           .fraction = (scalar)(steps / ENCODING_CODE_MAXIMUM),
                           .is_linear = settings->encoding == ENCODING_LINEAR};
    budget->texture_peaks = calloc(scene->texture_count + 1, sizeof *budget->texture_peaks);
    for (size_t i = 0; budget->texture_peaks && i < scene->texture_count; i++) {
        const Texture *texture = scene->textures[i].texture;
        budget->texture_peaks[i] = texture ? texture_peak(texture) : 0;
    }
    return budget->texture_peaks != NULL;
}

void loss_budget_deinit(LossBudget *budget) {
    free(budget->texture_peaks);
    budget->texture_peaks = NULL;
}

void loss_budget_set_view(LossBudget *budget, const Scene *scene, size_t light_count) {
    Scene view = *scene;
    view.ambient = budget->ambient;
    view.light_count = light_count;
    double bound = scene_radiance_bound(&view, budget->texture_peaks);
    double throughput = THROUGHPUT_CUTOFF * budget->cutoff / CUTOFF_DEFAULT / fmax(1, bound);
    // A finer cutoff must not merge fewer rays: more of them would be lost than by a coarser one.
    double usual = fmax(throughput, THROUGHPUT_CUTOFF / fmax(1, bound));
    budget->merged = (scalar)fmax(usual, LEAST_FIRST_THROUGHPUT);
    budget->radiance_bound = (scalar)bound;
    budget->throughput = budget->cutoff > 0 ? (scalar)fmax(throughput, LEAST_FIRST_THROUGHPUT)
                                            : (scalar)LEAST_THROUGHPUT;
}
