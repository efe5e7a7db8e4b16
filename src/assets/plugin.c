/**
 * @file
 * @brief Loading of the program's modules.
 */
#include "assets/plugin.h"

#include "base/executable_dir.h"

#include <dlfcn.h>
#include <libintl.h>
#include <stdio.h>
#include <unistd.h>

/** Folder of installed modules, relative to that of the program. */
#define INSTALLED_DIR "../lib/dioptre"

/** @return The hint on what works without a module, translated; may be empty. */
static const char *fallback_hint_text(const Plugin *plugin) {
    return plugin->fallback_hint[0] ? gettext(plugin->fallback_hint) : "";
}

/** Finds the symbol of a module. @return Its address; NULL if the version differs. */
static const void *find_symbol(const Plugin *plugin, void *handle, Error *error) {
    const int *version = dlsym(handle, plugin->symbol);
    if (!version || *version != plugin->version) {
        error_set(error, STATUS_FAILED,
                  "%s is of another version of this program: run make again%s", plugin->file,
                  fallback_hint_text(plugin));
        return NULL;
    }
    return version;
}

/** @return Whether a folder contains a readable module. */
static bool plugin_exists(const Plugin *plugin, const char *folder) {
    char path[PATH_MAX];
    return snprintf(path, sizeof path, "%s/%s", folder, plugin->file) < PATH_MAX &&
           access(path, R_OK) == 0;
}

const void *plugin_open_from(const Plugin *plugin, const char *folder, Error *error) {
    if (!plugin_exists(plugin, folder)) {
        error_set(error, STATUS_FAILED,
                  "%s need the module %s, which is not in %s: install %s and run make%s",
                  gettext(plugin->purpose), plugin->file, folder, plugin->build_package,
                  fallback_hint_text(plugin));
        return NULL;
    }
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/%s", folder, plugin->file);
    void *handle = dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!handle) {
        error_set(error, STATUS_FAILED, "%s need %s, which cannot be loaded (%s): install %s%s",
                  gettext(plugin->purpose), plugin->library, dlerror(), plugin->runtime_package,
                  fallback_hint_text(plugin));
        return NULL;
    }
    const void *symbol = find_symbol(plugin, handle, error);
    dlclose(handle); // It stays loaded: RTLD_NODELETE.
    return symbol;
}

const void *plugin_open(const Plugin *plugin, Error *error) {
    char executable[PATH_MAX];
    char installed[PATH_MAX + sizeof INSTALLED_DIR];
    if (!executable_dir(executable)) {
        error_set(error, STATUS_FAILED,
                  "the program's own folder, where %s should be, cannot be found%s", plugin->file,
                  fallback_hint_text(plugin));
        return NULL;
    }
    snprintf(installed, sizeof installed, "%s/" INSTALLED_DIR, executable);
    bool is_installed = !plugin_exists(plugin, executable) && plugin_exists(plugin, installed);
    return plugin_open_from(plugin, is_installed ? installed : executable, error);
}
