/**
 * @file
 * @brief Finds the pixels of a colour in a picture: prints their centroid and number.
 *        tests/window.sh uses it to test which way the keys move objects.
 */
#include "assets/images/image_file.h"

#include <stdio.h>
#include <string.h>

/** A range of colours, 0 to 255 per channel. */
typedef struct ColorRange {
    const char *name; /**< Its name. */
    uint8_t low[3];   /**< Least red, green and blue. */
    uint8_t high[3];  /**< Greatest red, green and blue. */
} ColorRange;

/** The available colours, from the scene of the box. */
static const ColorRange ranges[] = {
    {.name = "yellow", .low = {200, 150, 0}, .high = {255, 255, 90}},   /* the leaning panel */
    {.name = "white", .low = {225, 190, 190}, .high = {255, 255, 255}}, /* the highlight */
};

/** @return Whether a pixel is in a range. */
static bool is_in(const uint8_t pixel[3], const ColorRange *range) {
    for (int i = 0; i < 3; i++) {
        if (pixel[i] < range->low[i] || pixel[i] > range->high[i]) {
            return false;
        }
    }
    return true;
}

/** Prints the centroid of the pixels of a range, x and y, and their number. */
static void print_middle(const Picture *picture, const ColorRange *range) {
    double x_sum = 0, y_sum = 0, count = 0;
    const uint8_t *pixel = picture->pixels;
    for (int y = 0; y < picture->height; y++) {
        for (int x = 0; x < picture->width; x++, pixel += 3) {
            if (is_in(pixel, range)) {
                x_sum += x;
                y_sum += y;
                count++;
            }
        }
    }
    printf("%.3f %.3f %.0f\n", x_sum / count, y_sum / count, count);
}

/** The program: `picture_probe FILE COLOR`. @return 0, or 1 for an unknown file or colour. */
int main(int argc, char **argv) {
    Picture picture = {0};
    Error error = {0};
    if (argc != 3 || !image_file_read(argv[1], &picture, &error)) {
        fprintf(stderr, "picture_probe FILE COLOR: %s\n", error.message);
        return 1;
    }
    int status = 1;
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        if (strcmp(ranges[i].name, argv[2]) == 0) {
            print_middle(&picture, &ranges[i]);
            status = 0;
        }
    }
    picture_deinit(&picture);
    return status;
}
