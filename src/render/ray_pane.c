/**
 * @file
 * @brief Drawings beside the view of rays.
 */
#include "render/ray_pane.h"

#include "base/typeset_numbers.h"
#include "render/ray_microscope.h"
#include "render/renderer_internal.h"

#include <libintl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Pixels of a cell of the shapes in a drawing by parallel light. */
enum { CELL = 3 };
/** Space at the edges, in heights of letters. */
static const double MARGIN = 0.6;
/** Distance of two lines, in heights of letters. */
static const double LINE_PITCH = 1.2;
/** Bytes of a line of text; most lines of a text. */
enum { LINE_SIZE = 160, LINES_MAXIMUM = 8 };

/** Makes letters those of the drawings. @param shown The text as readers of the language have it.
 */
static void choose_letters(const RayPaneInput *input, const char *text, char shown[LINE_SIZE]) {
    cairo_t *cairo = input->drawing.cairo;
    snprintf(shown, LINE_SIZE, "%.*s", LINE_SIZE - 1, text);
    typeset_numbers(shown, LINE_SIZE);
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, input->text_size);
}

/** @return The width of a text, pixels. */
static double text_width(cairo_t *cairo, const char *text) {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo, text, &extents);
    return extents.x_advance;
}

/** @return Bytes of the words of a text that fit into a line; at least one word. @param room Width
 *  of the line, pixels. */
static size_t line_length(cairo_t *cairo, const char *text, double room) {
    size_t length = strcspn(text, " ");
    for (size_t end = length; text[end] != '\0';) {
        char line[LINE_SIZE];
        end += 1 + strcspn(text + end + 1, " ");
        snprintf(line, sizeof line, "%.*s", (int)end, text);
        if (text_width(cairo, line) > room) {
            break;
        }
        length = end;
    }
    return length;
}

/** Breaks a text into lines. @param[out] lines The lines. @return Their number. */
static size_t break_text(const RayPaneInput *input, double room, const char *text,
                         char lines[LINES_MAXIMUM][LINE_SIZE]) {
    char shown[LINE_SIZE];
    size_t count = 0;
    choose_letters(input, text, shown);
    for (const char *rest = shown; *rest != '\0' && count < LINES_MAXIMUM; count++) {
        size_t length = line_length(input->drawing.cairo, rest, room);
        snprintf(lines[count], LINE_SIZE, "%.*s", (int)length, rest);
        rest += length + (rest[length] == ' ');
    }
    return count;
}

/** Writes a line of text. @param y Its base line. */
static void write_text(const RayPaneInput *input, double x, double y, const char *text) {
    cairo_t *cairo = input->drawing.cairo;
    char shown[LINE_SIZE];
    choose_letters(input, text, shown);
    cairo_set_source_rgb(cairo, 0, 0, 0);
    cairo_move_to(cairo, x, y);
    cairo_show_text(cairo, shown);
}

/** Writes a text in as many lines as it needs. @param y Base line of the first. @param right Where
 *  they end at most, pixels. @return Base line of what comes below. */
static double write_lines(const RayPaneInput *input, double x, double y, double right,
                          const char *text) {
    char lines[LINES_MAXIMUM][LINE_SIZE];
    size_t count = break_text(input, right - x, text, lines);
    for (size_t i = 0; i < count; i++) {
        write_text(input, x, y, lines[i]);
        y += LINE_PITCH * input->text_size;
    }
    return y;
}

/** Writes a text from margin to margin. See #write_lines. */
static double write_paragraph(const RayPaneInput *input, double y, int width, const char *text) {
    const double margin = MARGIN * input->text_size;
    return write_lines(input, margin, y, width - margin, text);
}

/** Writes what a drawing shows over its upper left corner, on a ground of its own. */
static void write_title(const RayPaneInput *input, const char *text) {
    cairo_t *cairo = input->drawing.cairo;
    const double size = input->text_size, margin = MARGIN * size;
    char shown[LINE_SIZE];
    choose_letters(input, text, shown);
    cairo_rectangle(cairo, 0, 0, 2 * margin + text_width(cairo, shown), 1.7 * size);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_fill(cairo);
    write_text(input, margin, 1.2 * size, text);
}

/** Fills the ground. */
static void clear(cairo_t *cairo, int width, int height) {
    cairo_rectangle(cairo, 0, 0, width, height);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_fill(cairo);
}

/* --- by parallel light ------------------------------------------------------------------------ */

ParallelView ray_plan_view(void) {
    return (ParallelView){{1, 0, 0}, {0, 0, -1}, {0, -1, 0}};
}

ParallelView ray_side_view(const RayTree *tree) {
    const Vec3d up = {0, 1, 0}, direction = tree->nodes[0].direction;
    Vec3d along = {direction.x, 0, direction.z};
    along = vec3d_length(along) > 0 ? vec3d_normalize(along) : (Vec3d){0, 0, -1};
    return (ParallelView){along, up, vec3d_cross(up, along)};
}

/** @return A pale colour of a shape, 0xRRGGBB. @param shape Its index; -1: none. */
static uint32_t pale_color(int shape) {
    static const uint32_t colors[] = {0xe4e7eb, 0xdce9f5, 0xe2f0e6, 0xf6e9d8, 0xf2e1ec, 0xeceadb};
    return shape < 0 ? 0xffffff : colors[(size_t)shape % (sizeof colors / sizeof *colors)];
}

/** Draws the shapes as cells in pale colours, with darker cells where one shape ends.
 *  @param shapes The shape in each cell. */
static void draw_cells(cairo_t *cairo, const int *shapes, int columns, int rows) {
    cairo_surface_t *image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows);
    unsigned char *data = cairo_image_surface_get_data(image);
    int stride = cairo_image_surface_get_stride(image);
    for (int row = 0; data && row < rows; row++) {
        uint32_t *pixels = (uint32_t *)(void *)(data + (size_t)row * (size_t)stride);
        for (int column = 0; column < columns; column++) {
            const int *cell = shapes + row * columns + column;
            bool is_edge =
                (column > 0 && cell[-1] != *cell) || (row > 0 && cell[-columns] != *cell);
            pixels[column] = is_edge ? 0x8a929c : pale_color(*cell);
        }
    }
    cairo_surface_mark_dirty(image);
    cairo_save(cairo);
    cairo_scale(cairo, CELL, CELL);
    cairo_set_source_surface(cairo, image, 0, 0);
    cairo_pattern_set_filter(cairo_get_source(cairo), CAIRO_FILTER_NEAREST);
    cairo_paint(cairo);
    cairo_restore(cairo);
    cairo_surface_destroy(image);
}

/** @return The ray of a cell, along the light. @param start Depth at which it starts. */
static RayQuery cell_ray(const ProjectedView *view, int column, int row, double start) {
    const SceneCamera *camera = &view->camera;
    double unit = 1 / projected_view_scale(view, camera->look_at);
    double x = ((column + 0.5) * CELL - view->width / 2.0) * unit;
    double y = (view->height / 2.0 - (row + 0.5) * CELL) * unit;
    Vec3d o = vec3d_add(camera->position, vec3d_scale(camera->direction, start));
    o = vec3d_add(
        o, vec3d_add(vec3d_scale(scene_camera_right(camera), x), vec3d_scale(camera->up, y)));
    Vec3d d = camera->direction;
    return (RayQuery){{o.x, o.y, o.z}, {d.x, d.y, d.z}};
}

/** Draws the shapes by parallel light. @param start Depth of the plane of the cut. */
static void draw_shapes(const RayPaneInput *input, const ProjectedView *view, double start) {
    const int columns = view->width / CELL + 1, rows = view->height / CELL + 1;
    const size_t count = (size_t)columns * (size_t)rows;
    RayQuery *rays = malloc(count * sizeof *rays);
    int *shapes = malloc(count * sizeof *shapes);
    double *distances = malloc(count * sizeof *distances);
    if (rays && shapes && distances) {
        for (size_t i = 0; i < count; i++) {
            rays[i] = cell_ray(view, (int)(i % (size_t)columns), (int)(i / (size_t)columns), start);
        }
        input->engine->closest_hits(input->renderer->tracer, count, rays, shapes, distances);
        draw_cells(input->drawing.cairo, shapes, columns, rows);
    }
    free(rays);
    free(shapes);
    free(distances);
}

void ray_pane_parallel(const RayPaneInput *input, const ParallelView *view, int width, int height) {
    RayDrawing drawing = input->drawing;
    drawing.text_size = input->text_size;
    double nearest;
    drawing.view = parallel_view_fit(drawing.orbit, drawing.tree, view->forward, view->up, width,
                                     height, &nearest);
    double margin = 1e-3 * width / projected_view_scale(&drawing.view, drawing.view.camera.look_at);
    cairo_save(drawing.cairo);
    cairo_rectangle(drawing.cairo, 0, 0, width, height);
    cairo_clip(drawing.cairo);
    draw_shapes(input, &drawing.view, nearest - margin);
    ray_drawing_rays(&drawing);
    ray_drawing_march(&drawing);
    ray_drawing_mark(&drawing, drawing.tree->nodes[0].origin, RAY_MARK_EYE, NULL);
    ray_drawing_numbers(&drawing);
    cairo_restore(drawing.cairo);
}

/** Draws the plan and the view from the side, one above the other. */
static void draw_plan(const RayPaneInput *input, int width, int height) {
    cairo_t *cairo = input->drawing.cairo;
    const ParallelView views[] = {ray_plan_view(), ray_side_view(input->drawing.tree)};
    const char *const titles[] = {gettext("from above"), gettext("from the side")};
    int half = height / 2;
    for (int i = 0; i < 2; i++) {
        cairo_save(cairo);
        cairo_translate(cairo, 0, i * half);
        ray_pane_parallel(input, &views[i], width, half);
        write_title(input, titles[i]);
        cairo_restore(cairo);
    }
    cairo_set_source_rgb(cairo, 0.2, 0.2, 0.2);
    cairo_set_line_width(cairo, 1);
    cairo_move_to(cairo, 0, half);
    cairo_line_to(cairo, width, half);
    cairo_stroke(cairo);
}

/* --- the march -------------------------------------------------------------------------------- */

/** @return The ray whose march is shown; NULL: it has none. */
static const RayTreeNode *marched_ray(const RayDrawing *drawing) {
    size_t index = drawing->selected < drawing->tree->count ? drawing->selected : 0;
    const RayTreeNode *ray = &drawing->tree->nodes[index];
    return ray->step_count > 0 ? ray : NULL;
}

/** Draws the spheres of a ray that lies flat: distance to the right, free distance up and down, in
 *  one scale. @param area Left, right and the height of the ray, pixels. */
static void draw_flat_spheres(const RayPaneInput *input, const RayTreeNode *ray,
                              const double area[3]) {
    cairo_t *cairo = input->drawing.cairo;
    const RayMarchStep *steps = input->drawing.tree->steps + ray->first_step;
    const RayMarchStep *last = &steps[ray->step_count - 1];
    double first = steps[0].distance, length = last->distance + last->radius - first;
    double scale = (area[1] - area[0]) / (length > 0 ? length : 1);
    cairo_set_line_width(cairo, 1.5);
    for (size_t i = 0; i < ray->step_count; i++) {
        double x = area[0] + (steps[i].distance - first) * scale;
        cairo_new_path(cairo);
        cairo_arc(cairo, x, area[2], fmax(0.5, steps[i].radius * scale), 0, 2 * M_PI);
        cairo_set_source_rgba(cairo, 0.84, 0.37, 0, 0.08);
        cairo_fill_preserve(cairo);
        cairo_set_source_rgba(cairo, 0.84, 0.37, 0, 0.9);
        cairo_stroke(cairo);
        cairo_arc(cairo, x, area[2], 2, 0, 2 * M_PI);
        cairo_set_source_rgb(cairo, 0, 0, 0);
        cairo_fill(cairo);
    }
    cairo_set_source_rgb(cairo, 0, 0, 0);
    cairo_move_to(cairo, area[0], area[2]);
    cairo_line_to(cairo, area[1], area[2]);
    cairo_stroke(cairo);
}

/** Draws the free distance of each step as a bar: on a log scale, from the smallest to the largest.
 *  @param box Left, top, right, bottom, pixels. */
static void draw_free_distances(const RayPaneInput *input, const RayTreeNode *ray,
                                const double box[4]) {
    cairo_t *cairo = input->drawing.cairo;
    const RayMarchStep *steps = input->drawing.tree->steps + ray->first_step;
    double least = HUGE_VAL, most = 0;
    for (size_t i = 0; i < ray->step_count; i++) {
        least = steps[i].radius > 0 ? fmin(least, steps[i].radius) : least;
        most = fmax(most, steps[i].radius);
    }
    double range = most > least ? log(most / least) : 1;
    double bar = (box[2] - box[0]) / (double)ray->step_count;
    cairo_set_source_rgb(cairo, 0, 0.45, 0.7);
    for (size_t i = 0; i < ray->step_count; i++) {
        double part = steps[i].radius > 0 ? log(steps[i].radius / least) / range : 0;
        double top = box[3] - (0.04 + 0.96 * part) * (box[3] - box[1]);
        cairo_rectangle(cairo, box[0] + (double)i * bar, top, fmax(1, 0.8 * bar), box[3] - top);
        cairo_fill(cairo);
    }
}

/** Writes the smallest and the largest free distance of a ray. @param y The base line. */
static void write_range(const RayPaneInput *input, const RayTreeNode *ray, double x, double y) {
    const RayMarchStep *steps = input->drawing.tree->steps + ray->first_step;
    double least = HUGE_VAL, most = 0;
    char text[LINE_SIZE];
    for (size_t i = 0; i < ray->step_count; i++) {
        least = fmin(least, steps[i].radius);
        most = fmax(most, steps[i].radius);
    }
    snprintf(text, sizeof text, "%.3g … %.3g", least, most);
    write_text(input, x, y, text);
}

/** Draws the march of the selected ray. */
static void draw_march(const RayPaneInput *input, int width, int height) {
    const RayTreeNode *ray = marched_ray(&input->drawing);
    const double size = input->text_size, left = MARGIN * size;
    char text[LINE_SIZE];
    if (!ray) {
        write_paragraph(input, 1.5 * size, width, gettext("this ray does not march"));
        return;
    }
    const char *axis = gettext("free distance per step, log scale");
    char lines[LINES_MAXIMUM][LINE_SIZE];
    const size_t count = break_text(input, width - 2 * left, axis, lines);
    const double below = height - (0.8 + LINE_PITCH * (double)count) * size;
    const double flat[] = {left, width - left, 0.35 * height};
    const double bars[] = {left, fmin(0.68 * height, below - 3 * size), width - left,
                           below - 1.5 * size};
    cairo_save(input->drawing.cairo);
    cairo_rectangle(input->drawing.cairo, 0, 0, width, 0.6 * height);
    cairo_clip(input->drawing.cairo);
    draw_flat_spheres(input, ray, flat);
    cairo_restore(input->drawing.cairo);
    draw_free_distances(input, ray, bars);
    snprintf(text, sizeof text, ngettext("%zu step", "%zu steps", ray->step_count),
             ray->step_count);
    write_text(input, left, 1.3 * size, text);
    write_paragraph(input, below, width, axis);
    write_range(input, ray, left, height - 0.7 * size);
}

/* --- the microscope --------------------------------------------------------------------------- */

/** A height under the microscope, with its words. */
typedef struct HeightMark {
    double height;        /**< Ulps over the surface. */
    unsigned color;       /**< 0xRRGGBB. */
    char text[LINE_SIZE]; /**< Its words. */
} HeightMark;

/** Most heights: the surface, the rounded hit, the rays that leave it. */
enum { MARKS_MAXIMUM = MICROSCOPE_RAYS + 2 };

/** Orders marks from above. See qsort(). */
static int compare_marks(const void *first, const void *second) {
    double a = ((const HeightMark *)first)->height, b = ((const HeightMark *)second)->height;
    return (a < b) - (a > b);
}

/** @return How many marks a hit has. @param[out] marks The marks, from above. */
static size_t collect_marks(const RayMicroscope *hit, const RayTree *tree,
                            HeightMark marks[MARKS_MAXIMUM]) {
    size_t count = 0;
    marks[count] = (HeightMark){.color = 0x666666};
    snprintf(marks[count++].text, LINE_SIZE, "%s", gettext("0: surface (quad)"));
    marks[count] = (HeightMark){.height = hit->height, .color = 0xD55E00};
    snprintf(marks[count++].text, LINE_SIZE, gettext("%+.3g: rounded hit"), hit->height);
    for (size_t i = 0; i < hit->next_count; i++) {
        const MicroscopeRay *next = &hit->next[i];
        marks[count] = (HeightMark){.height = next->height,
                                    .color = ray_style(&tree->nodes[next->ray])->color};
        snprintf(marks[count++].text, LINE_SIZE, gettext("%+.3g: ray %zu"), next->height,
                 next->ray);
    }
    qsort(marks, count, sizeof *marks, compare_marks);
    return count;
}

/** @return The height of the words of marks. @param[out] heights The height of each, pixels.
 *  @param room Width of their lines, pixels. */
static double measure_marks(const RayPaneInput *input, const HeightMark *marks, size_t count,
                            double room, double heights[MARKS_MAXIMUM]) {
    char lines[LINES_MAXIMUM][LINE_SIZE];
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        heights[i] =
            LINE_PITCH * input->text_size * (double)break_text(input, room, marks[i].text, lines);
        sum += heights[i];
    }
    return sum;
}

/** Draws marks as lines with words beside them. @param top Where the largest may lie, pixels. */
static void draw_marks(const RayPaneInput *input, HeightMark *marks, size_t count, double top,
                       int width, int height) {
    cairo_t *cairo = input->drawing.cairo;
    const double size = input->text_size, right = 0.16 * width, words = right + 1.3 * size;
    const double end = width - MARGIN * size / 2;
    double heights[MARKS_MAXIMUM], below = measure_marks(input, marks, count, end - words, heights);
    double high = fmax(1, marks[0].height), low = fmin(-1, marks[count - 1].height);
    double unit = (height - top - 2 * size) / (high - low), above = top;
    for (size_t i = 0; i < count; i++) {
        double y = top + size + (high - marks[i].height) * unit;
        double text_y = fmin(fmax(y, above), height + (LINE_PITCH - 1) * size - below);
        above = text_y + heights[i];
        below -= heights[i];
        cairo_set_source_rgb(cairo, (marks[i].color >> 16) / 255.0,
                             (marks[i].color >> 8 & 0xff) / 255.0, (marks[i].color & 0xff) / 255.0);
        cairo_set_line_width(cairo, 2);
        cairo_move_to(cairo, MARGIN * size, y);
        cairo_line_to(cairo, right, y);
        cairo_line_to(cairo, right + size, text_y);
        cairo_stroke(cairo);
        write_lines(input, words, text_y + 0.35 * size, end, marks[i].text);
    }
}

/** Draws the hit of the selected ray under the microscope. */
static void draw_microscope(const RayPaneInput *input, int width, int height) {
    const RayDrawing *drawing = &input->drawing;
    const double size = input->text_size;
    size_t index = drawing->selected < drawing->tree->count ? drawing->selected : 0;
    if (drawing->tree->nodes[index].kind == RAY_SHADOW) {
        index = (size_t)drawing->tree->nodes[index].parent; // It starts at that hit.
    }
    RayMicroscope hit = ray_microscope_measure(input->engine, input->scene, drawing->tree, index);
    HeightMark marks[MARKS_MAXIMUM];
    char text[LINE_SIZE];
    if (!hit.is_valid) {
        write_paragraph(input, 1.5 * size, width, gettext("no hit to measure"));
        return;
    }
    snprintf(text, sizeof text, gettext("1 ulp of the hit = %.3g"), hit.ulp);
    double below = write_paragraph(input, 1.3 * size, width, text);
    snprintf(text, sizeof text, gettext("offset: %.3g ulps"), hit.epsilon);
    below = write_paragraph(input, below, width, text);
    size_t count = collect_marks(&hit, drawing->tree, marks);
    draw_marks(input, marks, count, below - 0.7 * size, width, height);
}

void ray_pane_draw(RayPane pane, const RayPaneInput *input, int width, int height) {
    clear(input->drawing.cairo, width, height);
    if (pane == RAY_PANE_PLAN) {
        draw_plan(input, width, height);
    } else if (pane == RAY_PANE_MARCH) {
        draw_march(input, width, height);
    } else if (pane == RAY_PANE_MICROSCOPE) {
        draw_microscope(input, width, height);
    }
}
