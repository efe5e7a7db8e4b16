/**
 * @file
 * @brief The rays of a pixel for programs.
 */
#include "cli/probe.h"

#include <stdio.h>

/** Prints a number; null where it is infinite. */
static void print_number(const char *name, double x) {
    isfinite(x) ? printf(", \"%s\": %.17g", name, x) : printf(", \"%s\": null", name);
}

/** Prints a whole number; null where it is negative: there is none. */
static void print_index(const char *name, int x) {
    x >= 0 ? printf(", \"%s\": %d", name, x) : printf(", \"%s\": null", name);
}

/** Prints three numbers. */
static void print_three(const char *name, double x, double y, double z) {
    printf(", \"%s\": [%.17g, %.17g, %.17g]", name, x, y, z);
}

/** Prints a vector. */
static void print_vector(const char *name, Vec3d v) {
    print_three(name, v.x, v.y, v.z);
}

/** Prints a colour. */
static void print_color(const char *name, Rgbd color) {
    print_three(name, color.red, color.green, color.blue);
}

/** Prints a vector of what was met; null where nothing was. */
static void print_vector_if_hit(const char *name, Vec3d v, bool is_hit) {
    is_hit ? print_vector(name, v) : (void)printf(", \"%s\": null", name);
}

/** Prints what a ray met besides where. */
static void print_surface(const ProbeReport *report, const RayTreeNode *ray) {
    const RayTreeSurface *surface = &ray->surface;
    printf(", \"keyword\": \"%s\"", ray_hit_keyword(report->scene, ray));
    int line = report->scene->shapes[ray->shape].line;
    print_index("line", line > 0 ? line : -1);
    if (ray->kind == RAY_SHADOW) {
        return;
    }
    print_number("angle", ray_incidence_angle(ray));
    print_number("epsilon", surface->epsilon);
    print_number("ulps", surface->ulps);
    if (surface->is_transparent) {
        print_number("index_before", surface->ior_from);
        print_number("index_behind", surface->ior_to);
        print_number("fresnel", surface->fresnel);
        printf(", \"total\": %s", surface->is_total ? "true" : "false");
    }
}

/** Prints a ray. */
static void print_ray(const ProbeReport *report, size_t index) {
    static const char *const kinds[] = {"camera", "shadow", "mirror", "refract"};
    const RayTreeNode *ray = &report->tree->nodes[index];
    bool has_point = isfinite(ray->distance);
    printf("{\"id\": %zu", index);
    print_index("parent", ray->parent);
    printf(", \"kind\": \"%s\", \"depth\": %d", kinds[ray->kind], ray->depth);
    print_vector("origin", ray->origin);
    print_vector("direction", ray->direction);
    printf(", \"hit\": %s", ray->is_hit ? "true" : "false");
    print_index("shape", ray->shape);
    print_number("distance", ray->distance);
    print_vector_if_hit("point", ray->point, has_point);
    print_vector_if_hit("normal", ray->normal, has_point);
    print_number("weight", ray->throughput);
    print_color("color", ray->color);
    print_color("own", ray->local_color);
    print_color("share", ray->weight);
    print_index("lamp", ray->light);
    print_number("limit", ray->limit);
    if (ray->shape >= 0) {
        print_surface(report, ray);
    }
}

void probe_print_json(const ProbeReport *report) {
    for (size_t i = 0; i < report->tree->count; i++) {
        print_ray(report, i);
        if (i == 0) {
            ProbePixel pixel = probe_pixel(report);
            printf(", \"x\": %d, \"y\": %d, \"engine\": \"%s\", \"steps\": [%d, %d, %d]", report->x,
                   report->y, report->settings.engine->name, pixel.channels[0], pixel.channels[1],
                   pixel.channels[2]);
        }
        puts("}");
    }
}
