/**
 * @file
 * @brief The help over the picture.
 */
#include "view/panels/help.h"

#include "view/input/keymap.h"
#include "view/panels/help_panel.h"
#include "view/window/font.h"

#include <stdio.h>
#include <string.h>

/** Letters that the column of keys is wide on standard output: the longest row and a little. */
static const int KEY_COLUMN_WIDTH = 22;

/** Prints the help. @param by_letter Whether the light's keys go by their letters. */
static void print_help(bool by_letter) {
    PanelRow rows[HELP_ROWS_MAXIMUM];
    size_t count = keymap_help_rows(by_letter, rows);
    for (size_t i = 0; i < count; i++) {
        if (rows[i].is_heading) {
            printf("%s\n", rows[i].text);
        } else {
            /* printf counts bytes; an arrow has three. */
            size_t extra = strlen(rows[i].label) - SDL_utf8strlen(rows[i].label);
            printf("  %-*s %s\n", KEY_COLUMN_WIDTH + (int)extra, rows[i].label, rows[i].text);
        }
    }
    fflush(stdout);
}

bool help_toggle(Help *help) {
    bool is_wanted = !help->is_open;
    help->is_open = is_wanted && font_is_available();
    if (is_wanted && !help->is_open) {
        print_help(help->by_letter);
    }
    return help->is_open == is_wanted;
}

void help_show(Help *help, const OverlayTarget *target) {
    if (!help->is_open) {
        return;
    }
    if (overlay_is_stale(&help->overlay)) {
        PanelBounds bounds = overlay_bounds(target);
        overlay_set_surface(&help->overlay, target, help_panel_draw(help->by_letter, &bounds));
    }
    overlay_show(&help->overlay, target);
}
