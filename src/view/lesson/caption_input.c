/**
 * @file
 * @brief Typing the caption of a lesson that is recorded. Its clock stands still meanwhile.
 */
#include "view/commands/time_control.h"
#include "view/lesson/lesson_writer.h"
#include "view/lesson/recorder.h"

#include "base/language.h"

#include <string.h>

/** Shows what was typed. */
static void caption_input_show(App *app) {
    Caption *caption = &app->window.caption;
    const char *text = app->recorder.caption;
    *caption = (Caption){
        .text = {text, text}, .hint = N_("Caption: type, then Enter"), .overlay = caption->overlay};
    overlay_invalidate(&caption->overlay);
    window_present(&app->window);
}

void caption_input_begin(App *app) {
    Recorder *recorder = &app->recorder;
    if (!recorder_is_active(app)) {
        app_set_status(app, "captions are for lessons that are recorded");
        return;
    }
    double now = clock_now_seconds();
    recorder_release_all(app, now);
    recorder_update(app, now);
    recorder->is_entering_caption = true;
    strcpy(recorder->caption, "");
    SDL_StartTextInput();
    caption_input_show(app);
}

/** Ends the typing. @param is_accepted Whether the caption counts. */
static void caption_input_end(App *app, bool is_accepted) {
    Recorder *recorder = &app->recorder;
    SDL_StopTextInput();
    recorder->is_entering_caption = false;
    recorder->start_time = clock_now_seconds() - step_clock_seconds(&recorder->step_clock);
    caption_close(&app->window.caption);
    if (is_accepted && recorder->caption[0]) {
        char step[2 * CAPTION_INPUT_SIZE + 64];
        lesson_writer_caption(step, sizeof step, recorder->caption);
        recorder_record_step(app, step);
    }
    window_present(&app->window);
}

/** Takes the last letter away. */
static void erase_character(char *text) {
    size_t length = strlen(text);
    while (length > 0 && (text[length - 1] & 0xC0) == 0x80) {
        length--;
    }
    text[length > 0 ? length - 1 : 0] = '\0';
}

/** Takes a key. */
static void caption_input_key(App *app, SDL_Keycode key) {
    if (key == SDLK_RETURN || key == SDLK_KP_ENTER || key == SDLK_ESCAPE) {
        caption_input_end(app, key != SDLK_ESCAPE);
    } else if (key == SDLK_BACKSPACE) {
        erase_character(app->recorder.caption);
        caption_input_show(app);
    }
}

bool caption_input_handle(App *app, const SDL_Event *event) {
    char *caption = app->recorder.caption;
    size_t length = strlen(caption);
    if (!app->recorder.is_entering_caption) {
        return false;
    }
    if (event->type == SDL_TEXTINPUT && length + strlen(event->text.text) < CAPTION_INPUT_SIZE) {
        strcpy(caption + length, event->text.text);
        caption_input_show(app);
    } else if (event->type == SDL_KEYDOWN) {
        caption_input_key(app, event->key.keysym.sym);
    }
    return event->type == SDL_TEXTINPUT || event->type == SDL_KEYDOWN || event->type == SDL_KEYUP ||
           event->type == SDL_MOUSEMOTION || event->type == SDL_MOUSEWHEEL;
}
