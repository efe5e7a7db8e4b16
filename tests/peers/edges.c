/**
 * @file
 * @brief Compares two pictures: counts the differing pixels and those of them near edges.
 *
 * Two exact ray tracers agree except where a ray passes an edge so closely that rounding decides
 * the side. So every differing pixel should be near an edge.
 *
 * Usage: `edges OURS.bmp THEIRS.bmp`; prints the numbers of pixels, of differing pixels, and of
 * differing pixels that are near no edge.
 */
#include "assets/images/bmp.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

/** Allowed difference of a channel, 8-bit steps: two roundings of the same light. */
enum { STEPS_ALLOWED = 1 };
/**
 * Difference of neighbours that counts as an edge, 8-bit steps: shading alone changes far less per
 * pixel.
 */
enum { EDGE_STEPS = 4 };
/** Bytes per pixel. */
enum { CHANNELS = 3 };

/** The counts. */
typedef struct Counts {
    long pixels;    /**< All pixels. */
    long off;       /**< Those that differ by more than `STEPS_ALLOWED` in a channel. */
    long elsewhere; /**< Differing pixels without an edge nearby. */
} Counts;

/** @return The channels of a pixel. */
static const uint8_t *pixel_at(const Picture *picture, int x, int y) {
    return picture->pixels + ((size_t)y * (size_t)picture->width + (size_t)x) * CHANNELS;
}

/** @return The largest difference of a channel, 8-bit steps. */
static int difference(const uint8_t *a, const uint8_t *b) {
    int largest = 0;
    for (int channel = 0; channel < CHANNELS; channel++) {
        int steps = abs(a[channel] - b[channel]);
        largest = steps > largest ? steps : largest;
    }
    return largest;
}

/**
 * Tests whether an edge passes near a pixel: whether its neighbours differ from each other. The
 * pixel itself is excluded: a single wrong pixel would make its own edge.
 * @return Whether there is an edge.
 */
static bool is_on_edge(const Picture *picture, int x, int y) {
    uint8_t low[CHANNELS] = {UINT8_MAX, UINT8_MAX, UINT8_MAX};
    uint8_t high[CHANNELS] = {0};
    for (int index = 0; index < 9; index++) {
        int column = x + index % 3 - 1;
        int row = y + index / 3 - 1;
        bool is_inside =
            row >= 0 && row < picture->height && column >= 0 && column < picture->width;
        if (!is_inside || (column == x && row == y)) {
            continue;
        }
        const uint8_t *pixel = pixel_at(picture, column, row);
        for (int channel = 0; channel < CHANNELS; channel++) {
            low[channel] = pixel[channel] < low[channel] ? pixel[channel] : low[channel];
            high[channel] = pixel[channel] > high[channel] ? pixel[channel] : high[channel];
        }
    }
    return difference(low, high) > EDGE_STEPS;
}

/** @return The counts over all pixels. */
static Counts count(const Picture *image, const Picture *other_image) {
    Counts counts = {.pixels = (long)image->width * image->height};
    for (int y = 0; y < image->height; y++) {
        for (int x = 0; x < image->width; x++) {
            if (difference(pixel_at(image, x, y), pixel_at(other_image, x, y)) > STEPS_ALLOWED) {
                counts.off++;
                counts.elsewhere += !is_on_edge(image, x, y);
            }
        }
    }
    return counts;
}

/** Reads a BMP file; ends the program on failure. @return The picture. */
static Picture read_or_exit(const char *path) {
    Error error = {0};
    Picture picture = {0};
    int file = open(path, O_RDONLY);
    if (file < 0 || !bmp_read(file, &picture, &error)) {
        fprintf(stderr, "edges: cannot read %s: %s\n", path, error.message);
        exit(EXIT_FAILURE);
    }
    close(file);
    return picture;
}

/**
 * Compares two files.
 * @param arguments  The program, our picture, the peer's.
 * @return 0, or 1 if they cannot be compared.
 */
int main(int count_of_arguments, char **arguments) {
    if (count_of_arguments != 3) {
        fprintf(stderr, "usage: edges OURS.bmp THEIRS.bmp\n");
        return EXIT_FAILURE;
    }
    Picture image = read_or_exit(arguments[1]);
    Picture other_image = read_or_exit(arguments[2]);
    if (image.width != other_image.width || image.height != other_image.height) {
        fprintf(stderr, "edges: the pictures are not of the same size\n");
        return EXIT_FAILURE;
    }
    Counts counts = count(&image, &other_image);
    printf("%ld %ld %ld\n", counts.pixels, counts.off, counts.elsewhere);
    picture_deinit(&image);
    picture_deinit(&other_image);
    return EXIT_SUCCESS;
}
