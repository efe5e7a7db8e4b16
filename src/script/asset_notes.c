/**
 * @file
 * @brief Notes about what was left out of the files of a scene.
 */
#include "script/asset_notes.h"

#include "base/sanitize.h"

#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/** Size of a note, with its final zero: a location, a path and a sentence. */
enum { NOTE_SIZE = 2 * ERROR_MESSAGE_SIZE };

/**
 * Adds a note about a file.
 * @param scene       The scene.
 * @param file        The file.
 * @param is_scene    Whether it is the scene file itself, whose name is left out.
 * @param line        Line of the file; 0: the whole file.
 * @param[out] error  What is wrong.
 * @param format      The text, translated, as for printf.
 * @return false when the scene's memory is full.
 */
static bool add_note(Scene *scene, const SceneFile *file, bool is_scene, size_t line, Error *error,
                     const char *format, ...) __attribute__((format(printf, 6, 7)));

static bool add_note(Scene *scene, const SceneFile *file, bool is_scene, size_t line, Error *error,
                     const char *format, ...) {
    char note[NOTE_SIZE], name[SANITIZED_PATH_SIZE];
    sanitize_path(name, file->name);
    if (is_scene) {
        snprintf(note, sizeof note, "%s: ", file->location);
    } else if (line > 0) {
        snprintf(note, sizeof note, "%s: %s:%zu: ", file->location, name, line);
    } else {
        snprintf(note, sizeof note, "%s: %s: ", file->location, name);
    }
    size_t length = strlen(note);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(note + length, sizeof note - length, format, arguments);
    va_end(arguments);
    return scene_add_note(scene, note, error);
}

/** Adds the notes about a mesh. @return false when the scene's memory is full. */
static bool add_mesh_notes(Scene *scene, const SceneMesh *mesh, Error *error) {
    const MeshRepairs *repairs = &mesh->mesh->repairs;
    bool is_built = mesh->built; // Of polygons in the scene file.
    size_t triangles = repairs->untriangulated_polygons, statements = repairs->skipped_statements;
    return (triangles == 0 ||
            add_note(scene, &mesh->file, is_built, 0, error,
                     ngettext("%zu triangle is missing, as edges of a polygon cross",
                              "%zu triangles are missing, as edges of polygons cross", triangles),
                     triangles)) &&
           (statements == 0 ||
            add_note(scene, &mesh->file, is_built, repairs->skipped_line, error,
                     ngettext("%zu statement is not understood and left out",
                              "%zu statements are not understood and left out; this is the first",
                              statements),
                     statements));
}

bool asset_notes_add(Scene *scene, Error *error) {
    bool is_added = true;
    for (size_t i = 0; is_added && i < scene->mesh_count; i++) {
        is_added = add_mesh_notes(scene, &scene->meshes[i], error);
    }
    for (size_t i = 0; is_added && i < scene->texture_count; i++) {
        const SceneTexture *texture = &scene->textures[i];
        is_added = !texture->texture->is_damaged ||
                   add_note(scene, &texture->file, false, 0, error, "%s",
                            gettext("it is cut off or damaged, and some of it is missing"));
    }
    return is_added;
}
