/**
 * @file
 * @brief Textures of surfaces and of the sky.
 */
#include "trace/materials/textures.h"

#include "trace/math/angle.h"

#include <stdlib.h>

/** Degrees of a whole turn. */
#define TURN_DEGREES 360

/** @return The textures of all materials; NULL if memory is exhausted. */
static Texture **material_maps_of(const Scene *scene) {
    Texture **maps = calloc(scene->material_count, sizeof *maps);
    for (size_t i = 0; maps && i < scene->material_count; i++) {
        size_t texture_index = scene->materials[i].texture_id;
        maps[i] = texture_index ? texture_retain(scene->textures[texture_index - 1].texture) : NULL;
    }
    return maps;
}

bool textures_init(Textures *textures, const Scene *scene, Error *error) {
    const SceneSky *sky = &scene->sky;
    *textures = (Textures){.material_count = scene->material_count};
    textures->sky_rotation = (scalar)(sky->rotate / TURN_DEGREES + 0.5);
    for (int step = 0; step < TEXEL_LEVELS; step++) {
        textures->srgb_to_linear[step] = (scalar)encoding_decode(ENCODING_SRGB, step);
    }
    if (sky->texture_id) {
        textures->sky = texture_retain(scene->textures[sky->texture_id - 1].texture);
    }
    if (scene_has_textures(scene)) {
        textures->material_maps = material_maps_of(scene);
        return textures->material_maps || error_set(error, STATUS_FAILED, "no memory for pictures");
    }
    return true;
}

void textures_deinit(Textures *textures) {
    for (size_t i = 0; textures->material_maps && i < textures->material_count; i++) {
        texture_release(textures->material_maps[i]);
    }
    free(textures->material_maps);
    texture_release(textures->sky);
    *textures = (Textures){0};
}

/** The positions of LANES points along one axis of a texture. */
typedef struct TexelAxis {
    real texels[2]; /**< The texels whose centres are just before and behind: whole numbers. */
    real fraction;  /**< Position between those centres, 0 to 1. */
} TexelAxis;

/**
 * @return The positions of points along an axis.
 * @param position  0 at its start, 1 at its end.
 * @param wraps  Whether the texture repeats.
 * @param size  Number of texels.
 */
INLINE TexelAxis texel_axis_of(real position, mask wraps, int size) {
    const real zero = real_of(0), last = real_of((scalar)(size - 1));
    position = real_select(wraps, position - real_floor(position), position);
    position = real_min(real_max(position, zero), real_of(1)); // NaN becomes 0.
    real texel = position * (scalar)size - (scalar)0.5f;
    real first = real_floor(texel), next = first + 1;
    // Beyond the edge is the texel of the other edge, or that of this one.
    real before = real_select(first < 0, real_select(wraps, last, zero), first);
    real behind = real_select(next > last, real_select(wraps, zero, last), next);
    return (TexelAxis){{before, behind}, texel - first};
}

/** @return The linear colour of a texel. @param row Its row, from the top. */
INLINE Rgbs texel_color(const Textures *textures, const Texture *texture, size_t column,
                        size_t row) {
    size_t index = (row * (size_t)texture->width + column) * TEXEL_CHANNELS;
    if (texture->is_hdr) {
        const float *light = texture_hdr_texels(texture) + index;
        return (Rgbs){(scalar)light[0], (scalar)light[1], (scalar)light[2]};
    }
    const uint8_t *steps = texture_ldr_texels(texture) + index;
    const scalar *light = textures->srgb_to_linear;
    return (Rgbs){light[steps[0]], light[steps[1]], light[steps[2]]};
}

/** @return Linear interpolation: a at fraction 0, b at 1. */
INLINE Rgb rgb_lerp(Rgb a, Rgb b, real fraction) {
    return (Rgb){a.red + (b.red - a.red) * fraction, a.green + (b.green - a.green) * fraction,
                 a.blue + (b.blue - a.blue) * fraction};
}

/** @return The colours of a texture, by bilinear interpolation. */
static Rgb texture_sample_bilinear(const Textures *textures, const Texture *texture,
                                   const TextureUv *uv, mask lanes) {
    const Rgb black = {real_of(0), real_of(0), real_of(0)};
    Rgb texels[4] = {black, black, black, black};
    TexelAxis x_axis = texel_axis_of(uv->u, uv->wrap_u, texture->width);
    TexelAxis y_axis = texel_axis_of(1 - uv->v, uv->wrap_v, texture->height);
    for (unsigned remaining = mask_bits(lanes); remaining; remaining &= remaining - 1) {
        int lane = __builtin_ctz(remaining);
        for (int k = 0; k < 4; k++) {
            size_t column = (size_t)(int)real_at(&x_axis.texels[k & 1], lane);
            size_t row = (size_t)(int)real_at(&y_axis.texels[k >> 1], lane);
            Rgbs color = texel_color(textures, texture, column, row);
            real_set_lane(&texels[k].red, lane, color.red);
            real_set_lane(&texels[k].green, lane, color.green);
            real_set_lane(&texels[k].blue, lane, color.blue);
        }
    }
    Rgb upper = rgb_lerp(texels[0], texels[1], x_axis.fraction);
    Rgb lower = rgb_lerp(texels[2], texels[3], x_axis.fraction);
    return rgb_lerp(upper, lower, y_axis.fraction);
}

/** @return The colours of the textures at hits; 1 where a material has none. @param hit_lanes The
 *  lanes with a hit. */
static Rgb texture_colors_at(const Textures *textures, const ShapeSet *shapes, const Hit *hit,
                             mask hit_lanes) {
    Rgb color = {real_of(1), real_of(1), real_of(1)};
    for (mask remaining = hit_lanes; any(remaining);) {
        int shape_index = integer_lane(hit->shape, mask_first(remaining));
        const Shape *shape = shapes->shapes[shape_index];
        const Texture *texture = textures->material_maps[shape->material];
        mask same = remaining & (hit->shape == integer_of(shape_index));
        if (texture) {
            TextureUv uv = shape_texture_uv(shape, hit, same);
            color = rgb_select(same, texture_sample_bilinear(textures, texture, &uv, same), color);
        }
        remaining &= mask_not(same);
    }
    return color;
}

void textures_sample(const Textures *textures, const ShapeSet *shapes, const SurfaceHit *surface,
                     Rgb *colors) {
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        colors[v] = texture_colors_at(textures, shapes, &surface->hits[v], surface->is_hit[v]);
    }
}

Rgb textures_sample_sky(const Textures *textures, Vec3 direction, mask lanes) {
    real x = direction.x, z = direction.z;
    real horizontal = real_sqrt(x * x + z * z);
    TextureUv uv = {.u = real_atan2_turns(x, -z) + real_of(textures->sky_rotation),
                    .v = 1 - 2 * real_atan2_turns(horizontal, direction.y),
                    .wrap_u = mask_of(true),
                    .wrap_v = mask_of(false)};
    return texture_sample_bilinear(textures, textures->sky, &uv, lanes);
}
