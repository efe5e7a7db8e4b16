/**
 * @file
 * @brief Colours that mean numbers, safe for the colour-blind.
 */
#ifndef DIOPTRE_RENDER_PALETTE_H
#define DIOPTRE_RENDER_PALETTE_H

#include <stddef.h>
#include <stdint.h>

/** Colours from dark to light. */
typedef struct Palette {
    size_t count;               /**< How many colours it goes through. */
    const uint8_t (*colors)[3]; /**< The colours, sRGB, equally far apart. */
} Palette;

/** From blue to yellow, the same to nearly all eyes (Nuñez, Anderton and Renslow, *Optimizing
 *  colormaps with consideration for color vision deficiency*, 2018). */
extern const Palette palette_cividis;
/** From violet to yellow (van der Walt and Smith, *A better default colormap for Matplotlib*,
 * 2015). */
extern const Palette palette_viridis;
/** From blue over white to red: for what may be on either side of zero. */
extern const Palette palette_diverging;

/** Finds a colour between two of them. @param fraction Where, 0 to 1; beyond, the first or the
 *  last. */
void palette_color(const Palette *palette, double fraction, uint8_t rgb[3]);

/** Finds the colour of a thing that is one of many. @param[out] rgb The colour, sRGB (Okabe and
 *  Ito, *Color Universal Design*, 2008). */
void palette_category(unsigned index, uint8_t rgb[3]);

/** How many kinds have a colour of their own. */
enum { PALETTE_CATEGORIES = 16 };

#endif
