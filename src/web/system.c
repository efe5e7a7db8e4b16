/**
 * @file
 * @brief What a page lacks of an operating system: programs, signals, the folder of the program, a
 *        watch on files, a way out and a clipboard.
 *
 * It stands in for base/process/pipe_process.c, base/executable_dir.c, view/input/signal_thread.c,
 * view/loading/file_watcher.c and view/state/way_out.c.
 */
#include "base/executable_dir.h"
#include "base/process/pipe_process.h"
#include "view/input/signal_thread.h"
#include "view/loading/file_watcher.h"
#include "view/state/way_out.h"

#include <SDL.h>
#include <emscripten.h>
#include <stdio.h>

// --- programs ------------------------------------------------------------------------------------

bool pipe_process_is_installed(const char *name) {
    (void)name;
    return false;
}

bool pipe_process_start(PipeProcess *program, const atomic_bool *stop, const char *const *argv,
                        Error *error) {
    *program = (PipeProcess){.name = argv[0], .input_pipe = -1, .stop = stop, .error_file = -1};
    return error_set(error, STATUS_FAILED, "%s does not run in a page", argv[0]);
}

bool pipe_process_write(PipeProcess *program, const void *bytes, size_t size) {
    (void)program, (void)bytes, (void)size;
    return false;
}

bool pipe_process_finish(PipeProcess *program, Error *error) {
    return error_set(error, STATUS_FAILED, "%s does not run in a page", program->name);
}

void pipe_process_kill(PipeProcess *program) {
    (void)program;
}

// --- the folder of the program -------------------------------------------------------------------

bool executable_dir(char folder[PATH_MAX]) {
    snprintf(folder, PATH_MAX, "/dioptre");
    return true;
}

// --- signals -------------------------------------------------------------------------------------

void signal_thread_block(SignalThread *signal_thread) {
    *signal_thread = (SignalThread){0};
}

bool signal_thread_start(SignalThread *signal_thread, uint32_t event) {
    signal_thread->event = event;
    return true;
}

void signal_thread_stop(SignalThread *signal_thread) {
    (void)signal_thread;
}

// --- the end -------------------------------------------------------------------------------------

bool way_out_exists(void) {
    return false;
}

// --- the clipboard -------------------------------------------------------------------------------

/** SDL's own function, whose clipboard is the program's alone in a page. */
int __real_SDL_SetClipboardText(const char *text);

/** Gives a text to the browser's clipboard, too. See SDL_SetClipboardText(). */
int __wrap_SDL_SetClipboardText(const char *text) {
    MAIN_THREAD_EM_ASM({ Module['onCopy'] && Module['onCopy'](UTF8ToString($0)); }, text);
    return __real_SDL_SetClipboardText(text);
}

// --- files that change ---------------------------------------------------------------------------

/** The event of the window that watches; the page has one window. 0: none does. */
static atomic_uint watch_event;

void file_watcher_start(FileWatcher *watcher, uint32_t event) {
    *watcher = (FileWatcher){.inotify = -1, .watch_id = -1, .event = event};
    atomic_store(&watch_event, event);
}

void file_watcher_watch(FileWatcher *watcher, const char *path) {
    (void)watcher;
    MAIN_THREAD_EM_ASM({ Module['onScene'] && Module['onScene'](UTF8ToString($0)); }, path);
}

void file_watcher_stop(FileWatcher *watcher) {
    (void)watcher;
    atomic_store(&watch_event, 0);
}

/** Tells the window that the page has written a scene file. Called by the page. */
EMSCRIPTEN_KEEPALIVE void web_file_changed(void) {
    SDL_Event event = {.type = atomic_load(&watch_event)};
    if (event.type != 0) {
        SDL_PushEvent(&event);
    }
}

/** Opens a scene in the window, as if its file were dropped there. Called by the page. */
EMSCRIPTEN_KEEPALIVE void web_open(const char *path) {
    SDL_Event event = {.drop = {.type = SDL_DROPFILE, .file = SDL_strdup(path)}};
    SDL_PushEvent(&event);
}
