/**
 * @file
 * @brief Watching a folder, by a thread that sleeps until something happens there.
 */
#include "view/watch.h"

#include <SDL.h>
#include <limits.h>
#include <poll.h>
#include <string.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

/** @return Whether a file's name is that of a scene, or of what scenes include. @param name It. */
static bool is_scene(const char *name) {
    const char *dot = strrchr(name, '.');
    return name[0] != '.' && dot && strcmp(dot, ".lua") == 0;
}

/**
 * Reads what has happened.
 * @param watch  The watch.
 * @return Whether any of it concerns a scene.
 */
static bool read_news(const Watch *watch) {
    _Alignas(struct inotify_event) char news[16 * (sizeof(struct inotify_event) + NAME_MAX + 1)];
    ssize_t size = read(watch->files, news, sizeof news);
    bool is_any = false;
    for (ssize_t at = 0; at < size;) {
        const struct inotify_event *one = (const void *)(news + at);
        is_any = is_any || (one->len > 0 && is_scene(one->name));
        at += (ssize_t)(sizeof *one + one->len);
    }
    return is_any;
}

/** Waits for news, as a thread. @param context The #Watch. @return NULL */
static void *wait_for_news(void *context) {
    Watch *watch = context;
    struct pollfd waited[] = {{watch->files, POLLIN, 0}, {watch->end, POLLIN, 0}};
    while (poll(waited, 2, -1) < 0 || !waited[1].revents) {
        if (waited[0].revents && read_news(watch)) {
            SDL_Event event = {.type = watch->event};
            SDL_PushEvent(&event);
        }
    }
    return NULL;
}

void watch_begin(Watch *watch, uint32_t event) {
    *watch = (Watch){.files = inotify_init1(IN_CLOEXEC | IN_NONBLOCK), .folder = -1};
    watch->end = eventfd(0, EFD_CLOEXEC);
    watch->event = event;
    if (watch->files < 0 || watch->end < 0 ||
        pthread_create(&watch->thread, NULL, wait_for_news, watch) != 0) {
        close(watch->files);
        close(watch->end);
        watch->files = -1;
    }
}

void watch_file(Watch *watch, const char *path) {
    char folder[PATH_MAX] = ".";
    const char *slash = strrchr(path, '/');
    if (watch->files < 0 || (slash && (size_t)(slash - path) >= sizeof folder)) {
        return;
    }
    if (slash) {
        snprintf(folder, sizeof folder, "%.*s/", (int)(slash - path), path);
    }
    if (watch->folder >= 0) {
        inotify_rm_watch(watch->files, watch->folder);
    }
    watch->folder = inotify_add_watch(watch->files, folder, IN_CLOSE_WRITE | IN_MOVED_TO);
}

void watch_end(Watch *watch) {
    const uint64_t one = 1;
    if (watch->files >= 0 && write(watch->end, &one, sizeof one) == sizeof one) {
        pthread_join(watch->thread, NULL);
        close(watch->files);
        close(watch->end);
        watch->files = -1;
    }
}
