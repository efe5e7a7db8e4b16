/**
 * @file
 * @brief What a ray of a ray tree met.
 */
#include "render/ray_hit.h"

#include "base/language.h"
#include "dioptre/scene_words.h"

#include <libintl.h>
#include <math.h>
#include <stdio.h>

const char *ray_hit_keyword(const Scene *scene, const RayTreeNode *ray) {
    return scene_shape_keywords[scene->shapes[ray->shape].class_index]->name;
}

void ray_hit_name(const Scene *scene, const RayTreeNode *ray, char name[RAY_HIT_NAME_SIZE]) {
    if (!ray->is_hit) {
        snprintf(name, RAY_HIT_NAME_SIZE, "%s", gettext("nothing but the sky"));
    } else if (ray->shape < 0) {
        snprintf(name, RAY_HIT_NAME_SIZE, gettext("lamp %d"), ray->light + 1);
    } else if (scene->shapes[ray->shape].origin.line > 0) {
        snprintf(name, RAY_HIT_NAME_SIZE, gettext("the %s of line %d"),
                 scene_word(ray_hit_keyword(scene, ray)), scene->shapes[ray->shape].origin.line);
    } else {
        snprintf(name, RAY_HIT_NAME_SIZE, gettext("%s number %d"),
                 scene_word(ray_hit_keyword(scene, ray)), ray->shape + 1);
    }
}

bool ray_is_in_glass(const RayTreeNode *ray) {
    return ray->surface.is_transparent && ray->surface.is_inside;
}

double ray_incidence_angle(const RayTreeNode *ray) {
    return acos(fmin(1, ray->surface.cosine)) * (180 / M_PI);
}

bool ray_is_through_glass(const RayTreeNode *ray) {
    Rgbd left = ray->transmittance;
    return ray->kind == RAY_SHADOW && !ray->is_hit &&
           (left.red < 1 || left.green < 1 || left.blue < 1);
}
