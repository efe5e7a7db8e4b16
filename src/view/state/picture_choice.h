/**
 * @file
 * @brief What the user has chosen of the pictures of a window: settings, layers, one picture or
 *        two.
 */
#ifndef DIOPTRE_VIEW_STATE_PICTURE_CHOICE_H
#define DIOPTRE_VIEW_STATE_PICTURE_CHOICE_H

#include "view/state/settings_override.h"

/** Most pictures of a window. */
enum { CHOICE_PICTURES = 2 };

/** How pictures share the window. */
typedef enum {
    SPLIT_NONE,       /**< One picture. */
    SPLIT_BAR,        /**< Two pictures, left and right of a bar. */
    SPLIT_DIFFERENCE, /**< Their difference. */
    SPLIT_COUNT       /**< Number of modes. */
} SplitMode;

/** What is chosen of all pictures. */
typedef struct PictureChoice {
    SettingsOverride overrides[CHOICE_PICTURES]; /**< What is changed of the settings of each. */
    Layer layers[CHOICE_PICTURES];               /**< The layer of each. */
    SplitMode split;                             /**< How they share the window. */
    size_t active;                               /**< The one that keys change. */
    double bar_position; /**< Position of the bar between them, fraction of the picture's width. */
} PictureChoice;

/** @return Whether two choices show the same, wherever the bar is. @param base The settings without
 *  changes. */
bool picture_choice_is_same(const PictureChoice *a, const PictureChoice *b,
                            const RenderSettings *base);

#endif
