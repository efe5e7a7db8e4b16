/**
 * @file
 * @brief What a button says while the mouse is on it: one sentence, and the keys that do the same.
 */
#ifndef DIOPTRE_VIEW_PANELS_TOOLTIP_H
#define DIOPTRE_VIEW_PANELS_TOOLTIP_H

#include "view/panels/help.h"

/** Bytes of a tooltip with the final zero. */
enum { TOOLTIP_SIZE = 384 };

/** @return What a command does, as a sentence in English; NULL: it has none, as no button issues
 *  it. @param name Its name. */
const char *tooltip_sentence(const char *name);

/** Writes the sentence of a command, and its keys as on the keyboard in use. @return The text. */
const char *tooltip_write(const Help *help, const char *name, char text[TOOLTIP_SIZE]);

/** The same with the keys of another command, too: that of the opposite, or the last of a row.
 *  @param gap What stands between the keys of both. */
const char *tooltip_write_pair(const Help *help, const char *name, const char *other,
                               const char *gap, char text[TOOLTIP_SIZE]);

#endif
