/**
 * @file
 * @brief The help over the picture: the keys of the keyboard in use.
 */
#ifndef DIOPTRE_VIEW_PANELS_HELP_H
#define DIOPTRE_VIEW_PANELS_HELP_H

#include "view/panels/overlay.h"

/** The help. Starts as `{.by_letter = ...}`: closed. */
typedef struct Help {
    bool by_letter;  /**< Whether the light's keys go by their letters. */
    bool is_open;    /**< Whether it is to be seen. */
    Overlay overlay; /**< It as a picture. */
} Help;

/** Opens or closes the help. @return false if it was to be opened and there is no font: it is on
 *  standard output instead. */
bool help_toggle(Help *help);

/** Lays the help over what the window shows, if it is open. @param[in,out] help The help, which
 *  keeps its picture. */
void help_show(Help *help, const OverlayTarget *target);

#endif
