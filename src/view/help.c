/**
 * @file
 * @brief The help over the picture.
 */
#include "view/help.h"

#include "view/help_panel.h"
#include "view/keymap.h"

#include <stdio.h>
#include <string.h>

/** Letters that the column of keys is wide on standard output: the longest row and a little. */
static const int KEYS_WIDTH = 22;

/** Prints the help. @param by_letter Whether the light's keys go by their letters. */
static void print_help(bool by_letter) {
    HelpRow rows[HELP_ROWS_MAXIMUM];
    size_t count = keymap_help(by_letter, rows);
    for (size_t i = 0; i < count; i++) {
        if (rows[i].is_heading) {
            printf("%s\n", rows[i].text);
        } else {
            /* printf counts bytes; an arrow has three. */
            size_t extra = strlen(rows[i].keys) - SDL_utf8strlen(rows[i].keys);
            printf("  %-*s %s\n", KEYS_WIDTH + (int)extra, rows[i].keys, rows[i].text);
        }
    }
    fflush(stdout);
}

bool help_toggle(Help *help) {
    bool is_wanted = !help->is_open;
    help->is_open = is_wanted && help_panel_is_possible();
    if (is_wanted && !help->is_open) {
        print_help(help->by_letter);
    }
    return help->is_open == is_wanted;
}

SDL_Texture *help_texture(Help *help, SDL_Renderer *renderer) {
    if (help->is_open && !help->texture) {
        int width = 0, height = 0;
        SDL_GetRendererOutputSize(renderer, &width, &height);
        SDL_Surface *panel = help_panel_draw(help->by_letter, width, height);
        if (panel) {
            help->texture = SDL_CreateTextureFromSurface(renderer, panel);
            SDL_FreeSurface(panel);
        }
    }
    return help->is_open ? help->texture : NULL;
}

void help_forget(Help *help) {
    if (help->texture) {
        SDL_DestroyTexture(help->texture);
        help->texture = NULL;
    }
}
