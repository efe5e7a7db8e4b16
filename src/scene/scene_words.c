/**
 * @file
 * @brief The table of words of the scene language and their names.
 *
 * Shapes, lights and materials share most of their words, so there is one table for all of them: a
 * word has one name, whatever it is a field of.
 */
#include "dioptre/scene_words.h"

#include "base/language.h"

#include <libintl.h>
#include <stddef.h>
#include <string.h>

/** A word and its name. */
typedef struct SceneWord {
    const char *word; /**< In scene files. */
    const char *name; /**< For a reader, in English. */
} SceneWord;

/** Shapes, lights, materials; then their fields; then the words of choices. Words that a reader
 *  says in both languages, such as `point`, are not here. */
static const SceneWord words[] = {
    {"sphere", N_("sphere")},
    {"plane", N_("plane")},
    {"quad", N_("quadrilateral")},
    {"box", N_("box")},
    {"disk", N_("disk")},
    {"cylinder", N_("cylinder")},
    {"cone", N_("cone")},
    {"mesh", N_("mesh")},
    {"sdf", N_("distance field")},
    {"light", N_("lamp")},
    {"sun", N_("sun")},
    {"rectangle_light", N_("rectangular lamp")},
    {"cylinder_light", N_("tubular lamp")},
    {"material", N_("material")},

    {"center", N_("centre")},
    {"radius", N_("radius")},
    {"top", N_("top")},
    {"top_radius", N_("radius at the top")},
    {"capped", N_("closed")},
    {"corner", N_("corner")},
    {"u", N_("edge u")},
    {"v", N_("edge v")},
    {"min", N_("lower corner")},
    {"max", N_("upper corner")},
    {"a", N_("corner a")},
    {"b", N_("corner b")},
    {"c", N_("corner c")},
    {"na", N_("normal at a")},
    {"nb", N_("normal at b")},
    {"nc", N_("normal at c")},
    {"ta", N_("(u, v) at a")},
    {"tb", N_("(u, v) at b")},
    {"tc", N_("(u, v) at c")},
    {"normal", N_("normal")},
    {"normals", N_("normals")},
    {"tolerance", N_("tolerance")},
    {"max_steps", N_("most steps")},
    {"falloff", N_("falloff")},
    {"falloff_constant", N_("falloff's c")},
    {"intensity", N_("intensity")},
    {"two_sided", N_("both sides")},
    {"color", N_("colour")},
    {"ambient", N_("ambient")},
    {"diffuse", N_("diffuse")},
    {"specular", N_("highlight")},
    {"shininess", N_("shininess")},
    {"reflectivity", N_("reflectivity")},
    {"transparency", N_("transparency")},
    {"ior", N_("refractive index")},
    {"emission", N_("own light")},
    {"scale", N_("scale")},
    {"rotate", N_("rotation")},
    {"translate", N_("translation")},

    {"none", N_("none at all")},
    {"inverse_square", N_("1 / d²")},
    {"inverse_linear", N_("1 / (c + d)")},
    {"file", N_("of the file")},
    {"smooth", N_("smooth")},
    {"flat", N_("flat")},
};

const char *scene_word(const char *word) {
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        if (strcmp(words[i].word, word) == 0) {
            return gettext(words[i].name);
        }
    }
    return word;
}
