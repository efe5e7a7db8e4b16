/**
 * @file
 * @brief The shapes that hide the rays of a pixel from a second camera, and the scene without them.
 *
 * A closed room can only be seen into where a wall is left out. A shape that rays meet stays, as it
 * is what the view explains; of those only flat walls are left out. Transparent shapes hide
 * nothing.
 */
#ifndef DIOPTRE_RENDER_CUT_AWAY_H
#define DIOPTRE_RENDER_CUT_AWAY_H

#include "dioptre/renderer.h"

/** What is left out. Starts as `{0}`: nothing. */
typedef struct CutAway {
    bool *may_be_hidden; /**< For each shape whether it may be left out; owned. */
    bool *is_hidden;     /**< For each shape whether it is; owned. */
    SceneShape *shapes;  /**< The shapes that are left; owned; they own nothing. */
    size_t shape_count;  /**< Number of shapes of the scene. */
    size_t left_count;   /**< Number of #shapes. */
} CutAway;

/** Most shapes of a scene that is cut away: the others are built anew at each change. */
enum { CUT_AWAY_SHAPES_MAXIMUM = 4096 };

/**
 * Finds what may be left out; what was left out of this scene stays so until #cut_away_update.
 * @param[in,out] cut  A cut away of any scene, or an empty one.
 * @param scene  The scene; outlives the cut away.
 * @return false for scenes with too many shapes, or without memory: nothing is left out then.
 */
bool cut_away_begin(CutAway *cut, const Scene *scene, const RayTree *tree);

/**
 * Leaves out the shapes between a point of view and the rays.
 * @param renderer  A renderer of the whole scene.
 * @param eye       The point of view.
 * @return Whether other shapes are left out than before.
 */
bool cut_away_update(CutAway *cut, const Renderer *renderer, const Scene *scene,
                     const RayTree *tree, Vec3d eye);

/** @return Whether a shape may be left out. */
bool cut_away_may_hide(const CutAway *cut, int shape);

/** @return The scene with the shapes that are left; it owns nothing. */
Scene cut_away_scene(const CutAway *cut, const Scene *scene);

/** Frees everything. */
void cut_away_deinit(CutAway *cut);

#endif
