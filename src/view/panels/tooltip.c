/**
 * @file
 * @brief The sentences of the buttons.
 *
 * The rows of the help name several keys at once, so a button has a sentence of its own.
 */
#include "view/panels/tooltip.h"

#include "base/language.h"

#include <libintl.h>
#include <stdio.h>
#include <string.h>

/** Bytes of the names of keys with the final zero. */
enum { KEYS_SIZE = GUI_LABEL_SIZE };

/** A command, and what its button says. */
typedef struct Sentence {
    const char *name; /**< Name of the command. */
    const char *text; /**< What it does, in English. */
} Sentence;

/** The sentences, in the order of the bar; then those of the rays. */
static const Sentence sentences[] = {
    {"toolbar", N_("hide this bar, or show it")},
    {"toolbar keys", N_("the buttons of this bar by keys")},
    {"presentation", N_("for a class: large letters, no bar")},
    {"full screen", N_("the whole screen, or a window")},
    {"text larger", N_("larger letters")},
    {"text smaller", N_("smaller letters")},
    {"language", N_("English, français")},
    {"quit", N_("leave dioptre")},
    {"scenes", N_("lessons and scenes: a list with pictures, or back to the picture")},
    {"lessons", N_("lessons: a list with pictures")},
    {"layer light", N_("what each pixel shows: its light, or a number such as the distance, the "
                       "rays it took, rounding errors, acne")},
    {"offset", N_("how far above a surface the next rays start, so that it does not shadow itself "
                  "(acne): none, fixed (epsilon), bound (fits the rounding of each hit)")},
    {"epsilon twice", N_("epsilon, the distance of a fixed offset: too small shows acne, too large "
                         "loses shadows; a change makes the offset fixed")},
    {"engine", N_("the number type that rays are computed with: float, double, quad")},
    {"deeper", N_("depth: how often a ray may be mirrored or refracted")},
    {"samples twice", N_("samples: rays through each pixel, for smooth edges and soft shadows")},
    {"light mode", N_("which light counts: that of the lamps and the ambient one, that of the "
                      "lamps alone, or none")},
    {"as at first", N_("settings, layer and pictures as at first")},
    {"split", N_("one picture, two with settings of their own side by side, or their difference")},
    {"time", N_("run the scene's time, or hold it")},
    {"rays", N_("the rays of one pixel with their formulas, or back to the picture")},
    {"settings", N_("the settings, and what the picture costs: time, rays, memory")},
    {"chart", N_("a chart of the settings tried: time against error")},
    {"magnifier", N_("the pixels under the mouse as large squares")},
    {"things", N_("all things of the scene, to choose one: lamps, shapes, the camera")},
    {"undo", N_("take the last change back")},
    {"redo", N_("do again what was taken back")},
    {"snapshot", N_("save the picture as a file")},
    {"record", N_("record a lesson, or end it")},
    {"help", N_("all keys, on a drawn keyboard")},
    {"fly ray", N_("the next ray flies along its path")},
    {"ray plan", N_("the rays from above")},
    {"ray march", N_("each step of a marched ray, with its free distance")},
    {"hit microscope", N_("the hit point magnified: rounding, offset, start of the next ray")},
    {"arrows", N_("arrows along the light, or along the rays")},
    {"camera rays", N_("show or hide the ray from the camera")},
    {"shadow rays", N_("show or hide the rays to the lamps")},
    {"mirrored rays", N_("show or hide mirrored rays")},
    {"refracted rays", N_("show or hide refracted rays")},
};

const char *tooltip_sentence(const char *name) {
    for (size_t i = 0; i < sizeof sentences / sizeof *sentences; i++) {
        if (strcmp(sentences[i].name, name) == 0) {
            return sentences[i].text;
        }
    }
    return NULL;
}

/** Appends the keys of a command. */
static void append_keys(const Help *help, const char *name, char keys[KEYS_SIZE]) {
    const Command *command = command_find(help->commands, name);
    char own[KEYS_SIZE] = "";
    size_t used = strlen(keys);
    if (command) {
        help_key_names(help, command, own, sizeof own);
        snprintf(keys + used, KEYS_SIZE - used, "%s", own);
    }
}

const char *tooltip_write_pair(const Help *help, const char *name, const char *other,
                               const char *gap, char text[TOOLTIP_SIZE]) {
    const char *sentence = tooltip_sentence(name);
    char keys[KEYS_SIZE] = "";
    text[0] = '\0';
    append_keys(help, name, keys);
    if (other && keys[0] != '\0') {
        size_t used = strlen(keys);
        snprintf(keys + used, sizeof keys - used, "%s", gap);
        append_keys(help, other, keys);
    }
    if (sentence) {
        snprintf(text, TOOLTIP_SIZE, "%s%s%s", gettext(sentence), keys[0] != '\0' ? " — " : "",
                 keys);
    }
    return text;
}

const char *tooltip_write(const Help *help, const char *name, char text[TOOLTIP_SIZE]) {
    return tooltip_write_pair(help, name, NULL, "", text);
}
