/**
 * @file
 * @brief `dioptre probe`: the ray tree of a pixel as text.
 */
#include "base/language.h"
#include "base/sanitize.h"
#include "cli/commands.h"
#include "cli/probe.h"
#include "dioptre/scene.h"
#include "render/ray_drawing.h"
#include "render/ray_formula.h"
#include "render/ray_hit.h"

#include <libintl.h>
#include <stdio.h>

/** Indent of a ray per ancestor, columns. */
enum { INDENT = 2 };
/** Greatest indent: numbers must stay on the line. */
enum { INDENT_MAXIMUM = 24 };
/** Width of the labels of lines, letters. */
enum { LABEL_WIDTH = 14 };
/** Width of the labels of formulas, letters. */
enum { FORMULA_LABEL_WIDTH = 24 };
/** Bytes of the label of a term of the sum. */
enum { TERM_NAME_SIZE = 64 };

ProbePixel probe_pixel(const ProbeReport *report) {
    Encoder encoder;
    Rgbd light = report->tree->nodes[0].color;
    encoder_init(&encoder, (Encoding)report->settings.encoding);
    return (ProbePixel){{encoder_encode(&encoder, (float)light.red),
                         encoder_encode(&encoder, (float)light.green),
                         encoder_encode(&encoder, (float)light.blue)}};
}

/** Begins a line under a ray. */
static void begin_line(int indent, const char *label) {
    printf("%*s", indent, "");
    print_padded(gettext(label), LABEL_WIDTH);
}

/** Prints a line of three numbers. */
static void print_three(int indent, const char *label, double x, double y, double z,
                        const char *words) {
    begin_line(indent, label);
    printf("%12.6g%12.6g%12.6g%s%s\n", x, y, z, *words ? "  " : "", *words ? gettext(words) : "");
}

/** Prints a line of a colour. */
static void print_color(int indent, const char *label, Rgbd color, const char *words) {
    print_three(indent, label, color.red, color.green, color.blue, words);
}

/** Prints refraction at a transparent surface. */
static void print_glass(int indent, const RayTreeSurface *surface) {
    begin_line(indent, N_("index"));
    printf(gettext("%12.6g before it, %.6g behind it"), surface->ior_from, surface->ior_to);
    puts(surface->is_overridden ? gettext(": a later shape is there, and this surface is not")
                                : "");
    begin_line(indent, N_("Fresnel"));
    if (surface->is_total) {
        printf(gettext("%12d: all is mirrored, the angle is too flat to get out\n"), 1);
    } else {
        printf(gettext("%12.6g of the light is mirrored, %.6g goes through\n"), surface->fresnel,
               1 - surface->fresnel);
    }
}

/** Prints the offset of rays that leave a surface. */
static void print_epsilon(int indent, const RayTreeSurface *surface) {
    begin_line(indent, N_("epsilon"));
    printf(gettext("%12.4g = %.4g ulps: so far from it the next rays start\n"), surface->epsilon,
           surface->ulps);
}

/** Prints the optics of a surface that was hit. */
static void print_surface(int indent, const RayTreeNode *ray) {
    begin_line(indent, N_("angle"));
    printf(gettext("%12.6g degrees from the normal"), ray_incidence_angle(ray));
    puts(ray_is_in_glass(ray) ? gettext(", from inside") : "");
    if (ray->surface.is_transparent) {
        print_glass(indent, &ray->surface);
    }
    print_epsilon(indent, &ray->surface);
}

/** Prints a hit. */
static void print_hit(int indent, const RayTreeNode *ray) {
    begin_line(indent, N_("distance"));
    printf("%12.6g\n", ray->distance);
    print_three(indent, N_("point"), ray->point.x, ray->point.y, ray->point.z, "");
    print_three(indent, N_("normal"), ray->normal.x, ray->normal.y, ray->normal.z, "");
}

/** @return The indent of a ray's lines. */
static int ray_indent(const RayTreeNode *ray) {
    int indent = INDENT * ray->depth;
    return indent < INDENT_MAXIMUM ? indent : INDENT_MAXIMUM;
}

/** Prints a shadow ray. */
static void print_shadow(const ProbeReport *report, size_t index) {
    const RayTreeNode *ray = &report->tree->nodes[index];
    int indent = ray_indent(ray);
    char name[RAY_HIT_NAME_SIZE];
    printf("%*s%zu  ", indent, "", index);
    printf(gettext("shadow ray to lamp %d: "), ray->light + 1);
    if (ray->shape >= 0) {
        ray_hit_name(report->scene, ray, name);
        printf(gettext("%s is in its way, at %.6g\n"), name, ray->distance);
    } else if (ray->is_hit) {
        puts(gettext("nothing is left of the light behind glass"));
    } else {
        bool is_filtered = ray->transmittance.red < 1 || ray->transmittance.green < 1 ||
                           ray->transmittance.blue < 1;
        fputs(is_filtered ? gettext("only glass is in its way") : gettext("nothing is in its way"),
              stdout);
        isinf(ray->limit) ? puts("") : printf(gettext(", over %.6g\n"), ray->limit);
        print_color(indent + INDENT, N_("adds"), ray->color, "");
    }
}

/** Prints a camera or secondary ray. */
static void print_traced_ray(const ProbeReport *report, size_t index) {
    static const char *const names[] = {[RAY_CAMERA] = N_("camera ray meets %s\n"),
                                        [RAY_REFLECTION] = N_("mirrored ray meets %s\n"),
                                        [RAY_REFRACTION] = N_("refracted ray meets %s\n")};
    const RayTreeNode *ray = &report->tree->nodes[index];
    int indent = ray_indent(ray), inner = indent + INDENT;
    char name[RAY_HIT_NAME_SIZE];
    ray_hit_name(report->scene, ray, name);
    printf("%*s%zu  ", indent, "", index);
    printf(gettext(names[ray->kind]), name);
    if (ray->is_hit) {
        print_hit(inner, ray);
    }
    if (ray->shape >= 0) {
        print_surface(inner, ray);
    }
    if (ray->kind != RAY_CAMERA) {
        begin_line(inner, N_("weight"));
        printf(gettext("%12.6g of the pixel at most\n"), ray->throughput);
        print_color(inner, N_("share"), ray->weight, "");
    }
    print_color(inner, N_("brings back"), ray->color, "");
}

/** Prints the rays, each after its parent. */
static void print_rays(const ProbeReport *report) {
    for (size_t i = 0; i < report->tree->count; i++) {
        if (report->tree->nodes[i].kind == RAY_SHADOW) {
            print_shadow(report, i);
        } else {
            print_traced_ray(report, i);
        }
    }
}

/** @return Emitted and reflected ambient light of a surface. */
static Rgbd emitted_and_ambient(const RayTreeSurface *surface) {
    const Rgbd *albedo = &surface->albedo, *ambient = &surface->ambient, *own = &surface->emission;
    return (Rgbd){own->red + albedo->red * ambient->red,
                  own->green + albedo->green * ambient->green,
                  own->blue + albedo->blue * ambient->blue};
}

/** @return The product of two colours. */
static Rgbd multiply_colors(Rgbd a, Rgbd b) {
    return (Rgbd){a.red * b.red, a.green * b.green, a.blue * b.blue};
}

/** Prints the sum that makes the colour of the camera ray. */
static void print_sum(const ProbeReport *report) {
    const RayTreeNode *camera = &report->tree->nodes[0];
    bool is_own = report->settings.method_set == METHODS_OWN;
    char label[TERM_NAME_SIZE];
    fputs(gettext("\nThe sum of ray 0, linear light:\n"), stdout);
    if (camera->shape < 0) {
        print_color(INDENT, camera->is_hit ? N_("the lamp") : N_("the sky"), camera->local_color,
                    "");
    } else if (!is_own) {
        print_color(INDENT, N_("of itself"), camera->local_color,
                    N_("its own light and that of the lamps"));
    } else if (!camera->surface.is_overridden) {
        print_color(INDENT, N_("of itself"), emitted_and_ambient(&camera->surface),
                    N_("its own light and that from everywhere"));
    }
    for (size_t i = 1; i < report->tree->count; i++) {
        const RayTreeNode *ray = &report->tree->nodes[i];
        if (ray->parent == 0 && (is_own || ray->kind != RAY_SHADOW)) {
            snprintf(label, sizeof label, gettext("+ ray %zu"), i);
            print_color(INDENT, label, multiply_colors(ray->color, ray->weight),
                        ray->kind == RAY_SHADOW ? "" : N_("what it brings back, times its share"));
        }
    }
    if (ray_tree_has_merged_light(report->tree)) {
        print_color(INDENT, N_("+ merged rays"), report->tree->merged_light,
                    N_("light of rays that are not listed: merged, or estimated"));
    }
    print_color(INDENT, N_("= the pixel"), camera->color,
                report->settings.trace.methods & METHOD_MEAN_OF_RAYS
                    ? N_("the mean of all rays: the sum over their number")
                    : "");
    ProbePixel pixel = probe_pixel(report);
    printf("%*s%12d%12d%12d  ", INDENT + LABEL_WIDTH, "", pixel.channels[0], pixel.channels[1],
           pixel.channels[2]);
    printf(gettext("of 255 in the picture: #%02x%02x%02x\n"), (unsigned)pixel.channels[0],
           (unsigned)pixel.channels[1], (unsigned)pixel.channels[2]);
}

void probe_print(const ProbeReport *report) {
    const RenderSettings *settings = &report->settings;
    sanitize_print_line(report->path, stdout);
    printf(gettext(": pixel %d %d of %d x %d, engine %s, offset %s, depth %d\n"), report->x,
           report->y, settings->width, settings->height, settings->engine->name,
           offset_strategy_names[settings->trace.offset], settings->trace.depth);
    if (settings->samples > 1) {
        printf(
            gettext(
                "Its first sample of %d, through its middle: the pixel is the mean of them all.\n"),
            settings->samples);
    }
    if (settings->trace.pixel_point != PIXEL_CENTER) {
        printf(gettext("Rays go %s.\n"), gettext(pixel_point_name(settings->trace.pixel_point)));
    }
    if (settings->method_set != METHODS_OWN) {
        printf(gettext("Drawn %s: %s.\n"), gettext(method_set_name(settings->method_set)),
               gettext(method_set_effect(settings->method_set)));
    }
    putchar('\n');
    print_rays(report);
    print_sum(report);
}

/** Prints formulas, one per line. */
static void print_formulas(const RayFormulas *formulas) {
    for (size_t i = 0; i < formulas->count; i++) {
        printf("%*s", INDENT, "");
        print_padded(formulas->items[i].label, FORMULA_LABEL_WIDTH);
        puts(formulas->items[i].text);
    }
    if (formulas->omitted > 0) {
        printf(gettext("and %zu more"), formulas->omitted);
        putchar('\n');
    }
}

void probe_print_ray(const ProbeReport *report) {
    const size_t index = (size_t)report->ray;
    const RayFormulaInput input = {report->scene, report->tree,
                                   report->settings.trace.methods == 0};
    RayFormulas formulas;
    printf(gettext("Ray %zu: %s"), index, gettext(ray_style(&report->tree->nodes[index])->name));
    putchar('\n');
    ray_formulas_write(&input, index, &formulas);
    print_formulas(&formulas);
    putchar('\n');
    printf(gettext("The sum of ray %zu"), index);
    putchar('\n');
    ray_sum_write(&input, index, &formulas);
    print_formulas(&formulas);
}
