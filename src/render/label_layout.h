/**
 * @file
 * @brief Where labels lie beside what they name, so that neither they nor their leader lines meet.
 */
#ifndef DIOPTRE_RENDER_LABEL_LAYOUT_H
#define DIOPTRE_RENDER_LABEL_LAYOUT_H

#include <stdbool.h>
#include <stddef.h>

/** A label and its leader line, from the middle of the label to a point of what it names. */
typedef struct LabelBox {
    double from_x;   /**< One end of the line that it names, pixels from the left edge. */
    double from_y;   /**< The same, pixels from the upper edge. */
    double to_x;     /**< The other end; of a point the same. */
    double to_y;     /**< See #to_x. */
    double width;    /**< Of its text, pixels. */
    double height;   /**< Of its text, pixels. */
    double anchor_x; /**< Result: the point of the line that the leader line goes to. */
    double anchor_y; /**< See #anchor_x. */
    double x;        /**< Result: its left edge, pixels. */
    double y;        /**< Result: its upper edge, pixels. */
    bool is_placed;  /**< Result: whether there was room for it. */
} LabelBox;

/**
 * Places labels, one after the other: the first has the choice. A label for which no place near its
 * line is free is left out.
 * @param[in,out] boxes  The labels, the most important first.
 * @param width   Of the picture, pixels: labels lie inside.
 * @param height  See width.
 */
void labels_place(LabelBox *boxes, size_t count, double width, double height);

/** @return Whether two labels or their leader lines meet. */
bool labels_meet(const LabelBox *a, const LabelBox *b);

#endif
