/**
 * @file
 * @brief Media: which transparent shapes rays are inside of, and what the index of refraction is
 *        there.
 *
 * Where shapes overlap, the one that comes later in the scene is there, and the earlier is not: a
 * bubble is a ball of air after the glass that it is in. So a ray need not know in which order it
 * has entered shapes, only which ones it is in (Schmidt and Budge, *Simple Nested Dielectrics in
 * Ray Traced Images*, 2002, with the scene's order as priority).
 */
#ifndef DIOPTRE_TRACE_MEDIA_H
#define DIOPTRE_TRACE_MEDIA_H

#include "trace/departure.h"
#include "trace/shape_list.h"
#include "trace/surface.h"

/** Most shapes that a ray is inside of at once; of more, those that come first in the scene are
 *  forgotten. */
enum { MEDIA_MAXIMUM = 8 };

/** The transparent shapes that LANES rays are inside of. */
typedef struct Media {
    integer places[MEDIA_MAXIMUM]; /**< Their places, the last of the scene first; then -1. */
} Media;

/** What a scene has of glass. */
typedef struct Glass {
    scalar *indices;  /**< Of refraction: air's, then each shape's, 0 where it is opaque; owned.
                           NULL: there is no glass. */
    ShapeList clear;  /**< The transparent shapes. */
    ShapeList opaque; /**< The others. */
    Media at_eye;     /**< What the camera is inside of. */
    bool hides;       /**< Whether a later shape may hide a tinted surface from a lamp's light. */
} Glass;

/** @return Nothing but air. */
INLINE Media media_air(void) {
    Media media;
    for (int i = 0; i < MEDIA_MAXIMUM; i++) {
        media.places[i] = integer_of(-1);
    }
    return media;
}

/** Takes shapes out. @param[in,out] media What rays are inside of. @param leaving The lanes that
 *  leave. @param place What they leave, whether they are in it or not. */
INLINE void media_leave(Media *media, mask leaving, integer place) {
    mask is_behind = mask_of(false);
    for (int i = 0; i < MEDIA_MAXIMUM; i++) {
        is_behind |= leaving & (media->places[i] == place);
        integer next = i + 1 < MEDIA_MAXIMUM ? media->places[i + 1] : integer_of(-1);
        media->places[i] = integer_select(is_behind, next, media->places[i]);
    }
}

/** Puts shapes in. @param[in,out] media What rays are inside of. @param entering The lanes that
 *  enter. @param place What they enter, whether they are in it already or not. */
INLINE void media_enter(Media *media, mask entering, integer place) {
    media_leave(media, entering, place);
    integer next = integer_select(entering, place, integer_of(-1));
    for (int i = 0; i < MEDIA_MAXIMUM; i++) {
        mask is_later = next > media->places[i];
        integer here = media->places[i];
        media->places[i] = integer_select(is_later, next, here);
        next = integer_select(is_later, here, next);
    }
}

/** @return Place of the shape that rays are in: of several, the last of the scene; -1: air.
 *  @param media What they are inside of. */
INLINE integer media_place(const Media *media) {
    return media->places[0];
}

/**
 * Takes rays over surfaces. Whoever leaves a shape was inside, whoever enters it was not, whatever
 * has been noted before.
 * @param[in,out] media  What the rays are inside of.
 * @param ray            The rays.
 * @param hit            The surfaces.
 * @param lanes          The lanes that met a transparent one.
 * @return Place of the medium before the surface.
 */
INLINE integer media_cross(Media *media, const Ray *ray, const Hit *hit, mask lanes) {
    mask leaves = vector_dot(ray->direction, hit->normal) > 0;
    mask leaving = lanes & leaves, entering = lanes & mask_not(leaves);
    Media here = *media;
    media_enter(&here, leaving, hit->shape);
    media_leave(&here, entering, hit->shape);
    media_leave(media, leaving, hit->shape);
    media_enter(media, entering, hit->shape);
    return media_place(&here);
}

/**
 * Aims a jump over a surface, backwards: from where rays behind it start to where those before it
 * do.
 * @param far     See #departure_far.
 * @param hit     The surface.
 * @param facing  Its normal, on the side that the rays come from.
 * @param lanes   The lanes that jump.
 * @param v       Which vector of the packet.
 * @param[in,out] jumps  The jumps.
 */
INLINE void jump_aim(real far, const Hit *hit, Vector facing, mask lanes, int v, Packet *jumps) {
    Vector before = vector_add(hit->point, vector_scale(facing, far));
    Vector behind = vector_add(hit->point, vector_scale(facing, -THROUGH_BOUNDS * far));
    jumps->rays[v] = ray_of(behind, vector_subtract(before, behind));
    jumps->active[v] = lanes & (far > 0);
    jumps->limit[v] = real_of(1);
}

/** @return Indices of refraction. @param glass The scene's. @param place See #media_place. */
INLINE real glass_index(const Glass *glass, integer place) {
    return real_gather(glass->indices, place + 1);
}

/**
 * Sorts a scene's shapes into transparent and opaque ones.
 * @param[out] glass  What the scene has; give it back with #glass_release.
 * @param scene       The scene.
 * @param list        Its shapes, which must live longer.
 * @param settings    Whether there are trees, and who builds them.
 * @return false without memory.
 */
bool glass_init(Glass *glass, const Scene *scene, const ShapeList *list,
                const TraceSettings *settings);

/** Finds whether any tinted shape meets a later transparent one: whether the boxes around them do.
 *  @param[in,out] glass What the scene has. @param surfaces All materials. */
void glass_survey(Glass *glass, const Surface *surfaces);

/** Gives indices and lists back. @param glass What the scene has. */
void glass_release(Glass *glass);

/**
 * Finds what the camera is inside of. No shape is asked for it: rays along the axes tell, by the
 * side on which the nearest of them meets a shape.
 * @param[in,out] glass  What the scene has; at_eye is filled.
 * @param eye            Where the camera is.
 */
void glass_look(Glass *glass, Vector eye);

/**
 * Sets right what rays are inside of, where they jump over a surface: every surface that lies in
 * the jump is crossed, also those that the first one hides.
 * @param glass  What the scene has.
 * @param jumps  From the end of each jump back to its start: the end is inside of a shape whose
 *               inside is seen first on the way back.
 * @param[in,out] media  What the rays are inside of.
 */
void glass_jump(const Glass *glass, const Packet *jumps, Media *media);

#endif
