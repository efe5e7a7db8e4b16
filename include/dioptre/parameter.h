/**
 * @file
 * @brief Parameter tables: the keywords of the scene language and their fields.
 *
 * Cameras, lights, materials and shapes are plain structs. A table describes each field: its name
 * in scene files, its type, unit and range, and its offset in the struct. The scene language reads
 * every keyword by these tables alone.
 */
#ifndef DIOPTRE_PARAMETER_H
#define DIOPTRE_PARAMETER_H

#include "base/error.h"
#include "base/vec3d.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Type of a field, and its C type in the struct. */
typedef enum {
    PARAMETER_NUMBER,    /**< `double` */
    PARAMETER_INTEGER,   /**< `int` */
    PARAMETER_BOOLEAN,   /**< `bool` */
    PARAMETER_CHOICE,    /**< `int`: index of the word in #Parameter.choices */
    PARAMETER_POINT,     /**< `Vec3d`, a position: #keyword_translate moves it */
    PARAMETER_VECTOR,    /**< `Vec3d`, any */
    PARAMETER_DIRECTION, /**< `Vec3d`, not zero */
    PARAMETER_SCALE,     /**< `Vec3d`: `{x, y, z}`, or one number for all three */
    PARAMETER_UV,        /**< `Uvd`, any */
    PARAMETER_COLOR,     /**< `Rgbd`: `{r, g, b}`, one number for grey, or `"#rrggbb"` in sRGB */
    PARAMETER_MESH,      /**< `size_t`: index of the named mesh file in #Scene.meshes. It has no
                              default: #Keyword.finish checks that it is given */
    PARAMETER_SDF,       /**< `const Sdf *`: a distance field, owned by the scene; NULL: none */
    PARAMETER_TEXTURE    /**< `size_t`: index of the named picture file in #Scene.textures, plus
                              one; 0: none */
} ParameterType;

/** A field of a keyword: a row of a parameter table. A row without a name ends the table. */
typedef struct Parameter {
    const char *name;           /**< Name in scene files, such as `radius`; NULL ends the table. */
    ParameterType type;         /**< Type. */
    size_t offset;              /**< Offset of the value in the struct. */
    double minimum;             /**< Smallest number, for each component. */
    double maximum;             /**< Largest number, for each component. */
    bool excludes_minimum;      /**< Whether the number must be above the minimum. */
    const char *const *choices; /**< For #PARAMETER_CHOICE: the words; NULL ends them. */
    const char *unit;           /**< Unit for the documentation: `scene units`, `degrees`, ... */
    const char *help;           /**< Description for the documentation, in a few words. */
} Parameter;

/** A keyword of the scene language: its name, and the struct that it fills. */
typedef struct Keyword {
    const char *name;            /**< Name in scene files, such as `sphere`. */
    const char *help;            /**< Description for the documentation, in a few words. */
    const Parameter *parameters; /**< Its fields; a row without a name ends them. */
    size_t size;                 /**< Bytes of the struct. */
    const void *defaults;        /**< The struct if no field is given. */
    /**
     * Checks the combination of fields, beyond the range of each, and computes derived values.
     * NULL: any combination is valid.
     * @param[in,out] values  The struct, with all fields.
     * @param given           Bit i: the scene gives row i of the table.
     * @param[out] error      What is wrong, without file and line.
     * @return Whether the combination is valid.
     */
    bool (*finish)(void *values, uint64_t given, Error *error);
} Keyword;

/**
 * Largest length or coordinate of a scene, in scene units. Products of two lengths must stay far
 * below the largest float (3.4e38).
 */
#define LENGTH_MAXIMUM 1e15

/** Smallest radius or edge, in scene units, for the same reason. */
#define LENGTH_MINIMUM 1e-15

/** Largest intensity of a light or an emission. */
#define INTENSITY_MAXIMUM 1e15

/**
 * Checks a number against the range of a row.
 * @param parameter  The row.
 * @param value      The number, or one component of a vector or a colour.
 * @param[out] error What is wrong, with the name of the field and the range.
 * @return Whether it is finite and in range.
 */
bool parameter_check_range(const Parameter *parameter, double value, Error *error);

/** @return Whether a keyword is of a distance field, its first parameter. @param keyword It. */
bool keyword_has_field(const Keyword *keyword);

/** Most numbers of a value, see #parameter_number_count. */
enum { PARAMETER_NUMBERS_MAXIMUM = 3 };

/** @return How many numbers make a value of a type: 3 for a point; 1 for a choice, its index, and
 *  for a boolean, 0 or 1; 0 for files and fields. */
int parameter_number_count(ParameterType type);

/** Reads the value of a row as numbers. @param values The struct. @param[out] numbers
 *  #parameter_number_count of them. */
void parameter_get_numbers(const Parameter *row, const void *values, double *numbers);

/** Writes the value of a row. @param values The struct. @param numbers Checked by
 *  #parameter_check_numbers. */
void parameter_set_numbers(const Parameter *row, void *values, const double *numbers);

/** Checks the numbers of a value. @param[out] error What is wrong. @return Whether a scene file may
 *  give this value; false for a row without numbers. */
bool parameter_check_numbers(const Parameter *row, const double *numbers, Error *error);

/**
 * Translates the struct of a keyword: all its #PARAMETER_POINT fields.
 * @param keyword         The keyword.
 * @param[in,out] values  Its struct.
 * @param offset          Translation, scene units.
 */
void keyword_translate(const Keyword *keyword, void *values, Vec3d offset);

/* --- Transforms: the fields that every shape takes -------------------------------------------- */

/**
 * Smallest absolute scale; its inverse is the largest: lengths times such a factor stay in the
 * range of float.
 */
#define SCALE_MINIMUM 1e-6

/** A transform. Filled through #transform_keyword. */
typedef struct Transform {
    Vec3d scale;  /**< Scale, applied first; negative: reflected in a plane through the origin. */
    Vec3d rotate; /**< Rotation about x, then y, then z, degrees. */
    Vec3d translate;     /**< Translation, applied last, scene units. */
    double matrix[3][3]; /**< Scale and rotation, row by row; set by #Keyword.finish. */
} Transform;

/** @return A transformed point. @param t The transform. @param p The point. */
static inline Vec3d transform_point(const Transform *t, Vec3d p) {
    const double v[3] = {p.x, p.y, p.z};
    double out[3] = {t->translate.x, t->translate.y, t->translate.z};
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) {
            out[row] += t->matrix[row][column] * v[column];
        }
    }
    return (Vec3d){out[0], out[1], out[2]};
}

/** The fields of all shapes besides their own. */
extern const Keyword transform_keyword;

#endif
