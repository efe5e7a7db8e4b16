/**
 * @file
 * @brief Printing camera and lights by the parameter tables that the parser uses.
 */
#include "view/state/scene_text.h"

#include "base/exact_digits.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/** Prints a number with the fewest digits that give it back exactly. */
static void print_number(double value, FILE *file) {
    fprintf(file, "%.*g", exact_digits(value, DBL_DIG), value);
}

/** Prints a list of numbers. @param count At least 1. */
static void print_list(const double *values, int count, FILE *file) {
    for (int i = 0; i < count; i++) {
        fputs(i ? ", " : "{", file);
        print_number(values[i], file);
    }
    fputc('}', file);
}

/** Prints the value of a field. See #scene_text_of_value. */
static void print_value(const Parameter *row, const double *numbers, FILE *file) {
    switch (row->type) {
    case PARAMETER_BOOLEAN:
        fputs(numbers[0] != 0 ? "true" : "false", file);
        break;
    case PARAMETER_CHOICE:
        fprintf(file, "\"%s\"", row->choices[(int)numbers[0]]);
        break;
    case PARAMETER_NUMBER:
    case PARAMETER_INTEGER:
        print_number(numbers[0], file);
        break;
    default:
        print_list(numbers, parameter_number_count(row->type), file);
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
        // Neither camera nor lights have files or fields.
        if (!is_skipped(row->name, skipped) && parameter_number_count(row->type) > 0) {
            double numbers[PARAMETER_NUMBERS_MAXIMUM];
            fprintf(file, "%s%s = ", separator, row->name);
            parameter_get_numbers(row, values, numbers);
            print_value(row, numbers, file);
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

/* --- texts in memory -------------------------------------------------------------------------- */

/** A text that is being written. */
typedef struct MemoryText {
    char *bytes; /**< It, once the file is closed. */
    size_t size; /**< Its length. */
    FILE *file;  /**< Where it is written to; NULL without memory. */
} MemoryText;

/** Begins a text. */
static void memory_text_begin(MemoryText *text) {
    text->bytes = NULL;
    text->file = open_memstream(&text->bytes, &text->size);
}

/** Ends a text. @param is_complete Whether all of it is written. @return It, owned by the caller;
 *  NULL if it is not complete, or without memory. */
static char *memory_text_end(MemoryText *text, bool is_complete) {
    bool is_whole = text->file && fclose(text->file) == 0 && is_complete;
    if (!is_whole) {
        free(text->bytes);
        text->bytes = NULL;
    }
    return text->bytes;
}

char *scene_text_create(const Scene *scene) {
    MemoryText text;
    memory_text_begin(&text);
    if (text.file) {
        scene_text_print(scene, text.file);
    }
    return memory_text_end(&text, true);
}

char *scene_text_of_value(const Parameter *row, const double *numbers) {
    MemoryText text;
    memory_text_begin(&text);
    if (text.file) {
        print_value(row, numbers, text.file);
    }
    return memory_text_end(&text, true);
}

/* --- objects ---------------------------------------------------------------------------------- */

/** An object that is printed. */
typedef struct ObjectText {
    const Scene *scene;    /**< Its scene. */
    FILE *file;            /**< Where to. */
    const char *separator; /**< Text before the next field. */
    bool is_complete;      /**< Whether all fields could be printed. */
} ObjectText;

/** Prints the name of a field. */
static void print_name(ObjectText *text, const char *name) {
    fprintf(text->file, "%s%s = ", text->separator, name);
    text->separator = ", ";
}

/** Prints a file's name in quotes. */
static void print_file(ObjectText *text, const char *field, const char *name) {
    print_name(text, field);
    fputc('"', text->file);
    for (; *name; name++) {
        if (strchr("\"\\", *name)) {
            fputc('\\', text->file);
        }
        fputc(*name, text->file);
    }
    fputc('"', text->file);
}

/** Prints a field that is no number. */
static void print_reference(ObjectText *text, const Parameter *row, const void *values) {
    size_t index;
    if (row->type == PARAMETER_SDF) {
        text->is_complete = false;
        return;
    }
    memcpy(&index, (const char *)values + row->offset, sizeof index);
    if (row->type == PARAMETER_MESH) {
        print_file(text, row->name, text->scene->meshes[index].file.name);
    } else if (index > 0) {
        print_file(text, row->name, text->scene->textures[index - 1].file.name);
    }
}

/** Prints the fields of a keyword that differ from its defaults. */
static void print_fields(ObjectText *text, const Keyword *keyword, const void *values) {
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        double numbers[PARAMETER_NUMBERS_MAXIMUM] = {0}, defaults[PARAMETER_NUMBERS_MAXIMUM] = {0};
        if (parameter_number_count(row->type) == 0) {
            print_reference(text, row, values);
            continue;
        }
        parameter_get_numbers(row, values, numbers);
        parameter_get_numbers(row, keyword->defaults, defaults);
        if (memcmp(numbers, defaults, sizeof numbers) != 0) {
            print_name(text, row->name);
            print_value(row, numbers, text->file);
        }
    }
}

/** Prints the call that makes an object. */
static void print_object(ObjectText *text, const SceneObject *object) {
    const Keyword *keyword = scene_object_keyword(object->keyword);
    fputs(keyword->name, text->file);
    text->separator = " { ";
    print_fields(text, keyword, object->values);
    if (scene_object_is_shape(object->keyword)) {
        size_t material = text->scene->shapes[object->index].material_index;
        if (object->transform) {
            print_fields(text, &transform_keyword, object->transform);
        }
        if (material > 0) {
            SceneObject own = scene_object_of_material(text->scene, material);
            print_name(text, scene_material_keyword.name);
            print_object(text, &own);
            text->separator = ", ";
        }
    }
    fputs(strcmp(text->separator, " { ") == 0 ? " {}" : " }", text->file);
}

char *scene_text_of_object(const Scene *scene, const SceneObject *object) {
    MemoryText memory;
    memory_text_begin(&memory);
    ObjectText text = {.scene = scene, .file = memory.file, .is_complete = true};
    if (memory.file) {
        print_object(&text, object);
    }
    return memory_text_end(&memory, text.is_complete);
}
