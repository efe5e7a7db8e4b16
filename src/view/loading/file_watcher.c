/**
 * @file
 * @brief Watching a folder with inotify in a thread.
 */
#include "view/loading/file_watcher.h"

#include "base/scene_name.h"

#include <SDL.h>
#include <limits.h>
#include <poll.h>
#include <string.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

/** @return Whether a file may be a scene or included by one. */
static bool is_scene_file(const char *name) {
    return name[0] != '.' && scene_format_of(name) != SCENE_FORMAT_NONE;
}

/** Reads inotify's events. @return Whether any is of a scene file. */
static bool read_events(const FileWatcher *watcher) {
    _Alignas(struct inotify_event) char events[16 * (sizeof(struct inotify_event) + NAME_MAX + 1)];
    ssize_t size = read(watcher->inotify, events, sizeof events);
    bool is_any = false;
    for (ssize_t at = 0; at < size;) {
        const struct inotify_event *event = (const void *)(events + at);
        is_any = is_any || (event->len > 0 && is_scene_file(event->name));
        at += (ssize_t)(sizeof *event + event->len);
    }
    return is_any;
}

/** Waits for events, as a thread. @return NULL */
static void *file_watcher_main(void *context) {
    FileWatcher *watcher = context;
    struct pollfd descriptors[] = {{watcher->inotify, POLLIN, 0}, {watcher->stop_event, POLLIN, 0}};
    while (poll(descriptors, 2, -1) < 0 || !descriptors[1].revents) {
        if (descriptors[0].revents && read_events(watcher)) {
            SDL_Event event = {.type = watcher->event};
            SDL_PushEvent(&event);
        }
    }
    return NULL;
}

void file_watcher_start(FileWatcher *watcher, uint32_t event) {
    *watcher = (FileWatcher){.inotify = inotify_init1(IN_CLOEXEC | IN_NONBLOCK), .watch_id = -1};
    watcher->stop_event = eventfd(0, EFD_CLOEXEC);
    watcher->event = event;
    if (watcher->inotify < 0 || watcher->stop_event < 0 ||
        pthread_create(&watcher->thread, NULL, file_watcher_main, watcher) != 0) {
        close(watcher->inotify);
        close(watcher->stop_event);
        watcher->inotify = -1;
    }
}

void file_watcher_watch(FileWatcher *watcher, const char *path) {
    char folder[PATH_MAX] = ".";
    const char *slash = strrchr(path, '/');
    if (watcher->inotify < 0 || (slash && (size_t)(slash - path) >= sizeof folder)) {
        return;
    }
    if (slash) {
        snprintf(folder, sizeof folder, "%.*s/", (int)(slash - path), path);
    }
    if (watcher->watch_id >= 0) {
        inotify_rm_watch(watcher->inotify, watcher->watch_id);
    }
    watcher->watch_id = inotify_add_watch(watcher->inotify, folder, IN_CLOSE_WRITE | IN_MOVED_TO);
}

void file_watcher_stop(FileWatcher *watcher) {
    const uint64_t one = 1;
    if (watcher->inotify >= 0 && write(watcher->stop_event, &one, sizeof one) == sizeof one) {
        pthread_join(watcher->thread, NULL);
        close(watcher->inotify);
        close(watcher->stop_event);
        watcher->inotify = -1;
    }
}
