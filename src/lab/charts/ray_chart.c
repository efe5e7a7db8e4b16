/**
 * @file
 * @brief The rays of a pixel as an SVG file.
 *
 * The background is the scene from a second camera, in a few light greys, with a line where one
 * shape ends and another begins: faint, small and sharp in print. The rays are drawn over it.
 */
#include "lab/charts/ray_chart.h"

#include "base/atomic_file.h"
#include "base/language.h"
#include "base/utf8.h"
#include "render/ray_formula.h"
#include "render/ray_pane.h"

#include <cairo-svg.h>
#include <libintl.h>
#include <stdlib.h>
#include <string.h>

/** Size of the drawing: its units are the pixels of the outlines. */
enum { WIDTH = 1000, HEIGHT = 750 };
/** Width of the plan and the view from the side, beside the drawing; height of what is below. */
enum { PLAN_WIDTH = 500, BELOW_HEIGHT = 360 };
/** Height of letters beside and below the drawing. */
static const double TEXT_SIZE = 15;
/** Letters of a line of formulas. */
enum { LINE_LETTERS = 110 };
/** Units of a pixel of the greys. */
enum { GREY_CELL = 2 };
/** Size of the greys. */
enum { GREY_COLUMNS = WIDTH / GREY_CELL, GREY_ROWS = HEIGHT / GREY_CELL };
/** How many greys there are. */
enum { GREY_LEVELS = 12 };
/** The brightest and the darkest grey. */
enum { GREY_BRIGHTEST = 255, GREY_DARKEST = 170 };

/** What the second camera sees of the scene. */
typedef struct Background {
    int *shapes;       /**< The shape in each pixel, or -1; owned. */
    double *distances; /**< The distance in each pixel; owned. */
    double *rgb;       /**< Linear light of each pixel of the greys, plane by plane; owned. */
} Background;

/** Releases a background. */
static void background_deinit(Background *background) {
    free(background->shapes);
    free(background->distances);
    free(background->rgb);
}

/** Traces a background. @param side The scene with the second camera. @return false without
 *  memory. */
static bool background_trace(const Engine *engine, Tracer *tracer, const Scene *side,
                             Background *background) {
    const size_t pixels = (size_t)WIDTH * HEIGHT, cells = (size_t)GREY_COLUMNS * GREY_ROWS;
    RayCounts counts = {0};
    PixelGrid all = {.columns = WIDTH, .rows = HEIGHT, .stride = 1};
    PixelGrid coarse = {.columns = GREY_COLUMNS, .rows = GREY_ROWS, .stride = GREY_CELL};
    background->shapes = malloc(pixels * sizeof *background->shapes);
    background->distances = malloc(pixels * sizeof *background->distances);
    background->rgb = malloc(3 * cells * sizeof *background->rgb);
    if (!background->shapes || !background->distances || !background->rgb) {
        return false;
    }
    engine->set_view(tracer, side, WIDTH, HEIGHT);
    engine->trace_primary(tracer, &all, background->shapes, background->distances);
    engine->trace(tracer, &coarse, background->rgb, &counts);
    return true;
}

/**
 * Makes a background.
 * @param scene  What is left of the scene.
 * @param[out] background  It; to be released also where anything is wrong.
 * @return false if anything is wrong.
 */
static bool background_init(const RayChart *chart, const Scene *scene, const SceneCamera *camera,
                            Background *background, Error *error) {
    // The fastest engine is accurate enough for it; the rays are the chosen engine's.
    const Engine *engine = engine_find("auto", error);
    Scene side = *scene;
    side.camera = *camera;
    TraceSettings trace = chart->settings->trace;
    trace.samples = 1;
    *background = (Background){0};
    Tracer *tracer = engine->create_tracer(&side, &trace, error);
    bool is_made = tracer && (background_trace(engine, tracer, &side, background) ||
                              error_set(error, STATUS_FAILED, "no memory for the drawing"));
    engine->destroy(tracer);
    return is_made;
}

/** @return The grey of a pixel, GREY_DARKEST to GREY_BRIGHTEST. */
static unsigned background_grey(const Background *background, size_t column, size_t row) {
    const size_t cells = (size_t)GREY_COLUMNS * GREY_ROWS;
    const double *light = background->rgb + row * GREY_COLUMNS + column;
    if (background->shapes[(row * WIDTH + column) * GREY_CELL] < 0) {
        return GREY_BRIGHTEST;
    }
    double luminance = 0.2126 * light[0] + 0.7152 * light[cells] + 0.0722 * light[2 * cells];
    double code = encoding_encode(ENCODING_SRGB, fmin(fmax(luminance, 0), 1));
    unsigned level = (unsigned)(code * GREY_LEVELS / (ENCODING_CODE_MAXIMUM + 1));
    return GREY_DARKEST + (GREY_BRIGHTEST - GREY_DARKEST) * level / (GREY_LEVELS - 1);
}

/** Draws the greys. */
static void draw_greys(cairo_t *cairo, const Background *background) {
    cairo_surface_t *image =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, GREY_COLUMNS, GREY_ROWS);
    unsigned char *data = cairo_image_surface_get_data(image);
    size_t stride = (size_t)cairo_image_surface_get_stride(image);
    for (size_t row = 0; data && row < GREY_ROWS; row++) {
        uint32_t *pixels = (uint32_t *)(void *)(data + row * stride);
        for (size_t column = 0; column < GREY_COLUMNS; column++) {
            pixels[column] = 0x010101 * background_grey(background, column, row);
        }
    }
    cairo_surface_mark_dirty(image);
    cairo_save(cairo);
    cairo_scale(cairo, GREY_CELL, GREY_CELL);
    cairo_set_source_surface(cairo, image, 0, 0);
    cairo_paint(cairo);
    cairo_restore(cairo);
    cairo_surface_destroy(image);
}

/**
 * Draws the lines between neighbouring rows, or columns, where the shapes differ.
 * @param length  Pixels along a line.
 * @param lines   Rows or columns.
 * @param along   Indices from a pixel to the next along a line.
 * @param across  Indices from a line to the next.
 */
static void draw_edges(cairo_t *cairo, const int *shapes, int length, int lines, int along,
                       int across) {
    for (int line = 1; line < lines; line++) {
        for (int start = 0, end; start < length; start = end + 1) {
            const int *pixel = shapes + line * across;
            for (end = start; end < length && pixel[end * along] != pixel[end * along - across];) {
                end++;
            }
            if (end > start) {
                cairo_move_to(cairo, along == 1 ? start : line, along == 1 ? line : start);
                cairo_line_to(cairo, along == 1 ? end : line, along == 1 ? line : end);
            }
        }
    }
}

/** Draws the scene. */
static void draw_background(cairo_t *cairo, const Background *background) {
    draw_greys(cairo, background);
    draw_edges(cairo, background->shapes, WIDTH, HEIGHT, 1, WIDTH);
    draw_edges(cairo, background->shapes, HEIGHT, WIDTH, WIDTH, 1);
    cairo_set_source_rgb(cairo, 0.6, 0.6, 0.6);
    cairo_set_line_width(cairo, 1);
    cairo_stroke(cairo);
}

/** Draws the edges of a light that has any. */
static void draw_light_outline(const RayDrawing *drawing, const SceneLight *light) {
    Vec3d points[SCENE_LIGHT_OUTLINE_POINTS];
    size_t count = scene_light_outline(light, points);
    double x, y;
    cairo_set_source_rgb(drawing->cairo, 0.94, 0.89, 0.26); // Okabe and Ito's yellow, as the marks.
    cairo_set_line_width(drawing->cairo, 4);
    for (size_t i = 0; i < count; i++) {
        if (projected_view_point(&drawing->view, points[i], &x, &y)) {
            cairo_line_to(drawing->cairo, x, y);
        } else {
            cairo_new_sub_path(drawing->cairo);
        }
    }
    cairo_stroke(drawing->cairo);
}

/** Marks the camera and the lights. */
static void draw_marks(const RayDrawing *drawing, const Scene *scene) {
    ray_drawing_mark(drawing, drawing->tree->nodes[0].origin, RAY_MARK_EYE, gettext("eye"));
    for (size_t i = 0; i < scene->light_count; i++) {
        Vec3d center;
        draw_light_outline(drawing, &scene->lights[i]);
        if (scene_light_center(&scene->lights[i], &center)) {
            char label[64];
            snprintf(label, sizeof label, gettext("lamp %zu"), i + 1);
            ray_drawing_mark(drawing, center, RAY_MARK_LIGHT, label);
        }
    }
}

/** Is a cairo_write_func_t. @param stream A FILE. */
static cairo_status_t write_bytes(void *stream, const unsigned char *bytes, unsigned length) {
    return fwrite(bytes, 1, length, stream) == length ? CAIRO_STATUS_SUCCESS
                                                      : CAIRO_STATUS_WRITE_ERROR;
}

/** Writes a formula below the last line, broken at spaces. @param[in,out] y Its base line. */
static void draw_formula(cairo_t *cairo, const RayFormula *formula, double *y) {
    char line[RAY_FORMULA_LABEL_SIZE + RAY_FORMULA_TEXT_SIZE + 2];
    int length = snprintf(line, sizeof line, "%s  %s", formula->label, formula->text);
    for (char *start = line, *end = line + length; start < end;) {
        char *stop = end - start > LINE_LETTERS ? start + LINE_LETTERS : end;
        while (stop < end && stop > start + 1 && *stop != ' ') {
            stop--;
        }
        *stop = '\0';
        cairo_move_to(cairo, start == line ? TEXT_SIZE : 3 * TEXT_SIZE, *y);
        cairo_show_text(cairo, start);
        *y += 1.4 * TEXT_SIZE;
        start = stop + 1;
    }
}

/** Draws the formulas of the chosen ray and its sum, from the origin of the target. */
static void draw_formulas(cairo_t *cairo, const RayChart *chart) {
    const RayFormulaInput input = {chart->scene, chart->probe, chart->settings->trace.methods == 0};
    RayFormulas formulas;
    double y = 2 * TEXT_SIZE;
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, TEXT_SIZE);
    cairo_set_source_rgb(cairo, 0, 0, 0);
    ray_formulas_write(&input, chart->selected, &formulas);
    for (size_t i = 0; i < formulas.count; i++) {
        draw_formula(cairo, &formulas.items[i], &y);
    }
    y += TEXT_SIZE / 2;
    ray_sum_write(&input, chart->selected, &formulas);
    for (size_t i = 0; i < formulas.count; i++) {
        draw_formula(cairo, &formulas.items[i], &y);
    }
}

/** Draws plan and view from the side beside the drawing, and below what belongs to a chosen ray. */
static void draw_panes(const RayChart *chart, const RayDrawing *drawing) {
    cairo_t *cairo = drawing->cairo;
    RayPaneInput pane = {chart->renderer, chart->scene, chart->settings->engine, *drawing,
                         TEXT_SIZE};
    cairo_save(cairo);
    cairo_translate(cairo, WIDTH, 0);
    ray_pane_draw(RAY_PANE_PLAN, &pane, PLAN_WIDTH, HEIGHT);
    cairo_restore(cairo);
    if (chart->selected < chart->probe->count) {
        bool marches = chart->probe->nodes[chart->selected].step_count > 0;
        cairo_save(cairo);
        cairo_translate(cairo, 0, HEIGHT);
        draw_formulas(cairo, chart);
        cairo_translate(cairo, WIDTH, 0);
        ray_pane_draw(marches ? RAY_PANE_MARCH : RAY_PANE_MICROSCOPE, &pane, PLAN_WIDTH,
                      BELOW_HEIGHT);
        cairo_restore(cairo);
    }
}

/** Draws the rays over the scene. */
static void draw_rays(const RayChart *chart, const RayDrawing *drawing, const char *title) {
    cairo_save(drawing->cairo);
    cairo_rectangle(drawing->cairo, 0, 0, WIDTH, HEIGHT);
    cairo_clip(drawing->cairo);
    ray_drawing_rays(drawing);
    ray_drawing_march(drawing);
    ray_drawing_numbers(drawing);
    draw_marks(drawing, chart->scene);
    ray_drawing_legend(drawing);
    ray_drawing_text(drawing, 20, 30, title);
    cairo_restore(drawing->cairo);
}

/** Draws everything as SVG. @param scene What is left of the scene. @param title Printable. @return
 * Whether cairo could do it. */
static bool draw_svg(const RayChart *chart, const Scene *scene, const OrbitCamera *orbit,
                     const char *title, FILE *stream, Error *error) {
    ProjectedView view = orbit_camera_project(orbit, WIDTH, HEIGHT);
    const int height = HEIGHT + (chart->selected < chart->probe->count ? BELOW_HEIGHT : 0);
    Background background;
    bool is_drawn = background_init(chart, scene, &view.camera, &background, error);
    if (is_drawn) {
        cairo_surface_t *surface =
            cairo_svg_surface_create_for_stream(write_bytes, stream, WIDTH + PLAN_WIDTH, height);
        cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
        RayDrawing drawing = {.cairo = cairo_create(surface),
                              .tree = chart->probe,
                              .orbit = orbit,
                              .view = view,
                              .selected = chart->selected};
        cairo_set_source_rgb(drawing.cairo, 1, 1, 1);
        cairo_paint(drawing.cairo);
        draw_background(drawing.cairo, &background);
        draw_rays(chart, &drawing, title);
        draw_panes(chart, &drawing);
        cairo_surface_finish(surface);
        is_drawn = cairo_status(drawing.cairo) == CAIRO_STATUS_SUCCESS ||
                   error_set(error, STATUS_FAILED, "no memory for the drawing");
        cairo_destroy(drawing.cairo);
        cairo_surface_destroy(surface);
    }
    background_deinit(&background);
    return is_drawn;
}

/** Writes text that XML may contain. @param text Printable. */
static void write_escaped(FILE *file, const char *text) {
    for (; *text; text++) {
        *text == '&'   ? (void)fputs("&amp;", file)
        : *text == '<' ? (void)fputs("&lt;", file)
                       : (void)fputc(*text, file);
    }
}

/**
 * Writes an SVG image with a title and a description: cairo draws text as outlines, which cannot
 * be searched or read aloud.
 * @param svg   The image, as cairo has drawn it.
 * @param tree  Whose legend is the description.
 */
static void write_described(FILE *file, const char *svg, const char *title, const RayTree *tree) {
    const char *root = strstr(svg, "<svg");
    size_t head = root ? (size_t)(strchr(root, '>') + 1 - svg) : 0;
    fwrite(svg, 1, head, file);
    fputs("\n<title>", file);
    write_escaped(file, title);
    fputs("</title>\n<desc>", file);
    const char *comma = "";
    for (int i = 0; i < RAY_STYLE_COUNT; i++) {
        if (ray_style_is_used(tree, &ray_styles()[i])) {
            fputs(comma, file);
            write_escaped(file, gettext(ray_styles()[i].name));
            comma = ", ";
        }
    }
    fputs("</desc>", file);
    fputs(svg + head, file);
}

/** Copies text. What is not printable or not UTF-8, which cairo refuses, becomes `?`. */
static void copy_printable(const char *text, char *copy, size_t size) {
    size_t length = 0;
    for (size_t left = strlen(text), taken; left > 0 && length + 5 < size; left -= taken) {
        uint32_t code = 0;
        size_t bytes = utf8_decode(text, left, &code);
        bool is_printable = bytes > 0 && !utf8_is_control(code);
        taken = is_printable ? bytes : 1;
        memcpy(copy + length, is_printable ? text : "?", taken);
        length += taken;
        text += taken;
    }
    copy[length] = '\0';
}

bool ray_chart_write(const RayChart *chart, const char *path, Error *error) {
    CutAway cut = {0};
    cut_away_begin(&cut, chart->scene, chart->probe);
    OrbitCamera orbit =
        orbit_camera_fit(chart->renderer, chart->scene, &cut, chart->probe, 0, WIDTH, HEIGHT);
    ProjectedView view = orbit_camera_project(&orbit, WIDTH, HEIGHT);
    cut_away_update(&cut, chart->renderer, chart->scene, chart->probe, view.camera.position);
    const Scene left = cut_away_scene(&cut, chart->scene);
    char *svg = NULL, title[512];
    size_t size = 0;
    AtomicFile file;
    copy_printable(chart->title, title, sizeof title);
    FILE *stream = open_memstream(&svg, &size);
    bool is_drawn = stream && draw_svg(chart, &left, &orbit, title, stream, error);
    cut_away_deinit(&cut);
    if (!stream || (fclose(stream) != 0 && is_drawn)) {
        is_drawn = error_set(error, STATUS_FAILED, "no memory for the drawing");
    }
    bool is_open = is_drawn && atomic_file_open(&file, path, ATOMIC_REPLACE, error);
    if (is_open) {
        write_described(file.stream, svg, title, chart->probe);
        is_open = atomic_file_commit(&file, error);
    }
    free(svg);
    return is_open || (is_drawn && error_prefix(error, "cannot write '%s': ", path));
}
