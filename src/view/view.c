/**
 * @file
 * @brief The window: opening it, its event loop, closing it.
 *
 * The loop sleeps until an event comes. A pass of the picture is an event too, and so is Ctrl-C,
 * so nothing is ever polled for; only held keys make it wake up by itself, once a frame.
 */
#include "dioptre/view.h"

#include "view/controls.h"
#include "view/interrupt.h"
#include "view/play.h"
#include "view/scenes.h"
#include "view/shoot.h"
#include "view/state.h"
#include "view/title.h"
#include "view/video.h"

#include <libintl.h>
#include <stdarg.h>
#include <string.h>

/** Seconds from one move of held keys to the next: a frame of a common screen. */
static const double STEP = 0.016;
/** Seconds that a title stands at least while a picture is drawn, so that it can be read. */
static const double TITLE_SECONDS = 0.25;

void view_note(View *view, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(view->note, sizeof view->note, gettext(format), arguments);
    va_end(arguments);
    view->title_due = 0;
}

void view_hush(View *view) {
    view->note[0] = '\0';
    view->title_due = 0;
}

void view_changed(View *view) {
    stage_change(&view->stage);
    if (!view->wants_snapshot) {
        view->note[0] = '\0';
    }
    if (!view->is_wrong) {
        stage_say(&view->stage, "");
    }
}

void view_report(View *view, const Error *error) {
    fprintf(stderr, "dioptre: %s\n", error->message);
    view_note(view, "%.*s", NOTE_SIZE - 1, error->message);
    stage_say(&view->stage, error->message);
}

/** Moves things as far as the keys were held. @param[in,out] view The view. @param now Seconds. */
static void move_by_keys(View *view, double now) {
    if (now >= view->next_step && stage_is_ready(&view->stage) && motion_is_active(&view->motion)) {
        Movement light, camera;
        motion_take(&view->motion, now, &light, &camera);
        controls_move(view, light, camera);
        view->next_step = now + STEP;
    }
}

/** Takes a snapshot if one is wanted and the picture is finished, with nothing on the move.
 *  @param[in,out] view The view. */
static void snapshot_if_wanted(View *view) {
    bool is_at_rest = stage_is_finished(&view->stage) && !motion_is_active(&view->motion) &&
                      play_is_at_rest(view);
    if (view->wants_snapshot && is_at_rest) {
        Error error = {0};
        view->wants_snapshot = false;
        if (!shoot(view, view->settings->snapshot_dir, view->name, &error)) {
            view_report(view, &error);
        }
    }
}

/** Brings the title up to date. @param[in,out] view The view. @param now Now, seconds. */
static void update_title(View *view, double now) {
    const Stage *stage = &view->stage;
    const Sight *sight = &stage->sights[0];
    if (now < view->title_due && !stage_is_finished(stage)) {
        return;
    }
    TitleFacts facts = {.name = view->name,
                        .width = sight->width,
                        .height = sight->height,
                        .report = stage->first_shown > 0 ? &sight->report : NULL,
                        .time = view->scene->reads_time ? &view->time : NULL,
                        .is_running = view->timeline.is_running,
                        .is_recorded = recorder_is_on(view),
                        .light = view->light,
                        .light_count = view->scene->light_count,
                        .note = view->note};
    char title[TITLE_SIZE];
    title_write(&facts, title);
    if (strcmp(title, SDL_GetWindowTitle(stage->display.window)) != 0) {
        SDL_SetWindowTitle(stage->display.window, title);
    }
    view->title_due = now + TITLE_SECONDS;
}

/**
 * Sleeps until there is something to do.
 * @param[in,out] view        The view.
 * @param now         Now, seconds.
 * @param[out] event  The event that came.
 * @return Whether one came.
 */
static bool wait_for_event(View *view, double now, SDL_Event *event) {
    double delay = fmin(stage_delay(&view->stage, now), scenes_delay(view, now));
    if (motion_is_active(&view->motion) && stage_is_ready(&view->stage)) {
        delay = fmin(delay, fmax(0, view->next_step - now));
    }
    delay = fmin(delay, fmin(player_delay(view, now), recorder_delay(view, now)));
    if (isinf(delay)) {
        return SDL_WaitEvent(event);
    }
    return SDL_WaitEventTimeout(event, (int)ceil(delay * 1000));
}

/** Does one round: moves, draws, shows, and sleeps. @param[in,out] view The view. */
static void do_round(View *view) {
    Error error = {0};
    move_by_keys(view, clock_seconds());
    player_update(view, clock_seconds());
    recorder_update(view, clock_seconds());
    if (!scenes_update(view, clock_seconds(), &error) && error.status != STATUS_INTERRUPTED) {
        view_report(view, &error);
    }
    if (!reloader_is_busy(&view->reloader) && !stage_settle(&view->stage, view->scene, &error)) {
        view_report(view, &error);
    }
    if (!stage_update(&view->stage, view->scene, clock_seconds(), &error)) {
        view_report(view, &error);
    }
    snapshot_if_wanted(view);
    if (!player_shoot(view, &error)) {
        view_report(view, &error);
    }
    update_title(view, clock_seconds());
    SDL_Event event;
    bool is_event = !view->is_over && wait_for_event(view, clock_seconds(), &event);
    while (is_event && !view->is_over) {
        controls_handle(view, &event);
        is_event = SDL_PollEvent(&event);
    }
}

/** Prints what was measured, as one line of JSON. @param[in,out] view The view. */
static void print_timing(View *view) {
    LatencySummary waits = latency_summary(&view->stage.latency);
    double first = view->stage.first_shown - view->settings->launched;
    printf("{\"first_picture_ms\": %.1f, \"keys\": %zu, \"key_to_picture_ms_median\": %.1f, "
           "\"key_to_picture_ms_worst\": %.1f}\n",
           first * 1e3, waits.count, waits.median * 1e3, waits.worst * 1e3);
    fflush(stdout);
}

/**
 * Opens the window, lives its life and closes it.
 * @param[in,out] view       The view, with SDL up.
 * @param stop               The window closes once this is true; may be NULL.
 * @param[in,out] interrupt  The signals, blocked.
 * @param[out] error         What is wrong.
 * @return What the program should end with.
 */
static Status live(View *view, const atomic_bool *stop, Interrupt *interrupt, Error *error) {
    const ViewSettings *settings = view->settings;
    view->first_event = SDL_RegisterEvents(EVENT_COUNT);
    view->reloader.event = view->first_event + EVENT_SCENE;
    interrupt_watch(interrupt, view->first_event + EVENT_INTERRUPT);
    scenes_begin(view);
    if (!pose_save(&view->home, view->scene, error) ||
        !stage_open(&view->stage, view->scene, &settings->render, view->name,
                    view->first_event + EVENT_PASS, error)) {
        return error->status;
    }
    player_begin(view);
    while (!view->is_over) {
        do_round(view);
        if (stop && atomic_load(stop)) {
            view->is_over = true;
            view->status = STATUS_INTERRUPTED;
        }
    }
    if (!recorder_end(view, error)) {
        view->status = error->status;
    }
    if (view->wants_snapshot) {
        fprintf(stderr, gettext("dioptre: no snapshot: the picture was not finished\n"));
    }
    if (settings->is_timed) {
        print_timing(view);
    }
    return view->status;
}

const char *const *view_actions(int *move_count) {
    *move_count = ACTION_MOVE_COUNT;
    return action_names();
}

bool view_is_possible(void) {
    bool is_possible = video_start(NULL);
    SDL_Quit();
    return is_possible;
}

Status view_run(Scene *scene, const ViewSettings *settings, const atomic_bool *stop, Error *error) {
    View view = {.settings = settings,
                 .scene = scene,
                 .motion = {.speed = 1},
                 .timeline = {.time = settings->time},
                 .time = settings->time,
                 .reloader = {.settings = settings}};
    view.stage.help.by_letter = settings->keys_by_letter;
    Status status = STATUS_FAILED;
    Interrupt interrupt;
    interrupt_block(&interrupt);
    if (video_start(error)) {
        status = live(&view, stop, &interrupt, error);
        player_end(&view);
        scenes_end(&view); // The scene that it may still make shares with what the stage draws.
        stage_close(&view.stage);
    }
    interrupt_release(&interrupt);
    SDL_Quit();
    pose_release(&view.home);
    return status;
}
