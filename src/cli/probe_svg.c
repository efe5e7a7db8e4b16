/**
 * @file
 * @brief The rays of a pixel as a drawing.
 */
#include "cli/probe.h"

bool probe_draw(const ProbeReport *report, const Renderer *renderer, const char *path,
                Error *error) {
    (void)report, (void)renderer;
    return error_set(error, STATUS_FAILED, "%s: cannot be drawn yet", path);
}
