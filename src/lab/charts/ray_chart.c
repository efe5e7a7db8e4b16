/**
 * @file
 * @brief The rays of a pixel as a drawing.
 *
 * The scene is drawn from the second camera in a few greys, each grey one path, with a line where
 * one shape ends and another begins: faint, small and sharp in print. The rays lie over it.
 */
#include "dioptre/ray_chart.h"

#include "base/atomic_file.h"
#include "base/language.h"

#include <libintl.h>
#include <stdlib.h>

/** Units of the drawing, which are pixels of the outlines. */
enum { WIDTH = 1000, HEIGHT = 750 };
/** Units of a cell of grey. */
enum { BACKGROUND_CELL = 2 };
/** How many greys there are. */
enum { GREY_LEVELS = 12 };
/** Rays whose numbers are written, at most: more would hide the drawing. */
enum { NUMBERED_RAYS_MAXIMUM = 40 };

/** The faintest grey, of 255. */
static const double GREY_BRIGHTEST = 255;
/** The darkest grey, of 255. */
static const double GREY_DARKEST = 170;

/** What the second camera sees of the scene. */
typedef struct BackgroundRaster {
    int *shapes;       /**< The shape in each pixel, or -1; owned. */
    double *distances; /**< How far it is; owned. */
    double *rgb;       /**< Linear light of each cell, plane by plane; owned. */
} BackgroundRaster;

/** Gives a backcloth back. */
static void background_raster_deinit(BackgroundRaster *raster) {
    free(raster->shapes);
    free(raster->distances);
    free(raster->rgb);
}

/**
 * Looks at the scene.
 * @param side  The scene, with the second camera.
 * @return false without memory.
 */
static bool background_raster_trace(const Engine *engine, Tracer *tracer, const Scene *side,
                                    BackgroundRaster *raster) {
    const size_t pixels = (size_t)WIDTH * HEIGHT,
                 cells = pixels / (BACKGROUND_CELL * BACKGROUND_CELL);
    RayCounts counts = {0};
    PixelGrid all = {.columns = WIDTH, .rows = HEIGHT, .stride = 1};
    PixelGrid coarse = {.columns = WIDTH / BACKGROUND_CELL,
                        .rows = HEIGHT / BACKGROUND_CELL,
                        .stride = BACKGROUND_CELL};
    raster->shapes = malloc(pixels * sizeof *raster->shapes);
    raster->distances = malloc(pixels * sizeof *raster->distances);
    raster->rgb = malloc(3 * cells * sizeof *raster->rgb);
    if (!raster->shapes || !raster->distances || !raster->rgb) {
        return false;
    }
    engine->set_view(tracer, side, WIDTH, HEIGHT);
    engine->trace_primary(tracer, &all, raster->shapes, raster->distances);
    engine->trace(tracer, &coarse, raster->rgb, &counts);
    return true;
}

/**
 * Makes a backcloth.
 * @param[out] raster  What it sees; to be released also where anything is wrong.
 * @return Whether it is there.
 */
static bool background_raster_init(const RayChart *chart, const ProjectedView *projected,
                                   BackgroundRaster *raster, Error *error) {
    // The fastest engine is good enough for it; what is drawn of the rays is the chosen one's.
    const Engine *engine = engine_find("auto", error);
    Scene side = *chart->scene;
    side.camera = projected->camera;
    TraceSettings trace = chart->settings->trace;
    trace.samples = 1;
    *raster = (BackgroundRaster){0};
    Tracer *tracer = engine->create_tracer(&side, &trace, error);
    bool is_made = tracer && (background_raster_trace(engine, tracer, &side, raster) ||
                              error_set(error, STATUS_FAILED, "no memory for the drawing"));
    engine->destroy(tracer);
    return is_made;
}

/** @return A cell's grey: 0 is the darkest. */
static int background_cell_grey(const BackgroundRaster *raster, size_t index) {
    const size_t cells = (size_t)WIDTH * HEIGHT / (BACKGROUND_CELL * BACKGROUND_CELL),
                 columns = WIDTH / BACKGROUND_CELL;
    const double *light = raster->rgb + index;
    if (raster->shapes[index / columns * BACKGROUND_CELL * WIDTH +
                       index % columns * BACKGROUND_CELL] < 0) {
        return GREY_LEVELS - 1;
    }
    double bright = 0.2126 * light[0] + 0.7152 * light[cells] + 0.0722 * light[2 * cells];
    double step = encoding_encode(ENCODING_SRGB, fmin(fmax(bright, 0), 1));
    int grey = (int)(step * GREY_LEVELS / (ENCODING_CODE_MAXIMUM + 1));
    return grey;
}

/** Draws the cells of one grey, in runs. */
static void draw_grey(FILE *file, const BackgroundRaster *raster, int grey) {
    const int columns = WIDTH / BACKGROUND_CELL;
    double shade = GREY_DARKEST + (GREY_BRIGHTEST - GREY_DARKEST) * grey / (GREY_LEVELS - 1);
    fprintf(file, "<path fill=\"#%02x%02x%02x\" d=\"", (unsigned)shade, (unsigned)shade,
            (unsigned)shade);
    for (int row = 0; row < HEIGHT / BACKGROUND_CELL; row++) {
        const size_t first = (size_t)row * (size_t)columns;
        for (int column = 0, run; column < columns; column += run) {
            for (run = 0; column + run < columns &&
                          background_cell_grey(raster, first + (size_t)(column + run)) == grey;) {
                run++;
            }
            if (run > 0) {
                fprintf(file, "M%d %dh%dv%dh%dz", column * BACKGROUND_CELL, row * BACKGROUND_CELL,
                        run * BACKGROUND_CELL, BACKGROUND_CELL, -run * BACKGROUND_CELL);
            }
            run += run == 0;
        }
    }
    fputs("\"/>\n", file);
}

/** @return Whether one shape ends between two pixels. */
static bool background_is_edge(const BackgroundRaster *raster, int a, int b) {
    return raster->shapes[a] != raster->shapes[b];
}

/**
 * Draws the edges between the pixels of neighbouring rows, or columns, in runs.
 * @param across  Pixels along the edges.
 * @param along  Places from a pixel to the next along.
 * @param over  Places to the next across.
 */
static void draw_edges(FILE *file, const BackgroundRaster *raster, int across, int down, int along,
                       int over) {
    for (int line = 1; line < down; line++) {
        for (int at = 0, run; at < across; at += run) {
            int index = line * over + at * along;
            for (run = 0; at + run < across && background_is_edge(raster, index, index - over);) {
                run++;
                index += along;
            }
            if (run > 0 && along == 1) {
                fprintf(file, "M%d %dh%d", at, line, run);
            } else if (run > 0) {
                fprintf(file, "M%d %dv%d", line, at, run);
            }
            run += run == 0;
        }
    }
}

/** Draws the scene. @param raster What is seen of it. */
static void draw_background(FILE *file, const BackgroundRaster *raster) {
    fputs("<g shape-rendering=\"crispEdges\">\n", file);
    for (int grey = 0; grey < GREY_LEVELS; grey++) {
        draw_grey(file, raster, grey);
    }
    fputs("</g>\n<path fill=\"none\" stroke=\"#999\" stroke-width=\"1\" d=\"", file);
    draw_edges(file, raster, WIDTH, HEIGHT, 1, WIDTH);
    draw_edges(file, raster, HEIGHT, WIDTH, WIDTH, 1);
    fputs("\"/>\n", file);
}

/** Draws a line. */
static void draw_line(FILE *file, const RayStyle *style, const ProjectedRay *line) {
    fprintf(file, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#%06x\"", line->x[0], line->y[0],
            line->x[1], line->y[1], style->color);
    if (style->dash > 0) {
        fprintf(file, " stroke-dasharray=\"%g %g\"", 3 * style->dash, 3 * style->gap);
    }
    fputs("/>\n", file);
}

/** Draws an arrowhead on a line. */
static void draw_arrow(FILE *file, const RayStyle *style, const ProjectedRay *line) {
    /** Units that it is long; share of the line where its point is. */
    const double size = 11, share = 0.6;
    double x = line->x[1] - line->x[0], y = line->y[1] - line->y[0], length = hypot(x, y);
    if (length < 3 * size) {
        return;
    }
    double u = x / length, v = y / length;
    double px = line->x[0] + share * x, py = line->y[0] + share * y;
    double bx = px - size * u, by = py - size * v, half = 0.4 * size;
    fprintf(file, "<path d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fz\" fill=\"#%06x\" stroke=\"none\"/>\n",
            px, py, bx - half * v, by + half * u, bx + half * v, by - half * u, style->color);
}

/** Draws a ray. @param line Where it is seen. */
static void draw_ray(FILE *file, const ProjectedRay *line, const RayTreeNode *ray) {
    const RayStyle halo = {0xffffff, 0, 0, NULL};
    fputs("<g stroke-width=\"6\" stroke-opacity=\"0.8\">", file);
    draw_line(file, &halo, line);
    fputs("</g>", file);
    draw_line(file, ray_style(ray), line);
    draw_arrow(file, ray_style(ray), line);
}

/** Writes words with a white border. @param text The words, without <, > and &. */
static void draw_label(FILE *file, double x, double y, const char *anchor, const char *text) {
    fprintf(file,
            "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"#000\" stroke=\"#fff\" "
            "stroke-width=\"4\" paint-order=\"stroke\">%s</text>\n",
            x, y, anchor, text);
}

/** Draws all rays and their numbers. */
static void draw_rays(FILE *file, const RayChart *chart, const OrbitCamera *orbit,
                      const ProjectedView *projected) {
    const RayTree *probe = chart->probe;
    char number[16];
    ProjectedRay line;
    fputs("<g stroke-width=\"3\" fill=\"none\" stroke-linecap=\"butt\">\n", file);
    for (size_t i = probe->count; i-- > 0;) {
        if (orbit_camera_project_ray(orbit, projected, &probe->nodes[i], &line)) {
            draw_ray(file, &line, &probe->nodes[i]);
        }
    }
    fputs("</g>\n", file);
    for (size_t i = 0; i < probe->count && i < NUMBERED_RAYS_MAXIMUM; i++) {
        if (orbit_camera_project_ray(orbit, projected, &probe->nodes[i], &line)) {
            snprintf(number, sizeof number, "%zu", i);
            draw_label(file, 0.5 * (line.x[0] + line.x[1]) + 12, 0.5 * (line.y[0] + line.y[1]) - 8,
                       "middle", number);
        }
    }
}

/** Draws where a light with edges is. */
static void draw_light_outline(FILE *file, const SceneLight *light,
                               const ProjectedView *projected) {
    Vec3d points[SCENE_LIGHT_OUTLINE_POINTS];
    size_t count = scene_light_outline(light, points);
    for (size_t i = 0; i + 1 < count; i++) {
        double x[2], y[2];
        if (projected_view_point(projected, points[i], &x[0], &y[0]) &&
            projected_view_point(projected, points[i + 1], &x[1], &y[1])) {
            fprintf(file,
                    "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#f0e442\" "
                    "stroke-width=\"4\"/>\n",
                    x[0], y[0], x[1], y[1]);
        }
    }
}

/** Draws the eye and the lamps that are in the picture. */
static void draw_markers(FILE *file, const RayChart *chart, const ProjectedView *projected) {
    char words[64];
    double x, y;
    if (projected_view_point(projected, chart->probe->nodes[0].origin, &x, &y)) {
        fprintf(file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"6\" fill=\"#000\"/>\n", x, y);
        draw_label(file, x + 11, y + 6, "start", gettext("eye"));
    }
    for (size_t i = 0; i < chart->scene->light_count; i++) {
        Vec3d center;
        draw_light_outline(file, &chart->scene->lights[i], projected);
        if (scene_light_center(&chart->scene->lights[i], &center) &&
            projected_view_point(projected, center, &x, &y)) {
            fprintf(file,
                    "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"7\" fill=\"#f0e442\" stroke=\"#000\"/>\n",
                    x, y);
            snprintf(words, sizeof words, gettext("lamp %zu"), i + 1);
            draw_label(file, x + 11, y + 6, "start", words);
        }
    }
}

/** @return Whether any ray is drawn in a style. */
static bool style_is_used(const RayTree *probe, const RayStyle *style) {
    bool is_any = false;
    for (size_t i = 0; i < probe->count && !is_any; i++) {
        is_any = ray_style(&probe->nodes[i]) == style;
    }
    return is_any;
}

/** Draws the legend. */
static void draw_legend(FILE *file, const RayTree *probe) {
    double y = HEIGHT - 20;
    for (int i = RAY_STYLE_COUNT - 1; i >= 0; i--) {
        const RayStyle *style = &ray_styles()[i];
        if (style_is_used(probe, style)) {
            ProjectedRay line = {.x = {20, 75}, .y = {y - 5, y - 5}};
            fputs("<g stroke-width=\"3\">", file);
            draw_line(file, style, &line);
            fputs("</g>", file);
            draw_label(file, 85, y, "start", gettext(style->name));
            y -= 24;
        }
    }
}

/** Writes the title. @param title The title, of any letters. */
static void draw_title(FILE *file, const char *title) {
    fputs("<text x=\"20\" y=\"30\" stroke=\"#fff\" stroke-width=\"4\" paint-order=\"stroke\">",
          file);
    for (const char *c = title; *c; c++) {
        *c == '&'   ? (void)fputs("&amp;", file)
        : *c == '<' ? (void)fputs("&lt;", file)
                    : (void)fputc((unsigned char)*c < ' ' ? '?' : *c, file);
    }
    fputs("</text>\n", file);
}

/** Draws everything. @param raster What is seen of the scene. */
static void draw_all(FILE *file, const RayChart *chart, const OrbitCamera *orbit,
                     const ProjectedView *projected, const BackgroundRaster *raster) {
    fprintf(file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" "
            "font-family=\"sans-serif\" font-size=\"18\">\n"
            "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n",
            WIDTH, HEIGHT, WIDTH, HEIGHT);
    draw_background(file, raster);
    draw_rays(file, chart, orbit, projected);
    draw_markers(file, chart, projected);
    draw_legend(file, chart->probe);
    draw_title(file, chart->title);
    fputs("</svg>\n", file);
}

/**
 * Writes the drawing.
 * @param raster  What is seen of the scene.
 * @return Whether it is there.
 */
static bool save_chart(const RayChart *chart, const OrbitCamera *orbit,
                       const ProjectedView *projected, const BackgroundRaster *raster,
                       const char *path, Error *error) {
    AtomicFile file;
    if (!atomic_file_open(&file, path, ATOMIC_REPLACE, error)) {
        return error_prefix(error, "cannot write '%s': ", path);
    }
    draw_all(file.stream, chart, orbit, projected, raster);
    return atomic_file_commit(&file, error) || error_prefix(error, "cannot write '%s': ", path);
}

bool ray_chart_write(const RayChart *chart, const char *path, Error *error) {
    OrbitCamera orbit =
        orbit_camera_fit(chart->renderer, &chart->scene->camera, chart->probe, WIDTH, HEIGHT);
    ProjectedView projected = orbit_camera_project(&orbit, WIDTH, HEIGHT);
    BackgroundRaster raster;
    bool is_written = background_raster_init(chart, &projected, &raster, error) &&
                      save_chart(chart, &orbit, &projected, &raster, path, error);
    background_raster_deinit(&raster);
    return is_written;
}
