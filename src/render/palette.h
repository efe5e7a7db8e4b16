/**
 * @file
 * @brief Palettes that are safe for colour-blind people.
 */
#ifndef DIOPTRE_RENDER_PALETTE_H
#define DIOPTRE_RENDER_PALETTE_H

#include <stddef.h>
#include <stdint.h>

/** A palette. */
typedef struct Palette {
    size_t count;               /**< Number of colours. */
    const uint8_t (*colors)[3]; /**< The colours, sRGB, equally spaced. */
} Palette;

/** From blue to yellow, the same to nearly all eyes (Nuñez, Anderton and Renslow, *Optimizing
 *  colormaps with consideration for color vision deficiency*, 2018). */
extern const Palette palette_cividis;
/** From blue over white to red, for signed numbers. */
extern const Palette palette_diverging;

/** Interpolates a palette. @param fraction Position, 0 to 1; clamped. */
void palette_color(const Palette *palette, double fraction, uint8_t rgb[3]);

/** Finds the colour of a category; they repeat after #PALETTE_CATEGORIES. @param[out] rgb The
 * colour, sRGB (Okabe and Ito, *Color Universal Design*, 2008). */
void palette_category(unsigned index, uint8_t rgb[3]);

/** Number of distinct categories. */
enum { PALETTE_CATEGORIES = 16 };

#endif
