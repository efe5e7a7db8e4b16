/**
 * @file
 * @brief The magnifier: some pixels of the picture as squares. Which pixel is in its middle.
 *
 * It follows the mouse until keys move it, and again once the mouse has moved.
 */
#ifndef DIOPTRE_VIEW_PANELS_MAGNIFIER_H
#define DIOPTRE_VIEW_PANELS_MAGNIFIER_H

#include <stdbool.h>

/** Pixels that it shows, to the right and down; odd, so that one is in the middle. */
enum { MAGNIFIER_PIXELS = 11 };

/** A pixel of a picture. */
typedef struct PixelPosition {
    int x; /**< Its column. */
    int y; /**< Its row. */
} PixelPosition;

/** The magnifier. Starts as `{0}`: off. */
typedef struct Magnifier {
    bool is_on;          /**< Whether it is shown. */
    bool has_place;      /**< Whether #pixel is valid. */
    bool has_mouse;      /**< Whether #mouse is valid. */
    PixelPosition pixel; /**< The pixel in its middle. */
    PixelPosition mouse; /**< The pixel that was under the mouse last. */
} Magnifier;

/** Shows or hides it. */
void magnifier_toggle(Magnifier *magnifier);

/**
 * Places it.
 * @param mouse   The pixel under the mouse; NULL: the mouse is not on the picture.
 * @param width   Pixels of the picture.
 * @param height  Pixels of the picture.
 */
void magnifier_follow(Magnifier *magnifier, const PixelPosition *mouse, int width, int height);

/** Moves it to a pixel nearby. @param right Pixels to the right. @param down Pixels down. */
void magnifier_step(Magnifier *magnifier, int right, int down);

#endif
