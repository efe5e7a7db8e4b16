/**
 * @file
 * @brief Recording lessons, typing their captions, and writing their text.
 */
#include "view/commands/recorder.h"

#include "base/language.h"
#include "base/text_file.h"
#include "base/utf8.h"
#include "dioptre/lesson.h"
#include "dioptre/scene.h"
#include "view/state/snapshot.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/** Longest step, bytes with the final zero: a caption with all its bytes escaped. */
enum { STEP_SIZE = 4 * CAPTION_INPUT_SIZE + 64 };

/* --- the text of lessons ---------------------------------------------------------------------- */

/** Quotes a text for Lua. @param[out] out The quoted text, cut to its size. @param size At least 3
 *  bytes. */
static void quote_lua_string(char *out, size_t size, const char *text) {
    size_t used = 0;
    out[used++] = '"';
    for (const char *c = text; *c && used + 6 < size; c++) {
        if ((unsigned char)*c < ' ') {
            used += (size_t)snprintf(out + used, size - used, "\\%03d", *c);
        } else {
            const char *escape = strchr("\"\\", *c) ? "\\" : "";
            used += (size_t)snprintf(out + used, size - used, "%s%c", escape, *c);
        }
    }
    snprintf(out + used, size - used, "\"");
}

void lesson_writer_relative_path(const char *folder, const char *path, char *out, size_t size) {
    size_t common = 0, used = 0;
    for (size_t i = 0; folder[i] == path[i] || (folder[i] == '\0' && path[i] == '/'); i++) {
        common = path[i] == '/' ? i + 1 : common;
        if (folder[i] == '\0') {
            break;
        }
    }
    if (common <= 1 || size == 0) { // Nothing but the root.
        snprintf(out, size, "%s", path);
        return;
    }
    out[0] = '\0';
    const char *rest = folder + SDL_min(common, strlen(folder));
    for (bool is_start = true; *rest; rest++) {
        if (is_start && used + 3 < size) {
            used += (size_t)snprintf(out + used, size - used, "../");
        }
        is_start = *rest == '/';
    }
    snprintf(out + used, size - used, "%s", path + common);
}

/** Finds the path of the scene as seen from the folder of the lesson: both can be moved together.
 */
static void find_scene_path(const App *app, char path[2 * PATH_MAX]) {
    char scene[PATH_MAX], folder[PATH_MAX];
    if (realpath(app->source.path, scene) && realpath(app->settings->snapshot_dir, folder)) {
        lesson_writer_relative_path(folder, scene, path, 2 * PATH_MAX);
    } else {
        snprintf(path, 2 * PATH_MAX, "%s", app->source.path);
    }
}

/** Writes the head of a lesson: scene, window and render settings. */
static void write_head(const App *app, FILE *file) {
    char path[2 * PATH_MAX], scene[4 * PATH_MAX], name[2 * PATH_MAX];
    int width = 0, height = 0;
    const RenderSettings *render = &app->window.base_settings;
    find_scene_path(app, path);
    quote_lua_string(scene, sizeof scene, path);
    quote_lua_string(name, sizeof name, app->source.name);
    window_size_below_toolbar(&app->window, &width, &height);
    fprintf(
        file,
        "-- A lesson, recorded in the window. `dioptre view --lesson` and this file play it.\n");
    fprintf(file, "lesson {\n  scene = %s,\n  title = %s,\n", scene, name);
    fprintf(file, "  size = {%d, %d}, samples = %d,\n", width, height, render->samples);
    if (render->trace.depth >= 0) {
        fprintf(file, "  depth = %d,\n", render->trace.depth);
    }
    if (app->home_view.move_speed > 0) {
        fprintf(file, "  move_speed = %.17g,\n", app->home_view.move_speed);
    }
    fprintf(file, "  offset = \"%s\", epsilon = %.17g, time = %.17g,\n}\n",
            offset_strategy_names[render->trace.offset], render->trace.epsilon, app->timeline.time);
}

void lesson_writer_wait(FILE *file, int64_t milliseconds) {
    const int64_t longest = (int64_t)(MILLISECONDS_PER_SECOND * LESSON_WAIT_MAXIMUM);
    for (; milliseconds > 0; milliseconds -= longest) {
        int64_t duration = milliseconds < longest ? milliseconds : longest;
        fprintf(file, "wait(%.7g)\n", (double)duration / MILLISECONDS_PER_SECOND);
    }
}

void lesson_writer_caption(char *step, size_t size, const char *caption) {
    char quoted[STEP_SIZE];
    quote_lua_string(quoted, sizeof quoted, caption);
    snprintf(step, size, "caption { %s = %s, wait = true }", language_is_french() ? "fr" : "en",
             quoted);
}

/* --- the clock -------------------------------------------------------------------------------- */

/** Advances the clock to the time of an event, never backwards. @param time Seconds on
 *  #clock_now_seconds. */
static void advance_clock(Recorder *recorder, double time) {
    int64_t moment = (int64_t)floor((time - recorder->start_time) * MILLISECONDS_PER_SECOND);
    int64_t now = recorder->step_clock.now;
    step_clock_advance(&recorder->step_clock, moment > now ? moment : now);
}

/** Advances the clock and writes the wait before a step. */
static void begin_step(Recorder *recorder, double time) {
    advance_clock(recorder, time);
    int64_t now = recorder->step_clock.now;
    lesson_writer_wait(recorder->stream, now - recorder->last_step_time);
    recorder->last_step_time = now;
}

void recorder_update(App *app, double now) {
    if (app_is_recording(app) && !app->recorder.is_entering_caption &&
        window_is_ready(&app->window)) {
        advance_clock(&app->recorder, now);
    }
}

double recorder_timeout(const App *app, double now) {
    const Recorder *recorder = &app->recorder;
    bool is_waiting = app_is_recording(app) && window_is_ready(&app->window);
    int64_t next = is_waiting ? step_clock_next_due(&recorder->step_clock) : INT64_MAX;
    return next == INT64_MAX
               ? WINDOW_NO_TIMEOUT
               : fmax(0, recorder->start_time + (double)next / MILLISECONDS_PER_SECOND - now);
}

/* --- events ----------------------------------------------------------------------------------- */

void recorder_on_command(App *app, const Command *command, double time, bool continues) {
    Recorder *recorder = &app->recorder;
    if (!app_is_recording(app) || (command->flags & COMMAND_UNRECORDED)) {
        return;
    }
    begin_step(recorder, time);
    if (command_is(command, "snapshot")) {
        fputs("snapshot()\n", recorder->stream);
        return;
    }
    const bool is_told = continues && command->flags & COMMAND_CHOICE;
    fprintf(recorder->stream, is_told ? "press(\"%s\", true)\n" : "press \"%s\"\n", command->name);
    if (command_is_move(command)) {
        StepClock *step_clock = &recorder->step_clock;
        held_keys_press(&step_clock->held_keys, command->move, step_clock_seconds(step_clock));
    }
}

void recorder_on_release(App *app, const Command *command, double time) {
    Recorder *recorder = &app->recorder;
    StepClock *step_clock = &recorder->step_clock;
    if (app_is_recording(app) && held_keys_is_down(&step_clock->held_keys, command->move)) {
        begin_step(recorder, time);
        fprintf(recorder->stream, "release \"%s\"\n", command->name);
        held_keys_release(&step_clock->held_keys, command->move, step_clock_seconds(step_clock));
    }
}

void recorder_on_release_all(App *app, double time) {
    for (const Command *row = app->commands; command_is_row(row); row++) {
        if (command_is_move(row)) {
            recorder_on_release(app, row, time);
        }
    }
}

void recorder_on_speed(App *app, double speed, double time) {
    Recorder *recorder = &app->recorder;
    StepClock *step_clock = &recorder->step_clock;
    if (app_is_recording(app) && step_clock->held_keys.speed != speed) {
        begin_step(recorder, time);
        fprintf(recorder->stream, "speed(%.17g)\n", speed);
        held_keys_set_speed(&step_clock->held_keys, speed, step_clock_seconds(step_clock));
    }
}

void recorder_on_step(App *app, const char *format, ...) {
    if (app_is_recording(app)) {
        va_list arguments;
        begin_step(&app->recorder, clock_now_seconds());
        va_start(arguments, format);
        vfprintf(app->recorder.stream, format, arguments);
        va_end(arguments);
        fputc('\n', app->recorder.stream);
    }
}

/* --- beginning -------------------------------------------------------------------------------- */

bool recorder_begin(App *app, Error *error) {
    Recorder *recorder = &app->recorder;
    if (strcmp(app->source.path, "-") == 0) {
        return error_set(error, STATUS_FAILED,
                         "a scene from standard input has no file for a lesson to name");
    }
    *recorder = (Recorder){.step_clock = app_step_clock(app), .start_time = clock_now_seconds()};
    recorder->stream = open_memstream(&recorder->text, &recorder->size);
    if (!recorder->stream) {
        return error_set(error, STATUS_FAILED, "no memory for a lesson");
    }
    app_restart_view(app, timeline_time_at(&app->timeline, clock_now_seconds()));
    write_head(app, recorder->stream);
    app->title.next_update_time = 0;
    return true;
}

/* --- captions --------------------------------------------------------------------------------- */

/** Shows the caption that is typed. */
static void show_typed_caption(App *app) {
    Caption *caption = &app->window.caption;
    const char *text = app->recorder.shown;
    snprintf(app->recorder.shown, sizeof app->recorder.shown, "%s%s", app->recorder.caption, CARET);
    *caption = (Caption){
        .text = {text, text}, .hint = N_("Caption: type, then Enter"), .side = caption->side};
    window_present(&app->window);
}

void recorder_begin_caption(App *app) {
    Recorder *recorder = &app->recorder;
    if (!app_is_recording(app)) {
        app_set_status(app, "captions are for lessons that are recorded");
        return;
    }
    double now = clock_now_seconds();
    recorder_on_release_all(app, now);
    recorder_update(app, now);
    recorder->is_entering_caption = true;
    strcpy(recorder->caption, "");
    SDL_StartTextInput();
    show_typed_caption(app);
}

/** Ends the typing of a caption. */
static void end_caption(App *app, bool is_accepted) {
    Recorder *recorder = &app->recorder;
    SDL_StopTextInput();
    recorder->is_entering_caption = false;
    recorder->start_time = clock_now_seconds() - step_clock_seconds(&recorder->step_clock);
    caption_close(&app->window.caption);
    if (is_accepted && recorder->caption[0]) {
        char step[STEP_SIZE];
        lesson_writer_caption(step, sizeof step, recorder->caption);
        recorder_on_step(app, "%s", step);
    }
    window_present(&app->window);
}

void recorder_accept_caption(App *app) {
    if (app->recorder.is_entering_caption) {
        end_caption(app, true);
    }
}

/** Handles a key while a caption is typed. */
static void on_caption_key(App *app, SDL_Keycode key) {
    if (key == SDLK_RETURN || key == SDLK_KP_ENTER || key == SDLK_ESCAPE) {
        end_caption(app, key != SDLK_ESCAPE);
    } else if (key == SDLK_BACKSPACE) {
        utf8_erase_last(app->recorder.caption);
        show_typed_caption(app);
    }
}

bool recorder_handle_caption_event(App *app, const SDL_Event *event) {
    char *caption = app->recorder.caption;
    size_t length = strlen(caption);
    if (!app->recorder.is_entering_caption) {
        return false;
    }
    if (event->type == SDL_TEXTINPUT && length + strlen(event->text.text) < CAPTION_INPUT_SIZE) {
        strcpy(caption + length, event->text.text);
        show_typed_caption(app);
    } else if (event->type == SDL_KEYDOWN) {
        on_caption_key(app, event->key.keysym.sym);
    }
    return event->type == SDL_TEXTINPUT || event->type == SDL_KEYDOWN || event->type == SDL_KEYUP ||
           event->type == SDL_MOUSEMOTION || event->type == SDL_MOUSEWHEEL;
}

/* --- end -------------------------------------------------------------------------------------- */

/** Writes the text of a lesson. See #NumberedFile.write. */
static bool write_lesson_text(const void *context, const char *path, bool *exists, Error *error) {
    const Recorder *recorder = context;
    return text_file_write_new(path, recorder->text, recorder->size, exists, error);
}

/** Writes the lesson's file. @return Whether it is written. */
static bool write_lesson(App *app, Error *error) {
    char name[SCENE_NAME_SIZE + 8], path[NUMBERED_FILE_PATH_SIZE];
    snprintf(name, sizeof name, "%s-lesson", app->source.name);
    const NumberedFile file = {app->settings->snapshot_dir, name, "lua", write_lesson_text,
                               &app->recorder};
    if (!numbered_file_write(&file, path, error)) {
        return false;
    }
    app_print_path(path);
    app_set_status(app, "the lesson is in %s", path);
    return true;
}

bool recorder_end(App *app, Error *error) {
    Recorder *recorder = &app->recorder;
    if (!app_is_recording(app)) {
        return true;
    }
    recorder_accept_caption(app);
    recorder_on_release_all(app, clock_now_seconds());
    step_clock_advance(&recorder->step_clock, recorder->step_clock.now + STEP_CLOCK_TICK);
    timeline_pause(&app->timeline, step_clock_seconds(&recorder->step_clock));
    bool is_kept = fclose(recorder->stream) == 0;
    bool is_written = is_kept ? write_lesson(app, error)
                              : error_set(error, STATUS_FAILED, "no memory for a lesson");
    free(recorder->text);
    *recorder = (Recorder){0};
    gui_request_frames(app->window.gui); // What says that a lesson is recorded goes.
    return is_written;
}
