/**
 * @file
 * @brief The window on the screen.
 *
 * The picture is made by the processor and is shown pixel by pixel, so there is nothing for a
 * graphics card to do. On X11 it goes straight into the window through shared memory: that opens
 * in 30 ms and shows 800x600 in 0.2 ms, where OpenGL took 80 to 260 ms and 2 ms. Wayland and the
 * others have no such way in SDL 2, so there the card is used, and SDL's own choice is the last
 * resort. `SDL_RENDER_DRIVER` overrules all this.
 */
#include "view/window/sdl_window.h"

#include "base/language.h"
#include "dioptre/scene.h"

#include <string.h>

/**
 * Says what SDL did not like.
 * @return false.
 * @param format  What failed, with room for SDL's words.
 */
__attribute__((format(printf, 2, 0))) static bool set_sdl_error(Error *error, const char *format) {
    return error_set(error, STATUS_FAILED, format, SDL_GetError());
}

/** Makes a size no larger than the room on the first screen, keeping its shape. @param[in,out]
 *  width Width, in the screen's units. */
static void fit_to_screen(int *width, int *height) {
    SDL_Rect usable;
    if (SDL_GetDisplayUsableBounds(0, &usable) == 0 && usable.w > 0 && usable.h > 0) {
        double shrink = SDL_min((double)usable.w / *width, (double)usable.h / *height);
        if (shrink < 1) {
            *width = SDL_max(1, (int)(*width * shrink));
            *height = SDL_max(1, (int)(*height * shrink));
        }
    }
}

/** @return What draws in a window, or NULL. */
static SDL_Renderer *create_renderer(SDL_Window *window) {
    bool is_x11 = strcmp(SDL_GetCurrentVideoDriver(), "x11") == 0;
    bool is_forced = SDL_GetHint(SDL_HINT_RENDER_DRIVER) != NULL;
    if (is_x11 && !is_forced) {
        SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
        return SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
    }
    SDL_Renderer *renderer = SDL_CreateRenderer(window, -1, SDL_RENDERER_ACCELERATED);
    return renderer ? renderer : SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
}

bool sdl_window_open(SdlWindow *sdl, const char *title, int width, int height, Error *error) {
    *sdl = (SdlWindow){0};
    /* Honest pixels: no smoothing, so that a class sees what was traced. */
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
    fit_to_screen(&width, &height);
    sdl->window = SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width,
                                   height, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
    if (!sdl->window) {
        return set_sdl_error(error, N_("cannot open a window: %s"));
    }
    sdl->renderer = create_renderer(sdl->window);
    if (!sdl->renderer) {
        set_sdl_error(error, N_("cannot draw in a window: %s"));
        sdl_window_close(sdl);
        return false;
    }
    return true;
}

void sdl_window_close(SdlWindow *sdl) {
    if (sdl->renderer) {
        SDL_DestroyRenderer(sdl->renderer);
    }
    if (sdl->window) {
        SDL_DestroyWindow(sdl->window);
    }
    *sdl = (SdlWindow){0};
}

void sdl_window_size(const SdlWindow *sdl, int *width, int *height) {
    if (SDL_GetRendererOutputSize(sdl->renderer, width, height) != 0) {
        SDL_GetWindowSize(sdl->window, width, height);
    }
    *width = SDL_clamp(*width, 1, IMAGE_SIZE_MAXIMUM);
    *height = SDL_clamp(*height, 1, IMAGE_SIZE_MAXIMUM);
}

void sdl_window_clear(SdlWindow *sdl) {
    SDL_SetRenderDrawColor(sdl->renderer, 0, 0, 0, SDL_ALPHA_OPAQUE);
    SDL_RenderClear(sdl->renderer);
}

void sdl_window_present(SdlWindow *sdl) {
    SDL_RenderPresent(sdl->renderer);
}

void sdl_window_toggle_full_screen(SdlWindow *sdl) {
    bool is_full = SDL_GetWindowFlags(sdl->window) & SDL_WINDOW_FULLSCREEN_DESKTOP;
    SDL_SetWindowFullscreen(sdl->window, is_full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
}
