/**
 * @file
 * @brief Textures: pictures that surfaces and the sky show, as they came from a file.
 *
 * A texture lives in one block of memory, its head first, then its texels row by row from the top.
 * The block is shared with the child process that reads the file, and by count with everybody who
 * looks at it afterwards: no texel is copied.
 */
#ifndef DIOPTRE_TEXTURE_H
#define DIOPTRE_TEXTURE_H

#include "dioptre/error.h"

#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>

/** Colours of a texel: red, green, blue. */
enum { TEXEL_CHANNELS = 3 };

/** A picture to be shown. Its texels follow it in memory: #texture_ldr_texels or
 * #texture_hdr_texels. */
typedef struct Texture {
    int width;   /**< Texels, 1 to `IMAGE_SIZE_MAXIMUM`. */
    int height;  /**< Texels, 1 to `IMAGE_SIZE_MAXIMUM`. */
    bool is_hdr; /**< Whether texels are linear light, as floats; else 8-bit steps of sRGB. */
    atomic_uint reference_count; /**< How many hold it. */
} Texture;

/**
 * @return Bytes of the block that a texture lies in.
 * @param head  The texture; only its size and kind are read.
 */
size_t texture_block_size(const Texture *head);

/** @return The texels of a texture of steps. @param texture The texture. */
static inline uint8_t *texture_ldr_texels(const Texture *texture) {
    return (uint8_t *)(uintptr_t)(texture + 1);
}

/** @return The texels of a texture of light. @param texture The texture. */
static inline float *texture_hdr_texels(const Texture *texture) {
    return (float *)(uintptr_t)(texture + 1);
}

/**
 * Makes a black texture, with one owner.
 * @param width       Texels.
 * @param height      Texels.
 * @param is_hdr    Whether it holds light.
 * @param[out] error  What is wrong.
 * @return The texture, to be given back with #texture_release; NULL without memory.
 */
Texture *texture_create(int width, int height, bool is_hdr, Error *error);

/** Becomes one more owner. @param texture The texture, or NULL. @return The same. */
Texture *texture_retain(Texture *texture);

/** Gives a texture back; the last owner's call gives its memory back. @param texture It, or NULL.
 */
void texture_release(Texture *texture);

/**
 * Puts right what no light can be: NaN and what is below 0 become 0, and what is brighter than any
 * lamp may be, infinity too, becomes as bright as that.
 * @param[in,out] texture  The texture.
 */
void texture_sanitize(Texture *texture);

#endif
