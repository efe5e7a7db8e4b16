/**
 * @file
 * @brief Game controllers, of which SDL is built without and Dear ImGui asks: there are none.
 */
#include <SDL_gamecontroller.h>

SDL_GameController *SDL_GameControllerOpen(int index) {
    return NULL;
}

Sint16 SDL_GameControllerGetAxis(SDL_GameController *controller, SDL_GameControllerAxis axis) {
    return 0;
}

Uint8 SDL_GameControllerGetButton(SDL_GameController *controller, SDL_GameControllerButton button) {
    return 0;
}
