/**
 * @file
 * @brief The rays of a pixel as a drawing.
 *
 * The scene is drawn from the second camera in a few greys, each grey one path, with a line where
 * one shape ends and another begins: faint, small and sharp in print. The rays lie over it.
 */
#include "dioptre/ray_chart.h"

#include "assets/atomic_file.h"
#include "dioptre/language.h"

#include <libintl.h>
#include <stdlib.h>

/** Units of the drawing, which are pixels of the outlines. */
enum { WIDTH = 1000, HEIGHT = 750 };
/** Units of a cell of grey. */
enum { CELL = 2 };
/** How many greys there are. */
enum { GREYS = 12 };
/** Rays whose numbers are written, at most: more would hide the drawing. */
enum { NUMBERED_MAXIMUM = 40 };

/** The faintest grey, of 255. */
static const double LIGHTEST = 255;
/** The darkest grey, of 255. */
static const double DARKEST = 170;

/** What the second camera sees of the scene. */
typedef struct Backcloth {
    int *shapes;       /**< The shape in each pixel, or -1; owned. */
    double *distances; /**< How far it is; owned. */
    double *light;     /**< Linear light of each cell, plane by plane; owned. */
} Backcloth;

/** Gives a backcloth back. @param cloth It. */
static void cloth_release(Backcloth *cloth) {
    free(cloth->shapes);
    free(cloth->distances);
    free(cloth->light);
}

/** Looks at the scene. @param engine Who traces. @param tracer Its tracer. @param side The scene,
 *  with the second camera. @param[out] cloth What is seen. @return false without memory. */
static bool cloth_fill(const Engine *engine, Tracer *tracer, const Scene *side, Backcloth *cloth) {
    const size_t pixels = (size_t)WIDTH * HEIGHT, cells = pixels / (CELL * CELL);
    RayCounts counts = {0};
    PixelGrid all = {.columns = WIDTH, .rows = HEIGHT, .stride = 1};
    PixelGrid coarse = {.columns = WIDTH / CELL, .rows = HEIGHT / CELL, .stride = CELL};
    cloth->shapes = malloc(pixels * sizeof *cloth->shapes);
    cloth->distances = malloc(pixels * sizeof *cloth->distances);
    cloth->light = malloc(3 * cells * sizeof *cloth->light);
    if (!cloth->shapes || !cloth->distances || !cloth->light) {
        return false;
    }
    engine->look(tracer, side, WIDTH, HEIGHT);
    engine->cast(tracer, &all, cloth->shapes, cloth->distances);
    engine->trace(tracer, &coarse, cloth->light, &counts);
    return true;
}

/** Makes a backcloth. @param chart What is drawn. @param sight The second camera.
 *  @param[out] cloth What it sees; to be released also where anything is wrong.
 *  @param[out] error What is wrong. @return Whether it is there. */
static bool cloth_make(const RayChart *chart, const RaySight *sight, Backcloth *cloth,
                       Error *error) {
    // The fastest engine is good enough for it; what is drawn of the rays is the chosen one's.
    const Engine *engine = engine_find("auto", error);
    Scene side = *chart->scene;
    side.camera = sight->camera;
    TraceSettings trace = chart->settings->trace;
    trace.samples = 1;
    *cloth = (Backcloth){0};
    Tracer *tracer = engine->prepare(&side, &trace, error);
    bool is_made = tracer && (cloth_fill(engine, tracer, &side, cloth) ||
                              error_set(error, STATUS_FAILED, "no memory for the drawing"));
    engine->release(tracer);
    return is_made;
}

/** @return A cell's grey: 0 is the darkest. @param cloth What is seen. @param place Which cell. */
static int cell_grey(const Backcloth *cloth, size_t place) {
    const size_t cells = (size_t)WIDTH * HEIGHT / (CELL * CELL), columns = WIDTH / CELL;
    const double *light = cloth->light + place;
    if (cloth->shapes[place / columns * CELL * WIDTH + place % columns * CELL] < 0) {
        return GREYS - 1;
    }
    double bright = 0.2126 * light[0] + 0.7152 * light[cells] + 0.0722 * light[2 * cells];
    double step = encoding_encode(ENCODING_SRGB, fmin(fmax(bright, 0), 1));
    int grey = (int)(step * GREYS / (ENCODING_STEP_MAXIMUM + 1));
    return grey;
}

/** Draws the cells of one grey, in runs. @param file The file. @param cloth What is seen.
 *  @param grey Which. */
static void draw_grey(FILE *file, const Backcloth *cloth, int grey) {
    const int columns = WIDTH / CELL;
    double shade = DARKEST + (LIGHTEST - DARKEST) * grey / (GREYS - 1);
    fprintf(file, "<path fill=\"#%02x%02x%02x\" d=\"", (unsigned)shade, (unsigned)shade,
            (unsigned)shade);
    for (int row = 0; row < HEIGHT / CELL; row++) {
        const size_t first = (size_t)row * (size_t)columns;
        for (int column = 0, run; column < columns; column += run) {
            for (run = 0; column + run < columns &&
                          cell_grey(cloth, first + (size_t)(column + run)) == grey;) {
                run++;
            }
            if (run > 0) {
                fprintf(file, "M%d %dh%dv%dh%dz", column * CELL, row * CELL, run * CELL, CELL,
                        -run * CELL);
            }
            run += run == 0;
        }
    }
    fputs("\"/>\n", file);
}

/** @return Whether one shape ends between two pixels. @param cloth What is seen. @param a A pixel.
 *  @param b Its neighbour. */
static bool is_edge(const Backcloth *cloth, int a, int b) {
    return cloth->shapes[a] != cloth->shapes[b];
}

/** Draws the edges between the pixels of neighbouring rows, or columns, in runs. @param file The
 *  file. @param cloth What is seen. @param across Pixels along the edges. @param down Pixels across
 *  them. @param along Places from a pixel to the next along. @param over Places to the next across.
 */
static void draw_edges(FILE *file, const Backcloth *cloth, int across, int down, int along,
                       int over) {
    for (int line = 1; line < down; line++) {
        for (int at = 0, run; at < across; at += run) {
            int place = line * over + at * along;
            for (run = 0; at + run < across && is_edge(cloth, place, place - over);) {
                run++;
                place += along;
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

/** Draws the scene. @param file The file. @param cloth What is seen of it. */
static void draw_cloth(FILE *file, const Backcloth *cloth) {
    fputs("<g shape-rendering=\"crispEdges\">\n", file);
    for (int grey = 0; grey < GREYS; grey++) {
        draw_grey(file, cloth, grey);
    }
    fputs("</g>\n<path fill=\"none\" stroke=\"#999\" stroke-width=\"1\" d=\"", file);
    draw_edges(file, cloth, WIDTH, HEIGHT, 1, WIDTH);
    draw_edges(file, cloth, HEIGHT, WIDTH, WIDTH, 1);
    fputs("\"/>\n", file);
}

/** Draws a line. @param file The file. @param style How. @param line Where. */
static void draw_line(FILE *file, const RayStyle *style, const RayLine *line) {
    fprintf(file, "<path d=\"M%.1f %.1fL%.1f %.1f\" stroke=\"#%06x\"", line->x[0], line->y[0],
            line->x[1], line->y[1], style->color);
    if (style->dash > 0) {
        fprintf(file, " stroke-dasharray=\"%g %g\"", 3 * style->dash, 3 * style->gap);
    }
    fputs("/>\n", file);
}

/** Draws an arrowhead on a line. @param file The file. @param style How. @param line Where. */
static void draw_arrow(FILE *file, const RayStyle *style, const RayLine *line) {
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

/** Draws a ray. @param file The file. @param line Where it is seen. @param ray The ray. */
static void draw_ray(FILE *file, const RayLine *line, const ProbeRay *ray) {
    const RayStyle halo = {0xffffff, 0, 0, NULL};
    fputs("<g stroke-width=\"6\" stroke-opacity=\"0.8\">", file);
    draw_line(file, &halo, line);
    fputs("</g>", file);
    draw_line(file, ray_style(ray), line);
    draw_arrow(file, ray_style(ray), line);
}

/** Writes words with a white border. @param file The file. @param x Where. @param y Where.
 *  @param anchor `start` or `middle`. @param words The words, without <, > and &. */
static void draw_words(FILE *file, double x, double y, const char *anchor, const char *words) {
    fprintf(file,
            "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" fill=\"#000\" stroke=\"#fff\" "
            "stroke-width=\"4\" paint-order=\"stroke\">%s</text>\n",
            x, y, anchor, words);
}

/** Draws all rays and their numbers. @param file The file. @param chart What is drawn.
 *  @param view How. @param sight From where. */
static void draw_rays(FILE *file, const RayChart *chart, const RayView *view,
                      const RaySight *sight) {
    const Probe *probe = chart->probe;
    char number[16];
    RayLine line;
    fputs("<g stroke-width=\"3\" fill=\"none\" stroke-linecap=\"butt\">\n", file);
    for (size_t i = probe->count; i-- > 0;) {
        if (ray_view_line(view, sight, &probe->rays[i], &line)) {
            draw_ray(file, &line, &probe->rays[i]);
        }
    }
    fputs("</g>\n", file);
    for (size_t i = 0; i < probe->count && i < NUMBERED_MAXIMUM; i++) {
        if (ray_view_line(view, sight, &probe->rays[i], &line)) {
            snprintf(number, sizeof number, "%zu", i);
            draw_words(file, 0.5 * (line.x[0] + line.x[1]) + 12, 0.5 * (line.y[0] + line.y[1]) - 8,
                       "middle", number);
        }
    }
}

/** Draws the eye and the lamps that are in the picture. @param file The file. @param chart What is
 *  drawn. @param sight From where. */
static void draw_places(FILE *file, const RayChart *chart, const RaySight *sight) {
    char words[64];
    double x, y;
    if (ray_sight_point(sight, chart->probe->rays[0].origin, &x, &y)) {
        fprintf(file, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"6\" fill=\"#000\"/>\n", x, y);
        draw_words(file, x + 11, y + 6, "start", gettext("eye"));
    }
    for (size_t i = 0; i < chart->scene->light_count; i++) {
        const Light *light = &chart->scene->lights[i];
        if (light->kind == LIGHT_POINT && ray_sight_point(sight, light->position, &x, &y)) {
            fprintf(file,
                    "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"7\" fill=\"#f0e442\" stroke=\"#000\"/>\n",
                    x, y);
            snprintf(words, sizeof words, gettext("lamp %zu"), i + 1);
            draw_words(file, x + 11, y + 6, "start", words);
        }
    }
}

/** @return Whether any ray is drawn in a style. @param probe The rays. @param style The style. */
static bool is_used(const Probe *probe, const RayStyle *style) {
    bool is_any = false;
    for (size_t i = 0; i < probe->count && !is_any; i++) {
        is_any = ray_style(&probe->rays[i]) == style;
    }
    return is_any;
}

/** Draws the legend. @param file The file. @param probe The rays. */
static void draw_legend(FILE *file, const Probe *probe) {
    double y = HEIGHT - 20;
    for (int i = RAY_STYLES - 1; i >= 0; i--) {
        const RayStyle *style = &ray_styles()[i];
        if (is_used(probe, style)) {
            RayLine line = {.x = {20, 75}, .y = {y - 5, y - 5}};
            fputs("<g stroke-width=\"3\">", file);
            draw_line(file, style, &line);
            fputs("</g>", file);
            draw_words(file, 85, y, "start", gettext(style->name));
            y -= 24;
        }
    }
}

/** Writes the title. @param file The file. @param title The title, of any letters. */
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

/** Draws everything. @param file The file. @param chart What is drawn. @param view How.
 *  @param sight From where. @param cloth What is seen of the scene. */
static void draw_all(FILE *file, const RayChart *chart, const RayView *view, const RaySight *sight,
                     const Backcloth *cloth) {
    fprintf(file,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" "
            "font-family=\"sans-serif\" font-size=\"18\">\n"
            "<rect width=\"%d\" height=\"%d\" fill=\"#fff\"/>\n",
            WIDTH, HEIGHT, WIDTH, HEIGHT);
    draw_cloth(file, cloth);
    draw_rays(file, chart, view, sight);
    draw_places(file, chart, sight);
    draw_legend(file, chart->probe);
    draw_title(file, chart->title);
    fputs("</svg>\n", file);
}

/** Writes the drawing. @param chart What is drawn. @param view How. @param cloth What is seen of
 *  the scene. @param sight From where. @param path The file. @param[out] error What is wrong.
 *  @return Whether it is there. */
static bool chart_save(const RayChart *chart, const RayView *view, const RaySight *sight,
                       const Backcloth *cloth, const char *path, Error *error) {
    AtomicFile file;
    if (!atomic_file_open(&file, path, ATOMIC_REPLACE, error)) {
        return error_prefix(error, "cannot write '%s': ", path);
    }
    draw_all(file.stream, chart, view, sight, cloth);
    return atomic_file_commit(&file, error) || error_prefix(error, "cannot write '%s': ", path);
}

bool ray_chart_write(const RayChart *chart, const char *path, Error *error) {
    RayView view =
        ray_view_choose(chart->renderer, &chart->scene->camera, chart->probe, WIDTH, HEIGHT);
    RaySight sight = ray_view_sight(&view, WIDTH, HEIGHT);
    Backcloth cloth;
    bool is_written = cloth_make(chart, &sight, &cloth, error) &&
                      chart_save(chart, &view, &sight, &cloth, path, error);
    cloth_release(&cloth);
    return is_written;
}
