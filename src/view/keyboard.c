/**
 * @file
 * @brief Drawing the keyboard.
 *
 * Places and sizes of keys are quarters of a key. Keyboards of America (ANSI) and of the rest of
 * the world (ISO) differ around Enter and the left Shift.
 */
#include "view/keyboard.h"

#include "view/font.h"
#include "view/key_words.h"

/** Quarters of a key that the keyboard is wide. */
static const int WIDTH = 73;
/** Quarters of a key that it is high. */
static const int HEIGHT = 25;
/** Pixels of a key below which nobody can read what it does. */
static const int KEY_MINIMUM = 28;

/** Which keyboards have a key. */
typedef enum {
    FORM_ANY,  /**< All. */
    FORM_ANSI, /**< Those of America. */
    FORM_ISO   /**< All others. */
} KeyForm;

/** A key of its own size or place. */
typedef struct DrawnKey {
    SDL_Scancode place; /**< Which. */
    int x;              /**< Quarters of a key from the left. */
    int y;              /**< From above. */
    int width;          /**< Quarters. */
    int height;         /**< Quarters. */
    KeyForm form;       /**< Which keyboards have it. */
} DrawnKey;

/** Keys of usual size, side by side. */
typedef struct KeyRun {
    int x;                   /**< Quarters of a key from the left. */
    int y;                   /**< From above. */
    SDL_Scancode places[13]; /**< Which, ended by SDL's "unknown". */
} KeyRun;

/** The keys that stand side by side. */
static const KeyRun runs[] = {
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
static const DrawnKey others[] = {
    {SDL_SCANCODE_BACKSPACE, 52, 5, 8, 4, FORM_ANY},
    {SDL_SCANCODE_TAB, 0, 9, 6, 4, FORM_ANY},
    {SDL_SCANCODE_BACKSLASH, 54, 9, 6, 4, FORM_ANSI},
    {SDL_SCANCODE_CAPSLOCK, 0, 13, 7, 4, FORM_ANY},
    {SDL_SCANCODE_RETURN, 51, 13, 9, 4, FORM_ANSI},
    {SDL_SCANCODE_BACKSLASH, 51, 13, 4, 4, FORM_ISO},
    {SDL_SCANCODE_RETURN, 55, 9, 5, 8, FORM_ISO},
    {SDL_SCANCODE_LSHIFT, 0, 17, 9, 4, FORM_ANSI},
    {SDL_SCANCODE_LSHIFT, 0, 17, 5, 4, FORM_ISO},
    {SDL_SCANCODE_NONUSBACKSLASH, 5, 17, 4, 4, FORM_ISO},
    {SDL_SCANCODE_RSHIFT, 49, 17, 11, 4, FORM_ANY},
    {SDL_SCANCODE_LCTRL, 0, 21, 5, 4, FORM_ANY},
    {SDL_SCANCODE_LGUI, 5, 21, 5, 4, FORM_ANY},
    {SDL_SCANCODE_LALT, 10, 21, 5, 4, FORM_ANY},
    {SDL_SCANCODE_SPACE, 15, 21, 25, 4, FORM_ANY},
    {SDL_SCANCODE_RALT, 40, 21, 5, 4, FORM_ANY},
    {SDL_SCANCODE_RGUI, 45, 21, 5, 4, FORM_ANY},
    {SDL_SCANCODE_APPLICATION, 50, 21, 5, 4, FORM_ANY},
    {SDL_SCANCODE_RCTRL, 55, 21, 5, 4, FORM_ANY},
};

/** What the keyboard is drawn with. */
typedef struct Pen {
    SDL_Surface *panel; /**< Where to. */
    SDL_Point corner;   /**< Where its upper left corner is. */
    double quarter;     /**< Pixels of a quarter of a key. */
    TTF_Font *font;     /**< The letters; owned. */
    bool by_letter;     /**< Whether the light's keys go by their letters. */
} Pen;

/** @return Pixels of a quarter of a key in a room. @param width Pixels. @param height Pixels. */
static double quarter(int width, int height) {
    return fmin((double)width / WIDTH, (double)height / HEIGHT);
}

SDL_Point keyboard_size(int width, int height) {
    double pixels = quarter(width, height);
    if (4 * pixels < KEY_MINIMUM || !font_is_there()) {
        return (SDL_Point){0, 0};
    }
    return (SDL_Point){(int)(WIDTH * pixels), (int)(HEIGHT * pixels)};
}

/** Fills a part of the panel. @param pen The pen. @param area Which. @param color The colour. */
static void fill(const Pen *pen, const SDL_Rect *area, SDL_Color color) {
    SDL_FillRect(pen->panel, area,
                 SDL_MapRGBA(pen->panel->format, color.r, color.g, color.b, color.a));
}

/** @return A colour of which only a share is left. @param color The colour. @param share 0 to 1. */
static SDL_Color dimmed(SDL_Color color, double share) {
    return (SDL_Color){(Uint8)(color.r * share), (Uint8)(color.g * share), (Uint8)(color.b * share),
                       color.a};
}

/**
 * Writes words into the middle of a line, smaller where they are too wide.
 * @param pen    The pen.
 * @param words  The words, UTF-8.
 * @param line   The line: its upper end, its width; the letters are as high as it at most.
 * @param color  Their colour.
 */
static void write_fitted(const Pen *pen, const char *words, const SDL_Rect *line, SDL_Color color) {
    /** Size of letters below which nothing is gained, pixels. */
    const int smallest = 6;
    int size = SDL_max(smallest, line->h);
    TTF_SetFontSize(pen->font, size);
    while (size > smallest && font_width(pen->font, words) > line->w) {
        TTF_SetFontSize(pen->font, --size);
    }
    int x = line->x + (line->w - font_width(pen->font, words)) / 2;
    font_write(pen->panel, pen->font, words, color, x, line->y + (line->h - size) / 2);
}

/** @return Where a key is, pixels. @param pen The pen. @param key The key. */
static SDL_Rect area_of(const Pen *pen, const DrawnKey *key) {
    int left = (int)(key->x * pen->quarter), top = (int)(key->y * pen->quarter);
    int right = (int)((key->x + key->width) * pen->quarter);
    int bottom = (int)((key->y + key->height) * pen->quarter);
    return (SDL_Rect){pen->corner.x + left + 1, pen->corner.y + top + 1, right - left - 2,
                      bottom - top - 2};
}

/** @return What a key means. @param pen The pen. @param place The key's place. */
static KeyMeaning meaning_of(const Pen *pen, SDL_Scancode place) {
    SDL_Keysym key = {.scancode = place, .sym = SDL_GetKeyFromScancode(place)};
    KeyMeaning meaning = keymap_meaning(key, pen->by_letter);
    if (key_word(place, &meaning)[0] != '\0' && meaning.tint == 0) {
        /* Shift and Ctrl go with the moves: the last of the lists. */
        meaning.tint = keymap_meaning((SDL_Keysym){.sym = SDLK_ESCAPE}, false).tint;
    }
    return meaning;
}

/** Draws a key. @param pen The pen. @param key The key. */
static void draw_key(const Pen *pen, const DrawnKey *key) {
    /** A key that does nothing, and what is printed on it. */
    static const SDL_Color idle = {42, 46, 58, SDL_ALPHA_OPAQUE},
                           faint = {125, 130, 142, SDL_ALPHA_OPAQUE};
    static const SDL_Color white = {245, 245, 245, SDL_ALPHA_OPAQUE};
    /** How dark the key behind its words is. */
    const double depth = 0.36;
    KeyMeaning meaning = meaning_of(pen, key->place);
    const char *word = key_word(key->place, &meaning);
    bool is_used = word[0] != '\0';
    SDL_Color tint = is_used ? panel_tint(meaning.tint) : faint;
    SDL_Rect area = area_of(pen, key);
    fill(pen, &area, is_used ? dimmed(tint, depth) : idle);
    SDL_Rect label = {area.x + 1, area.y + (int)(0.45 * pen->quarter), area.w - 2,
                      (int)(1.5 * pen->quarter)};
    SDL_Rect below = {area.x + 1, area.y + area.h - (int)(1.75 * pen->quarter), area.w - 2,
                      (int)(1.25 * pen->quarter)};
    SDL_SetClipRect(pen->panel, &area);
    write_fitted(pen, key_label(key->place), &label, tint);
    write_fitted(pen, word, &below, white);
    SDL_SetClipRect(pen->panel, NULL);
}

/** @return Which keyboard is in use, by what is printed right of P. */
static KeyForm form_in_use(void) {
    return SDL_GetKeyFromScancode(SDL_SCANCODE_LEFTBRACKET) == SDLK_LEFTBRACKET ? FORM_ANSI
                                                                                : FORM_ISO;
}

/** Draws all keys. @param pen The pen. */
static void draw_keys(const Pen *pen) {
    KeyForm form = form_in_use();
    for (size_t i = 0; i < sizeof runs / sizeof *runs; i++) {
        for (int j = 0; runs[i].places[j] != SDL_SCANCODE_UNKNOWN; j++) {
            draw_key(pen,
                     &(DrawnKey){runs[i].places[j], runs[i].x + 4 * j, runs[i].y, 4, 4, FORM_ANY});
        }
    }
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        if (others[i].form == FORM_ANY || others[i].form == form) {
            draw_key(pen, &others[i]);
        }
    }
}

void keyboard_draw(SDL_Surface *panel, const SDL_Rect *area, bool by_letter) {
    Pen pen = {.panel = panel,
               .corner = {area->x, area->y},
               .quarter = quarter(area->w, area->h),
               .font = font_open(),
               .by_letter = by_letter};
    if (pen.font) {
        draw_keys(&pen);
        font_close(pen.font);
    }
}
