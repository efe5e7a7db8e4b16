/**
 * @file
 * @brief The rays of a pixel in words.
 */
#include "cli/commands.h"
#include "cli/probe.h"

#include <stdio.h>
#include <string.h>

/** Columns that a ray is moved in for each ray before it. */
enum { INDENT = 2 };
/** Most columns that rays are moved in: numbers must stay on the line. */
enum { INDENT_MAXIMUM = 24 };
/** Longest name of a thing of the scene, bytes. */
enum { THING_SIZE = 64 };

ProbeSteps probe_steps(const ProbeReport *report) {
    Encoder encoder;
    Color light = report->probe->rays[0].color;
    encoder_init(&encoder, (Encoding)report->settings.encoding);
    return (ProbeSteps){{encoder_encode(&encoder, (float)light.red),
                         encoder_encode(&encoder, (float)light.green),
                         encoder_encode(&encoder, (float)light.blue)}};
}

const char *probe_shape(const ProbeReport *report, const ProbeRay *ray) {
    return report->settings.engine->shape_keywords[report->scene->shapes[ray->shape].kind]->name;
}

double probe_angle(const ProbeRay *ray) {
    return acos(fmin(1, ray->surface.cosine)) * (180 / M_PI);
}

/** Names what a ray met. @param report What is told. @param ray The ray. @param[out] name Its name.
 */
static void name_met(const ProbeReport *report, const ProbeRay *ray, char name[THING_SIZE]) {
    if (ray->shape < 0) {
        snprintf(name, THING_SIZE, "lamp %d", ray->lamp + 1);
        return;
    }
    int line = report->scene->shapes[ray->shape].line;
    const char *keyword = probe_shape(report, ray);
    if (line > 0) {
        snprintf(name, THING_SIZE, "the %s of line %d", keyword, line);
    } else {
        snprintf(name, THING_SIZE, "%s number %d", keyword, ray->shape + 1);
    }
}

/** Begins a line under a ray. @param indent Columns. @param what What it tells. */
static void begin_line(int indent, const char *what) {
    printf("%*s%-13s", indent, "", what);
}

/** Prints a line of three numbers. @param indent Columns. @param what What they are. @param x One.
 *  @param y One. @param z One. @param words What follows. */
static void print_three(int indent, const char *what, double x, double y, double z,
                        const char *words) {
    begin_line(indent, what);
    printf("%12.6g%12.6g%12.6g%s\n", x, y, z, words);
}

/** Prints a line of a colour. @param indent Columns. @param what What it is. @param color It.
 *  @param words What follows. */
static void print_color(int indent, const char *what, Color color, const char *words) {
    print_three(indent, what, color.red, color.green, color.blue, words);
}

/** Prints what becomes of a ray at glass. @param indent Columns. @param surface The surface. */
static void print_glass(int indent, const ProbeSurface *surface) {
    begin_line(indent, "index");
    printf("%12.6g before it, %.6g behind it%s\n", surface->before, surface->behind,
           surface->is_hidden ? ": a later shape is there, and this surface is not" : "");
    begin_line(indent, "Fresnel");
    if (surface->is_total) {
        printf("%12s all is mirrored: the angle is too flat to get out\n", "1");
    } else {
        printf("%12.6g of the light is mirrored, %.6g goes through\n", surface->fresnel,
               1 - surface->fresnel);
    }
}

/** Prints how far from a surface rays start. @param indent Columns. @param surface The surface. */
static void print_epsilon(int indent, const ProbeSurface *surface) {
    begin_line(indent, "epsilon");
    printf("%12.4g = %.4g ulps: so far from it the next rays start\n", surface->epsilon,
           surface->ulps);
}

/** Prints the numbers of a surface that was met. @param indent Columns. @param ray The ray. */
static void print_surface(int indent, const ProbeRay *ray) {
    begin_line(indent, "angle");
    printf("%12.6g degrees from the normal%s\n", probe_angle(ray),
           ray->surface.is_inside ? ", from inside" : "");
    if (ray->surface.is_transparent) {
        print_glass(indent, &ray->surface);
    }
    print_epsilon(indent, &ray->surface);
}

/** Prints where a ray met something. @param indent Columns. @param ray The ray. */
static void print_where(int indent, const ProbeRay *ray) {
    begin_line(indent, "distance");
    printf("%12.6g\n", ray->distance);
    print_three(indent, "point", ray->point.x, ray->point.y, ray->point.z, "");
    print_three(indent, "normal", ray->normal.x, ray->normal.y, ray->normal.z, "");
}

/** @return Columns of a ray's lines. @param ray The ray. */
static int ray_indent(const ProbeRay *ray) {
    int indent = INDENT * ray->depth;
    return indent < INDENT_MAXIMUM ? indent : INDENT_MAXIMUM;
}

/** Prints a shadow ray. @param report What is told. @param place Which. */
static void print_shadow(const ProbeReport *report, size_t place) {
    const ProbeRay *ray = &report->probe->rays[place];
    int indent = ray_indent(ray);
    char name[THING_SIZE];
    printf("%*s%zu  shadow ray to lamp %d: ", indent, "", place, ray->lamp + 1);
    if (ray->shape >= 0) {
        name_met(report, ray, name);
        printf("%s is in its way, at %.6g\n", name, ray->distance);
    } else if (ray->is_hit) {
        printf("nothing is left of the light behind glass\n");
    } else {
        bool is_filtered = ray->passed.red < 1 || ray->passed.green < 1 || ray->passed.blue < 1;
        isinf(ray->limit) ? printf("nothing is in its way")
                          : printf("nothing is in its way, over %.6g", ray->limit);
        printf("%s\n", is_filtered ? " but glass" : "");
        print_color(indent + INDENT, "adds", ray->color, "");
    }
}

/** Prints a ray that looks. @param report What is told. @param place Which. */
static void print_look(const ProbeReport *report, size_t place) {
    static const char *const names[] = {
        [PROBE_CAMERA] = "camera", [PROBE_MIRROR] = "mirrored", [PROBE_REFRACT] = "refracted"};
    const ProbeRay *ray = &report->probe->rays[place];
    int indent = ray_indent(ray), inner = indent + INDENT;
    char name[THING_SIZE] = "nothing but the sky";
    if (ray->is_hit) {
        name_met(report, ray, name);
    }
    printf("%*s%zu  %s ray meets %s\n", indent, "", place, names[ray->kind], name);
    if (ray->is_hit) {
        print_where(inner, ray);
    }
    if (ray->shape >= 0) {
        print_surface(inner, ray);
    }
    if (ray->kind != PROBE_CAMERA) {
        begin_line(inner, "weight");
        printf("%12.6g of the pixel at most\n", ray->weight);
        print_color(inner, "share", ray->share, "");
    }
    print_color(inner, "brings back", ray->color, "");
}

/** Prints the rays, each behind the one that it comes from. @param report What is told. */
static void print_rays(const ProbeReport *report) {
    for (size_t i = 0; i < report->probe->count; i++) {
        if (report->probe->rays[i].kind == PROBE_SHADOW) {
            print_shadow(report, i);
        } else {
            print_look(report, i);
        }
    }
}

/** @return What a surface sends back of light of its own and of light from everywhere.
 *  @param surface The surface. */
static Color light_of_itself(const ProbeSurface *surface) {
    const Color *body = &surface->body, *ambient = &surface->ambient, *own = &surface->emission;
    return (Color){own->red + body->red * ambient->red, own->green + body->green * ambient->green,
                   own->blue + body->blue * ambient->blue};
}

/** @return a times b, primary by primary. @param a Light. @param b Shares. */
static Color color_times(Color a, Color b) {
    return (Color){a.red * b.red, a.green * b.green, a.blue * b.blue};
}

/** Prints how the camera's ray got its colour. @param report What is told. */
static void print_sum(const ProbeReport *report) {
    const ProbeRay *camera = &report->probe->rays[0];
    char what[THING_SIZE];
    printf("\nThe sum of ray 0, linear light:\n");
    if (camera->shape < 0) {
        print_color(INDENT, camera->is_hit ? "the lamp" : "the sky", camera->own, "");
    } else if (!camera->surface.is_hidden) {
        print_color(INDENT, "of itself", light_of_itself(&camera->surface),
                    "  its own light and that from everywhere");
    }
    for (size_t i = 1; i < report->probe->count; i++) {
        const ProbeRay *ray = &report->probe->rays[i];
        if (ray->parent == 0) {
            snprintf(what, sizeof what, "+ ray %zu", i);
            print_color(INDENT, what, color_times(ray->color, ray->share),
                        ray->kind == PROBE_SHADOW ? "" : "  what it brings back, times its share");
        }
    }
    print_color(INDENT, "= the pixel", camera->color, "");
    ProbeSteps pixel = probe_steps(report);
    printf("%*s%-13s%12d%12d%12d  of 255 in the picture, #%02x%02x%02x\n", INDENT, "", "",
           pixel.step[0], pixel.step[1], pixel.step[2], pixel.step[0], pixel.step[1],
           pixel.step[2]);
}

void probe_print(const ProbeReport *report) {
    const RenderSettings *settings = &report->settings;
    print_clean(report->path, stdout);
    printf(": pixel %d %d of %d x %d, engine %s, offset %s, depth %d\n", report->x, report->y,
           settings->width, settings->height, settings->engine->name,
           offset_name(settings->trace.offset), settings->trace.depth);
    if (settings->samples > 1) {
        printf("Its first sample of %d, through its middle: the pixel is the mean of them all.\n",
               settings->samples);
    }
    putchar('\n');
    print_rays(report);
    print_sum(report);
}
