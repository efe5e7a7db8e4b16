/**
 * @file
 * @brief The drawn keyboard: what is printed on each key, and what it does.
 *
 * Positions and sizes of keys are in quarters of a key. American keyboards (ANSI) and all others
 * (ISO) differ around Enter and the left Shift.
 */
#include "base/language.h"
#include "view/panels/help.h"

#include <libintl.h>
#include <math.h>

/** Width of the keyboard, quarters of a key. */
static const int KEYBOARD_WIDTH = 73;
/** Height of the keyboard, quarters of a key. */
static const int KEYBOARD_HEIGHT = 25;
/** Smallest key that is drawn, in heights of letters. */
static const float SMALLEST_KEY = 1.4F;

/** The layouts that have a key. */
typedef enum {
    LAYOUT_ANY,  /**< Both. */
    LAYOUT_ANSI, /**< The American one. */
    LAYOUT_ISO   /**< The other one. */
} KeyboardLayout;

/** A key of special size or position. */
typedef struct KeyShape {
    SDL_Scancode scancode; /**< Its position. */
    int x;                 /**< Quarters of a key from the left. */
    int y;                 /**< From above. */
    int width;             /**< Quarters. */
    int height;            /**< Quarters. */
    KeyboardLayout layout; /**< The layouts that have it. */
} KeyShape;

/** Keys of equal size, side by side. */
typedef struct KeyRow {
    int x;                      /**< Quarters of a key from the left. */
    int y;                      /**< From above. */
    SDL_Scancode scancodes[13]; /**< Their positions, ended by SDL's "unknown". */
} KeyRow;

/** All keys of equal size. */
static const KeyRow key_rows[] = {
    {8, 0, {SDL_SCANCODE_F1, SDL_SCANCODE_F2, SDL_SCANCODE_F3, SDL_SCANCODE_F4}},
    {26, 0, {SDL_SCANCODE_F5, SDL_SCANCODE_F6, SDL_SCANCODE_F7, SDL_SCANCODE_F8}},
    {44, 0, {SDL_SCANCODE_F9}},
    {0,
     5,
     {SDL_SCANCODE_GRAVE, SDL_SCANCODE_1, SDL_SCANCODE_2, SDL_SCANCODE_3, SDL_SCANCODE_4,
      SDL_SCANCODE_5, SDL_SCANCODE_6, SDL_SCANCODE_7, SDL_SCANCODE_8, SDL_SCANCODE_9,
      SDL_SCANCODE_0, SDL_SCANCODE_MINUS}},
    {48, 5, {SDL_SCANCODE_EQUALS}},
    {6,
     9,
     {SDL_SCANCODE_Q, SDL_SCANCODE_W, SDL_SCANCODE_E, SDL_SCANCODE_R, SDL_SCANCODE_T,
      SDL_SCANCODE_Y, SDL_SCANCODE_U, SDL_SCANCODE_I, SDL_SCANCODE_O, SDL_SCANCODE_P,
      SDL_SCANCODE_LEFTBRACKET, SDL_SCANCODE_RIGHTBRACKET}},
    {7,
     13,
     {SDL_SCANCODE_A, SDL_SCANCODE_S, SDL_SCANCODE_D, SDL_SCANCODE_F, SDL_SCANCODE_G,
      SDL_SCANCODE_H, SDL_SCANCODE_J, SDL_SCANCODE_K, SDL_SCANCODE_L, SDL_SCANCODE_SEMICOLON,
      SDL_SCANCODE_APOSTROPHE}},
    {9,
     17,
     {SDL_SCANCODE_Z, SDL_SCANCODE_X, SDL_SCANCODE_C, SDL_SCANCODE_V, SDL_SCANCODE_B,
      SDL_SCANCODE_N, SDL_SCANCODE_M, SDL_SCANCODE_COMMA, SDL_SCANCODE_PERIOD, SDL_SCANCODE_SLASH}},
    {61, 5, {SDL_SCANCODE_INSERT, SDL_SCANCODE_HOME, SDL_SCANCODE_PAGEUP}},
    {61, 9, {SDL_SCANCODE_DELETE, SDL_SCANCODE_END, SDL_SCANCODE_PAGEDOWN}},
    {65, 17, {SDL_SCANCODE_UP}},
    {61, 21, {SDL_SCANCODE_LEFT, SDL_SCANCODE_DOWN, SDL_SCANCODE_RIGHT}},
};

/** All other keys. */
static const KeyShape special_keys[] = {
    {SDL_SCANCODE_ESCAPE, 0, 0, 7, 4, LAYOUT_ANY}, // Wider than on most: for "Échap".
    {SDL_SCANCODE_F10, 48, 0, 5, 4, LAYOUT_ANY},   // For two digits.
    {SDL_SCANCODE_F11, 53, 0, 5, 4, LAYOUT_ANY},
    {SDL_SCANCODE_F12, 58, 0, 5, 4, LAYOUT_ANY},
    {SDL_SCANCODE_BACKSPACE, 52, 5, 8, 4, LAYOUT_ANY},
    {SDL_SCANCODE_TAB, 0, 9, 6, 4, LAYOUT_ANY},
    {SDL_SCANCODE_BACKSLASH, 54, 9, 6, 4, LAYOUT_ANSI},
    {SDL_SCANCODE_CAPSLOCK, 0, 13, 7, 4, LAYOUT_ANY},
    {SDL_SCANCODE_RETURN, 51, 13, 9, 4, LAYOUT_ANSI},
    {SDL_SCANCODE_BACKSLASH, 51, 13, 4, 4, LAYOUT_ISO},
    {SDL_SCANCODE_RETURN, 55, 9, 5, 8, LAYOUT_ISO},
    {SDL_SCANCODE_LSHIFT, 0, 17, 9, 4, LAYOUT_ANSI},
    {SDL_SCANCODE_LSHIFT, 0, 17, 5, 4, LAYOUT_ISO},
    {SDL_SCANCODE_NONUSBACKSLASH, 5, 17, 4, 4, LAYOUT_ISO},
    {SDL_SCANCODE_RSHIFT, 49, 17, 11, 4, LAYOUT_ANY},
    {SDL_SCANCODE_LCTRL, 0, 21, 5, 4, LAYOUT_ANY},
    {SDL_SCANCODE_LGUI, 5, 21, 5, 4, LAYOUT_ANY},
    {SDL_SCANCODE_LALT, 10, 21, 5, 4, LAYOUT_ANY},
    {SDL_SCANCODE_SPACE, 15, 21, 25, 4, LAYOUT_ANY},
    {SDL_SCANCODE_RALT, 40, 21, 5, 4, LAYOUT_ANY},
    {SDL_SCANCODE_RGUI, 45, 21, 5, 4, LAYOUT_ANY},
    {SDL_SCANCODE_APPLICATION, 50, 21, 5, 4, LAYOUT_ANY},
    {SDL_SCANCODE_RCTRL, 55, 21, 5, 4, LAYOUT_ANY},
};

/** Where the keyboard is drawn, and what the mouse does with it. */
typedef struct KeyboardPainter {
    GuiPoint origin;        /**< Upper left corner, units of the window. */
    float quarter_key;      /**< Units of a quarter of a key. */
    const Help *help;       /**< The commands. */
    const Command *marked;  /**< Command whose keys are marked; NULL: none. */
    const Command *hovered; /**< Command under the mouse; NULL: none. */
    const Command *clicked; /**< Command of the key that was clicked; NULL: none. */
} KeyboardPainter;

/** @return Units of a quarter of a key in a space; 0: its keys would be too small. */
static float quarter_key_size(float width, float height) {
    float size = fminf(width / (float)KEYBOARD_WIDTH, height / (float)KEYBOARD_HEIGHT);
    return 4 * size < SMALLEST_KEY * gui_text_size() ? 0 : size;
}

/** @return The row of a key; NULL: it does nothing. */
static const Command *find_row(const KeyboardPainter *painter, SDL_Scancode scancode) {
    SDL_Keysym key = {.scancode = scancode, .sym = SDL_GetKeyFromScancode(scancode)};
    return command_find_key(painter->help->commands, key, painter->help->by_letter);
}

const char *key_action_label(const Command *row) {
    return row ? gettext(row->cap ? row->cap : row->help) : "";
}

const char *key_cap_label(SDL_Scancode scancode) {
    static const struct {
        SDL_Scancode scancode;
        const char *label;
    } signs[] = {{SDL_SCANCODE_LSHIFT, "⇧"},      {SDL_SCANCODE_RSHIFT, "⇧"},
                 {SDL_SCANCODE_BACKSPACE, "⌫"},   {SDL_SCANCODE_RETURN, "⏎"},
                 {SDL_SCANCODE_CAPSLOCK, "⇪"},    {SDL_SCANCODE_SPACE, N_("Space")},
                 {SDL_SCANCODE_TAB, N_("Tab")},   {SDL_SCANCODE_LCTRL, "Ctrl"},
                 {SDL_SCANCODE_RCTRL, "Ctrl"},    {SDL_SCANCODE_LALT, "Alt"},
                 {SDL_SCANCODE_RALT, "Alt"},      {SDL_SCANCODE_LGUI, ""},
                 {SDL_SCANCODE_RGUI, ""},         {SDL_SCANCODE_APPLICATION, ""},
                 {SDL_SCANCODE_LEFT, "←"},        {SDL_SCANCODE_RIGHT, "→"},
                 {SDL_SCANCODE_UP, "↑"},          {SDL_SCANCODE_DOWN, "↓"},
                 {SDL_SCANCODE_INSERT, ""},       {SDL_SCANCODE_DELETE, ""},
                 {SDL_SCANCODE_END, "⇲"},         {SDL_SCANCODE_HOME, "⇱"},
                 {SDL_SCANCODE_PAGEUP, "⇞"},      {SDL_SCANCODE_PAGEDOWN, "⇟"},
                 {SDL_SCANCODE_ESCAPE, N_("Esc")}};
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
        if (signs[i].scancode == scancode) {
            return signs[i].label[0] ? gettext(signs[i].label) : "";
        }
    }
    return help_printed_name(scancode);
}

/** Draws a key. */
static void draw_key(KeyboardPainter *painter, const KeyShape *key) {
    const float quarter = painter->quarter_key;
    const Command *row = find_row(painter, key->scancode);
    const GuiRect rect = {painter->origin.x + (float)key->x * quarter + 1,
                          painter->origin.y + (float)key->y * quarter + 1,
                          (float)key->width * quarter - 2, (float)key->height * quarter - 2};
    GuiColor color = row ? gui_group_color(help_group(painter->help, row)) : GUI_COLOR_FAINT;
    bool is_marked = row && row == painter->marked;
    GuiMouse mouse = gui_key(&rect, key_cap_label(key->scancode), color, is_marked);
    painter->hovered = mouse != GUI_IDLE ? row : painter->hovered;
    painter->clicked = mouse == GUI_CLICKED ? row : painter->clicked;
}

/** @return The layout in use, by the key right of P. */
static KeyboardLayout detect_layout(void) {
    return SDL_GetKeyFromScancode(SDL_SCANCODE_LEFTBRACKET) == SDLK_LEFTBRACKET ? LAYOUT_ANSI
                                                                                : LAYOUT_ISO;
}

/** Draws all keys. */
static void draw_keys(KeyboardPainter *painter) {
    KeyboardLayout layout = detect_layout();
    for (size_t i = 0; i < sizeof key_rows / sizeof *key_rows; i++) {
        for (int j = 0; key_rows[i].scancodes[j] != SDL_SCANCODE_UNKNOWN; j++) {
            draw_key(painter, &(KeyShape){key_rows[i].scancodes[j], key_rows[i].x + 4 * j,
                                          key_rows[i].y, 4, 4, LAYOUT_ANY});
        }
    }
    for (size_t i = 0; i < sizeof special_keys / sizeof *special_keys; i++) {
        if (special_keys[i].layout == LAYOUT_ANY || special_keys[i].layout == layout) {
            draw_key(painter, &special_keys[i]);
        }
    }
}

const Command *keyboard_diagram_show(const Help *help, float height, const Command *marked,
                                     const Command **hovered) {
    const float width = gui_panel_width();
    KeyboardPainter painter = {
        .quarter_key = quarter_key_size(width, height), .help = help, .marked = marked};
    *hovered = NULL;
    if (painter.quarter_key > 0) {
        painter.origin = gui_canvas((float)KEYBOARD_HEIGHT * painter.quarter_key);
        painter.origin.x += (width - (float)KEYBOARD_WIDTH * painter.quarter_key) / 2;
        draw_keys(&painter);
        *hovered = painter.hovered;
    }
    return painter.clicked;
}
