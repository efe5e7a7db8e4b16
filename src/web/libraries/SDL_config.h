/**
 * @file
 * @brief Configuration of SDL for the page: SDL's own for emscripten, without sound and OpenGL.
 */
#ifndef DIOPTRE_WEB_SDL_CONFIG_H
#define DIOPTRE_WEB_SDL_CONFIG_H
/** SDL's header of this name includes others that say the same. */
#define SDL_config_h_

#include "SDL_config_emscripten.h"

#undef SDL_VIDEO_OPENGL_ES2
#undef SDL_VIDEO_OPENGL_EGL
#undef SDL_VIDEO_RENDER_OGL_ES2
#undef SDL_LOADSO_DLOPEN
#undef HAVE_DLOPEN
#undef HAVE_ICONV
#undef SDL_AUDIO_DRIVER_DISK
#undef SDL_AUDIO_DRIVER_DUMMY
#undef SDL_AUDIO_DRIVER_EMSCRIPTEN
#undef SDL_JOYSTICK_EMSCRIPTEN
#undef SDL_POWER_EMSCRIPTEN
/** None is loaded. */
#define SDL_LOADSO_DUMMY 1
/** No sound. */
#define SDL_AUDIO_DISABLED 1
/** No joystick. */
#define SDL_JOYSTICK_DISABLED 1
/** No battery. */
#define SDL_POWER_DISABLED 1
/** No sensors. */
#define SDL_SENSOR_DISABLED 1
/** For tests of the program without a page. */
#define SDL_VIDEO_DRIVER_DUMMY 1

#endif
