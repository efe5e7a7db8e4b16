/**
 * @file
 * @brief The help as a picture: the keyboard, and below it what the keys do.
 */
#ifndef DIOPTRE_VIEW_PANELS_HELP_PANEL_H
#define DIOPTRE_VIEW_PANELS_HELP_PANEL_H

#include "view/panels/panel.h"

/**
 * @return The help, to be freed by the caller; NULL without font or memory.
 * @param by_letter  Whether the light's keys go by their letters.
 */
SDL_Surface *help_panel_draw(bool by_letter, const PanelBounds *bounds);

#endif
