/**
 * @file
 * @brief Hexadecimal colours, such as `#ff8000`.
 */
#ifndef SCRIPT_HEX_COLOR_H
#define SCRIPT_HEX_COLOR_H

#include "base/vec3d.h"

#include <stdbool.h>
#include <stddef.h>

/**
 * Reads a hexadecimal colour: red, green and blue in sRGB, each 00 to ff.
 * @param text        The text.
 * @param length      Bytes of the text.
 * @param[out] color  The colour in linear light by the exact sRGB curve, 0 to 1.
 * @return Whether the text is such a colour.
 */
bool hex_color_read(const char *text, size_t length, Rgbd *color);

#endif
