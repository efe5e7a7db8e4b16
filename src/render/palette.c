/**
 * @file
 * @brief Palettes: tables of colours and their interpolation.
 */
#include "render/palette.h"

#include <string.h>

/** See #palette_cividis. */
static const uint8_t cividis[][3] = {{0x00, 0x20, 0x4d}, {0x00, 0x33, 0x6f}, {0x39, 0x48, 0x6b},
                                     {0x57, 0x5c, 0x6d}, {0x70, 0x71, 0x73}, {0x8a, 0x87, 0x79},
                                     {0xa6, 0x9d, 0x75}, {0xc4, 0xb5, 0x6c}, {0xe4, 0xcf, 0x5b},
                                     {0xff, 0xea, 0x46}};

/** See #palette_diverging. */
static const uint8_t blue_white_red[][3] = {
    {0x05, 0x30, 0x61}, {0x21, 0x66, 0xac}, {0x67, 0xa9, 0xcf}, {0xf7, 0xf7, 0xf7},
    {0xef, 0x8a, 0x62}, {0xb2, 0x18, 0x2b}, {0x67, 0x00, 0x1f}};

/** The eight of Okabe and Ito, with grey in place of black; then the same, darker. */
static const uint8_t categories[PALETTE_CATEGORIES][3] = {
    {0x56, 0xb4, 0xe9}, {0xe6, 0x9f, 0x00}, {0x00, 0x9e, 0x73}, {0xf0, 0xe4, 0x42},
    {0x00, 0x72, 0xb2}, {0xd5, 0x5e, 0x00}, {0xcc, 0x79, 0xa7}, {0xc8, 0xc8, 0xc8},
    {0x2b, 0x5a, 0x75}, {0x73, 0x50, 0x00}, {0x00, 0x4f, 0x3a}, {0x78, 0x72, 0x21},
    {0x00, 0x39, 0x59}, {0x6b, 0x2f, 0x00}, {0x66, 0x3d, 0x54}, {0x64, 0x64, 0x64}};

/** Initialiser of a palette. */
#define PALETTE_OF(table)                                                                          \
    { sizeof(table) / sizeof(table)[0], table }

const Palette palette_cividis = PALETTE_OF(cividis);
const Palette palette_diverging = PALETTE_OF(blue_white_red);

void palette_color(const Palette *palette, double fraction, uint8_t rgb[3]) {
    double last = (double)(palette->count - 1);
    double position = fraction > 0 ? (fraction < 1 ? fraction * last : last) : 0;
    size_t below = (size_t)position < palette->count - 1 ? (size_t)position : palette->count - 2;
    double weight = position - (double)below;
    for (int i = 0; i < 3; i++) {
        double a = palette->colors[below][i], b = palette->colors[below + 1][i];
        rgb[i] = (uint8_t)(a + (b - a) * weight + 0.5);
    }
}

void palette_category(unsigned index, uint8_t rgb[3]) {
    memcpy(rgb, categories[index % PALETTE_CATEGORIES], sizeof categories[0]);
}
