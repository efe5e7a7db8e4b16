/**
 * @file
 * @brief The state of the window as text, for links: camera, lights, time, layers, settings and
 * edits.
 *
 * Lines of a word and numbers, in the order of state_write(). What a link says is a stranger's:
 * each number is checked as that of a scene file is, and a line that is wrong ends the reading.
 */
#include "dioptre/engine.h"
#include "view/app.h"
#include "view/commands/edits.h"
#include "web/description.h"

#include <SDL.h>
#include <emscripten.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Event of the page: data1 is a text to be read, to be freed; NULL: the state is wanted. Beyond
 * all that SDL_RegisterEvents() gives. */
enum { STATE_EVENT = SDL_LASTEVENT - 1 };
/** Longest name in a state, bytes with the final zero. */
enum { NAME_SIZE = 64 };
/** Most numbers of a light. */
enum { LIGHT_NUMBERS = 64 };
/** Largest time of a scene, seconds: that of lessons. */
static const double TIME_MAXIMUM = 1e9;
/** Largest deviation of a camera's axes from length one and a right angle. */
static const double AXIS_TOLERANCE = 1e-9;

// --- writing -------------------------------------------------------------------------------------

/** Writes numbers, so that they are read as the same. */
static void write_numbers(FILE *file, const double *numbers, int count) {
    for (int i = 0; i < count; i++) {
        fprintf(file, " %.17g", numbers[i]);
    }
}

/** Writes the camera, if the user has moved it. */
static void write_camera(const App *app, FILE *file) {
    const SceneCamera *camera = &app->scene->camera;
    if (app->home_view.is_camera_moved) {
        fputs("camera", file);
        write_numbers(file, &camera->position.x, 3);
        write_numbers(file, &camera->direction.x, 3);
        write_numbers(file, &camera->up.x, 3);
        write_numbers(file, (double[]){camera->fov, camera->target_distance}, 2);
        fputc('\n', file);
    }
}

/** Writes the lights that the user has moved: the values of their fields. */
static void write_lights(const App *app, FILE *file) {
    for (size_t i = 0; i < app->scene->light_count; i++) {
        const SceneLight *light = &app->scene->lights[i];
        if (!app->home_view.is_light_moved[i]) {
            continue;
        }
        fprintf(file, "light %zu", i);
        for (const Parameter *row = scene_light_keyword_for(light)->parameters; row->name; row++) {
            double numbers[PARAMETER_NUMBERS_MAXIMUM];
            parameter_get_numbers(row, light, numbers);
            write_numbers(file, numbers, parameter_number_count(row->type));
        }
        fputc('\n', file);
    }
}

/** Writes layer and settings of both pictures. */
static void write_pictures(const App *app, FILE *file) {
    const SplitView *split = &app->window.split;
    fprintf(file, "split %d %zu %.17g\n", (int)split->mode, split->active, split->bar_position);
    for (size_t i = 0; i < SCENE_LOAD_VIEWPORTS; i++) {
        const Viewport *viewport = &app->window.viewports[i];
        const RenderSettings *values = &viewport->overrides.values;
        unsigned mask = viewport->overrides.mask;
        fprintf(file, "picture %zu %d %u %s %d %.17g %d %d %d %d %d\n", i, (int)viewport->layer,
                mask, mask & SETTING_ENGINE ? values->engine->name : "-", (int)values->trace.offset,
                values->trace.epsilon, values->trace.depth, values->samples, (int)values->lighting,
                (int)values->trace.pixel_point, (int)values->method_set);
    }
}

/** Writes what the user has changed of the scene's objects. */
static void write_edits(const App *app, FILE *file) {
    SceneOverride *overrides = calloc(SCENE_OVERRIDES_MAXIMUM, sizeof *overrides);
    size_t count = overrides ? edit_history_overrides(&app->edits, overrides) : 0;
    for (size_t i = 0; i < count; i++) {
        const SceneOverride *edit = &overrides[i];
        fprintf(file, "edit %s %d %s", scene_object_keyword(edit->keyword)->name, edit->number,
                scene_object_row(edit->keyword, edit->row)->name);
        write_numbers(file, edit->numbers, PARAMETER_NUMBERS_MAXIMUM);
        fputc('\n', file);
    }
    free(overrides);
}

/** @return The state, to be freed; NULL without memory. */
static char *state_write(const App *app) {
    char *text = NULL;
    size_t size = 0;
    FILE *file = open_memstream(&text, &size);
    if (file) {
        write_camera(app, file);
        write_lights(app, file);
        fprintf(file, "time %.17g\n", app->scene_time);
        write_pictures(app, file);
        write_edits(app, file);
        fclose(file);
    }
    return text;
}

// --- reading -------------------------------------------------------------------------------------

/** Reads numbers. @param[in,out] text Goes on behind them. @return How many there are, at most
 * maximum. */
static int read_numbers(const char *text, double *numbers, int maximum) {
    int count = 0;
    char *end;
    while (count < maximum) {
        numbers[count] = strtod(text, &end);
        if (end == text || !isfinite(numbers[count])) {
            break;
        }
        count++;
        text = end;
    }
    return count;
}

/** @return Whether a vector is of length one. */
static bool is_unit(Vec3d vector) {
    return fabs(vec3d_length(vector) - 1) <= AXIS_TOLERANCE;
}

/** @return Whether three coordinates are those of a scene. */
static bool is_position(const double *numbers) {
    return fabs(numbers[0]) <= LENGTH_MAXIMUM && fabs(numbers[1]) <= LENGTH_MAXIMUM &&
           fabs(numbers[2]) <= LENGTH_MAXIMUM;
}

/** Moves the camera. @return Whether the line is right. */
static bool read_camera(App *app, const char *text) {
    double n[11];
    Vec3d direction, up;
    if (read_numbers(text, n, 11) != 11 || !is_position(n)) {
        return false;
    }
    direction = (Vec3d){n[3], n[4], n[5]};
    up = (Vec3d){n[6], n[7], n[8]};
    bool is_valid = is_unit(direction) && is_unit(up) &&
                    fabs(vec3d_dot(direction, up)) <= AXIS_TOLERANCE && n[9] >= 0.01 &&
                    n[9] <= 175 && n[10] > 0 && n[10] <= LENGTH_MAXIMUM;
    if (is_valid) {
        SceneCamera *camera = &app->scene->camera;
        camera->position = (Vec3d){n[0], n[1], n[2]};
        camera->direction = direction;
        camera->up = up;
        camera->fov = n[9];
        camera->target_distance = n[10];
        app->home_view.is_camera_moved = true;
    }
    return is_valid;
}

/** Moves a light. @return Whether the line is right. */
static bool read_light(App *app, const char *text) {
    char *rest;
    double numbers[LIGHT_NUMBERS] = {0};
    size_t index = strtoul(text, &rest, 10);
    int count = read_numbers(rest, numbers, LIGHT_NUMBERS), next = 0;
    if (index >= app->scene->light_count) {
        return false;
    }
    SceneLight light = app->scene->lights[index];
    Error error = {0};
    for (const Parameter *row = scene_light_keyword_for(&light)->parameters; row->name; row++) {
        int size = parameter_number_count(row->type);
        if (next + size > count ||
            (size > 0 && !parameter_check_numbers(row, numbers + next, &error))) {
            return false;
        }
        if (size > 0) {
            parameter_set_numbers(row, &light, numbers + next);
        }
        next += size;
    }
    const Keyword *keyword = scene_light_keyword_for(&light);
    if (next != count || (keyword->finish && !keyword->finish(&light, 0, &error))) {
        return false;
    }
    app->scene->lights[index] = light;
    app->home_view.is_light_moved[index] = true;
    return true;
}

/** Sets the scene's time. @return Whether the line is right. */
static bool read_time(App *app, const char *text) {
    double time;
    bool is_valid = read_numbers(text, &time, 1) == 1 && fabs(time) <= TIME_MAXIMUM;
    app->timeline = is_valid ? (Timeline){.time = time} : app->timeline;
    return is_valid;
}

/** Sets how two pictures share the window. @return Whether the line is right. */
static bool read_split(App *app, const char *text) {
    double n[3];
    if (read_numbers(text, n, 3) != 3 || !(n[0] >= 0 && n[0] < SPLIT_COUNT) ||
        !(n[1] == 0 || n[1] == 1) || !(n[2] >= 0 && n[2] <= 1)) {
        return false;
    }
    Window *window = &app->window;
    window_cycle_split(window, (int)n[0] - (int)window->split.mode);
    window->split.active = (size_t)n[1];
    split_view_move_bar(&window->split, n[2]);
    return true;
}

/** @return Whether settings are possible. */
static bool is_possible(const RenderSettings *settings, unsigned mask) {
    const TraceSettings *trace = &settings->trace;
    return (!(mask & SETTING_OFFSET) || (unsigned)trace->offset <= OFFSET_BOUND) &&
           (!(mask & SETTING_EPSILON) ||
            (trace->epsilon >= 0 && trace->epsilon <= LENGTH_MAXIMUM)) &&
           (!(mask & SETTING_DEPTH) || (trace->depth >= 0 && trace->depth <= DEPTH_MAXIMUM)) &&
           (!(mask & SETTING_SAMPLES) ||
            (settings->samples >= 1 && settings->samples <= KEY_SAMPLES_MAXIMUM)) &&
           (!(mask & SETTING_LIGHT) || (unsigned)settings->lighting <= LIGHTING_UNLIT) &&
           (!(mask & SETTING_PIXEL) || (unsigned)trace->pixel_point <= PIXEL_CORNER) &&
           (!(mask & SETTING_METHODS) || (unsigned)settings->method_set < METHODS_COUNT);
}

/** Sets layer and settings of a picture. @return Whether the line is right. */
static bool read_picture(App *app, const char *text) {
    size_t index;
    int layer, offset, lighting, pixel, methods;
    SettingsOverride changes = {0};
    RenderSettings *values = &changes.values;
    char engine[NAME_SIZE];
    Error error = {0};
    if (sscanf(text, "%zu %d %u %63s %d %lf %d %d %d %d %d", &index, &layer, &changes.mask, engine,
               &offset, &values->trace.epsilon, &values->trace.depth, &values->samples, &lighting,
               &pixel, &methods) != 11) {
        return false;
    }
    values->trace.offset = (OffsetStrategy)offset;
    values->lighting = (LightingMode)lighting;
    values->trace.pixel_point = (PixelPoint)pixel;
    values->method_set = (MethodSet)methods;
    values->engine = changes.mask & SETTING_ENGINE ? engine_find(engine, &error) : NULL;
    if (index >= SCENE_LOAD_VIEWPORTS || layer < 0 || layer >= LAYER_COUNT ||
        error.status != STATUS_OK || !is_possible(values, changes.mask)) {
        return false;
    }
    Viewport *viewport = &app->window.viewports[index];
    viewport->overrides = changes;
    viewport->needs_new_renderer = true;
    if (viewport->renderer) {
        viewport_set_layer(viewport, (Layer)layer);
    } else {
        viewport->layer = (Layer)layer;
    }
    return true;
}

/** Changes a field of an object. @return Whether the line is right. */
static bool read_edit(App *app, const char *text) {
    char keyword[NAME_SIZE], row[NAME_SIZE];
    int used = 0;
    Error error = {0};
    SceneOverride edit = {0};
    if (sscanf(text, "%63s %d %63s%n", keyword, &edit.number, row, &used) != 3 || edit.number < 1) {
        return false;
    }
    edit.keyword = scene_object_keyword_find(keyword);
    edit.row = edit.keyword >= 0 ? scene_object_row_find(edit.keyword, row) : -1;
    SceneObject object;
    return edit.row >= 0 &&
           read_numbers(text + used, edit.numbers, PARAMETER_NUMBERS_MAXIMUM) == 3 &&
           scene_object_find(app->scene, edit.keyword, edit.number, &object) &&
           parameter_check_numbers(scene_object_row(edit.keyword, edit.row), edit.numbers,
                                   &error) &&
           edits_check(app, &object, &edit, 1, &error) &&
           edit_history_add(&app->edits, &edit, false, &error);
}

/** Reads lines. @return Whether all are right. */
static bool state_read(App *app, char *text) {
    static const struct {
        const char *word;
        bool (*read)(App *app, const char *text);
    } lines[] = {{"camera ", read_camera}, {"light ", read_light},     {"time ", read_time},
                 {"split ", read_split},   {"picture ", read_picture}, {"edit ", read_edit}};
    bool is_right = true;
    char *rest = text;
    for (char *line = strtok_r(text, "\n", &rest); line && is_right;
         line = strtok_r(NULL, "\n", &rest)) {
        is_right = false;
        for (size_t i = 0; i < sizeof lines / sizeof *lines && !is_right; i++) {
            size_t length = strlen(lines[i].word);
            is_right =
                strncmp(line, lines[i].word, length) == 0 && lines[i].read(app, line + length);
        }
    }
    return is_right;
}

// --- the page's side -----------------------------------------------------------------------------

/** The window's own function. */
void __real_input_handle_event(App *app, const SDL_Event *event);

/** Tells the page what a finished picture shows. */
static void tell_description(App *app) {
    const Viewport *viewport = window_active_viewport(&app->window);
    if (viewport->renderer && renderer_progress(viewport->renderer) >= 1) {
        char *text = description_write(app);
        MAIN_THREAD_EM_ASM(
            { Module['onDescription'] && Module['onDescription'](UTF8ToString($0)); }, text);
        free(text);
    }
}

/** Tells the page that there is something to be seen of a picture: once. */
static void tell_picture(void) {
    static bool is_told;
    if (!is_told) {
        is_told = true;
        MAIN_THREAD_ASYNC_EM_ASM({ Module['onPicture'] && Module['onPicture'](); });
    }
}

/** Handles an event: those of the page here. See #input_handle_event. */
void __wrap_input_handle_event(App *app, const SDL_Event *event) {
    if (event->type != STATE_EVENT) {
        __real_input_handle_event(app, event);
        if (event->type == app->first_event + EVENT_PASS_FINISHED) {
            tell_picture();
            tell_description(app);
        }
        return;
    }
    char *text = event->user.data1;
    if (text) {
        bool is_right = state_read(app, text);
        app_on_view_changed(app);
        MAIN_THREAD_EM_ASM({ Module['onStateRead'] && Module['onStateRead']($0); }, is_right);
    } else {
        text = state_write(app);
        MAIN_THREAD_EM_ASM({ Module['onState'] && Module['onState'](UTF8ToString($0)); }, text);
    }
    free(text);
}

/** Asks the window for its state, which Module.onState gets. Called by the page. */
EMSCRIPTEN_KEEPALIVE void web_ask_state(void) {
    SDL_Event event = {.user = {.type = STATE_EVENT}};
    SDL_PushEvent(&event);
}

/** Has the window read a state. Called by the page. */
EMSCRIPTEN_KEEPALIVE void web_set_state(const char *text) {
    SDL_Event event = {.user = {.type = STATE_EVENT, .data1 = strdup(text)}};
    SDL_PushEvent(&event);
}
