/**
 * @file
 * @brief The keyboard: which panel has it, and what its keys do there.
 */
#include "view/gui/gui_internal.h"

#include <backends/imgui_impl_sdl.h>

namespace {

/** @return Whether an event is of the keyboard. */
bool is_keyboard_event(const SDL_Event *event) {
    return event->type == SDL_KEYDOWN || event->type == SDL_KEYUP || event->type == SDL_TEXTINPUT;
}

/** @return Whether an event is Esc while no field is being changed. */
bool is_leaving(const SDL_Event *event) {
    return event->type == SDL_KEYDOWN && event->key.keysym.sym == SDLK_ESCAPE &&
           !ImGui::IsAnyItemActive() && !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
}

/** @return Whether an event is of a function key, or of a letter while nothing is typed and no list
 *  is open or Ctrl is held: those are for the program, as panels use none of them. */
bool is_program_key(const SDL_Event *event) {
    if (event->type == SDL_TEXTINPUT) {
        return false;
    }
    const SDL_Keysym &key = event->key.keysym;
    const bool is_letter = key.sym >= SDLK_a && key.sym <= SDLK_z;
    const bool is_free =
        key.mod & KMOD_CTRL || !ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
    return (key.sym >= SDLK_F1 && key.sym <= SDLK_F12) ||
           (is_letter && is_free && !ImGui::GetIO().WantTextInput);
}

/**
 * Makes what is typed part of a number, as only numbers are typed into fields: what a French
 * keyboard gives for its digits without Shift. A sign that numbers have, such as the minus there,
 * stays.
 * @param key   The key that typed it.
 * @param text  What is typed.
 */
void use_signs_of_numbers(SDL_Scancode key, char *text) {
    const bool is_digit_key = key >= SDL_SCANCODE_1 && key <= SDL_SCANCODE_0;
    if (is_digit_key && !is_sign_of_number(static_cast<ImWchar>(text[0]))) {
        text[0] = static_cast<char>('0' + (key - SDL_SCANCODE_1 + 1) % 10);
        text[1] = '\0';
    }
}

/** Makes the keys of a bar those of Dear ImGui: Enter, too, presses a button, and Tab goes on. */
void use_keys_of_bar(SDL_KeyboardEvent *key) {
    SDL_Scancode &place = key->keysym.scancode;
    if (place == SDL_SCANCODE_RETURN || place == SDL_SCANCODE_KP_ENTER) {
        place = SDL_SCANCODE_SPACE;
    } else if (place == SDL_SCANCODE_TAB) {
        bool is_back = key->keysym.mod & KMOD_SHIFT;
        place = is_back ? SDL_SCANCODE_LEFT : SDL_SCANCODE_RIGHT;
        // Shift may have changed since Tab went down.
        ImGui::GetIO().KeysDown[is_back ? SDL_SCANCODE_RIGHT : SDL_SCANCODE_LEFT] = false;
    }
}

/** Makes Enter in the inspector press what is no number, as Space does; a number is typed then. */
void use_keys_of_inspector(const Gui *gui, SDL_KeyboardEvent *key) {
    SDL_Scancode &place = key->keysym.scancode;
    const bool is_enter = place == SDL_SCANCODE_RETURN || place == SDL_SCANCODE_KP_ENTER;
    if (key->type == SDL_KEYDOWN && is_enter && !gui->is_number_chosen &&
        !ImGui::GetIO().WantTextInput) {
        place = SDL_SCANCODE_SPACE;
    } else if (key->type == SDL_KEYUP && is_enter) {
        ImGui::GetIO().KeysDown[SDL_SCANCODE_SPACE] = false; // Whatever it was when it went down.
    }
}

/** Makes the modifiers those of a key, as its event has them: SDL's own state, which Dear ImGui's
 * backend reads, is that of the newest event, which may come after this one. */
void take_modifiers(Uint16 mod) {
    ImGuiIO &io = ImGui::GetIO();
    io.KeyShift = mod & KMOD_SHIFT;
    io.KeyCtrl = mod & KMOD_CTRL;
    io.KeyAlt = mod & KMOD_ALT;
}

/** Passes a key or a text on to Dear ImGui, as the panel that has the keyboard uses it. */
void pass_on_key(Gui *gui, SDL_Event event) {
    const bool is_text = event.type == SDL_TEXTINPUT;
    const Uint16 mod = is_text ? 0 : event.key.keysym.mod;
    if (is_text) {
        use_signs_of_numbers(gui->plain_key, event.text.text);
    } else if (gui->keyboard == GUI_BAR) {
        use_keys_of_bar(&event.key);
    } else if (gui->keyboard == GUI_INSPECTOR) {
        use_keys_of_inspector(gui, &event.key);
    }
    ImGui_ImplSDL2_ProcessEvent(&event);
    if (!is_text) {
        take_modifiers(mod);
        gui->has_new_key = true;
    }
    gui->due_frames = FRAMES_PER_EVENT;
}

} // namespace

void update_text_input(Gui *gui) {
    bool is_wanted = ImGui::GetIO().WantTextInput;
    if (is_wanted && !gui->has_text_input) {
        SDL_StartTextInput();
    } else if (!is_wanted && gui->has_text_input) {
        SDL_StopTextInput();
    }
    gui->has_text_input = is_wanted;
}

void take_keyboard(Gui *gui) {
    ImGuiIO &io = ImGui::GetIO();
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    memset(io.KeysDown, 0, sizeof io.KeysDown);
    gui->keyboard = GUI_PICTURE;
    gui->takes_focus = false;
    ImGui::SetWindowFocus(nullptr);
    gui->due_frames = FRAMES_PER_EVENT;
}

bool handle_key_event(Gui *gui, const SDL_Event *event) {
    if (event->type == SDL_KEYDOWN) {
        const bool is_plain =
            !(event->key.keysym.mod & (KMOD_SHIFT | KMOD_CTRL | KMOD_MODE | KMOD_ALT));
        gui->plain_key = is_plain ? event->key.keysym.scancode : SDL_SCANCODE_UNKNOWN;
    }
    const bool has_panel = gui->keyboard != GUI_PICTURE;
    if (event->type == SDL_KEYDOWN && !has_panel) {
        silence_tooltips(&gui->rest); // Who presses keys looks at the picture.
    }
    const bool is_typed = (ImGui::GetIO().WantTextInput || has_panel) && is_keyboard_event(event);
    if (is_typed && has_panel && is_leaving(event)) {
        take_keyboard(gui);
        return true;
    }
    if (is_typed && has_panel && is_program_key(event)) {
        return false;
    }
    if (is_typed) {
        pass_on_key(gui, *event);
    }
    return is_typed;
}

extern "C" {

bool gui_give_keyboard(Gui *gui, GuiKeyboard panel) {
    if (!gui) {
        return false;
    }
    ImGui::SetCurrentContext(gui->context);
    const bool is_back = gui->keyboard == panel;
    take_keyboard(gui);
    if (!is_back) {
        ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
        gui->keyboard = panel;
        gui->takes_focus = true;
    }
    return !is_back;
}

void gui_take_keyboard(Gui *gui) {
    if (gui && gui->keyboard != GUI_PICTURE) {
        ImGui::SetCurrentContext(gui->context);
        take_keyboard(gui);
    }
}

GuiKeyboard gui_keyboard(const Gui *gui) {
    return gui ? gui->keyboard : GUI_PICTURE;
}

bool gui_awaits_frame(const Gui *gui) {
    return gui && gui->has_new_key;
}

} // extern "C"
