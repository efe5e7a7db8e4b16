/**
 * @file
 * @brief Recording lessons.
 */
#include "view/lesson/recorder.h"

#include "base/language.h"
#include "base/text_file.h"
#include "view/commands/commands.h"
#include "view/commands/numbered_file.h"
#include "view/commands/time_control.h"
#include "view/input/input.h"
#include "view/lesson/lesson_writer.h"

#include <stdlib.h>
#include <string.h>

bool recorder_is_active(const App *app) {
    return app->recorder.stream != NULL;
}

/** Moves light and camera. See #StepClockMoveFn. */
static void move_by_clock(void *context, Movement light, Movement camera) {
    app_move(context, light, camera);
}

/** Begins to record, from the scene's own view. @return Whether it has begun. */
static bool recorder_begin(App *app, Error *error) {
    Recorder *recorder = &app->recorder;
    if (strcmp(app->path, "-") == 0) {
        return error_set(error, STATUS_FAILED,
                         "a scene from standard input has no file for a lesson to name");
    }
    *recorder =
        (Recorder){.step_clock = {.move = move_by_clock, .context = app, .held_keys = {.speed = 1}},
                   .start_time = clock_now_seconds()};
    recorder->stream = open_memstream(&recorder->text, &recorder->size);
    if (!recorder->stream) {
        return error_set(error, STATUS_FAILED, "no memory for a lesson");
    }
    held_keys_clear(&app->held_keys);
    timeline_pause(&app->timeline, clock_now_seconds());
    command_run(app, ACTION_RESET_SETTINGS);
    command_run(app, ACTION_LAYER_FIRST);
    command_run(app, ACTION_RESET_VIEW);
    inspector_reset(&app->window.inspector);
    LessonHeader header = {.scene = app->path,
                           .name = app->name,
                           .time = app->timeline.time,
                           .render = &app->settings->render};
    SDL_GetWindowSize(app->window.sdl.window, &header.width, &header.height);
    lesson_writer_begin(recorder->stream, &header);
    app->next_title_time = 0;
    return true;
}

/** Finds when something happens, and does what is due before. @param time When, on
 *  #clock_now_seconds; what is done already is not undone. */
static void advance_clock(Recorder *recorder, double time) {
    int64_t moment = (int64_t)floor((time - recorder->start_time) * 1000);
    int64_t now = recorder->step_clock.now;
    step_clock_advance(&recorder->step_clock, moment > now ? moment : now);
}

/** Writes how long nothing happened before a step. */
static void write_wait(Recorder *recorder) {
    int64_t now = recorder->step_clock.now;
    lesson_writer_wait(recorder->stream, now - recorder->last_step_time);
    recorder->last_step_time = now;
}

void recorder_update(App *app, double now) {
    if (recorder_is_active(app) && !app->recorder.is_entering_caption &&
        window_is_ready(&app->window)) {
        advance_clock(&app->recorder, now);
    }
}

double recorder_timeout(const App *app, double now) {
    const Recorder *recorder = &app->recorder;
    bool is_waiting = recorder_is_active(app) && window_is_ready(&app->window);
    int64_t next = is_waiting ? step_clock_next_tick(&recorder->step_clock) : INT64_MAX;
    return next == INT64_MAX ? WINDOW_NO_TIMEOUT
                             : fmax(0, recorder->start_time + (double)(next + 1) / 1000 - now);
}

void recorder_press(App *app, Action action, double time) {
    Recorder *recorder = &app->recorder;
    if (!action_is_recorded(action)) {
        return;
    }
    advance_clock(recorder, time);
    write_wait(recorder);
    StepClock *step_clock = &recorder->step_clock;
    if (action == ACTION_SNAPSHOT) {
        fputs("snapshot()\n", recorder->stream);
        return;
    }
    fprintf(recorder->stream, "press \"%s\"\n", action_names()[action]);
    if (action_is_move(action)) {
        held_keys_press(&step_clock->held_keys, action, step_clock_seconds(step_clock));
    }
}

void recorder_release(App *app, Action action, double time) {
    Recorder *recorder = &app->recorder;
    StepClock *step_clock = &recorder->step_clock;
    if (step_clock->held_keys.keys[action].is_down) {
        advance_clock(recorder, time);
        write_wait(recorder);
        fprintf(recorder->stream, "release \"%s\"\n", action_names()[action]);
        held_keys_release(&step_clock->held_keys, action, step_clock_seconds(step_clock));
    }
}

void recorder_release_all(App *app, double time) {
    for (int action = 0; action < ACTION_MOVE_COUNT; action++) {
        recorder_release(app, (Action)action, time);
    }
}

void recorder_set_speed(App *app, double speed, double time) {
    Recorder *recorder = &app->recorder;
    StepClock *step_clock = &recorder->step_clock;
    if (step_clock->held_keys.speed != speed) {
        advance_clock(recorder, time);
        write_wait(recorder);
        fprintf(recorder->stream, "speed(%.17g)\n", speed);
        held_keys_set_speed(&step_clock->held_keys, speed, step_clock_seconds(step_clock));
    }
}

void recorder_record_step(App *app, const char *step) {
    if (recorder_is_active(app)) {
        advance_clock(&app->recorder, clock_now_seconds());
        write_wait(&app->recorder);
        fprintf(app->recorder.stream, "%s\n", step);
    }
}

/** Writes a lesson. See #NumberedFile.write. @return See there. */
static bool write_lesson_text(const void *context, const char *path, bool *exists, Error *error) {
    const Recorder *recorder = context;
    return text_file_write_new(path, recorder->text, recorder->size, exists, error);
}

/** Writes the lesson's file. @return Whether it is there. */
static bool write_lesson(App *app, Error *error) {
    char name[SCENE_NAME_SIZE + 8], path[NUMBERED_FILE_PATH_SIZE];
    snprintf(name, sizeof name, "%s-lesson", app->name);
    const NumberedFile file = {app->settings->snapshot_dir, name, "lua", write_lesson_text,
                               &app->recorder};
    if (!numbered_file_write(&file, path, error)) {
        return false;
    }
    printf("%s\n", path);
    fflush(stdout);
    app_set_status(app, "the lesson is in %s", path);
    return true;
}

bool recorder_end(App *app, Error *error) {
    Recorder *recorder = &app->recorder;
    if (!recorder_is_active(app)) {
        return true;
    }
    recorder_release_all(app, clock_now_seconds());
    step_clock_advance(&recorder->step_clock, recorder->step_clock.now + STEP_CLOCK_TICK);
    timeline_pause(&app->timeline, step_clock_seconds(&recorder->step_clock));
    bool is_kept = fclose(recorder->stream) == 0;
    bool is_written = is_kept ? write_lesson(app, error)
                              : error_set(error, STATUS_FAILED, "no memory for a lesson");
    free(recorder->text);
    *recorder = (Recorder){0};
    return is_written;
}

bool recorder_toggle(App *app, Error *error) {
    return recorder_is_active(app) ? recorder_end(app, error) : recorder_begin(app, error);
}
