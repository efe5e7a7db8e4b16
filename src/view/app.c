/**
 * @file
 * @brief Messages, time and view of an open window.
 */
#include "view/app.h"

#include "base/sanitize.h"
#include "view/state/scene_text.h"
#include "view/state/snapshot.h"

#include <libintl.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/** Factor of the field of view per notch of the wheel. */
static const double ZOOM_PER_NOTCH = 0.9;
/** Widest field of view by the wheel, degrees: in a wider one things at the edge are drawn so
 * large, and those in the middle so small, that a turned wheel seems to have lost the scene. */
static const double ZOOM_FOV_MAXIMUM = 100;
/** Movement of the second camera per notch of the wheel, in seconds of a held key. */
static const double FORWARD_PER_NOTCH = 0.125;

/* --- messages --------------------------------------------------------------------------------- */

void app_set_status(App *app, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(app->title.status_text, sizeof app->title.status_text, gettext(format), arguments);
    va_end(arguments);
    app->title.holds = NULL;
    app->title.next_update_time = 0;
    window_set_toast(&app->window, app->title.status_text);
}

void app_set_title_status(App *app, const char *text) {
    app_clear_status(app);
    SDL_strlcpy(app->title.status_text, gettext(text), sizeof app->title.status_text);
}

void app_set_status_while(App *app, StatusHoldsFn *holds, const char *text) {
    app_set_status(app, "%s", gettext(text));
    app->title.holds = holds;
}

void app_update_status(App *app) {
    if (app->title.holds && !app->title.holds(app)) {
        app_clear_status(app);
    }
}

void app_sync_window(App *app) {
    window_set_state(
        &app->window,
        &(WindowState){.scene = app->scene,
                       .selected_light = app->selected_light,
                       .is_animated = app_is_animated(app),
                       .is_running = app->timeline.is_running,
                       .is_recording = app_is_recording(app),
                       .is_playing = app_is_playing(app),
                       .can_undo = app->moves.done > 0 || edit_history_in_force(&app->edits) > 0,
                       .can_redo =
                           app->moves.done < app->moves.count || app->edits.done < app->edits.count,
                       .edits = &app->edits,
                       .is_light_moved = app->home_view.is_light_moved});
}

void app_clear_status(App *app) {
    if (app->title.holds) {
        window_end_toast(&app->window);
    }
    app->title.status_text[0] = '\0';
    app->title.holds = NULL;
    app->title.next_update_time = 0;
}

void app_report_error(App *app, const Error *error) {
    fputs("dioptre: ", stderr);
    sanitize_print(error->message, stderr);
    fputc('\n', stderr);
    app_set_status(app, "%.*s", STATUS_TEXT_SIZE - 1, error->message);
    window_set_notice(&app->window, error->message);
}

void app_show_notes(App *app) {
    const Scene *scene = app->scene;
    if (scene->note_count == 0) {
        return;
    }
    char text[NOTICE_SIZE];
    size_t more = scene->note_count - 1;
    int length = snprintf(text, sizeof text, "%s", scene->notes[0]);
    if (more > 0 && length >= 0 && (size_t)length < sizeof text) {
        snprintf(
            text + length, sizeof text - (size_t)length,
            ngettext(" (%zu more note on the terminal)", " (%zu more notes on the terminal)", more),
            more);
    }
    app_set_status(app, "%.*s", STATUS_TEXT_SIZE - 1, text);
    window_set_notice(&app->window, text);
}

/* --- time ------------------------------------------------------------------------------------- */

bool app_is_playing(const App *app) {
    return app->player.lesson && app->player.state != PLAYER_IS_FINISHED;
}

bool app_is_lesson_stopped(const App *app) {
    return app->player.state != PLAYER_RUNS;
}

bool app_is_recording(const App *app) {
    return app->recorder.stream != NULL;
}

double app_clock(const App *app) {
    if (app_is_playing(app)) {
        return step_clock_seconds(&app->player.step_clock);
    }
    return app_is_recording(app) ? step_clock_seconds(&app->recorder.step_clock)
                                 : clock_now_seconds();
}

double app_scene_time(const App *app) {
    return timeline_time_at(&app->timeline, app_clock(app));
}

bool app_is_animated(const App *app) {
    return app->settings->load && app->scene->is_time_dependent;
}

bool app_is_time_settled(const App *app) {
    bool is_stopped = !app->timeline.is_running || app_is_lesson_stopped(app);
    bool is_edited = app->source.shown_revision == app->edits.revision;
    return is_stopped && is_edited &&
           (!app_is_animated(app) || app_scene_time(app) == app->scene_time);
}

/* --- the view --------------------------------------------------------------------------------- */

/** The user is about to move camera or lights: it can be undone. @param subject See
 *  #ViewStep.subject. */
static void note_move(App *app, size_t subject) {
    const ViewStep step = {.edits = edit_history_in_force(&app->edits), .subject = subject};
    view_history_note(&app->moves, &app->home_view, app->scene, &step, app_clock(app));
}

void app_on_view_changed(App *app) {
    window_invalidate(&app->window);
    if (!app->wants_snapshot) {
        app->title.status_text[0] = '\0';
    }
    if (!app->source.has_load_error) {
        window_set_notice(&app->window, "");
    }
}

void app_move(App *app, Movement light, Movement camera) {
    if (app->window.ray_view.is_open && movement_is_nonzero(camera)) {
        ray_view_move(&app->window.ray_view, camera);
        camera = (Movement){0};
        if (!movement_is_nonzero(light)) {
            latency_discard_pending(&app->window.latency);
            return;
        }
    }
    bool is_light_moved =
        movement_is_nonzero(light) && app->selected_light < app->scene->light_count;
    if (is_light_moved || movement_is_nonzero(camera)) {
        note_move(app, movement_is_nonzero(camera) ? VIEW_SUBJECT_ALL : app->selected_light);
        view_state_move(&app->home_view, app->scene, app->selected_light, light, camera,
                        app->input.camera_motion);
        app_on_view_changed(app);
    } else {
        latency_discard_pending(&app->window.latency);
        if (movement_is_nonzero(light)) {
            app_set_status(app, "there is no light to move");
        }
    }
}

void app_drag_light(App *app, size_t light, Vec3d offset) {
    if (light < app->scene->light_count) {
        app->selected_light = light;
        note_move(app, light);
        app->home_view.is_light_moved[light] = true;
        scene_light_move(&app->scene->lights[light], offset, app->scene->camera.target_distance);
        app_on_view_changed(app);
    }
}

void app_turn(App *app, double right, double up) {
    if (app->window.ray_view.is_open) {
        ray_view_turn(&app->window.ray_view, right, up);
        return;
    }
    note_move(app, VIEW_SUBJECT_ALL);
    scene_camera_rotate(&app->scene->camera, app->home_view.up_axis, right, up);
    app->home_view.is_camera_moved = true;
    app_on_view_changed(app);
}

void app_orbit(App *app, double right, double up, Vec3d center) {
    if (app->window.ray_view.is_open) {
        ray_view_turn(&app->window.ray_view, right, up);
        return;
    }
    note_move(app, VIEW_SUBJECT_ALL);
    scene_camera_orbit(&app->scene->camera, app->home_view.up_axis, center, right, up);
    app->home_view.is_camera_moved = true;
    app_on_view_changed(app);
}

void app_pan(App *app, double right, double up) {
    if (!app->window.ray_view.is_open) {
        note_move(app, VIEW_SUBJECT_ALL);
        scene_camera_move(&app->scene->camera, right, up, 0);
        app->home_view.is_camera_moved = true;
        app_on_view_changed(app);
    }
}

void app_zoom(App *app, double notches) {
    if (app->window.ray_view.is_open) {
        ray_view_move(&app->window.ray_view, (Movement){.forward = notches * FORWARD_PER_NOTCH});
        return;
    }
    note_move(app, VIEW_SUBJECT_ALL);
    SceneCamera *camera = &app->scene->camera;
    const double widest = fmax(camera->fov, ZOOM_FOV_MAXIMUM);
    scene_camera_zoom(camera, pow(ZOOM_PER_NOTCH, notches));
    camera->fov = fmin(camera->fov, widest);
    app->home_view.is_camera_moved = true;
    app_on_view_changed(app);
}

void app_pick_pixel(App *app, double x, double y) {
    ray_view_pick(&app->window.ray_view, x, y);
}

void app_step_pixel(App *app, int right, int down) {
    if (app->window.magnifier.is_on && !app->window.ray_view.is_open) {
        magnifier_step(&app->window.magnifier, right, down);
        window_present(&app->window);
    } else {
        ray_view_step_pixel(&app->window.ray_view, right, down);
    }
}

void app_choose_ray(App *app, size_t ray) {
    ray_view_choose_ray(&app->window.ray_view, ray);
}

void app_note_choice(App *app, const PictureChoice *before, bool continues) {
    const PictureChoice now = window_choice(&app->window);
    if (!picture_choice_is_same(before, &now, &app->window.base_settings)) {
        edit_history_forget_undone(&app->edits);
        view_history_note_choice(&app->moves, before, edit_history_in_force(&app->edits),
                                 continues);
    }
}

void app_take_own_settings(App *app) {
    const RenderSettings before = app->window.base_settings;
    window_take_own_settings(&app->window);
    view_history_rebase(&app->moves, &before, &app->window.base_settings);
}

void app_reset_view(App *app) {
    ray_view_reset_camera(&app->window.ray_view);
    note_move(app, VIEW_SUBJECT_ALL);
    view_state_reset(&app->home_view, app->scene);
    app->selected_light = 0;
    app_on_view_changed(app);
}

void app_restart_view(App *app, double time) {
    held_keys_clear(&app->input.held_keys);
    app->input.camera_motion = MOTION_FLY;
    app->timeline = (Timeline){.time = time};
    window_reset_overrides(&app->window);
    app_reset_view(app);
    edit_history_clear(&app->edits);
    view_history_clear(&app->moves);
    app->window.object_inspector = (ObjectInspector){0};
    ray_view_reset(&app->window.ray_view);
}

/** Writes the settings of the active picture. */
static void write_settings_text(App *app, char *text, size_t size) {
    const RenderSettings *settings = &window_active_viewport(&app->window)->settings;
    snprintf(text, size, "engine %s, offset %s, epsilon %.3g, depth %d, samples %d",
             settings->engine->name, offset_strategy_names[settings->trace.offset],
             settings->trace.epsilon, settings->trace.depth, settings->samples);
}

void app_print_path(const char *path) {
    sanitize_print_line(path, stdout);
    putchar('\n');
    fflush(stdout);
}

/** Moves light and camera. See #StepClockMoveFn. */
static void move_by_clock(void *context, Movement light, Movement camera) {
    app_move(context, light, camera);
}

StepClock app_step_clock(App *app) {
    return (StepClock){.move = move_by_clock, .context = app, .held_keys = {.speed = 1}};
}

/** Says where a file was saved: its name, then its folder. */
static void show_saved_path(App *app, const char *path) {
    const char *slash = strrchr(path, '/');
    char folder[NUMBERED_FILE_PATH_SIZE], full[PATH_MAX];
    snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) : 1, slash ? path : ".");
    app_set_status(app, "saved %s in %s", slash ? slash + 1 : path,
                   realpath(folder, full) ? full : folder);
}

bool app_save_screen(App *app, Error *error) {
    Picture picture = {0};
    char path[NUMBERED_FILE_PATH_SIZE], settings[STATUS_TEXT_SIZE];
    char *view = scene_text_create(app->scene);
    write_settings_text(app, settings, sizeof settings);
    const MetadataEntry metadata[] = {{"Software", "dioptre " DIOPTRE_VERSION},
                                      {"ImageDescription", settings},
                                      {"dioptre:view", view ? view : ""},
                                      {0}};
    bool is_saved = window_copy_screen(&app->window, &picture, error);
    picture.metadata = metadata;
    is_saved = is_saved && snapshot_write_as(app->settings->snapshot_dir, app->source.name, "png",
                                             &picture, path, error);
    picture_deinit(&picture);
    free(view);
    if (is_saved) {
        app_print_path(path);
        show_saved_path(app, path);
    }
    return is_saved;
}

bool app_save_picture(App *app, const char *folder, const char *name, Error *error) {
    Picture picture = {0};
    char path[NUMBERED_FILE_PATH_SIZE];
    bool is_saved = window_copy_picture(&app->window, &picture, error) &&
                    snapshot_write(folder, name, &picture, path, error);
    picture_deinit(&picture);
    if (is_saved) {
        scene_text_print(app->scene, stdout);
        if (app->scene->is_time_dependent) {
            printf("  -- t = %.17g", app->scene_time);
        }
        fputs("  -- ", stdout);
        app_print_path(path);
        show_saved_path(app, path);
    }
    return is_saved;
}
