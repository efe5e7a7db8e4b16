/**
 * @file
 * @brief Recording lessons.
 */
#include "view/recorder.h"

#include "dioptre/language.h"
#include "dioptre/text_file.h"
#include "view/controls.h"
#include "view/deeds.h"
#include "view/lesson_text.h"
#include "view/numbered.h"
#include "view/play.h"

#include <stdlib.h>
#include <string.h>

bool recorder_is_on(const View *view) {
    return view->recorder.stream != NULL;
}

/** Moves light and camera. See #MetronomeMover. @param context The #View. @param light See there.
 *  @param camera See there. */
static void move(void *context, Movement light, Movement camera) {
    controls_move(context, light, camera);
}

/** Begins to record, from the scene's own view. @param[in,out] view The view. @param[out] error
 *  What is wrong. @return Whether it has begun. */
static bool begin(View *view, Error *error) {
    Recorder *recorder = &view->recorder;
    if (strcmp(view->path, "-") == 0) {
        return error_set(error, STATUS_FAILED,
                         "a scene from standard input has no file for a lesson to name");
    }
    *recorder = (Recorder){.metronome = {.move = move, .context = view, .motion = {.speed = 1}},
                           .began = clock_seconds()};
    recorder->stream = open_memstream(&recorder->text, &recorder->size);
    if (!recorder->stream) {
        return error_set(error, STATUS_FAILED, "no memory for a lesson");
    }
    motion_forget(&view->motion);
    timeline_hold(&view->timeline, clock_seconds());
    deeds_do(view, ACTION_AS_ASKED);
    deeds_do(view, ACTION_LAYER);
    deeds_do(view, ACTION_HOME);
    inspector_reset(&view->stage.inspector);
    LessonFacts facts = {.scene = view->path,
                         .name = view->name,
                         .time = view->timeline.time,
                         .render = &view->settings->render};
    SDL_GetWindowSize(view->stage.display.window, &facts.width, &facts.height);
    lesson_text_begin(recorder->stream, &facts);
    view->title_due = 0;
    return true;
}

/**
 * Finds when something happens, and does what is due before.
 * @param[in,out] recorder  The recording.
 * @param time              When, on #clock_seconds; what is done already is not undone.
 */
static void go_to(Recorder *recorder, double time) {
    int64_t moment = (int64_t)floor((time - recorder->began) * 1000);
    int64_t now = recorder->metronome.now;
    metronome_go(&recorder->metronome, moment > now ? moment : now);
}

/** Writes how long nothing happened before a step. @param[in,out] recorder The recording. */
static void write_wait(Recorder *recorder) {
    int64_t now = recorder->metronome.now;
    lesson_text_wait(recorder->stream, now - recorder->written);
    recorder->written = now;
}

void recorder_update(View *view, double now) {
    if (recorder_is_on(view) && !view->recorder.is_typing && stage_is_ready(&view->stage)) {
        go_to(&view->recorder, now);
    }
}

double recorder_delay(const View *view, double now) {
    const Recorder *recorder = &view->recorder;
    bool is_waiting = recorder_is_on(view) && stage_is_ready(&view->stage);
    int64_t next = is_waiting ? metronome_next(&recorder->metronome) : INT64_MAX;
    return next == INT64_MAX ? STAGE_NEVER
                             : fmax(0, recorder->began + (double)(next + 1) / 1000 - now);
}

void recorder_press(View *view, Action action, double time) {
    Recorder *recorder = &view->recorder;
    if (!action_is_taught(action)) {
        return;
    }
    go_to(recorder, time);
    write_wait(recorder);
    Metronome *metronome = &recorder->metronome;
    if (action == ACTION_SNAPSHOT) {
        fputs("snapshot()\n", recorder->stream);
        return;
    }
    fprintf(recorder->stream, "press \"%s\"\n", action_names()[action]);
    if (action_is_move(action)) {
        motion_press(&metronome->motion, action, metronome_seconds(metronome));
    }
}

void recorder_release(View *view, Action action, double time) {
    Recorder *recorder = &view->recorder;
    Metronome *metronome = &recorder->metronome;
    if (metronome->motion.keys[action].is_down) {
        go_to(recorder, time);
        write_wait(recorder);
        fprintf(recorder->stream, "release \"%s\"\n", action_names()[action]);
        motion_release(&metronome->motion, action, metronome_seconds(metronome));
    }
}

void recorder_release_all(View *view, double time) {
    for (int action = 0; action < ACTION_MOVE_COUNT; action++) {
        recorder_release(view, (Action)action, time);
    }
}

void recorder_set_speed(View *view, double speed, double time) {
    Recorder *recorder = &view->recorder;
    Metronome *metronome = &recorder->metronome;
    if (metronome->motion.speed != speed) {
        go_to(recorder, time);
        write_wait(recorder);
        fprintf(recorder->stream, "speed(%.17g)\n", speed);
        motion_set_speed(&metronome->motion, speed, metronome_seconds(metronome));
    }
}

void recorder_note(View *view, const char *words) {
    if (recorder_is_on(view)) {
        go_to(&view->recorder, clock_seconds());
        write_wait(&view->recorder);
        fprintf(view->recorder.stream, "%s\n", words);
    }
}

/** Writes a lesson. See #Numbered.write. @param context The #Recorder. @param path See there.
 *  @param[out] exists See there. @param[out] error See there. @return See there. */
static bool write_file(const void *context, const char *path, bool *exists, Error *error) {
    const Recorder *recorder = context;
    return text_file_write_new(path, recorder->text, recorder->size, exists, error);
}

/** Writes the lesson's file. @param[in,out] view The view. @param[out] error What is wrong.
 *  @return Whether it is there. */
static bool write_lesson(View *view, Error *error) {
    char name[SCENE_NAME_SIZE + 8], path[NUMBERED_PATH_SIZE];
    snprintf(name, sizeof name, "%s-lesson", view->name);
    const Numbered file = {view->settings->snapshot_dir, name, "lua", write_file, &view->recorder};
    if (!numbered_write(&file, path, error)) {
        return false;
    }
    printf("%s\n", path);
    fflush(stdout);
    view_note(view, "the lesson is in %s", path);
    return true;
}

bool recorder_end(View *view, Error *error) {
    Recorder *recorder = &view->recorder;
    if (!recorder_is_on(view)) {
        return true;
    }
    recorder_release_all(view, clock_seconds());
    metronome_go(&recorder->metronome, recorder->metronome.now + METRONOME_BEAT);
    timeline_hold(&view->timeline, metronome_seconds(&recorder->metronome));
    bool is_kept = fclose(recorder->stream) == 0;
    bool is_written = is_kept ? write_lesson(view, error)
                              : error_set(error, STATUS_FAILED, "no memory for a lesson");
    free(recorder->text);
    *recorder = (Recorder){0};
    return is_written;
}

bool recorder_toggle(View *view, Error *error) {
    return recorder_is_on(view) ? recorder_end(view, error) : begin(view, error);
}
