/**
 * @file
 * @brief Printing camera and lights by the parameter tables that the parser uses.
 */
#include "view/state/scene_text.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/** Prints a number with the fewest digits that give it back exactly. */
static void print_number(double value, FILE *file) {
    char text[32];
    int digits = DBL_DIG;
    do {
        snprintf(text, sizeof text, "%.*g", digits, value);
    } while (strtod(text, NULL) != value && ++digits <= DBL_DECIMAL_DIG);
    fputs(text, file);
}

/** Prints a list of numbers. @param count At least 1. */
static void print_list(const double *values, int count, FILE *file) {
    for (int i = 0; i < count; i++) {
        fputs(i ? ", " : "{", file);
        print_number(values[i], file);
    }
    fputc('}', file);
}

/** Prints the value of a field. */
static void print_value(const Parameter *row, const void *value, FILE *file) {
    switch (row->type) {
    case PARAMETER_NUMBER:
        print_number(*(const double *)value, file);
        break;
    case PARAMETER_INTEGER:
        fprintf(file, "%d", *(const int *)value);
        break;
    case PARAMETER_BOOLEAN:
        fputs(*(const bool *)value ? "true" : "false", file);
        break;
    case PARAMETER_CHOICE:
        fprintf(file, "\"%s\"", row->choices[*(const int *)value]);
        break;
    case PARAMETER_POINT:
    case PARAMETER_VECTOR:
    case PARAMETER_DIRECTION:
    case PARAMETER_SCALE:
    case PARAMETER_COLOR:
        print_list(value, 3, file);
        break;
    case PARAMETER_UV:
        print_list(value, 2, file);
        break;
    case PARAMETER_MESH: // Neither camera nor lights have such fields.
    case PARAMETER_SDF:
    case PARAMETER_TEXTURE:
        break;
    }
}

/** @return Whether a field is left out. @param skipped Names of such fields, ended by NULL. */
static bool is_skipped(const char *name, const char *const *skipped) {
    while (*skipped && strcmp(name, *skipped) != 0) {
        skipped++;
    }
    return *skipped != NULL;
}

/** Prints a keyword with its fields. @param skipped Names of fields that are left out, ended by
 * NULL. */
static void print_keyword(const Keyword *keyword, const void *values, const char *const *skipped,
                          FILE *file) {
    const char *separator = " { ";
    fputs(keyword->name, file);
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        if (!is_skipped(row->name, skipped)) {
            fprintf(file, "%s%s = ", separator, row->name);
            print_value(row, (const char *)values + row->offset, file);
            separator = ", ";
        }
    }
    fputs(" }", file);
}

void scene_text_print(const Scene *scene, FILE *file) {
    // Direction and up define the camera; the other fields would contradict them.
    static const char *const redundant[] = {"look_at", "pan", "tilt", NULL};
    static const char *const none[] = {NULL};
    print_keyword(&scene_camera_keyword, &scene->camera, redundant, file);
    for (size_t i = 0; i < scene->light_count; i++) {
        fputs("  ", file);
        const SceneLight *light = &scene->lights[i];
        print_keyword(scene_light_keyword_for(light), light, none, file);
    }
}

char *scene_text_create(const Scene *scene) {
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (stream) {
        scene_text_print(scene, stream);
        fclose(stream);
    }
    return text;
}
