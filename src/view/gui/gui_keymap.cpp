/**
 * @file
 * @brief Where the letters of shortcuts lie on the keyboard in use.
 */
#include "view/gui/gui_internal.h"

extern "C" {

void gui_on_keymap(Gui *gui) {
    /** Dear ImGui's letters: select all, copy, paste, cut, redo, undo. */
    static const struct {
        ImGuiKey_ key;           /**< Its name for it. */
        SDL_Keycode letter;      /**< What is printed on it. */
        SDL_Scancode on_us_keys; /**< Where it lies on a keyboard that has no Latin letters. */
    } letters[] = {{ImGuiKey_A, SDLK_a, SDL_SCANCODE_A}, {ImGuiKey_C, SDLK_c, SDL_SCANCODE_C},
                   {ImGuiKey_V, SDLK_v, SDL_SCANCODE_V}, {ImGuiKey_X, SDLK_x, SDL_SCANCODE_X},
                   {ImGuiKey_Y, SDLK_y, SDL_SCANCODE_Y}, {ImGuiKey_Z, SDLK_z, SDL_SCANCODE_Z}};
    if (!gui) {
        return;
    }
    ImGui::SetCurrentContext(gui->context);
    for (const auto &letter : letters) {
        const SDL_Scancode place = SDL_GetScancodeFromKey(letter.letter);
        ImGui::GetIO().KeyMap[letter.key] =
            place == SDL_SCANCODE_UNKNOWN ? letter.on_us_keys : place;
    }
}

} // extern "C"
