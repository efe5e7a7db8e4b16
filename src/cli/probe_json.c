/**
 * @file
 * @brief The rays of a pixel for programs.
 */
#include "cli/probe.h"

#include <stdio.h>

/** Prints a number; null where it is infinite. @param name Its name. @param x It. */
static void print_number(const char *name, double x) {
    isfinite(x) ? printf(", \"%s\": %.17g", name, x) : printf(", \"%s\": null", name);
}

/** Prints a whole number; null where it is negative: there is none. @param name Its name.
 *  @param x It. */
static void print_place(const char *name, int x) {
    x >= 0 ? printf(", \"%s\": %d", name, x) : printf(", \"%s\": null", name);
}

/** Prints three numbers. @param name Their name. @param x One. @param y One. @param z One. */
static void print_three(const char *name, double x, double y, double z) {
    printf(", \"%s\": [%.17g, %.17g, %.17g]", name, x, y, z);
}

/** Prints a vector. @param name Its name. @param v It. */
static void print_vector(const char *name, Vector3 v) {
    print_three(name, v.x, v.y, v.z);
}

/** Prints a colour. @param name Its name. @param color It. */
static void print_color(const char *name, Color color) {
    print_three(name, color.red, color.green, color.blue);
}

/** Prints a vector of what was met; null where nothing was. @param name Its name. @param v It.
 *  @param is_hit Whether anything was. */
static void print_met(const char *name, Vector3 v, bool is_hit) {
    is_hit ? print_vector(name, v) : (void)printf(", \"%s\": null", name);
}

/** Prints what a ray met besides where. @param report What is told. @param ray The ray. */
static void print_surface(const ProbeReport *report, const ProbeRay *ray) {
    const ProbeSurface *surface = &ray->surface;
    printf(", \"keyword\": \"%s\"", ray_keyword(report->scene, ray));
    int line = report->scene->shapes[ray->shape].line;
    print_place("line", line > 0 ? line : -1);
    if (ray->kind == PROBE_SHADOW) {
        return;
    }
    print_number("angle", ray_angle(ray));
    print_number("epsilon", surface->epsilon);
    print_number("ulps", surface->ulps);
    if (surface->is_transparent) {
        print_number("index_before", surface->before);
        print_number("index_behind", surface->behind);
        print_number("fresnel", surface->fresnel);
        printf(", \"total\": %s", surface->is_total ? "true" : "false");
    }
}

/** Prints a ray. @param report What is told. @param place Which. */
static void print_ray(const ProbeReport *report, size_t place) {
    static const char *const kinds[] = {"camera", "shadow", "mirror", "refract"};
    const ProbeRay *ray = &report->probe->rays[place];
    bool has_point = isfinite(ray->distance);
    printf("{\"id\": %zu", place);
    print_place("parent", ray->parent);
    printf(", \"kind\": \"%s\", \"depth\": %d", kinds[ray->kind], ray->depth);
    print_vector("origin", ray->origin);
    print_vector("direction", ray->direction);
    printf(", \"hit\": %s", ray->is_hit ? "true" : "false");
    print_place("shape", ray->shape);
    print_number("distance", ray->distance);
    print_met("point", ray->point, has_point);
    print_met("normal", ray->normal, has_point);
    print_number("weight", ray->weight);
    print_color("color", ray->color);
    print_color("own", ray->own);
    print_color("share", ray->share);
    print_place("lamp", ray->lamp);
    print_number("limit", ray->limit);
    if (ray->shape >= 0) {
        print_surface(report, ray);
    }
}

void probe_print_json(const ProbeReport *report) {
    for (size_t i = 0; i < report->probe->count; i++) {
        print_ray(report, i);
        if (i == 0) {
            ProbeSteps pixel = probe_steps(report);
            printf(", \"x\": %d, \"y\": %d, \"engine\": \"%s\", \"steps\": [%d, %d, %d]", report->x,
                   report->y, report->settings.engine->name, pixel.step[0], pixel.step[1],
                   pixel.step[2]);
        }
        puts("}");
    }
}
