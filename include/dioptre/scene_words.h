/**
 * @file
 * @brief Words of the scene language as a reader says them.
 *
 * A scene file says `ior` and `quad` in every language. Where a reader is shown what such a word
 * stands for, it is `refractive index` or `indice`, `quadrilateral` or `quadrilatère`.
 */
#ifndef DIOPTRE_SCENE_WORDS_H
#define DIOPTRE_SCENE_WORDS_H

/**
 * @param word  A keyword, the name of a field, or one of its words to choose from.
 * @return Its name in the user's language; the word itself where there is no other, so that a new
 *         shape needs none.
 */
const char *scene_word(const char *word);

#endif
