/**
 * @file
 * @brief Prints the keywords of the scene language as the tables of doc/scene-reference.md.
 *
 * This is not a test: tests/documentation.sh compares its output with the document. The table of a
 * new keyword is pasted from it.
 */
#include "dioptre/scene.h"

#include <stdio.h>

/** @return The type of a field's values, for readers. */
static const char *type_name(const Parameter *row) {
    static const char *const names[] = {[PARAMETER_NUMBER] = "number",
                                        [PARAMETER_INTEGER] = "whole number",
                                        [PARAMETER_BOOLEAN] = "`true` or `false`",
                                        [PARAMETER_CHOICE] = "word",
                                        [PARAMETER_POINT] = "`{x, y, z}`",
                                        [PARAMETER_VECTOR] = "`{x, y, z}`",
                                        [PARAMETER_DIRECTION] = "`{x, y, z}`, not zero",
                                        [PARAMETER_SCALE] = "number, or `{x, y, z}`; not zero",
                                        [PARAMETER_UV] = "`{u, v}`",
                                        [PARAMETER_COLOR] = "colour",
                                        [PARAMETER_MESH] = "name of a model file",
                                        [PARAMETER_SDF] = "distance field or function",
                                        [PARAMETER_TEXTURE] = "name of a picture file"};
    return names[row->type];
}

/** Prints the range of a field. */
static void print_range(const Parameter *row) {
    if (row->type == PARAMETER_CHOICE) {
        for (int i = 0; row->choices[i]; i++) {
            printf("%s`\"%s\"`", i ? ", " : "", row->choices[i]);
        }
    } else if (row->type != PARAMETER_BOOLEAN && row->type != PARAMETER_MESH &&
               row->type != PARAMETER_TEXTURE && row->type != PARAMETER_SDF) {
        printf("%s%.15g to %.15g", row->excludes_minimum ? "above " : "", row->minimum,
               row->maximum);
    }
}

/** Prints the default of a field. @param values The struct that contains it. */
static void print_value(const Parameter *row, const void *values) {
    const void *field = (const char *)values + row->offset;
    const double *part = field;
    switch (row->type) {
    case PARAMETER_NUMBER:
        printf("%.15g", *part);
        break;
    case PARAMETER_INTEGER:
        if (*(const int *)field < row->minimum) {
            printf("as the scene needs");
        } else {
            printf("%d", *(const int *)field);
        }
        break;
    case PARAMETER_BOOLEAN:
        printf("`%s`", *(const bool *)field ? "true" : "false");
        break;
    case PARAMETER_CHOICE:
        printf("`\"%s\"`", row->choices[*(const int *)field]);
        break;
    case PARAMETER_MESH:
    case PARAMETER_SDF:
        printf("none: it must be given");
        break;
    case PARAMETER_TEXTURE:
        printf("none");
        break;
    case PARAMETER_UV:
        printf("`{%.15g, %.15g}`", part[0], part[1]);
        break;
    default:
        printf("`{%.15g, %.15g, %.15g}`", part[0], part[1], part[2]);
    }
}

/** Prints the table of a keyword. */
static void print_keyword(const Keyword *keyword) {
    printf("<!-- table: %s -->\n`%s`: %s.\n\n", keyword->name, keyword->name, keyword->help);
    printf("| field | takes | unit | range | default | meaning |\n|---|---|---|---|---|---|\n");
    for (const Parameter *row = keyword->parameters; row->name; row++) {
        printf("| `%s` | %s | %s | ", row->name, type_name(row), row->unit);
        print_range(row);
        printf(" | ");
        print_value(row, keyword->defaults);
        printf(" | %s |\n", row->help);
    }
    printf("<!-- end -->\n");
}

/** Prints all keywords. @return 0 */
int main(void) {
    const Keyword *const common[] = {&scene_sky_keyword, &scene_material_keyword,
                                     &transform_keyword, NULL};
    print_keyword(&scene_camera_keyword);
    print_keyword(&scene_image_keyword);
    for (const SceneLightClass *const *light = scene_light_classes; *light; light++) {
        print_keyword((*light)->keyword);
    }
    for (const Keyword *const *keyword = common; *keyword; keyword++) {
        print_keyword(*keyword);
    }
    for (const Keyword *const *keyword = scene_shape_keywords; *keyword; keyword++) {
        print_keyword(*keyword);
    }
    for (const SdfPrimitive *const *kind = sdf_primitives; *kind; kind++) {
        print_keyword(&(*kind)->keyword);
    }
    return 0;
}
