/**
 * @file
 * @brief Textures: their memory.
 */
#include "dioptre/scene.h"

#include "dioptre/parameter.h"

#include <sys/mman.h>

size_t texture_block_size(const Texture *head) {
    size_t channel = head->is_hdr ? sizeof(float) : sizeof(uint8_t);
    return sizeof *head + (size_t)head->width * (size_t)head->height * TEXEL_CHANNELS * channel;
}

Texture *texture_create(int width, int height, bool is_hdr, Error *error) {
    const Texture head = {.width = width, .height = height, .is_hdr = is_hdr, .reference_count = 1};
    Texture *texture = mmap(NULL, texture_block_size(&head), PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (texture == MAP_FAILED) {
        error_set(error, STATUS_FAILED, "no memory for a picture of %d x %d pixels", width, height);
        return NULL;
    }
    *texture = head;
    return texture;
}

Texture *texture_retain(Texture *texture) {
    if (texture) {
        atomic_fetch_add(&texture->reference_count, 1);
    }
    return texture;
}

void texture_release(Texture *texture) {
    if (texture && atomic_fetch_sub(&texture->reference_count, 1) == 1) {
        munmap(texture, texture_block_size(texture));
    }
}

void texture_sanitize(Texture *texture) {
    const float brightest = (float)INTENSITY_MAXIMUM;
    if (!texture->is_hdr) {
        return;
    }
    float *texels = texture_hdr_texels(texture);
    size_t count = (size_t)texture->width * (size_t)texture->height * TEXEL_CHANNELS;
    for (size_t i = 0; i < count; i++) {
        float clean = texels[i] > 0 ? texels[i] : 0; // 0 for NaN, too.
        texels[i] = clean < brightest ? clean : brightest;
    }
}
