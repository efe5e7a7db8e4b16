/**
 * @file
 * @brief `dioptre probe --json`: the ray tree of a pixel, one object per ray.
 */
#include "base/json.h"
#include "cli/probe.h"
#include "render/ray_hit.h"

/** Writes a number so that it can be read back exactly. */
static void write_exact(JsonWriter *json, const char *name, double value) {
    json_number(json, name, value, JSON_EXACT_DIGITS);
}

/** Writes an index; null where it is negative: there is none. */
static void write_index(JsonWriter *json, const char *name, int index) {
    index >= 0 ? json_integer(json, name, index) : json_null(json, name);
}

/** Writes a vector. */
static void write_vector(JsonWriter *json, const char *name, Vec3d v) {
    json_numbers(json, name, (const double[]){v.x, v.y, v.z}, 3, JSON_EXACT_DIGITS);
}

/** Writes a colour. */
static void write_color(JsonWriter *json, const char *name, Rgbd color) {
    json_numbers(json, name, (const double[]){color.red, color.green, color.blue}, 3,
                 JSON_EXACT_DIGITS);
}

/** Writes a point or a normal of the hit; null without a hit. */
static void write_hit_vector(JsonWriter *json, const char *name, Vec3d v, bool is_hit) {
    is_hit ? write_vector(json, name, v) : json_null(json, name);
}

/** Writes the shape that a ray hit and the optics of its surface. */
static void write_surface(JsonWriter *json, const ProbeReport *report, const RayTreeNode *ray) {
    const RayTreeSurface *surface = &ray->surface;
    json_string(json, "keyword", ray_hit_keyword(report->scene, ray));
    int line = report->scene->shapes[ray->shape].origin.line;
    write_index(json, "line", line > 0 ? line : -1);
    if (ray->kind == RAY_SHADOW) {
        return;
    }
    write_exact(json, "angle", ray_incidence_angle(ray));
    write_exact(json, "epsilon", surface->epsilon);
    write_exact(json, "ulps", surface->ulps);
    if (surface->is_transparent) {
        write_exact(json, "index_before", surface->ior_from);
        write_exact(json, "index_behind", surface->ior_to);
        write_exact(json, "fresnel", surface->fresnel);
        json_bool(json, "total", surface->is_total);
    }
}

/** Writes the members that only the first object has: pixel, engine, merged light and 8-bit colour.
 */
static void write_pixel(JsonWriter *json, const ProbeReport *report) {
    ProbePixel pixel = probe_pixel(report);
    json_integer(json, "x", report->x);
    json_integer(json, "y", report->y);
    json_string(json, "engine", report->settings.engine->name);
    json_string(json, "pixel", pixel_point_words[report->settings.trace.pixel_point]);
    json_string(json, "methods", method_set_words[report->settings.method_set]);
    write_color(json, "merged", report->tree->merged_light);
    json_array_begin(json, "steps");
    for (int channel = 0; channel < 3; channel++) {
        json_integer(json, NULL, pixel.channels[channel]);
    }
    json_array_end(json);
}

/** Writes a ray. */
static void write_ray(JsonWriter *json, const ProbeReport *report, size_t index) {
    static const char *const kinds[] = {"camera", "shadow", "mirror", "refract"};
    const RayTreeNode *ray = &report->tree->nodes[index];
    bool has_point = isfinite(ray->distance);
    json_object_begin(json, NULL);
    json_count(json, "id", index);
    write_index(json, "parent", ray->parent);
    json_string(json, "kind", kinds[ray->kind]);
    json_integer(json, "depth", ray->depth);
    write_vector(json, "origin", ray->origin);
    write_vector(json, "direction", ray->direction);
    json_bool(json, "hit", ray->is_hit);
    write_index(json, "shape", ray->shape);
    write_exact(json, "distance", ray->distance);
    write_hit_vector(json, "point", ray->point, has_point);
    write_hit_vector(json, "normal", ray->normal, has_point);
    write_exact(json, "weight", ray->throughput);
    write_color(json, "color", ray->color);
    write_color(json, "own", ray->local_color);
    write_color(json, "share", ray->weight);
    write_index(json, "lamp", ray->light);
    write_exact(json, "limit", ray->limit);
    if (ray->shape >= 0) {
        write_surface(json, report, ray);
    }
    if (index == 0) {
        write_pixel(json, report);
    }
    json_line_end(json);
}

void probe_print_json(const ProbeReport *report) {
    JsonWriter json = {.stream = stdout};
    for (size_t i = 0; i < report->tree->count; i++) {
        if (report->ray < 0 || i == (size_t)report->ray) {
            write_ray(&json, report, i);
        }
    }
}
