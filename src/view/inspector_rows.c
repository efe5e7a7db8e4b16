/**
 * @file
 * @brief Numbers of rays in rows.
 */
#include "view/inspector_rows.h"

#include "dioptre/language.h"

#include <libintl.h>
#include <stdarg.h>

/** Rays that are named at most: those around the chosen one. */
enum { NAMED_MAXIMUM = 9 };

/** @return A new row; NULL where there is no more room. @param[in,out] inspector The inspector. */
static PanelRow *row_new(Inspector *inspector) {
    if (inspector->row_count == INSPECTOR_ROWS) {
        return NULL;
    }
    char *text = inspector->texts[inspector->row_count];
    PanelRow *row = &inspector->rows[inspector->row_count++];
    *row = (PanelRow){.text = text};
    return row;
}

/** Adds a row. @param[in,out] inspector The inspector. @param label Its label, in English, or "" (of
 *  which gettext() makes the catalogue's header); NULL: it is a heading. @param format What it says, as for printf, in the user's language. */
static void __attribute__((format(printf, 3, 4)))
row_add(Inspector *inspector, const char *label, const char *format, ...) {
    PanelRow *row = row_new(inspector);
    if (row) {
        va_list arguments;
        va_start(arguments, format);
        SDL_vsnprintf(inspector->texts[row - inspector->rows], INSPECTOR_TEXT_SIZE, format,
                      arguments);
        va_end(arguments);
        row->is_heading = label == NULL;
        SDL_strlcpy(row->label, label && *label ? gettext(label) : "", sizeof row->label);
    }
}

/** Adds a row of three numbers. @param[in,out] inspector The inspector. @param label Its label.
 *  @param x One. @param y One. @param z One. */
static void row_add_three(Inspector *inspector, const char *label, double x, double y, double z) {
    row_add(inspector, label, "%.4g  %.4g  %.4g", x, y, z);
}

/** Adds a row of a colour. @param[in,out] inspector The inspector. @param label Its label.
 *  @param color It. */
static void row_add_color(Inspector *inspector, const char *label, Color color) {
    row_add_three(inspector, label, color.red, color.green, color.blue);
}

/** Says what a ray is and what it meets. @param ray The ray. @param scene The scene.
 *  @param[out] words What is said. */
static void describe(const ProbeRay *ray, const Scene *scene, char words[INSPECTOR_TEXT_SIZE]) {
    static const char *const kinds[] = {[PROBE_CAMERA] = N_("camera: %s"),
                                        [PROBE_MIRROR] = N_("mirrored: %s"),
                                        [PROBE_REFRACT] = N_("refracted: %s")};
    char name[RAY_NAME_SIZE];
    ray_name_met(scene, ray, name);
    if (ray->kind != PROBE_SHADOW) {
        SDL_snprintf(words, INSPECTOR_TEXT_SIZE, gettext(kinds[ray->kind]), name);
    } else if (ray->shape >= 0) {
        SDL_snprintf(words, INSPECTOR_TEXT_SIZE, gettext("lamp %d: behind %s"), ray->lamp + 1,
                     name);
    } else {
        SDL_snprintf(words, INSPECTOR_TEXT_SIZE,
                     ray->is_hit ? gettext("lamp %d: dark") : gettext("lamp %d: lit"),
                     ray->lamp + 1);
    }
}

/** Adds the row of a ray. @param[in,out] inspector The inspector. @param scene The scene.
 *  @param place Which ray. */
static void add_ray(Inspector *inspector, const Scene *scene, size_t place) {
    const ProbeRay *ray = &inspector->probe.rays[place];
    unsigned color = ray_style(ray)->color;
    char words[INSPECTOR_TEXT_SIZE];
    size_t index = inspector->row_count;
    int indent = 2 * SDL_min(ray->depth, 6);
    describe(ray, scene, words);
    row_add(inspector, "", "%*s%s%zu  %.90s", indent, "", place == inspector->chosen ? "▸ " : "",
            place, words);
    inspector->rows[index].has_swatch = true;
    inspector->rows[index].swatch[0] = (uint8_t)(color >> 16);
    inspector->rows[index].swatch[1] = (uint8_t)(color >> 8);
    inspector->rows[index].swatch[2] = (uint8_t)color;
}

/** Adds the rows of all rays, or of those around the chosen one. @param[in,out] inspector The
 *  inspector. @param scene The scene. */
static void add_rays(Inspector *inspector, const Scene *scene) {
    size_t count = inspector->probe.count, first = 0;
    if (count > NAMED_MAXIMUM && inspector->chosen > NAMED_MAXIMUM / 2) {
        first = SDL_min(inspector->chosen - NAMED_MAXIMUM / 2, count - NAMED_MAXIMUM);
    }
    size_t last = SDL_min(first + NAMED_MAXIMUM, count);
    for (size_t i = first; i < last; i++) {
        add_ray(inspector, scene, i);
    }
    if (last - first < count) {
        row_add(inspector, "", gettext("%zu to %zu of %zu rays"), first, last - 1, count);
    }
}

/** Adds the numbers of a surface. @param[in,out] inspector The inspector. @param ray The ray that
 *  met it. */
static void add_surface(Inspector *inspector, const ProbeRay *ray) {
    const ProbeSurface *surface = &ray->surface;
    row_add(inspector, N_("angle"), "%.2f°%s", ray_angle(ray),
            surface->is_inside ? gettext(", from inside") : "");
    if (surface->is_transparent) {
        row_add(inspector, N_("index"), "%.4g → %.4g", surface->before, surface->behind);
        row_add(inspector, N_("Fresnel"), gettext("%.4g mirrored, %.4g through"), surface->fresnel,
                1 - surface->fresnel);
    }
    row_add(inspector, N_("epsilon"), "%.3g = %.3g ulps", surface->epsilon, surface->ulps);
}

/** Adds the numbers of the chosen ray. @param[in,out] inspector The inspector. */
static void add_chosen(Inspector *inspector) {
    const ProbeRay *ray = &inspector->probe.rays[inspector->chosen];
    row_add(inspector, NULL, gettext("Ray %zu: %s"), inspector->chosen,
            gettext(ray_style(ray)->name));
    if (isfinite(ray->distance)) {
        row_add(inspector, N_("distance"), "%.5g", ray->distance);
        row_add_three(inspector, N_("point"), ray->point.x, ray->point.y, ray->point.z);
        row_add_three(inspector, N_("normal"), ray->normal.x, ray->normal.y, ray->normal.z);
    }
    if (ray->shape >= 0 && ray->kind != PROBE_SHADOW) {
        add_surface(inspector, ray);
    }
    row_add(inspector, N_("weight"), "%.4g", ray->weight);
    row_add_color(inspector, N_("brings back"), ray->color);
}

/** Adds how the camera's ray gets its colour. @param[in,out] inspector The inspector. */
static void add_sum(Inspector *inspector) {
    const ProbeRay *camera = &inspector->probe.rays[0];
    Color rest = camera->color;
    char label[PANEL_LABEL_SIZE];
    row_add(inspector, NULL, "%s", gettext("The sum of ray 0"));
    size_t sum = inspector->row_count;
    row_add(inspector, N_("of itself"), "%s", "");
    for (size_t i = 1; i < inspector->probe.count; i++) {
        const ProbeRay *ray = &inspector->probe.rays[i];
        if (ray->parent == 0 && inspector->row_count < INSPECTOR_ROWS - 1) {
            Color part = {ray->color.red * ray->share.red, ray->color.green * ray->share.green,
                          ray->color.blue * ray->share.blue};
            rest = (Color){rest.red - part.red, rest.green - part.green, rest.blue - part.blue};
            SDL_snprintf(label, sizeof label, gettext("+ ray %zu"), i);
            row_add_color(inspector, label, part);
        }
    }
    row_add_color(inspector, N_("= the pixel"), camera->color);
    SDL_snprintf(inspector->texts[sum], INSPECTOR_TEXT_SIZE, "%.4g  %.4g  %.4g", fmax(0, rest.red),
                 fmax(0, rest.green), fmax(0, rest.blue));
}

void inspector_rows_fill(Inspector *inspector, const Inspected *inspected, int x, int y) {
    Encoder encoder;
    const Color *color = &inspector->probe.rays[0].color;
    const RenderSettings *settings = &inspected->sight->settings;
    encoder_init(&encoder, (Encoding)settings->encoding);
    inspector->row_count = 0;
    row_add(inspector, NULL, gettext("Pixel %d %d: #%02x%02x%02x"), x, y,
            (unsigned)encoder_encode(&encoder, (float)color->red),
            (unsigned)encoder_encode(&encoder, (float)color->green),
            (unsigned)encoder_encode(&encoder, (float)color->blue));
    add_rays(inspector, inspected->scene);
    add_chosen(inspector);
    add_sum(inspector);
}
