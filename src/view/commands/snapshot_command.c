/**
 * @file
 * @brief Keeping the picture.
 */
#include "view/commands/snapshot_command.h"

#include "view/commands/scene_text.h"
#include "view/commands/snapshot.h"

bool snapshot_take(App *app, const char *folder, const char *name, Error *error) {
    Picture picture = {0};
    char path[NUMBERED_FILE_PATH_SIZE];
    bool is_saved = window_copy_picture(&app->window, &picture, error) &&
                    snapshot_write(folder, name, &picture, path, error);
    picture_deinit(&picture);
    if (is_saved) {
        scene_text_print(app->scene, stdout);
        if (app->scene->is_time_dependent) {
            printf("  -- t = %.17g", app->scene_time);
        }
        printf("  -- %s\n", path);
        fflush(stdout);
        app_set_status(app, "saved %s", path);
    }
    return is_saved;
}
