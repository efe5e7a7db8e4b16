/**
 * @file
 * @brief An upper bound of the light that any ray can bring back. The theory is in doc/cutoff.md.
 */
#include "dioptre/scene.h"

/** The channels of a colour, one after the other. */
typedef struct Channels {
    double value[3]; /**< Red, green, blue. */
} Channels;

/** @return The channels of a colour. */
static Channels channels_of(Rgbd color) {
    return (Channels){{color.red, color.green, color.blue}};
}

/** @return The largest channel. */
static double channels_max(Channels color) {
    return fmax(color.value[0], fmax(color.value[1], color.value[2]));
}

/* --- textures --------------------------------------------------------------------------------- */

double texture_peak(const Texture *texture) {
    size_t count = TEXEL_CHANNELS * (size_t)texture->width * (size_t)texture->height;
    const float *texels = texture->is_hdr ? texture_hdr_texels(texture) : NULL;
    float peak = texels ? 0 : 1;
    for (size_t i = 0; texels && i < count; i++) {
        peak = texels[i] > peak ? texels[i] : peak;
    }
    return (double)peak;
}

/** @return The largest texel of a texture; 1 without one. @param texture_id Index plus one. */
static double peak_of(const double *texture_peaks, size_t texture_id) {
    return texture_id ? texture_peaks[texture_id - 1] : 1;
}

/* --- distances -------------------------------------------------------------------------------- */

/** @return The distance of a point from a box; 0 inside. */
static double box_distance(Aabbd box, Vec3d p) {
    Vec3d away = {fmax(0, fmax(box.low.x - p.x, p.x - box.high.x)),
                  fmax(0, fmax(box.low.y - p.y, p.y - box.high.y)),
                  fmax(0, fmax(box.low.z - p.z, p.z - box.high.z))};
    return vec3d_length(away);
}

/** @return A point before a transform, in the coordinates of the shape. */
static Vec3d untransform_point(const Transform *t, Vec3d p) {
    // The columns of the matrix are at right angles, each as long as its scale.
    Vec3d v = vec3d_subtract(p, t->translate);
    const double scale[3] = {t->scale.x, t->scale.y, t->scale.z};
    double out[3];
    for (int column = 0; column < 3; column++) {
        Vec3d axis = {t->matrix[0][column], t->matrix[1][column], t->matrix[2][column]};
        out[column] = vec3d_dot(axis, v) / (scale[column] * scale[column]);
    }
    return (Vec3d){out[0], out[1], out[2]};
}

double scene_shape_distance(const Scene *scene, const SceneShape *shape, Vec3d point) {
    const SceneShapeClass *class = scene_shape_classes[shape->class_index];
    const Transform *t = shape->transform;
    Vec3d local = t ? untransform_point(t, point) : point;
    ShapeFacts facts = class->facts(shape->parameters, scene);
    double distance = box_distance(facts.bounds, local);
    if (class->distance && (distance == 0 || !facts.mesh)) {
        distance = fmax(distance, class->distance(shape->parameters, scene, local));
    }
    double least_scale = t ? fmin(fabs(t->scale.x), fmin(fabs(t->scale.y), fabs(t->scale.z))) : 1;
    return distance * least_scale;
}

/* --- lights ----------------------------------------------------------------------------------- */

/**
 * @return The largest factor of a light's intensity on a shape.
 * @param least_distance  Shorter distances count as this, scene units.
 */
static double light_gain(const Scene *scene, const SceneLight *light, const SceneShape *shape,
                         double least_distance) {
    const SceneLightClass *class = scene_light_classes[light->class_index];
    if (light->falloff == FALLOFF_NONE || !class->center) {
        return 1;
    }
    SceneLightSize size = class->size ? class->size(light) : (SceneLightSize){0, 0};
    double distance = scene_shape_distance(scene, shape, class->center(light)) - size.reach;
    distance = fmax(distance, least_distance);
    if (light->falloff == FALLOFF_INVERSE_LINEAR) {
        return 1 / (light->falloff_constant + distance);
    }
    // A surface of radiance L = I / area gives at most 2 pi L, from all of the hemisphere.
    return 1 / fmax(distance * distance, size.area / (2 * M_PI));
}

/** @return The largest sum of all lights on a shape. */
static Channels shape_irradiance(const Scene *scene, const SceneShape *shape,
                                 double least_distance) {
    Channels sum = {{0}};
    for (size_t i = 0; i < scene->light_count; i++) {
        const SceneLight *light = &scene->lights[i];
        Channels color = channels_of(light->color);
        double gain = light->intensity * light_gain(scene, light, shape, least_distance);
        for (int c = 0; c < 3; c++) {
            sum.value[c] += color.value[c] * gain;
        }
    }
    return sum;
}

/** @return The largest radiance of a light that is seen; 0 if it is not. */
static double light_radiance(const SceneLight *light) {
    const SceneLightClass *class = scene_light_classes[light->class_index];
    bool is_visible = class->size && class->size(light).area > 0;
    return is_visible ? light->intensity * channels_max(channels_of(light->color)) : 0;
}

/* --- the bound -------------------------------------------------------------------------------- */

/**
 * @return The largest radiance L of a shape whose mirror images and contents are no brighter than
 *         itself: L = emission + rest local + (1 - rest) L, where rest is what the surface neither
 *         reflects nor transmits. Channels where it is 0 are left to shape_glow().
 */
static double shape_radiance(const Scene *scene, const SceneShape *shape,
                             const double *texture_peaks, double least_distance) {
    const SceneMaterial *material = &scene->materials[shape->material_index];
    Channels light = shape_irradiance(scene, shape, least_distance);
    Channels color = channels_of(material->color), emission = channels_of(material->emission);
    Channels ambient = channels_of(scene->ambient);
    Channels reflected = channels_of(material->reflectivity);
    Channels transmitted = channels_of(material->transparency);
    double peak = peak_of(texture_peaks, material->texture_id), largest = 0;
    for (int c = 0; c < 3; c++) {
        double rest = fmax(0, 1 - reflected.value[c] - transmitted.value[c]);
        double local =
            color.value[c] * peak *
                (material->ambient * ambient.value[c] + material->diffuse * light.value[c]) +
            material->specular * light.value[c];
        largest = rest > 0 ? fmax(largest, local + emission.value[c] / rest) : largest;
    }
    return largest;
}

/** @return What a shape that glows and keeps no light adds to a ray in all its turns. */
static double shape_glow(const Scene *scene, const SceneShape *shape) {
    const SceneMaterial *material = &scene->materials[shape->material_index];
    Channels emission = channels_of(material->emission);
    Channels reflected = channels_of(material->reflectivity);
    Channels transmitted = channels_of(material->transparency);
    double largest = 0;
    for (int c = 0; c < 3; c++) {
        bool keeps_light = reflected.value[c] + transmitted.value[c] < 1;
        largest = keeps_light ? largest : fmax(largest, emission.value[c]);
    }
    return largest * (DEPTH_MAXIMUM + 1);
}

double scene_radiance_bound(const Scene *scene, const double *texture_peaks) {
    const SceneCamera *camera = &scene->camera;
    const SceneSky *sky = &scene->sky;
    double bound = sky->texture_id ? peak_of(texture_peaks, sky->texture_id)
                                   : fmax(channels_max(channels_of(sky->horizon)),
                                          channels_max(channels_of(sky->zenith)));
    // Nearer to a lamp than half a pixel at the distance looked at, brighter spots are too small
    // to be seen as such.
    double pixel = 2 * tan(camera->fov / 2 * (M_PI / 180)) / scene->image.width;
    double least_distance = fmax(LENGTH_MINIMUM, pixel / 2 * camera->target_distance);
    double glow = 0;
    for (size_t i = 0; i < scene->light_count; i++) {
        bound = fmax(bound, light_radiance(&scene->lights[i]));
    }
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneShape *shape = &scene->shapes[i];
        bound = fmax(bound, shape_radiance(scene, shape, texture_peaks, least_distance));
        glow = fmax(glow, shape_glow(scene, shape));
    }
    return bound + glow;
}
