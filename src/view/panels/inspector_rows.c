/**
 * @file
 * @brief Numbers of rays in rows.
 */
#include "view/panels/inspector.h"

#include "base/language.h"
#include "render/ray_drawing.h"

#include <libintl.h>
#include <stdarg.h>

/** Rays that are named at most: those around the chosen one. */
enum { LISTED_RAYS_MAXIMUM = 9 };

/** @return A new row; NULL where there is no more room. */
static PanelRow *new_row(Inspector *inspector) {
    if (inspector->row_count == INSPECTOR_ROWS) {
        return NULL;
    }
    char *text = inspector->row_texts[inspector->row_count];
    PanelRow *row = &inspector->rows[inspector->row_count++];
    *row = (PanelRow){.text = text};
    return row;
}

/**
 * Adds a row.
 * @param label  Its label, in English, or "" (of which gettext() makes the catalogue's header);
 *         NULL: it is a heading.
 * @param format  What it says, as for printf, in the user's language.
 */
static void __attribute__((format(printf, 3, 4)))
row_add(Inspector *inspector, const char *label, const char *format, ...) {
    PanelRow *row = new_row(inspector);
    if (row) {
        va_list arguments;
        va_start(arguments, format);
        SDL_vsnprintf(inspector->row_texts[row - inspector->rows], INSPECTOR_TEXT_SIZE, format,
                      arguments);
        va_end(arguments);
        row->is_heading = label == NULL;
        SDL_strlcpy(row->label, label && *label ? gettext(label) : "", sizeof row->label);
    }
}

/** Adds a row of three numbers. */
static void row_add_vector(Inspector *inspector, const char *label, double x, double y, double z) {
    row_add(inspector, label, "%.4g  %.4g  %.4g", x, y, z);
}

/** Adds a row of a colour. */
static void row_add_color(Inspector *inspector, const char *label, Rgbd color) {
    row_add_vector(inspector, label, color.red, color.green, color.blue);
}

/** Says what a ray is and what it meets. */
static void describe_ray(const RayTreeNode *ray, const Scene *scene,
                         char text[INSPECTOR_TEXT_SIZE]) {
    static const char *const kinds[] = {[RAY_CAMERA] = N_("camera: %s"),
                                        [RAY_REFLECTION] = N_("mirrored: %s"),
                                        [RAY_REFRACTION] = N_("refracted: %s")};
    char name[RAY_HIT_NAME_SIZE];
    ray_hit_name(scene, ray, name);
    if (ray->kind != RAY_SHADOW) {
        SDL_snprintf(text, INSPECTOR_TEXT_SIZE, gettext(kinds[ray->kind]), name);
    } else if (ray->shape >= 0) {
        SDL_snprintf(text, INSPECTOR_TEXT_SIZE, gettext("lamp %d: behind %s"), ray->light + 1,
                     name);
    } else {
        SDL_snprintf(text, INSPECTOR_TEXT_SIZE,
                     ray->is_hit ? gettext("lamp %d: dark") : gettext("lamp %d: lit"),
                     ray->light + 1);
    }
}

/** Adds the row of a ray. */
static void add_ray_row(Inspector *inspector, const Scene *scene, size_t ray_index) {
    const RayTreeNode *ray = &inspector->ray_tree.nodes[ray_index];
    unsigned color = ray_style(ray)->color;
    char text[INSPECTOR_TEXT_SIZE];
    size_t index = inspector->row_count;
    int indent = 2 * SDL_min(ray->depth, 6);
    describe_ray(ray, scene, text);
    row_add(inspector, "", "%*s%s%zu  %.90s", indent, "",
            ray_index == inspector->selected ? "▸ " : "", ray_index, text);
    inspector->rows[index].has_swatch = true;
    inspector->rows[index].swatch[0] = (uint8_t)(color >> 16);
    inspector->rows[index].swatch[1] = (uint8_t)(color >> 8);
    inspector->rows[index].swatch[2] = (uint8_t)color;
}

/** Adds the rows of all rays, or of those around the chosen one. */
static void add_ray_rows(Inspector *inspector, const Scene *scene) {
    size_t count = inspector->ray_tree.count, first = 0;
    if (count > LISTED_RAYS_MAXIMUM && inspector->selected > LISTED_RAYS_MAXIMUM / 2) {
        first = SDL_min(inspector->selected - LISTED_RAYS_MAXIMUM / 2, count - LISTED_RAYS_MAXIMUM);
    }
    size_t last = SDL_min(first + LISTED_RAYS_MAXIMUM, count);
    for (size_t i = first; i < last; i++) {
        add_ray_row(inspector, scene, i);
    }
    if (last - first < count) {
        row_add(inspector, "", gettext("%zu to %zu of %zu rays"), first, last - 1, count);
    }
}

/** Adds the numbers of a surface. @param ray The ray that met it. */
static void add_surface_rows(Inspector *inspector, const RayTreeNode *ray) {
    const RayTreeSurface *surface = &ray->surface;
    row_add(inspector, N_("angle"), "%.2f°%s", ray_incidence_angle(ray),
            surface->is_inside ? gettext(", from inside") : "");
    if (surface->is_transparent) {
        row_add(inspector, N_("index"), "%.4g → %.4g", surface->ior_from, surface->ior_to);
        row_add(inspector, N_("Fresnel"), gettext("%.4g mirrored, %.4g through"), surface->fresnel,
                1 - surface->fresnel);
    }
    row_add(inspector, N_("epsilon"), "%.3g = %.3g ulps", surface->epsilon, surface->ulps);
}

/** Adds the numbers of the chosen ray. */
static void add_selected_ray(Inspector *inspector) {
    const RayTreeNode *ray = &inspector->ray_tree.nodes[inspector->selected];
    row_add(inspector, NULL, gettext("Ray %zu: %s"), inspector->selected,
            gettext(ray_style(ray)->name));
    if (isfinite(ray->distance)) {
        row_add(inspector, N_("distance"), "%.5g", ray->distance);
        row_add_vector(inspector, N_("point"), ray->point.x, ray->point.y, ray->point.z);
        row_add_vector(inspector, N_("normal"), ray->normal.x, ray->normal.y, ray->normal.z);
    }
    if (ray->shape >= 0 && ray->kind != RAY_SHADOW) {
        add_surface_rows(inspector, ray);
    }
    row_add(inspector, N_("weight"), "%.4g", ray->throughput);
    row_add_color(inspector, N_("brings back"), ray->color);
}

/** Adds how the camera's ray gets its colour. */
static void add_sum_rows(Inspector *inspector) {
    const RayTreeNode *camera = &inspector->ray_tree.nodes[0];
    Rgbd own_color = camera->color;
    char label[PANEL_LABEL_SIZE];
    row_add(inspector, NULL, "%s", gettext("The sum of ray 0"));
    size_t sum_row = inspector->row_count;
    row_add(inspector, N_("of itself"), "%s", "");
    for (size_t i = 1; i < inspector->ray_tree.count; i++) {
        const RayTreeNode *ray = &inspector->ray_tree.nodes[i];
        if (ray->parent == 0 && inspector->row_count < INSPECTOR_ROWS - 1) {
            Rgbd contribution = {ray->color.red * ray->weight.red,
                                 ray->color.green * ray->weight.green,
                                 ray->color.blue * ray->weight.blue};
            own_color =
                (Rgbd){own_color.red - contribution.red, own_color.green - contribution.green,
                       own_color.blue - contribution.blue};
            SDL_snprintf(label, sizeof label, gettext("+ ray %zu"), i);
            row_add_color(inspector, label, contribution);
        }
    }
    row_add_color(inspector, N_("= the pixel"), camera->color);
    SDL_snprintf(inspector->row_texts[sum_row], INSPECTOR_TEXT_SIZE, "%.4g  %.4g  %.4g",
                 fmax(0, own_color.red), fmax(0, own_color.green), fmax(0, own_color.blue));
}

void inspector_rows_write(Inspector *inspector, const InspectorInput *input, int x, int y) {
    Encoder encoder;
    const Rgbd *color = &inspector->ray_tree.nodes[0].color;
    const RenderSettings *settings = &input->viewport->settings;
    encoder_init(&encoder, (Encoding)settings->encoding);
    inspector->row_count = 0;
    row_add(inspector, NULL, gettext("Pixel %d %d: #%02x%02x%02x"), x, y,
            (unsigned)encoder_encode(&encoder, (float)color->red),
            (unsigned)encoder_encode(&encoder, (float)color->green),
            (unsigned)encoder_encode(&encoder, (float)color->blue));
    add_ray_rows(inspector, input->scene);
    add_selected_ray(inspector);
    add_sum_rows(inspector);
}
