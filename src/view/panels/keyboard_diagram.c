/**
 * @file
 * @brief Drawing the keyboard.
 *
 * Places and sizes of keys are quarters of a key. Keyboards of America (ANSI) and of the rest of
 * the world (ISO) differ around Enter and the left Shift.
 */
#include "view/panels/keyboard_diagram.h"

#include "view/panels/key_labels.h"
#include "view/window/font.h"

/** Quarters of a key that the keyboard is wide. */
static const int KEYBOARD_WIDTH = 73;
/** Quarters of a key that it is high. */
static const int KEYBOARD_HEIGHT = 25;
/** Pixels of a key below which nobody can read what it does. */
static const int MINIMUM_KEY_SIZE = 28;

/** Which keyboards have a key. */
typedef enum {
    LAYOUT_ANY,  /**< All. */
    LAYOUT_ANSI, /**< Those of America. */
    LAYOUT_ISO   /**< All others. */
} KeyboardLayout;

/** A key of its own size or place. */
typedef struct KeyShape {
    SDL_Scancode scancode; /**< Which. */
    int x;                 /**< Quarters of a key from the left. */
    int y;                 /**< From above. */
    int width;             /**< Quarters. */
    int height;            /**< Quarters. */
    KeyboardLayout layout; /**< Which keyboards have it. */
} KeyShape;

/** Keys of usual size, side by side. */
typedef struct KeyRow {
    int x;                      /**< Quarters of a key from the left. */
    int y;                      /**< From above. */
    SDL_Scancode scancodes[13]; /**< Which, ended by SDL's "unknown". */
} KeyRow;

/** The keys that stand side by side. */
static const KeyRow key_rows[] = {
    {0, 0, {SDL_SCANCODE_ESCAPE}},
    {8, 0, {SDL_SCANCODE_F1, SDL_SCANCODE_F2, SDL_SCANCODE_F3, SDL_SCANCODE_F4}},
    {26, 0, {SDL_SCANCODE_F5, SDL_SCANCODE_F6, SDL_SCANCODE_F7, SDL_SCANCODE_F8}},
    {44, 0, {SDL_SCANCODE_F9, SDL_SCANCODE_F10, SDL_SCANCODE_F11, SDL_SCANCODE_F12}},
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

/** What the keyboard is drawn with. */
typedef struct KeyboardPainter {
    SDL_Surface *surface; /**< Where to. */
    SDL_Point origin;     /**< Where its upper left corner is. */
    double quarter_key;   /**< Pixels of a quarter of a key. */
    TTF_Font *font;       /**< The letters; owned. */
    bool by_letter;       /**< Whether the light's keys go by their letters. */
} KeyboardPainter;

/** @return Pixels of a quarter of a key in a room. */
static double quarter_key_size(int width, int height) {
    return fmin((double)width / KEYBOARD_WIDTH, (double)height / KEYBOARD_HEIGHT);
}

SDL_Point keyboard_diagram_size(int width, int height) {
    double pixels = quarter_key_size(width, height);
    if (4 * pixels < MINIMUM_KEY_SIZE || !font_is_available()) {
        return (SDL_Point){0, 0};
    }
    return (SDL_Point){(int)(KEYBOARD_WIDTH * pixels), (int)(KEYBOARD_HEIGHT * pixels)};
}

/** Fills a part of the panel. */
static void fill_rect(const KeyboardPainter *painter, const SDL_Rect *area, SDL_Color color) {
    SDL_FillRect(painter->surface, area,
                 SDL_MapRGBA(painter->surface->format, color.r, color.g, color.b, color.a));
}

/** @return A colour of which only a share is left. */
static SDL_Color dim_color(SDL_Color color, double perceived_brightness) {
    return (SDL_Color){(Uint8)(color.r * perceived_brightness),
                       (Uint8)(color.g * perceived_brightness),
                       (Uint8)(color.b * perceived_brightness), color.a};
}

/** Writes words into the middle of a line, smaller where they are too wide. @param line The line:
 *  its upper end, its width; the letters are as high as it at most. */
static void draw_fitted_text(const KeyboardPainter *painter, const char *text, const SDL_Rect *line,
                             SDL_Color color) {
    /** Size of letters below which nothing is gained, pixels. */
    const int smallest = 6;
    int size = SDL_max(smallest, line->h);
    TTF_SetFontSize(painter->font, size);
    while (size > smallest && font_text_width(painter->font, text) > line->w) {
        TTF_SetFontSize(painter->font, --size);
    }
    int x = line->x + (line->w - font_text_width(painter->font, text)) / 2;
    font_draw_text(painter->surface, painter->font, text, color, x, line->y + (line->h - size) / 2);
}

/** @return Where a key is, pixels. */
static SDL_Rect key_rect(const KeyboardPainter *painter, const KeyShape *key) {
    int left = (int)(key->x * painter->quarter_key), top = (int)(key->y * painter->quarter_key);
    int right = (int)((key->x + key->width) * painter->quarter_key);
    int bottom = (int)((key->y + key->height) * painter->quarter_key);
    return (SDL_Rect){painter->origin.x + left + 1, painter->origin.y + top + 1, right - left - 2,
                      bottom - top - 2};
}

/** @return What a key means. */
static KeyInfo key_info(const KeyboardPainter *painter, SDL_Scancode scancode) {
    SDL_Keysym key = {.scancode = scancode, .sym = SDL_GetKeyFromScancode(scancode)};
    KeyInfo info = keymap_lookup(key, painter->by_letter);
    if (key_action_label(scancode, &info)[0] != '\0' && info.tint == 0) {
        /* Shift and Ctrl go with the moves: the last of the lists. */
        info.tint = keymap_lookup((SDL_Keysym){.sym = SDLK_ESCAPE}, false).tint;
    }
    return info;
}

/** Draws a key. */
static void draw_key(const KeyboardPainter *painter, const KeyShape *key) {
    /** A key that does nothing, and what is printed on it. */
    static const SDL_Color idle = {42, 46, 58, SDL_ALPHA_OPAQUE},
                           faint = {125, 130, 142, SDL_ALPHA_OPAQUE};
    static const SDL_Color white = {245, 245, 245, SDL_ALPHA_OPAQUE};
    /** How dark the key behind its words is. */
    const double perceived_brightness = 0.36;
    KeyInfo info = key_info(painter, key->scancode);
    const char *word = key_action_label(key->scancode, &info);
    bool is_used = word[0] != '\0';
    SDL_Color tint = is_used ? panel_tint_color(info.tint) : faint;
    SDL_Rect area = key_rect(painter, key);
    fill_rect(painter, &area, is_used ? dim_color(tint, perceived_brightness) : idle);
    SDL_Rect label = {area.x + 1, area.y + (int)(0.45 * painter->quarter_key), area.w - 2,
                      (int)(1.5 * painter->quarter_key)};
    SDL_Rect below = {area.x + 1, area.y + area.h - (int)(1.75 * painter->quarter_key), area.w - 2,
                      (int)(1.25 * painter->quarter_key)};
    SDL_SetClipRect(painter->surface, &area);
    draw_fitted_text(painter, key_cap_label(key->scancode), &label, tint);
    draw_fitted_text(painter, word, &below, white);
    SDL_SetClipRect(painter->surface, NULL);
}

/** @return Which keyboard is in use, by what is printed right of P. */
static KeyboardLayout detect_layout(void) {
    return SDL_GetKeyFromScancode(SDL_SCANCODE_LEFTBRACKET) == SDLK_LEFTBRACKET ? LAYOUT_ANSI
                                                                                : LAYOUT_ISO;
}

/** Draws all keys. */
static void draw_keys(const KeyboardPainter *painter) {
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

void keyboard_diagram_draw(SDL_Surface *panel, const SDL_Rect *area, bool by_letter) {
    KeyboardPainter painter = {.surface = panel,
                               .origin = {area->x, area->y},
                               .quarter_key = quarter_key_size(area->w, area->h),
                               .font = font_open(),
                               .by_letter = by_letter};
    if (painter.font) {
        draw_keys(&painter);
        font_close(painter.font);
    }
}
