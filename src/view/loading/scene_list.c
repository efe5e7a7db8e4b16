/**
 * @file
 * @brief Finding scenes and drawing their thumbnails in a thread.
 */
#include "view/loading/scene_list.h"

#include "base/data_dir.h"
#include "base/language.h"
#include "base/lesson_file.h"
#include "base/scene_name.h"
#include "render/ray_stack.h"

#include <SDL.h>
#include <dirent.h>
#include <libintl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

/** Folder of lessons, beside the scenes. */
#define LESSON_FOLDER "lessons/"
/** Depth of a lesson's picture, at least. */
enum { LESSON_DEPTH = 8 };
/** Niceness of the thread and its children. */
static const int THREAD_NICENESS = 15;

void scene_list_lock(SceneList *list) {
    pthread_mutex_lock(&list->mutex);
}

void scene_list_unlock(SceneList *list) {
    pthread_mutex_unlock(&list->mutex);
}

/** Sends the event of a change. */
static void push_list_event(const SceneList *list) {
    SDL_Event event = {.type = list->event};
    SDL_PushEvent(&event);
}

/** @return Whether a file may be a scene, for scandir. */
static int is_scene_file(const struct dirent *entry) {
    return entry->d_name[0] != '.' && scene_format_of(entry->d_name) != SCENE_FORMAT_NONE;
}

/** Takes the thumbnail over that was drawn of a file before, unless the file was modified since.
 *  @param[in,out] scene A new entry with path and time. */
static void take_kept_picture(SceneList *list, SceneEntry *scene) {
    for (size_t i = 0; i < list->kept_count; i++) {
        SceneEntry *kept = &list->kept[i];
        if (kept->picture.pixels && kept->modified.tv_sec == scene->modified.tv_sec &&
            kept->modified.tv_nsec == scene->modified.tv_nsec &&
            strcmp(kept->path, scene->path) == 0) {
            scene->picture = kept->picture;
            scene->is_loaded = true;
            kept->picture = (Picture){0};
            return;
        }
    }
}

/** Adds a scene or a lesson. Behind the end of the list its thread writes alone, so files are read
 *  without the lock, for which the window waits. @param[in,out] list With a free place. @param
 *  folder Empty, or with a slash at its end. @param wants_lesson Whether files other than lessons
 *  are left out, or lessons. */
static void add_entry(SceneList *list, const char *folder, const char *file, bool wants_lesson) {
    SceneEntry *scene = &list->scenes[list->count];
    size_t size = strlen(folder) + strlen(file) + 1;
    *scene = (SceneEntry){.path = malloc(size), .is_lesson = wants_lesson};
    if (!scene->path) {
        return;
    }
    snprintf(scene->path, size, "%s%s", folder, file);
    if (lesson_file_is(scene->path) == wants_lesson) {
        struct stat info;
        if (stat(scene->path, &info) == 0) {
            scene->modified = info.st_mtim;
            take_kept_picture(list, scene);
        }
        scene_name_from_path(scene->path, scene->name, sizeof scene->name);
        scene_title_read(scene->path, wants_lesson, language_is_french(), scene->title);
        if (wants_lesson) {
            scene_title_read_summary(scene->path, language_is_french(), &scene->summary);
        }
        SDL_strlcpy(scene->label, scene->name, sizeof scene->label);
        scene_title_read_name(scene->path, language_is_french(), scene->label, sizeof scene->label);
        scene_list_lock(list);
        list->count++;
        scene_list_unlock(list);
    } else {
        free(scene->path);
    }
}

/** Adds the scenes or the lessons of a folder, sorted by name. @param folder With a slash at its
 *  end; empty: the current one. */
static void list_folder(SceneList *list, const char *folder, bool wants_lessons) {
    struct dirent **files = NULL;
    int count = scandir(folder[0] ? folder : ".", &files, is_scene_file, alphasort);
    for (int i = 0; i < count; i++) {
        if (list->count < SCENE_LIST_MAXIMUM) {
            add_entry(list, folder, files[i]->d_name, wants_lessons);
        }
        free(files[i]);
    }
    free(files);
}

/** Adds the lessons beside the scenes of a folder, then the scenes. @param folder See #list_folder.
 */
static void list_lessons_and_scenes(SceneList *list, const char *folder) {
    char lessons[PATH_MAX + sizeof LESSON_FOLDER];
    snprintf(lessons, sizeof lessons, "%s" LESSON_FOLDER, folder);
    list_folder(list, lessons, true);
    list_folder(list, folder, false);
}

/** Frees what was listed before. */
static void free_kept(SceneList *list) {
    for (size_t i = 0; i < list->kept_count; i++) {
        picture_deinit(&list->kept[i].picture);
        free(list->kept[i].path);
    }
    free(list->kept);
    list->kept = NULL;
    list->kept_count = 0;
}

/** Finds all scenes and lessons: beside the scene, and the program's own. */
static void find_scenes(SceneList *list) {
    char scene_folder[PATH_MAX], program_folder[PATH_MAX], listed[PATH_MAX + 1];
    list_lessons_and_scenes(list, list->folder);
    if (data_dir_scenes(program_folder) &&
        realpath(list->folder[0] ? list->folder : ".", scene_folder) &&
        strcmp(scene_folder, program_folder) != 0) {
        snprintf(listed, sizeof listed, "%s/", program_folder);
        list_lessons_and_scenes(list, listed);
    }
    free_kept(list);
    atomic_store(&list->is_complete, true);
}

/** Draws a thumbnail. @param[out] error Error of the scene. */
static void draw_thumbnail(const SceneList *list, const SceneEntry *entry, Picture *picture,
                           Error *error) {
    const ViewSettings *settings = list->settings;
    RenderSettings render;
    Scene *scene = settings->preview(settings->loader_context, entry->path, &list->should_stop,
                                     &render, error);
    if (!scene) {
        return;
    }
    render.threads = 1;
    render.samples = SDL_min(render.samples, 2);
    // A lesson may begin with black mirrors and glass, which says nothing of what comes.
    render.trace.depth =
        entry->is_lesson ? SDL_max(render.trace.depth, LESSON_DEPTH) : render.trace.depth;
    render.width = THUMBNAIL_WIDTH;
    render.height = THUMBNAIL_HEIGHT;
    Renderer *renderer = renderer_create(scene, &render, error);
    if (renderer && picture_init(picture, render.width, render.height, error)) {
        renderer_render(renderer, &list->should_stop, picture);
    }
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/** @return An error message without the folder at its beginning. */
static const char *strip_folder(const SceneEntry *scene, const char *message) {
    const char *slash = strrchr(scene->path, '/');
    size_t length = slash ? (size_t)(slash + 1 - scene->path) : 0;
    return strncmp(message, scene->path, length) == 0 ? message + length : message;
}

/** Loads one scene: its thumbnail or error. One that is stopped meanwhile, perhaps half drawn, is
 *  drawn when the list is filled again. */
static void load_entry(SceneList *list, size_t index) {
    SceneEntry *scene = &list->scenes[index];
    Picture picture = {0};
    Error error = {0};
    draw_thumbnail(list, scene, &picture, &error);
    if (atomic_load(&list->should_stop)) {
        picture_deinit(&picture);
        return;
    }
    scene_list_lock(list);
    scene->picture = picture;
    scene->is_loaded = true;
    if (!picture.pixels) {
        SDL_strlcpy(scene->title, strip_folder(scene, error.message), sizeof scene->title);
    }
    scene_list_unlock(list);
    push_list_event(list);
}

/** Finds the scene to be drawn next: the first in sight, else the first of all. @param[out] next
 *  Its index. @return false if all are drawn. */
static bool find_next(SceneList *list, size_t *next) {
    bool is_any = false, is_in_sight = false;
    scene_list_lock(list);
    for (size_t i = 0; i < list->count && !is_in_sight; i++) {
        const SceneEntry *scene = &list->scenes[i];
        if (!scene->is_loaded && (!is_any || scene->is_in_sight)) {
            *next = i;
            is_any = true;
            is_in_sight = scene->is_in_sight;
        }
    }
    scene_list_unlock(list);
    return is_any;
}

/** Finds and draws all scenes, as a thread. @return NULL */
static void *scene_list_main(void *context) {
    SceneList *list = context;
    setpriority(PRIO_PROCESS, (id_t)gettid(), THREAD_NICENESS); // On Linux, of this thread alone.
    find_scenes(list);
    push_list_event(list);
    size_t next = 0;
    while (!atomic_load(&list->should_stop) && find_next(list, &next)) {
        load_entry(list, next);
    }
    atomic_store(&list->is_running, false);
    push_list_event(list);
    return NULL;
}

/** Ends the thread. */
static void end_thread(SceneList *list) {
    scene_list_request_stop(list);
    pthread_join(list->thread, NULL);
    pthread_mutex_destroy(&list->mutex);
    list->is_started = false;
}

bool scene_list_start(SceneList *list, const ViewSettings *settings, uint32_t event,
                      const char *path) {
    const char *slash = strrchr(path, '/');
    if (list->is_started) {
        end_thread(list);
    }
    *list = (SceneList){
        .settings = settings, .event = event, .kept = list->scenes, .kept_count = list->count};
    snprintf(list->folder, sizeof list->folder, "%.*s", slash ? (int)(slash + 1 - path) : 0, path);
    list->scenes = calloc(SCENE_LIST_MAXIMUM, sizeof *list->scenes);
    if (!list->scenes) {
        free_kept(list);
        return false;
    }
    pthread_mutex_init(&list->mutex, NULL);
    atomic_store(&list->is_running, true);
    list->is_started = ray_thread_create(&list->thread, scene_list_main, list) == 0;
    if (!list->is_started) {
        pthread_mutex_destroy(&list->mutex);
        free(list->scenes);
        free_kept(list);
        *list = (SceneList){0};
    }
    return list->is_started;
}

void scene_list_request_stop(SceneList *list) {
    atomic_store(&list->should_stop, true);
}

bool scene_list_is_busy(const SceneList *list) {
    return list->is_started && atomic_load(&list->is_running);
}

void scene_list_deinit(SceneList *list) {
    if (!list->is_started) {
        return;
    }
    end_thread(list);
    list->kept = list->scenes;
    list->kept_count = list->count;
    free_kept(list);
    *list = (SceneList){0};
}
