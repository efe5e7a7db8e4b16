/**
 * @file
 * @brief Tells the page which file could not be opened, so that its text can be mended there.
 */
#include "view/commands/current_scene.h"

#include <emscripten.h>

/** The window's own function. */
bool __real_current_scene_update(App *app, double now, Error *error);

/** Shows a scene that was loaded; of another that is faulty, the page is told the file, before its
 *  error is said. See #current_scene_update. */
bool __wrap_current_scene_update(App *app, double now, Error *error) {
    bool ok = __real_current_scene_update(app, now, error);
    if (!ok && app->source.has_load_error && app->source.failed_path[0] != '\0') {
        MAIN_THREAD_EM_ASM({ Module['onFaulty'] && Module['onFaulty'](UTF8ToString($0)); },
                           app->source.failed_path);
    }
    return ok;
}
