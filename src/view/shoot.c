/**
 * @file
 * @brief Keeping the picture.
 */
#include "view/shoot.h"

#include "view/scene_text.h"
#include "view/snapshot.h"

bool shoot(View *view, const char *folder, const char *name, Error *error) {
    Picture picture = {0};
    char path[NUMBERED_PATH_SIZE];
    bool is_saved = stage_copy(&view->stage, &picture, error) &&
                    snapshot_write(folder, name, &picture, path, error);
    picture_release(&picture);
    if (is_saved) {
        scene_text_print(view->scene, stdout);
        if (view->scene->reads_time) {
            printf("  -- t = %.17g", view->time);
        }
        printf("  -- %s\n", path);
        fflush(stdout);
        view_note(view, "saved %s", path);
    }
    return is_saved;
}
