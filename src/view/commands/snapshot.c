/**
 * @file
 * @brief Snapshots.
 */
#include "view/commands/snapshot.h"

#include "dioptre/image_file.h"

/** Writes a snapshot. See #NumberedFile.write. @return See there. */
static bool write_picture(const void *context, const char *path, bool *exists, Error *error) {
    return image_file_write_new(path, context, exists, error);
}

bool snapshot_write(const char *folder, const char *name, const Picture *picture,
                    char path[NUMBERED_FILE_PATH_SIZE], Error *error) {
    const NumberedFile file = {folder, name, "bmp", write_picture, picture};
    return numbered_file_write(&file, path, error);
}

void snapshot_from_bgrx(const uint8_t *bgrx, Picture *picture) {
    size_t count = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < count; i++) {
        picture->pixels[3 * i] = bgrx[4 * i + 2];
        picture->pixels[3 * i + 1] = bgrx[4 * i + 1];
        picture->pixels[3 * i + 2] = bgrx[4 * i];
    }
}
