/**
 * @file
 * @brief Opens the program's modules: what needs a large library is not linked with the program.
 */
#ifndef ASSETS_MODULE_H
#define ASSETS_MODULE_H

#include "dioptre/error.h"

/** A module: where it is, and what is said when it is not there. */
typedef struct Module {
    const char *file;     /**< Its file name. */
    const char *symbol;   /**< The one thing that it shows: a struct that begins with an `int`. */
    int version;          /**< What that number must be. */
    const char *purpose;  /**< What needs it, in words. */
    const char *library;  /**< The library behind it. */
    const char *to_build; /**< The package that it is built with. */
    const char *to_run;   /**< The package that it runs with. */
    const char *without;  /**< What still works without it, with `; ` before; or nothing. */
} Module;

/**
 * Opens a module, which takes some time when it is done first and nothing after. It is looked for
 * beside the program, then in `../lib/dioptre` seen from there. It stays open until the process
 * ends: libraries of its kind are not made to be taken away again.
 * @param module      The module.
 * @param[out] error  What is missing and what to install (#STATUS_FAILED).
 * @return What it shows, or NULL.
 */
const void *module_open(const Module *module, Error *error);

/**
 * Opens a module that lies in one folder.
 * @param module      The module.
 * @param folder      The folder.
 * @param[out] error  What is missing and what to install (#STATUS_FAILED).
 * @return What it shows, or NULL.
 */
const void *module_open_from(const Module *module, const char *folder, Error *error);

#endif
