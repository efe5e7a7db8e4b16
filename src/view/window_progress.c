/**
 * @file
 * @brief How far the pictures are: a bar at their lower edge, and when it moves next.
 */
#include "base/clock.h"
#include "view/gui/gui.h"
#include "view/window_internal.h"

#include <math.h>

/** Seconds of a pass after which a bar says how far it is, and between two lengths of that bar. */
static const double PROGRESS_INTERVAL = 0.25;

/** @return Whether a legend says how much of the work is done, and it is not all done. */
static bool is_reference_under_way(const Window *window) {
    bool is_under_way = false;
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        const RenderStats *report = &window->viewports[i].report;
        is_under_way = is_under_way || (report->layer.reference && !report->is_finished);
    }
    return is_under_way;
}

/** Finds how far the pass of the pictures is that has run longest. @param[out] progress That.
 *  @return Whether any picture is being drawn. */
static bool find_progress(const Window *window, PassProgress *progress) {
    bool is_any = false;
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        const Viewport *viewport = &window->viewports[i];
        PassProgress pass = renderer_pass_progress(viewport->renderer);
        bool is_drawn = !viewport_is_finished(viewport) && pass.fraction < 1;
        if (is_drawn && (!is_any || pass.seconds > progress->seconds)) {
            *progress = pass;
            is_any = true;
        }
    }
    return is_any;
}

double window_progress_timeout(const Window *window, double now) {
    PassProgress progress;
    double next = fmax(0, window->next_progress_time - now);
    if (!window->gui || window->ray_view.is_open) {
        return WINDOW_NO_TIMEOUT;
    }
    if (is_reference_under_way(window)) {
        return next;
    }
    return find_progress(window, &progress) ? fmax(PROGRESS_INTERVAL - progress.seconds, next)
                                            : WINDOW_NO_TIMEOUT;
}

void window_show_progress(Window *window) {
    PassProgress progress;
    window->next_progress_time = clock_now_seconds() + PROGRESS_INTERVAL;
    if (!window->ray_view.is_open && find_progress(window, &progress) &&
        progress.seconds >= PROGRESS_INTERVAL) {
        SDL_Rect picture = window_to_units(window, window_picture_rect(window));
        gui_progress_bar((GuiPoint){(float)picture.x, (float)(picture.y + picture.h)},
                         (float)picture.w, (float)progress.fraction);
    }
}
