/**
 * @file
 * @brief Parameter tables: what a thing of the scene language is called and which fields it takes.
 *
 * A camera, a light, a material, each shape: all are plain structs, and a table says for each of
 * their fields its name in scene files, its type, unit and range, and where it lies in the struct.
 * The scene language reads every keyword by these tables alone, so it knows no keyword by heart.
 */
#ifndef DIOPTRE_PARAMETER_H
#define DIOPTRE_PARAMETER_H

#include "dioptre/error.h"
#include "dioptre/vec3d.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Type of a field, and with it the C type behind its offset. */
typedef enum {
    PARAMETER_NUMBER,    /**< `double` */
    PARAMETER_INTEGER,   /**< `int` */
    PARAMETER_BOOLEAN,   /**< `bool` */
    PARAMETER_CHOICE,    /**< `int`: the place of the word in #Parameter.choices */
    PARAMETER_POINT,     /**< `Vec3d`, a place: it moves with what it belongs to */
    PARAMETER_VECTOR,    /**< `Vec3d`, any */
    PARAMETER_DIRECTION, /**< `Vec3d`, not zero */
    PARAMETER_SCALE,     /**< `Vec3d`: `{x, y, z}`, or one number for all three */
    PARAMETER_UV,        /**< `Uvd`, any */
    PARAMETER_COLOR,     /**< `Rgbd`: `{r, g, b}`, one number for grey, or `"#rrggbb"` in sRGB */
    PARAMETER_MESH,      /**< `size_t`: the place in #Scene.meshes of the model file that is named.
                              It has no default: #Keyword.finish sees whether it was given */
    PARAMETER_SDF,       /**< `const Field *`: a distance field, kept by the scene; NULL: none */
    PARAMETER_TEXTURE    /**< `size_t`: the place in #Scene.textures of the picture file that is
                              named, plus one; 0: none is */
} ParameterType;

/** One field of a keyword: a row of a parameter table. A table ends with a row without a name. */
typedef struct Parameter {
    const char *name;           /**< As in a scene file, such as `radius`; NULL ends the table. */
    ParameterType type;         /**< What may be given. */
    size_t offset;              /**< Where the value lies in the struct. */
    double minimum;             /**< Smallest number allowed, for each component. */
    double maximum;             /**< Largest number allowed, for each component. */
    bool excludes_minimum;      /**< Whether the minimum itself is forbidden. */
    const char *const *choices; /**< For #PARAMETER_CHOICE: the words, ended by NULL. */
    const char *unit;           /**< For people: `scene units`, `degrees`, ... */
    const char *help;           /**< For people: what it is, in a few words. */
} Parameter;

/** A keyword of the scene language that fills a struct: its name, fields, defaults and checks. */
typedef struct Keyword {
    const char *name;            /**< As in a scene file, such as `sphere`. */
    const char *help;            /**< For people: what it makes, in a few words. */
    const Parameter *parameters; /**< Its fields, ended by a row without a name. */
    size_t size;                 /**< Bytes of the struct that the table describes. */
    const void *defaults;        /**< Such a struct, as it is when no field is given. */
    /**
     * Says whether the fields fit together, beyond the range of each one, and works out what
     * follows from them. NULL: any combination is good.
     * @param[in,out] values  The struct, filled.
     * @param given           Bit i is set where row i of the table was given.
     * @param[out] error      What is wrong, without file and line.
     * @return false if they do not fit.
     */
    bool (*finish)(void *values, uint64_t given, Error *error);
} Keyword;

/**
 * Largest length or coordinate that a scene may hold, in scene units. Squares of it, and products
 * of two, must stay far from the end of float (3.4e38) in every engine.
 */
#define LENGTH_MAXIMUM 1e15

/** Smallest length that a radius or an edge may have, in scene units; the same reason. */
#define LENGTH_MINIMUM 1e-15

/** Brightest light or emission that may be asked for. */
#define INTENSITY_MAXIMUM 1e15

/**
 * Checks a number against the range of a row.
 * @param parameter  The row.
 * @param value      The number, or one component of a vector or a colour.
 * @param[out] error What is wrong, with the name of the field and the range.
 * @return Whether it is finite and in range.
 */
bool parameter_check_range(const Parameter *parameter, double value, Error *error);

/**
 * Moves what a keyword has filled: all places in it, and nothing else.
 * @param keyword         The keyword.
 * @param[in,out] values  Its struct.
 * @param offset             How far, scene units.
 */
void keyword_translate(const Keyword *keyword, void *values, Vec3d offset);

/**
 * @return The number of rows of a table.
 * @param table  A table, ended by a row without a name.
 */
size_t parameter_count(const Parameter *table);

#endif
