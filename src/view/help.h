/**
 * @file
 * @brief The help over the picture: the keys of the keyboard in use.
 */
#ifndef DIOPTRE_VIEW_HELP_H
#define DIOPTRE_VIEW_HELP_H

#include <SDL.h>
#include <stdbool.h>

/** The help. Starts as `{.by_letter = ...}`: closed. */
typedef struct Help {
    bool by_letter;       /**< Whether the light's keys go by their letters. */
    bool is_open;         /**< Whether it is to be seen. */
    SDL_Texture *texture; /**< It as a picture, or NULL: to be made when needed; owned. */
} Help;

/**
 * Opens or closes the help.
 * @param[in,out] help  The help.
 * @return false if it was to be opened and there is no font: it is on standard output instead.
 */
bool help_toggle(Help *help);

/**
 * @return The help as a picture to be laid over the middle of a window; NULL while it is closed.
 * @param[in,out] help  The help, which keeps the picture.
 * @param renderer      What draws in the window.
 */
SDL_Texture *help_texture(Help *help, SDL_Renderer *renderer);

/**
 * Forgets the picture: size or keyboard have changed, or the graphics card lost it. To be called
 * before the window closes, too.
 * @param[in,out] help  The help.
 */
void help_forget(Help *help);

#endif
