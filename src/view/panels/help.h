/**
 * @file
 * @brief The help over the picture: the drawn keyboard, and the list of keys.
 */
#ifndef DIOPTRE_VIEW_PANELS_HELP_H
#define DIOPTRE_VIEW_PANELS_HELP_H

#include "view/panels/panel.h"
#include "view/state/command.h"

/** Most rows of the list of keys. */
enum { HELP_ROWS_MAXIMUM = 64 };

/** The help. Starts as `{.commands = ...}`: closed. */
typedef struct Help {
    const Command *commands; /**< All commands. */
    bool by_letter;          /**< See #command_find_key. */
    bool is_open;            /**< Whether it is shown. */
    Overlay overlay;         /**< Its panel. */
} Help;

/** Opens or closes the help. @return false if it cannot be opened, as there is no font: it is
 *  printed on standard output instead. */
bool help_toggle(Help *help);

/** Appends the names of a command's keys, as on the keyboard in use. @param by_letter See
 *  #command_find_key. */
void help_key_names(const Command *command, bool by_letter, char *text, size_t size);

/** Shows the help over the picture, if it is open. */
void help_show(Help *help, const OverlayTarget *target);

/** Writes the list of keys, named as on the keyboard in use. @return Number of rows. */
size_t help_write_rows(const Help *help, PanelRow rows[HELP_ROWS_MAXIMUM]);

/** @return The help as a panel, owned by the caller; NULL without font or memory. */
SDL_Surface *help_draw(const Help *help, const PanelBounds *bounds);

/** @return The tint of a command's group, from 1. */
int help_tint(const Help *help, const Command *command);

/* --- the drawn keyboard ----------------------------------------------------------------------- */

/** @return Size of the drawn keyboard in a space: as wide as the space, unless that is too low.
 *  Height 0: its keys would be too small to be read. */
SDL_Point keyboard_diagram_size(int width, int height);

/** Draws the keyboard in use. @param area Of the size that #keyboard_diagram_size returns. */
void keyboard_diagram_draw(SDL_Surface *panel, const SDL_Rect *area, const Help *help);

/** @return What a key does, in a word, translated. @param row Its row; NULL: it does nothing. */
const char *key_action_label(const Command *row);

/** @return What is printed on a key of the keyboard in use, or a sign for it; may be empty. */
const char *key_cap_label(SDL_Scancode scancode);

#endif
