/**
 * @file
 * @brief Opens the program's modules.
 */
#include "assets/module.h"

#include "assets/own_folder.h"

#include <dlfcn.h>
#include <libintl.h>
#include <stdio.h>
#include <unistd.h>

/** Where modules are installed, seen from the folder of the program. */
#define INSTALLED_FOLDER "../lib/dioptre"

/** @return What is said of how to do without a module; it may be nothing. @param module The module.
 */
static const char *words_without(const Module *module) {
    return module->without[0] ? gettext(module->without) : "";
}

/**
 * Finds a module's one symbol.
 * @param module      The module.
 * @param handle      The same, open.
 * @param[out] error  What is wrong.
 * @return What it shows; NULL when it is not of this program's version.
 */
static const void *find_symbol(const Module *module, void *handle, Error *error) {
    const int *version = dlsym(handle, module->symbol);
    if (!version || *version != module->version) {
        error_set(error, STATUS_FAILED,
                  "%s is of another version of this program: run make again%s", module->file,
                  words_without(module));
        return NULL;
    }
    return version;
}

/**
 * Says whether a module is in a folder.
 * @param module  The module.
 * @param folder  The folder.
 * @return Whether it is, and can be read.
 */
static bool has_module(const Module *module, const char *folder) {
    char path[PATH_MAX];
    return snprintf(path, sizeof path, "%s/%s", folder, module->file) < PATH_MAX &&
           access(path, R_OK) == 0;
}

const void *module_open_from(const Module *module, const char *folder, Error *error) {
    if (!has_module(module, folder)) {
        error_set(error, STATUS_FAILED,
                  "%s need the module %s, which is not in %s: install %s and run make%s",
                  gettext(module->purpose), module->file, folder, module->to_build,
                  words_without(module));
        return NULL;
    }
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/%s", folder, module->file);
    void *handle = dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!handle) {
        error_set(error, STATUS_FAILED, "%s need %s, which cannot be loaded (%s): install %s%s",
                  gettext(module->purpose), module->library, dlerror(), module->to_run,
                  words_without(module));
        return NULL;
    }
    const void *shown = find_symbol(module, handle, error);
    dlclose(handle); // It stays loaded all the same: RTLD_NODELETE.
    return shown;
}

const void *module_open(const Module *module, Error *error) {
    char beside[PATH_MAX];
    char installed[PATH_MAX + sizeof INSTALLED_FOLDER];
    if (!own_folder(beside)) {
        error_set(error, STATUS_FAILED,
                  "the program's own folder, where %s should be, cannot be found%s", module->file,
                  words_without(module));
        return NULL;
    }
    snprintf(installed, sizeof installed, "%s/" INSTALLED_FOLDER, beside);
    bool is_installed = !has_module(module, beside) && has_module(module, installed);
    return module_open_from(module, is_installed ? installed : beside, error);
}
