/**
 * @file
 * @brief Where labels lie beside what they name.
 *
 * Each label tries places on rings around a few points of its line, near ones first, and takes the
 * first at which it meets no label and no leader line that was placed before.
 */
#include "render/label_layout.h"

#include <math.h>

/** Points of a line that are tried, as fractions of it. */
static const double FRACTIONS[] = {0.5, 0.35, 0.65, 0.2, 0.8};
/** How many they are. */
enum { FRACTION_COUNT = sizeof FRACTIONS / sizeof *FRACTIONS };
/** Rings around such a point that are tried. */
enum { RINGS = 9 };
/** Places on a ring. */
enum { PLACES = 16 };
/** Radius of the first ring, and from ring to ring, in heights of the label. */
static const double RING_STEP = 0.75;
/** Space that is left free around a label, in heights of the label. */
static const double GAP = 0.12;

/** @return On which side of a line a point is: the sign of the area. */
static double side(const double from[2], const double to[2], const double point[2]) {
    return (to[0] - from[0]) * (point[1] - from[1]) - (to[1] - from[1]) * (point[0] - from[0]);
}

/** @return Whether two line segments cross. */
static bool segments_cross(const double a[2], const double b[2], const double c[2],
                           const double d[2]) {
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/** @return Whether a segment meets a label with its gap. */
static bool segment_meets_box(const double from[2], const double to[2], const LabelBox *box) {
    const double gap = GAP * box->height, left = box->x - gap, top = box->y - gap;
    const double right = box->x + box->width + gap, bottom = box->y + box->height + gap;
    const double corners[4][2] = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
    bool is_inside = from[0] > left && from[0] < right && from[1] > top && from[1] < bottom;
    for (int i = 0; i < 4 && !is_inside; i++) {
        is_inside = segments_cross(from, to, corners[i], corners[(i + 1) % 4]);
    }
    return is_inside;
}

/** @return Whether two labels with their gaps overlap. */
static bool boxes_overlap(const LabelBox *a, const LabelBox *b) {
    double gap = GAP * fmax(a->height, b->height);
    return a->x < b->x + b->width + gap && b->x < a->x + a->width + gap &&
           a->y < b->y + b->height + gap && b->y < a->y + a->height + gap;
}

bool labels_meet(const LabelBox *a, const LabelBox *b) {
    const double from_a[2] = {a->anchor_x, a->anchor_y}, from_b[2] = {b->anchor_x, b->anchor_y};
    const double to_a[2] = {a->x + a->width / 2, a->y + a->height / 2};
    const double to_b[2] = {b->x + b->width / 2, b->y + b->height / 2};
    return boxes_overlap(a, b) || segments_cross(from_a, to_a, from_b, to_b) ||
           segment_meets_box(from_a, to_a, b) || segment_meets_box(from_b, to_b, a);
}

/** @return Whether a label may lie where it is. @param before The labels that are placed. */
static bool is_free(const LabelBox *box, const LabelBox *before, size_t count, double width,
                    double height) {
    bool is_inside = box->x >= 0 && box->y >= 0 && box->x + box->width <= width &&
                     box->y + box->height <= height;
    for (size_t i = 0; i < count && is_inside; i++) {
        is_inside = !before[i].is_placed || !labels_meet(box, &before[i]);
    }
    return is_inside;
}

/** Moves a label to a place on a ring around a point of its line. */
static void move_to(LabelBox *box, int ring, double fraction, int place) {
    // The first place is up and to the right.
    double angle = (place + 2) * (2 * M_PI / PLACES), radius = (ring + 1) * RING_STEP * box->height;
    box->anchor_x = box->from_x + fraction * (box->to_x - box->from_x);
    box->anchor_y = box->from_y + fraction * (box->to_y - box->from_y);
    box->x = box->anchor_x + cos(angle) * (radius + box->width / 2) - box->width / 2;
    box->y = box->anchor_y - sin(angle) * (radius + box->height / 2) - box->height / 2;
}

void labels_place(LabelBox *boxes, size_t count, double width, double height) {
    for (size_t i = 0; i < count; i++) {
        boxes[i].is_placed = false;
        for (int turn = 0; turn < RINGS * FRACTION_COUNT * PLACES && !boxes[i].is_placed; turn++) {
            int row = turn / PLACES;
            move_to(&boxes[i], row / FRACTION_COUNT, FRACTIONS[row % FRACTION_COUNT],
                    turn % PLACES);
            boxes[i].is_placed = is_free(&boxes[i], boxes, i, width, height);
        }
    }
}
