/**
 * @file
 * @brief Modules of the page: they are linked. It stands in for assets/plugin.c.
 */
#include "assets/plugin.h"

#include "assets/images/image_plugin.h"
#include "web/mesh_reader.h"

#include <string.h>

/** Reads pictures, see image_plugin.c. */
extern const ImagePlugin dioptre_image_plugin;

const void *plugin_open(const Plugin *plugin, Error *error) {
    (void)error;
    bool is_of_images = strcmp(plugin->symbol, IMAGE_PLUGIN_SYMBOL) == 0;
    return is_of_images ? (const void *)&dioptre_image_plugin : (const void *)&web_mesh_plugin;
}

const void *plugin_open_from(const Plugin *plugin, const char *folder, Error *error) {
    (void)folder;
    return plugin_open(plugin, error);
}
