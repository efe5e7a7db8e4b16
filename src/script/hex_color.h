/**
 * @file
 * @brief Colours as on the web.
 */
#ifndef SCRIPT_HEX_COLOR_H
#define SCRIPT_HEX_COLOR_H

#include "base/vec3d.h"

#include <stdbool.h>
#include <stddef.h>

/**
 * Reads a colour such as `#ff8000`: red, green and blue in sRGB, from 00 to ff.
 * @param[out] color  Its linear light, by the exact curve; each part 0 to 1.
 * @return Whether the text is such a colour.
 */
bool hex_color_read(const char *text, size_t length, Rgbd *color);

#endif
