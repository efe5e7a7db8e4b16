/**
 * @file
 * @brief A view as text of the scene language, by the same tables that it is read with.
 */
#include "view/state/scene_text.h"

#include <string.h>

/** Prints a field's numbers. @param count How many, at least 1. */
static void print_list(const double *values, int count, FILE *file) {
    for (int i = 0; i < count; i++) {
        fprintf(file, "%s%.17g", i ? ", " : "{", values[i]);
    }
    fputc('}', file);
}

/** Prints a field's value. @param row Its row of the table. */
static void print_value(const Parameter *row, const void *value, FILE *file) {
    switch (row->type) {
    case PARAMETER_NUMBER:
        fprintf(file, "%.17g", *(const double *)value);
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
    case PARAMETER_MESH: // Neither a camera nor a light names a file or has a field.
    case PARAMETER_SDF:
    case PARAMETER_TEXTURE:
        break;
    }
}

/**
 * Says whether a field is left out of the text.
 * @param skipped  Names that are left out, ended by NULL.
 * @return Whether it is one of them.
 */
static bool is_skipped(const char *name, const char *const *skipped) {
    while (*skipped && strcmp(name, *skipped) != 0) {
        skipped++;
    }
    return *skipped != NULL;
}

/** Prints a keyword with its fields. @param skipped Names of fields that are left out, ended by
 *  NULL. */
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
    /* The camera's direction and up say it all; the other ways to say it would contradict them. */
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
