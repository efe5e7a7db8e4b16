/**
 * @file
 * @brief Draws the rays of a pixel.
 *
 * Everything has a light border, so that it is seen on any background.
 */
#include "render/ray_drawing.h"

#include "base/language.h"

#include <libintl.h>
#include <math.h>
#include <stdio.h>

/** Thickness of a ray, relative to the height of the drawing. */
static const double LINE_THICKNESS = 1.0 / 240;
/** Least thickness of a ray, pixels. */
static const double THICKNESS_MINIMUM = 1.5;

/* Relative to the thickness of a ray: */
/** Thickness of the selected ray. */
static const double SELECTED_FACTOR = 2;
/** Thickness of a border. */
static const double BORDER_FACTOR = 2.2;
/** Length of an arrowhead. */
static const double ARROW_FACTOR = 4.5;
/** Size of the font. */
static const double FONT_FACTOR = 6;
/** Radius of a spot. */
static const double MARK_FACTOR = 2.4;

/** Where on a ray the point of its arrowhead is, 0 to 1. */
static const double ARROW_POSITION = 0.6;
/** Opacity of a ray's border. */
static const double BORDER_ALPHA = 0.8;
/** Rays that have numbers, at most: more would hide the rays. */
enum { NUMBERED_RAYS_MAXIMUM = 40 };

const RayStyle *ray_styles(void) {
    static const RayStyle styles[RAY_STYLE_COUNT] = {
        {0x000000, 0, 0, N_("camera ray")},          {0x0072B2, 0, 0, N_("mirrored ray")},
        {0x009E73, 8, 2, N_("refracted ray")},       {0xE69F00, 3, 2, N_("shadow ray: lit")},
        {0xCC79A7, 1, 2, N_("shadow ray: blocked")},
    };
    return styles;
}

const RayStyle *ray_style(const RayTreeNode *ray) {
    static const int indices[] = {
        [RAY_CAMERA] = 0, [RAY_REFLECTION] = 1, [RAY_REFRACTION] = 2, [RAY_SHADOW] = 3};
    return &ray_styles()[indices[ray->kind] + (ray->kind == RAY_SHADOW && ray->is_hit)];
}

bool ray_style_is_used(const RayTree *tree, const RayStyle *style) {
    for (size_t i = 0; i < tree->count; i++) {
        if (ray_style(&tree->nodes[i]) == style) {
            return true;
        }
    }
    return false;
}

/** @return The thickness of a ray, pixels. */
static double line_thickness(const RayDrawing *drawing) {
    return fmax(THICKNESS_MINIMUM, LINE_THICKNESS * drawing->view.height);
}

/** Sets the colour of what is drawn next. @param color 0xRRGGBB. */
static void set_color(cairo_t *cairo, unsigned color, double alpha) {
    cairo_set_source_rgba(cairo, (color >> 16) / 255.0, (color >> 8 & 0xff) / 255.0,
                          (color & 0xff) / 255.0, alpha);
}

/** Draws a line in a style, over a border. @param thickness Of the line, pixels. */
static void draw_line(const RayDrawing *drawing, const ProjectedRay *line, const RayStyle *style,
                      double thickness, double border_alpha) {
    cairo_t *cairo = drawing->cairo;
    const double unit = line_thickness(drawing), dashes[] = {style->dash * unit, style->gap * unit};
    cairo_move_to(cairo, line->x[0], line->y[0]);
    cairo_line_to(cairo, line->x[1], line->y[1]);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_width(cairo, BORDER_FACTOR * thickness);
    set_color(cairo, 0xffffff, border_alpha);
    cairo_stroke_preserve(cairo);
    cairo_set_dash(cairo, dashes, style->dash > 0 ? 2 : 0, 0);
    cairo_set_line_width(cairo, thickness);
    set_color(cairo, style->color, 1);
    cairo_stroke(cairo);
}

/** Draws an arrowhead on a line that is long enough, in the colour of the line. */
static void draw_arrow(const RayDrawing *drawing, const ProjectedRay *line, double thickness) {
    const double size = ARROW_FACTOR * thickness;
    double x = line->x[1] - line->x[0], y = line->y[1] - line->y[0], length = hypot(x, y);
    if (length < 3 * size) {
        return;
    }
    double u = x / length * size, v = y / length * size;
    double tip_x = line->x[0] + ARROW_POSITION * x, tip_y = line->y[0] + ARROW_POSITION * y;
    cairo_move_to(drawing->cairo, tip_x, tip_y);
    cairo_line_to(drawing->cairo, tip_x - u - 0.45 * v, tip_y - v + 0.45 * u);
    cairo_line_to(drawing->cairo, tip_x - u + 0.45 * v, tip_y - v - 0.45 * u);
    cairo_fill(drawing->cairo);
}

/**
 * Projects a ray and clips it to the drawing (Liang and Barsky), so that its arrowhead and its
 * number are in sight and its dashes are few.
 * @return Whether any of it is in sight.
 */
static bool project_clipped(const RayDrawing *drawing, const RayTreeNode *ray, ProjectedRay *line) {
    if (!orbit_camera_project_ray(drawing->orbit, &drawing->view, ray, line)) {
        return false;
    }
    double first = 0, last = 1;
    const double from[] = {line->x[0], line->y[0]};
    const double delta[] = {line->x[1] - line->x[0], line->y[1] - line->y[0]};
    const double size[] = {drawing->view.width, drawing->view.height};
    for (int axis = 0; axis < 2; axis++) {
        if (delta[axis] == 0) {
            continue;
        }
        // The fractions of the line at which it crosses the two edges.
        double near = -from[axis] / delta[axis], far = (size[axis] - from[axis]) / delta[axis];
        first = fmax(first, fmin(near, far));
        last = fmin(last, fmax(near, far));
    }
    line->x[1] = from[0] + last * delta[0];
    line->y[1] = from[1] + last * delta[1];
    line->x[0] = from[0] + first * delta[0];
    line->y[0] = from[1] + first * delta[1];
    return first < last;
}

/** Draws a ray. */
static void draw_ray(const RayDrawing *drawing, const ProjectedRay *line, size_t index) {
    bool is_selected = index == drawing->selected;
    double thickness = line_thickness(drawing) * (is_selected ? SELECTED_FACTOR : 1);
    draw_line(drawing, line, ray_style(&drawing->tree->nodes[index]), thickness,
              is_selected ? 1 : BORDER_ALPHA);
    draw_arrow(drawing, line, thickness);
}

void ray_drawing_text(const RayDrawing *drawing, double x, double y, const char *text) {
    cairo_t *cairo = drawing->cairo;
    double thickness = line_thickness(drawing);
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, FONT_FACTOR * thickness);
    cairo_move_to(cairo, x, y);
    cairo_text_path(cairo, text);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cairo, 1.5 * thickness);
    set_color(cairo, 0xffffff, 1);
    cairo_stroke(cairo);
    set_color(cairo, 0x000000, 1);
    cairo_move_to(cairo, x, y);
    cairo_show_text(cairo, text);
}

void ray_drawing_rays(const RayDrawing *drawing) {
    const RayTree *tree = drawing->tree;
    double thickness = line_thickness(drawing);
    ProjectedRay line;
    for (size_t i = tree->count; i-- > 0;) { // The first rays are drawn last, over all others.
        if (project_clipped(drawing, &tree->nodes[i], &line)) {
            draw_ray(drawing, &line, i);
        }
    }
    for (size_t i = 0; i < tree->count && i < NUMBERED_RAYS_MAXIMUM; i++) {
        if (project_clipped(drawing, &tree->nodes[i], &line)) {
            char number[24];
            snprintf(number, sizeof number, "%zu", i);
            ray_drawing_text(drawing, (line.x[0] + line.x[1]) / 2 + 3 * thickness,
                             (line.y[0] + line.y[1]) / 2 - 2 * thickness, number);
        }
    }
}

void ray_drawing_mark(const RayDrawing *drawing, Vec3d point, unsigned color, const char *label) {
    cairo_t *cairo = drawing->cairo;
    double thickness = line_thickness(drawing), x, y;
    if (!projected_view_point(&drawing->view, point, &x, &y)) {
        return;
    }
    cairo_new_path(cairo);
    cairo_arc(cairo, x, y, MARK_FACTOR * thickness, 0, 2 * M_PI);
    set_color(cairo, color, 1);
    cairo_fill_preserve(cairo);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_width(cairo, thickness);
    set_color(cairo, 0x000000, 1);
    cairo_stroke(cairo);
    if (label) {
        ray_drawing_text(drawing, x + 4 * thickness, y - 2 * thickness, label);
    }
}

void ray_drawing_legend(const RayDrawing *drawing) {
    double thickness = line_thickness(drawing), y = drawing->view.height - FONT_FACTOR * thickness;
    for (int i = RAY_STYLE_COUNT - 1; i >= 0; i--) {
        const RayStyle *style = &ray_styles()[i];
        if (ray_style_is_used(drawing->tree, style)) {
            double middle = y - FONT_FACTOR / 3 * thickness;
            ProjectedRay line = {.x = {6 * thickness, 25 * thickness}, .y = {middle, middle}};
            draw_line(drawing, &line, style, thickness, BORDER_ALPHA);
            ray_drawing_text(drawing, 28 * thickness, y, gettext(style->name));
            y -= 8 * thickness;
        }
    }
}
