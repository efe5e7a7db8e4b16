/**
 * @file
 * @brief The formulas of the rays of a pixel, with the numbers put in.
 */
#include "render/ray_formula.h"

#include "base/language.h"
#include "render/ray_hit.h"

#include <libintl.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>

/** Bytes of a vector as text with the final zero. */
enum { VECTOR_TEXT_SIZE = 56 };
/** Relative difference below which a factor counts as 1 / d². */
static const double SQUARE_TOLERANCE = 1e-3;

/** Smallest share of the light that is told. */
static const double SHARE_MINIMUM = 1e-6;

/** A vector as text. */
typedef struct VectorText {
    char text[VECTOR_TEXT_SIZE]; /**< Its coordinates. */
} VectorText;

/** @return Three numbers as text. */
static VectorText three_text(double x, double y, double z) {
    VectorText text;
    snprintf(text.text, sizeof text.text, "(%.4g, %.4g, %.4g)", x, y, z);
    return text;
}

/** @return A vector as text. */
static VectorText vector_text(Vec3d v) {
    return three_text(v.x, v.y, v.z);
}

/** @return A colour as text: one number where it is grey. */
static VectorText color_text(Rgbd color) {
    VectorText text = three_text(color.red, color.green, color.blue);
    if (color.red == color.green && color.green == color.blue) {
        snprintf(text.text, sizeof text.text, "%.4g", color.red);
    }
    return text;
}

/** @return The product of two colours. */
static Rgbd product(Rgbd a, Rgbd b) {
    return (Rgbd){a.red * b.red, a.green * b.green, a.blue * b.blue};
}

/** @return A colour times a number. */
static Rgbd scaled(Rgbd color, double factor) {
    return (Rgbd){color.red * factor, color.green * factor, color.blue * factor};
}

/** @return Whether a colour is not black. */
static bool is_bright(Rgbd color) {
    return color.red != 0 || color.green != 0 || color.blue != 0;
}

/** Adds a formula. @param label In the user's language. */
static void __attribute__((format(printf, 3, 4)))
add(RayFormulas *formulas, const char *label, const char *format, ...) {
    if (formulas->count == RAY_FORMULAS_MAXIMUM) {
        formulas->omitted++;
        return;
    }
    RayFormula *formula = &formulas->items[formulas->count++];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(formula->text, sizeof formula->text, format, arguments);
    va_end(arguments);
    snprintf(formula->label, sizeof formula->label, "%s", label);
}

/** Makes room for the last formulas: the ones before them are left out. @param count Number of the
 *  last ones. */
static void make_room(RayFormulas *formulas, size_t count) {
    while (formulas->count > RAY_FORMULAS_MAXIMUM - count) {
        formulas->count--;
        formulas->omitted++;
    }
}

Vec3d ray_front_normal(const RayTreeNode *ray) {
    return vec3d_scale(ray->normal, ray->surface.is_inside ? -1 : 1);
}

double ray_refraction_cosine(const RayTreeSurface *surface) {
    double eta = surface->ior_from / surface->ior_to, cosine = fmin(1, surface->cosine);
    double squared = 1 - eta * eta * (1 - cosine) * (1 + cosine);
    return squared < 0 ? -1 : sqrt(squared);
}

/* --- how a ray begins ------------------------------------------------------------------------- */

/** @return An angle in degrees. @param cosine Its cosine; slightly above 1 by rounding. */
static double degrees(double cosine) {
    return acos(fmax(-1, fmin(1, cosine))) * (180 / M_PI);
}

/** Adds the law that a reflected ray follows. */
static void add_reflection(const RayTreeNode *ray, const RayTreeNode *parent,
                           RayFormulas *formulas) {
    Vec3d normal = ray_front_normal(parent);
    add(formulas, gettext("reflection"), "r = d − 2 (d·n) n = %s − 2 × (%.4g) %s = %s",
        vector_text(parent->direction).text, vec3d_dot(parent->direction, normal),
        vector_text(normal).text, vector_text(ray->direction).text);
}

/** Adds the law that a refracted ray follows. */
static void add_refraction(const RayTreeNode *ray, const RayTreeNode *parent,
                           RayFormulas *formulas) {
    const RayTreeSurface *surface = &parent->surface;
    if (surface->is_overridden) {
        add(formulas, gettext("refraction"), "%s",
            gettext("none: a later shape is there, and this surface is not"));
        return;
    }
    double a = ray_incidence_angle(parent);
    double b = degrees(-vec3d_dot(ray->direction, ray_front_normal(parent)));
    add(formulas, gettext("refraction"),
        gettext("n1 sin a = n2 sin b: %.4g × sin %.2f° = %.4g × sin %.2f° = %.4g"),
        surface->ior_from, a, surface->ior_to, b, surface->ior_from * sin(a * (M_PI / 180)));
}

/** Adds what a ray counts for in the pixel. */
static void add_weight(const RayTreeNode *ray, const RayTreeNode *parent, RayFormulas *formulas) {
    add(formulas, gettext("weight"), gettext("parent's × share = %.4g × %s = %.4g"),
        parent->throughput, color_text(ray->weight).text, ray->throughput);
}

/** Adds where a ray comes from. */
static void add_begin(const RayTreeNode *ray, const RayTreeNode *parent, RayFormulas *formulas) {
    if (ray->kind == RAY_REFLECTION) {
        add_reflection(ray, parent, formulas);
    } else if (ray->kind == RAY_REFRACTION) {
        add_refraction(ray, parent, formulas);
    }
}

/* --- where it ends ---------------------------------------------------------------------------- */

/** Adds the point that a ray reaches. */
static void add_point(const RayTreeNode *ray, RayFormulas *formulas) {
    VectorText origin = vector_text(ray->origin), direction = vector_text(ray->direction);
    if (isfinite(ray->distance)) {
        add(formulas, gettext("point"), "o + t d = %s + %.5g %s = %s", origin.text, ray->distance,
            direction.text, vector_text(ray->point).text);
    } else {
        add(formulas, gettext("ray"), "o + t d = %s + t %s", origin.text, direction.text);
    }
}

/** @return The largest channel of a colour. */
static double largest_channel(Rgbd color) {
    return fmax(color.red, fmax(color.green, color.blue));
}

/** Adds what a transparent surface does with the light, in percent: the result of what follows. */
static void add_shares(const RayTreeSurface *surface, RayFormulas *formulas) {
    double mirrored = largest_channel(surface->reflect_weight);
    double refracted = surface->is_total ? 0 : largest_channel(surface->refract_weight);
    double own = 1 - mirrored - refracted;
    if (own > SHARE_MINIMUM) {
        add(formulas, gettext("result"),
            gettext(
                "%.3g %% are mirrored, %.3g %% refracted, %.3g %% show the surface's own colour"),
            100 * mirrored, 100 * refracted, 100 * own);
    } else {
        add(formulas, gettext("result"), gettext("%.3g %% are mirrored, %.3g %% refracted"),
            100 * mirrored, 100 * refracted);
    }
}

/** Adds how Fresnel's shares and the transparency of the material make the weights of both rays. */
static void add_weights(const RayTreeSurface *surface, RayFormulas *formulas) {
    if (surface->fresnel >= 1) {
        return; // Seen flat along it: nothing is refracted.
    }
    Rgbd through = scaled(surface->refract_weight, 1 / (1 - surface->fresnel));
    Rgbd glass = scaled(through, surface->fresnel), all = surface->reflect_weight;
    Rgbd mirror = {all.red - glass.red, all.green - glass.green, all.blue - glass.blue};
    bool has_mirror = largest_channel(mirror) > SHARE_MINIMUM;
    if (has_mirror) {
        add(formulas, gettext("mirrored"),
            gettext("reflectivity + transparency × R = %s + %s × %.4g = %s"),
            color_text(mirror).text, color_text(through).text, surface->fresnel,
            color_text(all).text);
    } else {
        add(formulas, gettext("mirrored"), gettext("transparency × R = %s × %.4g = %s"),
            color_text(through).text, surface->fresnel, color_text(all).text);
    }
    add(formulas, gettext("refracted"), gettext("transparency × (1 − R) = %s × %.4g = %s"),
        color_text(through).text, 1 - surface->fresnel, color_text(surface->refract_weight).text);
}

/** Adds Fresnel's shares. */
static void add_fresnel(const RayTreeSurface *surface, RayFormulas *formulas) {
    double from = surface->ior_from, to = surface->ior_to, a = surface->cosine;
    double b = ray_refraction_cosine(surface);
    if (surface->is_total || b < 0) {
        add(formulas, gettext("Fresnel"), gettext("n1 sin a / n2 = %.4g > 1: all is mirrored"),
            from * sqrt(fmax(0, 1 - a * a)) / to);
        return;
    }
    double across = (from * a - to * b) / (from * a + to * b);
    double along = (to * a - from * b) / (to * a + from * b);
    double sine = sqrt(fmax(0, 1 - a * a)), bent = from * sine / to;
    add(formulas, gettext("angle b"),
        "sin b = n1 sin a / n2 = %.4g × %.4g / %.4g = %.4g, cos b = %.4g, b = %.2f°", from, sine,
        to, bent, b, degrees(b));
    add(formulas, "r_s",
        "(n1 cos a − n2 cos b) / (n1 cos a + n2 cos b) = "
        "(%.4g × %.4g − %.4g × %.4g) / (%.4g × %.4g + %.4g × %.4g) = %.4g",
        from, a, to, b, from, a, to, b, across);
    add(formulas, "r_p",
        "(n2 cos a − n1 cos b) / (n2 cos a + n1 cos b) = "
        "(%.4g × %.4g − %.4g × %.4g) / (%.4g × %.4g + %.4g × %.4g) = %.4g",
        to, a, from, b, to, a, from, b, along);
    add(formulas, gettext("Fresnel"),
        gettext("R = (r_s² + r_p²) / 2 = %.4g is mirrored, 1 − R = %.4g goes on"), surface->fresnel,
        1 - surface->fresnel);
    add_weights(surface, formulas);
}

/** Adds what a surface does. */
static void add_surface(const RayTreeNode *ray, RayFormulas *formulas) {
    const RayTreeSurface *surface = &ray->surface;
    add(formulas, gettext("angle"), "cos a = −d·n = %.4g, a = %.2f°%s", surface->cosine,
        ray_incidence_angle(ray), ray_is_in_glass(ray) ? gettext(", from inside") : "");
    if (surface->is_transparent && surface->is_overridden) {
        add(formulas, gettext("Fresnel"), "%s",
            gettext("none: a later shape is there, and this surface is not"));
    } else if (surface->is_transparent) {
        add_fresnel(surface, formulas);
    }
    add(formulas, gettext("offset"),
        gettext("%.3g = %.3g ulps (from a number to the next): so far away the next rays start"),
        surface->epsilon, surface->ulps);
}

/* --- shadow rays ------------------------------------------------------------------------------ */

/** Writes how a light falls off. */
static void add_falloff(const RayFormulaInput *input, const RayTreeNode *ray,
                        const RayTreeNode *parent, RayFormulas *formulas) {
    const SceneLight *light = &input->scene->lights[ray->light];
    Vec3d center;
    bool has_center = scene_light_center(light, &center);
    double distance = has_center ? vec3d_length(vec3d_subtract(center, parent->point)) : 0;
    double weight = ray->falloff * distance * distance;
    if (!has_center || light->falloff == FALLOFF_NONE) {
        add(formulas, "f", gettext("%.4g: this light does not fall off"), ray->falloff);
    } else if (light->falloff == FALLOFF_INVERSE_LINEAR) {
        add(formulas, "f", "1 / (%.4g + d) = 1 / (%.4g + %.4g) = %.4g", light->falloff_constant,
            light->falloff_constant, distance, ray->falloff);
    } else if (fabs(weight - 1) < SQUARE_TOLERANCE) {
        add(formulas, "f", "1 / d² = 1 / %.4g² = %.4g", distance, ray->falloff);
    } else {
        add(formulas, "f",
            gettext("w / d² = %.4g / %.4g² = %.4g; w: how much of the lamp is seen from there"),
            weight, distance, ray->falloff);
    }
}

/** Adds what a shadow ray adds to the light of its surface. */
static void add_light(const RayFormulaInput *input, const RayTreeNode *ray,
                      const RayTreeNode *parent, RayFormulas *formulas) {
    const SceneLight *light = &input->scene->lights[ray->light];
    const RayTreeSurface *surface = &parent->surface;
    Rgbd albedo = scaled(surface->albedo, surface->diffuse);
    Rgbd intensity = product(scaled(light->color, light->intensity), ray->transmittance);
    add_falloff(input, ray, parent, formulas);
    add(formulas, gettext("diffuse"), "k I f N·L = %s × %s × %.4g × %.4g = %s",
        color_text(albedo).text, color_text(intensity).text, ray->falloff, ray->cosine,
        color_text(product(albedo, ray->diffuse)).text);
    if (is_bright(surface->specular)) {
        double largest = fmax(intensity.red, fmax(intensity.green, intensity.blue));
        double shine = fmax(ray->specular.red, fmax(ray->specular.green, ray->specular.blue));
        add(formulas, gettext("highlight"), "s I f (r·v)^m = %s × %s × %.4g × %.4g = %s",
            color_text(surface->specular).text, color_text(intensity).text, ray->falloff,
            largest > 0 ? shine / (largest * ray->falloff) : 0,
            color_text(product(surface->specular, ray->specular)).text);
    }
}

/** Adds the formulas of a shadow ray. */
static void add_shadow(const RayFormulaInput *input, const RayTreeNode *ray,
                       const RayTreeNode *parent, RayFormulas *formulas) {
    char name[RAY_HIT_NAME_SIZE];
    if (ray->shape >= 0) {
        add_point(ray, formulas);
        ray_hit_name(input->scene, ray, name);
        add(formulas, gettext("light"), gettext("0: behind %s"), name);
    } else if (ray->is_hit) {
        add(formulas, gettext("light"), "%s",
            gettext("0: nothing is left of the light behind glass"));
    } else {
        add_point(ray, formulas);
        if (ray_is_through_glass(ray)) {
            add(formulas, gettext("through glass"), gettext("%s of the light is left"),
                color_text(ray->transmittance).text);
        }
        if (input->is_own) {
            add_light(input, ray, parent, formulas);
        }
    }
}

void ray_formulas_write(const RayFormulaInput *input, size_t index, RayFormulas *formulas) {
    const RayTreeNode *ray = &input->tree->nodes[index];
    const RayTreeNode *parent = index > 0 ? &input->tree->nodes[ray->parent] : NULL;
    *formulas = (RayFormulas){0};
    if (ray->kind == RAY_SHADOW) {
        add_shadow(input, ray, parent, formulas);
        return;
    }
    if (ray->shape >= 0 && ray->surface.is_transparent && !ray->surface.is_overridden) {
        add_shares(&ray->surface, formulas);
    }
    if (parent) {
        add_begin(ray, parent, formulas);
    }
    add_point(ray, formulas);
    if (ray->shape >= 0) {
        add_surface(ray, formulas);
    }
    if (parent) {
        add_weight(ray, parent, formulas);
    }
}

/* --- the sum ---------------------------------------------------------------------------------- */

/** Adds the terms of the surface itself. */
static void add_own_terms(const RayFormulaInput *input, const RayTreeNode *ray, RayFormulas *sum) {
    const RayTreeSurface *surface = &ray->surface;
    Rgbd ambient = product(surface->albedo, surface->ambient);
    if (ray->shape < 0) {
        add(sum, ray->is_hit ? gettext("the lamp") : gettext("the sky"), "%s",
            color_text(ray->local_color).text);
    } else if (!input->is_own) {
        add(sum, gettext("of itself"), "%s", color_text(ray->local_color).text);
    } else if (!surface->is_overridden) {
        if (is_bright(surface->emission)) {
            add(sum, gettext("its own light"), "%s", color_text(surface->emission).text);
        }
        if (is_bright(ambient)) {
            add(sum, gettext("light from everywhere"),
                gettext("own colour × ambient = %s × %s = %s"), color_text(surface->albedo).text,
                color_text(surface->ambient).text, color_text(ambient).text);
        }
    }
}

/** Adds the term of a ray that a surface sends on. */
static void add_child_term(const RayTreeNode *child, size_t index, RayFormulas *sum) {
    char label[RAY_FORMULA_LABEL_SIZE];
    snprintf(label, sizeof label, gettext("+ ray %zu"), index);
    if (child->kind == RAY_SHADOW) {
        add(sum, label, "%s", color_text(child->color).text);
    } else {
        add(sum, label, "%s × %s = %s", color_text(child->weight).text,
            color_text(child->color).text, color_text(product(child->weight, child->color)).text);
    }
}

/** Adds the two terms of a shadow ray. */
static void add_shadow_terms(const RayTreeNode *ray, const RayTreeNode *parent, RayFormulas *sum) {
    const RayTreeSurface *surface = &parent->surface;
    Rgbd diffuse = product(surface->albedo, scaled(ray->diffuse, surface->diffuse));
    add(sum, gettext("diffuse"), "%s", color_text(diffuse).text);
    if (is_bright(surface->specular)) {
        add(sum, gettext("+ highlight"), "%s",
            color_text(product(surface->specular, ray->specular)).text);
    }
}

void ray_sum_write(const RayFormulaInput *input, size_t index, RayFormulas *sum) {
    const RayTree *tree = input->tree;
    const RayTreeNode *ray = &tree->nodes[index];
    char label[RAY_FORMULA_LABEL_SIZE];
    *sum = (RayFormulas){0};
    if (ray->kind != RAY_SHADOW) {
        add_own_terms(input, ray, sum);
    } else if (input->is_own) {
        add_shadow_terms(ray, &tree->nodes[ray->parent], sum);
    }
    for (size_t i = index + 1; i < tree->count; i++) {
        const RayTreeNode *child = &tree->nodes[i];
        if (child->parent == (int)index && (input->is_own || child->kind != RAY_SHADOW)) {
            add_child_term(child, i, sum);
        }
    }
    const bool has_merged = index == 0 && ray_tree_has_merged_light(tree);
    make_room(sum, has_merged ? 2 : 1); // For the result, which is the last one.
    if (has_merged) {
        add(sum, gettext("+ merged rays"), "%s", color_text(tree->merged_light).text);
    }
    snprintf(label, sizeof label, gettext("= ray %zu"), index);
    add(sum, index == 0 ? gettext("= the pixel") : label, "%s", color_text(ray->color).text);
}
