/**
 * @file
 * @brief Loading of the program's modules, which link large libraries.
 */
#ifndef DIOPTRE_ASSETS_PLUGIN_H
#define DIOPTRE_ASSETS_PLUGIN_H

#include "base/error.h"

/** A module, with the messages for its absence. */
typedef struct Plugin {
    const char *file;            /**< File name. */
    const char *symbol;          /**< Exported symbol: a struct that starts with an `int`. */
    int version;                 /**< Required value of that `int`. */
    const char *purpose;         /**< What needs the module, for messages. */
    const char *library;         /**< Its library, for messages. */
    const char *build_package;   /**< Package that contains the library for builds. */
    const char *runtime_package; /**< Package that contains the library for use. */
    const char *fallback_hint;   /**< What works without it, after `; `; or an empty string. */
} Plugin;

/**
 * Loads a module from the folder of the program, or from `../lib/dioptre` relative to it. Later
 * calls are fast. It stays loaded until the process ends, because such libraries cannot be unloaded
 * safely.
 * @param plugin      The module.
 * @param[out] error  What is missing, and the package to install (#STATUS_FAILED).
 * @return The address of its symbol, or NULL.
 */
const void *plugin_open(const Plugin *plugin, Error *error);

/**
 * Loads a module from a folder.
 * @param plugin      The module.
 * @param folder      The folder.
 * @param[out] error  What is missing, and the package to install (#STATUS_FAILED).
 * @return The address of its symbol, or NULL.
 */
const void *plugin_open_from(const Plugin *plugin, const char *folder, Error *error);

#endif
