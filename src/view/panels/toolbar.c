/**
 * @file
 * @brief The widgets of the bar, and the commands that they request.
 */
#include "view/panels/toolbar.h"

#include "base/language.h"
#include "base/typeset_numbers.h"
#include "dioptre/scene.h"
#include "view/panels/tooltip.h"
#include "view/state/settings_words.h"
#include "view/state/way_out.h"

#include <libintl.h>
#include <math.h>
#include <stdio.h>

/** Smallest epsilon of the slider, scene units: below the spacing of doubles near 1. */
static const double EPSILON_LOW = 1e-16;
/** Largest epsilon of the slider, scene units: as large as most shapes. */
static const double EPSILON_HIGH = 1;
/** Bytes of a label with the final zero. */
enum { LABEL_SIZE = 64 };

/** Requests a command. @param repetitions How many times; 0: not at all. */
static void request(Toolbar *toolbar, const char *command, int repetitions) {
    if (repetitions > 0) {
        toolbar->command = command;
        toolbar->repetitions = repetitions;
        toolbar->continues = false;
    }
}

/** A button that issues a command. @param is_on Whether what it shows or hides is on. */
static void command_button(Toolbar *toolbar, const ToolbarContent *content, const char *label,
                           const char *command, bool is_on) {
    char text[TOOLTIP_SIZE];
    request(toolbar, command,
            gui_button(label, tooltip_write(content->help, command, text), is_on));
}

/** A button that issues a command, dimmed while that would do nothing. */
static void possible_button(Toolbar *toolbar, const ToolbarContent *content, const char *label,
                            const char *command, bool is_possible) {
    char text[TOOLTIP_SIZE];
    gui_same_line(label);
    request(
        toolbar, command,
        gui_step_button(label, tooltip_write(content->help, command, text), is_possible, false));
}

/** A list whose next entry a command chooses, cyclically. @param explained See #gui_choice. */
static void cyclic_choice(Toolbar *toolbar, const ToolbarContent *content, const char *command,
                          const char *const *names, const char *const *explained, int count,
                          int selected) {
    char text[TOOLTIP_SIZE];
    int chosen = gui_choice(command, names, explained, count, selected,
                            tooltip_write(content->help, command, text));
    request(toolbar, command, chosen < 0 ? 0 : (chosen - selected + count) % count);
}

/** A number that two commands change. @param values It, and the widest one. */
static void number(Toolbar *toolbar, const ToolbarContent *content, const char *const values[2],
                   const char *less, const char *more) {
    char text[TOOLTIP_SIZE];
    int step = gui_stepper(more, values[0], values[1],
                           tooltip_write_pair(content->help, more, less, ", ", text));
    request(toolbar, step < 0 ? less : more, step != 0);
}

const char *toolbar_layer_command(Layer layer) {
    static const char *const commands[LAYER_COUNT] = {
        "layer light",  "layer normals", "layer distance", "layer shapes",
        "layer places", "layer rays",    "layer steps",    "layer time",
        "layer error",  "layer acne",    "layer rounding", "layer operations"};
    return commands[layer];
}

/** The list of layers. */
static void layer_choice(Toolbar *toolbar, const ToolbarContent *content) {
    const char *names[LAYER_COUNT];
    char text[TOOLTIP_SIZE];
    for (int i = 0; i < LAYER_COUNT; i++) {
        names[i] = gettext(layer_name((Layer)i));
    }
    const char *first = toolbar_layer_command(LAYER_SHADED),
               *last = toolbar_layer_command(LAYER_ACNE);
    int chosen = gui_choice("layer", names, names, LAYER_COUNT, (int)content->layer,
                            tooltip_write_pair(content->help, first, last, " … ", text));
    if (chosen >= 0) {
        request(toolbar, toolbar_layer_command((Layer)chosen), 1);
    }
}

/** The offset strategy, and its epsilon as a slider that goes by factors of two. */
static void offset_widgets(Toolbar *toolbar, const ToolbarContent *content) {
    const TraceSettings *trace = &content->settings->trace;
    const char *const explained[OFFSET_BOUND + 1] = {
        [OFFSET_NONE] = gettext("none: rays start at the surface, acne is seen"),
        [OFFSET_FIXED] = gettext("fixed: rays start epsilon above the surface"),
        [OFFSET_BOUND] = gettext("bound: as far above it as rounding can reach")};
    const char *names[OFFSET_BOUND + 1];
    for (int i = 0; i <= OFFSET_BOUND; i++) {
        names[i] = offset_strategy_word((OffsetStrategy)i);
    }
    cyclic_choice(toolbar, content, "offset", names, explained, OFFSET_BOUND + 1,
                  (int)trace->offset);
    char text[TOOLTIP_SIZE], label[LABEL_SIZE];
    const double shown = fmax(trace->epsilon, EPSILON_LOW);
    double epsilon = shown;
    snprintf(label, sizeof label, "ε %.1e", trace->epsilon);
    typeset_numbers(label, sizeof label);
    if (gui_log_slider(
            "epsilon", &epsilon, EPSILON_LOW, EPSILON_HIGH, label, trace->offset == OFFSET_FIXED,
            tooltip_write_pair(content->help, "epsilon twice", "epsilon half", ", ", text))) {
        int steps = (int)round(log2(epsilon / shown));
        request(toolbar, steps < 0 ? "epsilon half" : "epsilon twice", abs(steps));
        toolbar->continues = toolbar->is_continuing;
        toolbar->is_continuing = toolbar->is_continuing || steps != 0;
    }
    toolbar->is_continuing = toolbar->is_continuing && gui_is_editing();
}

/** The settings of a ray: offset, number type, depth. */
static void ray_settings(Toolbar *toolbar, const ToolbarContent *content) {
    const RenderSettings *settings = content->settings;
    const char *types[NUMBER_TYPE_COUNT];
    char depth[LABEL_SIZE], deepest[LABEL_SIZE];
    offset_widgets(toolbar, content);
    for (int i = 0; i < NUMBER_TYPE_COUNT; i++) {
        types[i] = number_type_word((NumberType)i);
    }
    cyclic_choice(toolbar, content, "engine", types, types, NUMBER_TYPE_COUNT,
                  (int)number_type_of(settings->engine));
    snprintf(depth, sizeof depth, "%s %d", gettext("depth"), settings->trace.depth);
    snprintf(deepest, sizeof deepest, "%s %d", gettext("depth"), KEY_DEPTH_MAXIMUM);
    number(toolbar, content, (const char *[]){depth, deepest}, "less deep", "deeper");
}

/** Writes a number of samples. */
static void write_samples(int samples, char text[LABEL_SIZE]) {
    snprintf(text, LABEL_SIZE, ngettext("%d sample", "%d samples", (unsigned long)samples),
             samples);
}

/** The settings of a picture: samples and light. */
static void picture_settings(Toolbar *toolbar, const ToolbarContent *content) {
    const RenderSettings *settings = content->settings;
    const char *lights[LIGHTING_MODE_COUNT];
    char samples[LABEL_SIZE], most[LABEL_SIZE];
    write_samples(settings->samples, samples);
    write_samples(KEY_SAMPLES_MAXIMUM, most);
    number(toolbar, content, (const char *[]){samples, most}, "samples half", "samples twice");
    for (int i = 0; i < LIGHTING_MODE_COUNT; i++) {
        lights[i] = gettext(light_mode_name((LightingMode)i));
    }
    cyclic_choice(toolbar, content, "light mode", lights, lights, LIGHTING_MODE_COUNT,
                  (int)settings->lighting);
}

/** The menu of what is about the window, not about the picture; a folded bar has a button instead,
 *  which unfolds it. */
static void menu(Toolbar *toolbar, const ToolbarContent *content) {
    static const char *const commands[] = {
        "toolbar",      "toolbar keys", "presentation", "full screen", "text larger",
        "text smaller", "language",     "lessons",      "record",      "quit"};
    enum { COUNT = sizeof commands / sizeof *commands };
    const bool has_way_out = way_out_exists();
    const int count = has_way_out ? COUNT : COUNT - 1; // The last one is the way out.
    if (toolbar->is_folded) {
        command_button(toolbar, content, "☰", "toolbar", false);
        return;
    }
    if (!gui_menu_begin("☰", has_way_out ? gettext("bar, letters, language, lessons, the way out")
                                         : gettext("bar, letters, language, lessons"))) {
        return;
    }
    for (int i = 0; i < count; i++) {
        char text[TOOLTIP_SIZE];
        request(toolbar, commands[i],
                gui_menu_entry(tooltip_write(content->help, commands[i], text)));
    }
    gui_menu_end();
}

/** The widgets of the rays of a pixel, with the settings that such a ray has. */
static void ray_widgets(Toolbar *toolbar, const ToolbarContent *content) {
    ray_view_show_buttons(content->rays, content->help);
    ray_settings(toolbar, content);
}

/** The button of the list of scenes; dimmed while a lesson keeps to its scene, and says so. */
static void scenes_button(Toolbar *toolbar, const ToolbarContent *content) {
    const char *label = gettext("scenes");
    if (content->is_playing || content->is_recording) {
        gui_same_line(label);
        gui_step_button(label,
                        gettext(content->is_playing ? N_("a lesson plays: leave it first — Esc")
                                                    : N_("a lesson is recorded: end it first")),
                        false, false);
    } else {
        command_button(toolbar, content, label, "scenes", content->shows_scenes);
    }
}

/** The widgets of the picture. */
static void picture_widgets(Toolbar *toolbar, const ToolbarContent *content) {
    const char *const splits[SPLIT_COUNT] = {gettext("one picture"), gettext("side by side"),
                                             gettext("difference")};
    scenes_button(toolbar, content);
    layer_choice(toolbar, content);
    ray_settings(toolbar, content);
    picture_settings(toolbar, content);
    command_button(toolbar, content, "↺", "as at first", false);
    cyclic_choice(toolbar, content, "split", splits, splits, SPLIT_COUNT, (int)content->split);
    if (content->is_animated) {
        char text[TOOLTIP_SIZE];
        request(toolbar, "time",
                gui_toggle((const char *const[]){"▶", "❚❚"},
                           tooltip_write(content->help, "time", text), content->is_running));
    }
    command_button(toolbar, content, gettext("rays"), "rays", false);
    command_button(toolbar, content, gettext("costs"), "settings", content->shows_settings);
    command_button(toolbar, content, gettext("chart"), "chart", content->shows_chart);
    command_button(toolbar, content, gettext("magnifier"), "magnifier", content->shows_magnifier);
    command_button(toolbar, content, "▤", "things", content->lists_things);
    possible_button(toolbar, content, "↩", "undo", content->can_undo);
    possible_button(toolbar, content, "↪", "redo", content->can_redo);
}

void toolbar_show(Toolbar *toolbar, const ToolbarContent *content) {
    gui_bar_begin(toolbar->is_folded);
    menu(toolbar, content);
    if (!toolbar->is_folded) {
        if (content->rays) {
            ray_widgets(toolbar, content);
        } else {
            picture_widgets(toolbar, content);
        }
        command_button(toolbar, content, gettext("photo"), "snapshot", false);
        command_button(toolbar, content, "?", "help", content->help->is_open);
        if (content->is_recording) { // The last one: no other moves.
            command_button(toolbar, content, "●", "record", true);
        }
    }
    toolbar->height = gui_bar_end();
}
