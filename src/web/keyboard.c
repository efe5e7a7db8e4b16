/**
 * @file
 * @brief What is printed on the keys: SDL knows the keyboard of the United States alone in a page.
 */
#include <SDL.h>
#include <emscripten.h>

/** SDL's own function, for drivers: sets names of keys. @param start The first place. @param keys
 * What is printed there and behind. @param length Number of places. @param send_event Whether the
 * window is told. */
void SDL_SetKeymap(int start, const SDL_Keycode *keys, int length, SDL_bool send_event);

/** Says what is printed on a key. Called by the page. @param scancode Its place. @param letter What
 * it writes, a code point of Unicode. */
EMSCRIPTEN_KEEPALIVE void web_set_key(int scancode, int letter) {
    SDL_SetKeymap(scancode, &letter, 1, SDL_TRUE);
}
