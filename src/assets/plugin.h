/**
 * @file
 * @brief Opens the program's modules: what needs a large library is not linked with the program.
 */
#ifndef DIOPTRE_ASSETS_PLUGIN_H
#define DIOPTRE_ASSETS_PLUGIN_H

#include "base/error.h"

/** A module: where it is, and what is said when it is not there. */
typedef struct Plugin {
    const char *file;    /**< Its file name. */
    const char *symbol;  /**< The one thing that it shows: a struct that begins with an `int`. */
    int version;         /**< What that number must be. */
    const char *purpose; /**< What needs it, in words. */
    const char *library; /**< The library behind it. */
    const char *build_package;   /**< The package that it is built with. */
    const char *runtime_package; /**< The package that it runs with. */
    const char *fallback_hint;   /**< What still works without it, with `; ` before; or nothing. */
} Plugin;

/**
 * Opens a module, which takes some time when it is done first and nothing after. It is looked for
 * beside the program, then in `../lib/dioptre` seen from there. It stays open until the process
 * ends: libraries of its kind are not made to be taken away again.
 * @param[out] error  What is missing and what to install (#STATUS_FAILED).
 * @return What it shows, or NULL.
 */
const void *plugin_open(const Plugin *plugin, Error *error);

/**
 * Opens a module that lies in one folder.
 * @param[out] error  What is missing and what to install (#STATUS_FAILED).
 * @return What it shows, or NULL.
 */
const void *plugin_open_from(const Plugin *plugin, const char *folder, Error *error);

#endif
