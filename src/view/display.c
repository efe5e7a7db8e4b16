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
#include "view/display.h"

#include "dioptre/language.h"
#include "dioptre/scene.h"

#include <string.h>

/** Says what SDL did not like. @return false. @param[out] error Where to. @param format What
 * failed, with room for SDL's words. */
__attribute__((format(printf, 2, 0))) static bool sdl_failed(Error *error, const char *format) {
    return error_set(error, STATUS_FAILED, format, SDL_GetError());
}

/**
 * Makes a size no larger than the room on the first screen, keeping its shape.
 * @param[in,out] width   Width, in the screen's units.
 * @param[in,out] height  Height.
 */
static void fit_to_screen(int *width, int *height) {
    SDL_Rect room;
    if (SDL_GetDisplayUsableBounds(0, &room) == 0 && room.w > 0 && room.h > 0) {
        double shrink = SDL_min((double)room.w / *width, (double)room.h / *height);
        if (shrink < 1) {
            *width = SDL_max(1, (int)(*width * shrink));
            *height = SDL_max(1, (int)(*height * shrink));
        }
    }
}

/** @return What draws in a window, or NULL. @param window The window. */
static SDL_Renderer *create_renderer(SDL_Window *window) {
    bool is_x11 = strcmp(SDL_GetCurrentVideoDriver(), "x11") == 0;
    bool is_chosen = SDL_GetHint(SDL_HINT_RENDER_DRIVER) != NULL;
    if (is_x11 && !is_chosen) {
        SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
        return SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
    }
    SDL_Renderer *renderer = SDL_CreateRenderer(window, -1, SDL_RENDERER_ACCELERATED);
    return renderer ? renderer : SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
}

bool display_open(Display *display, const char *title, int width, int height, Error *error) {
    *display = (Display){0};
    /* Honest pixels: no smoothing, so that a class sees what was traced. */
    SDL_SetHint(SDL_HINT_RENDER_SCALE_QUALITY, "nearest");
    fit_to_screen(&width, &height);
    display->window = SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width,
                                       height, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
    if (!display->window) {
        return sdl_failed(error, N_("cannot open a window: %s"));
    }
    display->renderer = create_renderer(display->window);
    if (!display->renderer) {
        sdl_failed(error, N_("cannot draw in a window: %s"));
        display_close(display);
        return false;
    }
    return true;
}

void display_close(Display *display) {
    if (display->renderer) {
        SDL_DestroyRenderer(display->renderer);
    }
    if (display->window) {
        SDL_DestroyWindow(display->window);
    }
    *display = (Display){0};
}

void display_size(const Display *display, int *width, int *height) {
    if (SDL_GetRendererOutputSize(display->renderer, width, height) != 0) {
        SDL_GetWindowSize(display->window, width, height);
    }
    *width = SDL_clamp(*width, 1, IMAGE_SIZE_MAXIMUM);
    *height = SDL_clamp(*height, 1, IMAGE_SIZE_MAXIMUM);
}

void display_begin(Display *display) {
    SDL_SetRenderDrawColor(display->renderer, 0, 0, 0, SDL_ALPHA_OPAQUE);
    SDL_RenderClear(display->renderer);
}

void display_end(Display *display) {
    SDL_RenderPresent(display->renderer);
}

void display_toggle_full_screen(Display *display) {
    bool is_full = SDL_GetWindowFlags(display->window) & SDL_WINDOW_FULLSCREEN_DESKTOP;
    SDL_SetWindowFullscreen(display->window, is_full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
}
