/**
 * @file
 * @brief Pictures on surfaces and in the sky.
 */
#include "trace/texture.h"

#include "trace/angle.h"

#include <stdlib.h>

/** Degrees of a whole turn. */
#define TURN_DEGREES 360

/** @return Places for the pictures of all materials; NULL without memory. @param scene The scene.
 */
static Texture **worn_of(const Scene *scene) {
    Texture **worn = calloc(scene->material_count, sizeof *worn);
    for (size_t i = 0; worn && i < scene->material_count; i++) {
        size_t place = scene->materials[i].texture;
        worn[i] = place ? texture_share(scene->textures[place - 1].texture) : NULL;
    }
    return worn;
}

bool textures_init(Textures *textures, const Scene *scene, Error *error) {
    const Sky *sky = &scene->sky;
    *textures = (Textures){.material_count = scene->material_count};
    textures->turn = (scalar)(sky->rotate / TURN_DEGREES + 0.5);
    for (int step = 0; step < TEXEL_STEPS; step++) {
        textures->light[step] = (scalar)encoding_decode(ENCODING_SRGB, step);
    }
    if (sky->image) {
        textures->sky = texture_share(scene->textures[sky->image - 1].texture);
    }
    if (scene_has_textures(scene)) {
        textures->worn = worn_of(scene);
        return textures->worn || error_set(error, STATUS_FAILED, "no memory for pictures");
    }
    return true;
}

void textures_release(Textures *textures) {
    for (size_t i = 0; textures->worn && i < textures->material_count; i++) {
        texture_release(textures->worn[i]);
    }
    free(textures->worn);
    texture_release(textures->sky);
    *textures = (Textures){0};
}

/** Where LANES points lie along one edge of a picture. */
typedef struct TexelRow {
    real first;  /**< The texel whose middle is just before; -1 to #size - 1. */
    real share;  /**< How far from there to the middle of the next, 0 to 1. */
    mask around; /**< Where the last texel is followed by the first. */
    int size;    /**< How many texels. */
} TexelRow;

/**
 * @return Where points lie along an edge.
 * @param at      0 at its beginning, 1 at its end.
 * @param around  Where it goes on beyond.
 * @param size    How many texels it has.
 */
INLINE TexelRow texel_row_of(real at, mask around, int size) {
    at = real_select(around, at - real_floor(at), at);
    at = real_min(real_max(at, real_of(0)), real_of(1)); // 0 where it is no number.
    real texel = at * (scalar)size - (scalar)0.5f;
    real first = real_floor(texel);
    return (TexelRow){first, texel - first, around, size};
}

/** @return A texel along an edge. @param row Where. @param lane Which point's. @param next Whether
 *  the second of the two that it lies between. */
INLINE size_t texel_row_at(const TexelRow *row, int lane, bool next) {
    int texel = (int)real_lane(row->first, lane) + next, last = row->size - 1;
    bool is_around = mask_lane(row->around, lane);
    return (size_t)(texel < 0      ? (is_around ? last : 0)
                    : texel > last ? (is_around ? 0 : last)
                                   : texel);
}

/** @return A texel's light. @param textures The pictures. @param texture One of them.
 *  @param column Which texel. @param row Which, from the top. */
INLINE Scalar3 texel_light(const Textures *textures, const Texture *texture, size_t column,
                           size_t row) {
    size_t place = (row * (size_t)texture->width + column) * TEXEL_CHANNELS;
    if (texture->is_light) {
        const float *light = texture_light(texture) + place;
        return (Scalar3){(scalar)light[0], (scalar)light[1], (scalar)light[2]};
    }
    const uint8_t *steps = texture_steps(texture) + place;
    const scalar *light = textures->light;
    return (Scalar3){light[steps[0]], light[steps[1]], light[steps[2]]};
}

/** @return Light between two lights. @param a One. @param b The other. @param share How near to the
 *  second. */
INLINE Light3 light3_between(Light3 a, Light3 b, real share) {
    return (Light3){a.red + (b.red - a.red) * share, a.green + (b.green - a.green) * share,
                    a.blue + (b.blue - a.blue) * share};
}

/**
 * @return What a picture shows: between the four texels around each point.
 * @param textures  The pictures.
 * @param texture   One of them.
 * @param place     Where.
 * @param lanes     The lanes that count.
 */
static Light3 texture_sample(const Textures *textures, const Texture *texture,
                             const TexturePlace *place, mask lanes) {
    const Light3 dark = {real_of(0), real_of(0), real_of(0)};
    Light3 texels[4] = {dark, dark, dark, dark};
    TexelRow across = texel_row_of(place->u, place->around_u, texture->width);
    TexelRow down = texel_row_of(1 - place->v, place->around_v, texture->height);
    for (unsigned left = mask_bits(lanes); left; left &= left - 1) {
        int lane = __builtin_ctz(left);
        size_t columns[2] = {texel_row_at(&across, lane, 0), texel_row_at(&across, lane, 1)};
        size_t rows[2] = {texel_row_at(&down, lane, 0), texel_row_at(&down, lane, 1)};
        for (int k = 0; k < 4; k++) {
            Scalar3 light = texel_light(textures, texture, columns[k & 1], rows[k >> 1]);
            real_set_lane(&texels[k].red, lane, light.red);
            real_set_lane(&texels[k].green, lane, light.green);
            real_set_lane(&texels[k].blue, lane, light.blue);
        }
    }
    Light3 upper = light3_between(texels[0], texels[1], across.share);
    Light3 lower = light3_between(texels[2], texels[3], across.share);
    return light3_between(upper, lower, down.share);
}

/** @return What the pictures show at LANES points; 1 where there is none. @param textures The
 *  pictures. @param list The shapes. @param hit The points. @param met The lanes that met any. */
static Light3 points_paint(const Textures *textures, const ShapeList *list, const Hit *hit,
                           mask met) {
    Light3 paint = {real_of(1), real_of(1), real_of(1)};
    for (mask left = met; any(left);) {
        int place = integer_lane(hit->shape, mask_first(left));
        const Shape *shape = list->shapes[place];
        const Texture *texture = textures->worn[shape->material];
        mask same = left & (hit->shape == integer_of(place));
        if (texture) {
            TexturePlace where = shape_texture_place(shape, hit, same);
            paint = light3_select(same, texture_sample(textures, texture, &where, same), paint);
        }
        left &= mask_not(same);
    }
    return paint;
}

void textures_paint(const Textures *textures, const ShapeList *list, const Encounter *met,
                    Light3 *paint) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        paint[v] = points_paint(textures, list, &met->hits[v], met->met[v]);
    }
}

Light3 textures_panorama(const Textures *textures, Vector direction, mask lanes) {
    real x = direction.x, z = direction.z;
    real across = real_sqrt(x * x + z * z);
    TexturePlace place = {.u = angle_in_turns(x, -z) + real_of(textures->turn),
                          .v = 1 - 2 * angle_in_turns(across, direction.y),
                          .around_u = mask_of(true),
                          .around_v = mask_of(false)};
    return texture_sample(textures, textures->sky, &place, lanes);
}
