/**
 * @file
 * @brief Typing the caption of a lesson that is recorded. Its clock stands still meanwhile.
 */
#include "view/lesson_text.h"
#include "view/play.h"
#include "view/recorder.h"

#include "dioptre/language.h"

#include <string.h>

/** Shows what was typed. @param[in,out] view The view. */
static void show_typed(View *view) {
    Caption *caption = &view->stage.caption;
    const char *words = view->recorder.typed;
    *caption = (Caption){.text = {words, words},
                         .hint = N_("Caption: type, then Enter"),
                         .overlay = caption->overlay};
    overlay_forget(&caption->overlay);
    stage_present(&view->stage);
}

void recorder_begin_caption(View *view) {
    Recorder *recorder = &view->recorder;
    if (!recorder_is_on(view)) {
        view_note(view, "captions are for lessons that are recorded");
        return;
    }
    double now = clock_seconds();
    recorder_release_all(view, now);
    recorder_update(view, now);
    recorder->is_typing = true;
    strcpy(recorder->typed, "");
    SDL_StartTextInput();
    show_typed(view);
}

/** Ends the typing. @param[in,out] view The view. @param is_kept Whether the caption counts. */
static void end_typing(View *view, bool is_kept) {
    Recorder *recorder = &view->recorder;
    SDL_StopTextInput();
    recorder->is_typing = false;
    recorder->began = clock_seconds() - metronome_seconds(&recorder->metronome);
    caption_close(&view->stage.caption);
    if (is_kept && recorder->typed[0]) {
        char step[2 * TYPED_SIZE + 64];
        lesson_text_caption(step, sizeof step, recorder->typed);
        recorder_note(view, step);
    }
    stage_present(&view->stage);
}

/** Takes the last letter away. @param[in,out] typed The text, UTF-8. */
static void erase_letter(char *typed) {
    size_t length = strlen(typed);
    while (length > 0 && (typed[length - 1] & 0xC0) == 0x80) {
        length--;
    }
    typed[length > 0 ? length - 1 : 0] = '\0';
}

/** Takes a key. @param[in,out] view The view. @param key Which. */
static void type_key(View *view, SDL_Keycode key) {
    if (key == SDLK_RETURN || key == SDLK_KP_ENTER || key == SDLK_ESCAPE) {
        end_typing(view, key != SDLK_ESCAPE);
    } else if (key == SDLK_BACKSPACE) {
        erase_letter(view->recorder.typed);
        show_typed(view);
    }
}

bool recorder_types(View *view, const SDL_Event *event) {
    char *typed = view->recorder.typed;
    size_t used = strlen(typed);
    if (!view->recorder.is_typing) {
        return false;
    }
    if (event->type == SDL_TEXTINPUT && used + strlen(event->text.text) < TYPED_SIZE) {
        strcpy(typed + used, event->text.text);
        show_typed(view);
    } else if (event->type == SDL_KEYDOWN) {
        type_key(view, event->key.keysym.sym);
    }
    return event->type == SDL_TEXTINPUT || event->type == SDL_KEYDOWN || event->type == SDL_KEYUP ||
           event->type == SDL_MOUSEMOTION || event->type == SDL_MOUSEWHEEL;
}
