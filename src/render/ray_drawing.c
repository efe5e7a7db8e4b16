/**
 * @file
 * @brief Draws the rays of a pixel.
 *
 * Everything has a light border, so that it is seen on any background.
 */
#include "render/ray_drawing.h"

#include "base/language.h"

#include <float.h>
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
/** Length of a normal, relative to the height of the drawing. */
static const double NORMAL_LENGTH = 0.22;
/** Opacity of the rays that are not selected, if one is. */
static const double DIM_ALPHA = 0.55;

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

/** @return The height of letters. */
static double text_size(const RayDrawing *drawing) {
    return drawing->text_size > 0 ? drawing->text_size : FONT_FACTOR * line_thickness(drawing);
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
static void draw_arrow(const RayDrawing *drawing, const ProjectedRay *ray, double thickness) {
    const double size = ARROW_FACTOR * thickness;
    const ProjectedRay reversed = {{ray->x[1], ray->x[0]}, {ray->y[1], ray->y[0]}, false};
    const ProjectedRay *line = drawing->is_along_light ? &reversed : ray;
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

/** @return Whether a ray is drawn. */
static bool is_shown(const RayDrawing *drawing, size_t index) {
    return !(drawing->hidden_kinds >> drawing->tree->nodes[index].kind & 1);
}

/** Projects a ray and clips it to the drawing (Liang and Barsky), so that arrowhead and number are
 *  in sight and dashes are few. @return Whether any of it is in sight. */
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
            if (from[axis] < 0 || from[axis] > size[axis]) {
                return false;
            }
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

bool ray_drawing_project(const RayDrawing *drawing, size_t index, ProjectedRay *line) {
    return is_shown(drawing, index) && project_clipped(drawing, &drawing->tree->nodes[index], line);
}

/** Draws a ray. */
static void draw_ray(const RayDrawing *drawing, const ProjectedRay *line, size_t index) {
    bool is_selected = index == drawing->selected;
    double thickness = line_thickness(drawing) * (is_selected ? SELECTED_FACTOR : 1);
    draw_line(drawing, line, ray_style(&drawing->tree->nodes[index]), thickness,
              is_selected ? 1 : BORDER_ALPHA);
    draw_arrow(drawing, line, thickness);
}

/** Draws how a blocked shadow ray would go on to its lamp. */
static void draw_missing_light(const RayDrawing *drawing, size_t index) {
    RayTreeNode beyond = drawing->tree->nodes[index];
    ProjectedRay line;
    if (beyond.kind != RAY_SHADOW || !beyond.is_hit || !is_shown(drawing, index) ||
        !(isfinite(beyond.limit) && beyond.distance < beyond.limit)) {
        return;
    }
    beyond.origin = vec3d_add(beyond.origin, vec3d_scale(beyond.direction, beyond.distance));
    beyond.limit -= beyond.distance;
    beyond.distance = HUGE_VAL;
    if (project_clipped(drawing, &beyond, &line)) {
        const RayStyle dots = {ray_style(&drawing->tree->nodes[index])->color, 1, 3, NULL};
        draw_line(drawing, &line, &dots, line_thickness(drawing), BORDER_ALPHA / 2);
    }
}

/** Draws the normal at a point: on both sides of what lets rays through, else on that of the ray.
 *  @param ray The ray that meets the surface there. */
static void draw_normal(const RayDrawing *drawing, const RayTreeNode *ray) {
    static const RayStyle style = {0x404040, 4, 2, NULL};
    if (!ray->is_hit || ray->shape < 0 || ray->kind == RAY_SHADOW) {
        return;
    }
    const double scale = projected_view_scale(&drawing->view, ray->point);
    const double length = NORMAL_LENGTH * drawing->view.height / fmax(scale, DBL_MIN);
    const double side = vec3d_dot(ray->direction, ray->normal) > 0 ? -length : length;
    const double behind = ray->surface.is_transparent ? -side : 0;
    const Vec3d from = vec3d_add(ray->point, vec3d_scale(ray->normal, behind));
    const Vec3d to = vec3d_add(ray->point, vec3d_scale(ray->normal, side));
    ProjectedRay line;
    if (projected_view_point(&drawing->view, from, &line.x[0], &line.y[0]) &&
        projected_view_point(&drawing->view, to, &line.x[1], &line.y[1])) {
        draw_line(drawing, &line, &style, line_thickness(drawing), BORDER_ALPHA);
    }
}

/** Draws the normals where the selected ray starts and ends. */
static void draw_normals(const RayDrawing *drawing) {
    const RayTreeNode *ray = &drawing->tree->nodes[drawing->selected];
    draw_normal(drawing, ray);
    if (ray->parent >= 0) {
        draw_normal(drawing, &drawing->tree->nodes[ray->parent]);
    }
}

void ray_drawing_text(const RayDrawing *drawing, double x, double y, const char *text) {
    cairo_t *cairo = drawing->cairo;
    double thickness = line_thickness(drawing);
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, text_size(drawing));
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

/** Draws the rays but the selected one. */
static void draw_other_rays(const RayDrawing *drawing) {
    ProjectedRay line;
    for (size_t i = drawing->tree->count; i-- > 0;) { // The first rays lie over all others.
        if (i != drawing->selected && ray_drawing_project(drawing, i, &line)) {
            draw_missing_light(drawing, i);
            draw_ray(drawing, &line, i);
        }
    }
}

void ray_drawing_rays(const RayDrawing *drawing) {
    bool is_dim = drawing->selected < drawing->tree->count;
    ProjectedRay line;
    if (is_dim) {
        cairo_push_group(drawing->cairo);
    }
    draw_other_rays(drawing);
    if (is_dim) {
        cairo_pop_group_to_source(drawing->cairo);
        cairo_paint_with_alpha(drawing->cairo, DIM_ALPHA);
    }
    if (is_dim && !drawing->hides_selected &&
        ray_drawing_project(drawing, drawing->selected, &line)) {
        draw_missing_light(drawing, drawing->selected);
        draw_ray(drawing, &line, drawing->selected);
        draw_normals(drawing);
    }
}

/* --- numbers ---------------------------------------------------------------------------------- */

/** Adds the number of a ray, if the ray is in sight. @return How many there are then. */
static size_t add_label(const RayDrawing *drawing, size_t ray, size_t count, RayLabel *labels,
                        LabelBox *boxes) {
    ProjectedRay line;
    if (count == RAY_LABELS_MAXIMUM || !ray_drawing_project(drawing, ray, &line)) {
        return count;
    }
    labels[count].ray = ray;
    snprintf(labels[count].text, RAY_LABEL_SIZE, "%zu", ray);
    boxes[count] =
        (LabelBox){.from_x = line.x[0], .from_y = line.y[0], .to_x = line.x[1], .to_y = line.y[1]};
    return count + 1;
}

/** Rays that all have their numbers. */
enum { RAYS_WITH_NUMBERS = 10 };

/** @return Whether a ray comes from another, at once or after others. */
static bool comes_from(const RayTree *tree, size_t ray, size_t ancestor) {
    while (ray > ancestor) { // A parent stands before its children.
        ray = (size_t)tree->nodes[ray].parent;
    }
    return ray == ancestor;
}

/** @return Whether a ray has its number. See #ray_drawing_labels. */
static bool has_number(const RayDrawing *drawing, size_t ray) {
    const RayTree *tree = drawing->tree;
    const size_t selected = drawing->selected;
    if (tree->count <= RAYS_WITH_NUMBERS || selected >= tree->count ||
        ray + 1 == drawing->hovered) {
        return true;
    }
    bool is_beside =
        ray > 0 && selected > 0 && tree->nodes[ray].parent == tree->nodes[selected].parent;
    bool is_begun = ray > 0 && (size_t)tree->nodes[ray].parent == selected;
    return is_beside || is_begun || comes_from(tree, selected, ray);
}

size_t ray_drawing_labels(const RayDrawing *drawing, RayLabel labels[RAY_LABELS_MAXIMUM],
                          LabelBox boxes[RAY_LABELS_MAXIMUM]) {
    size_t count = 0;
    if (drawing->selected < drawing->tree->count) {
        count = add_label(drawing, drawing->selected, count, labels, boxes);
    }
    for (size_t i = 0; i < drawing->tree->count && count < RAY_LABELS_MAXIMUM; i++) {
        if (i != drawing->selected && has_number(drawing, i)) {
            count = add_label(drawing, i, count, labels, boxes);
        }
    }
    return count;
}

/** Draws the line from a ray to its number. */
static void draw_leader(const RayDrawing *drawing, const LabelBox *box) {
    cairo_t *cairo = drawing->cairo;
    cairo_move_to(cairo, box->anchor_x, box->anchor_y);
    cairo_line_to(cairo, box->x + box->width / 2, box->y + box->height / 2);
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_width(cairo, line_thickness(drawing) / 2);
    set_color(cairo, 0x000000, BORDER_ALPHA);
    cairo_stroke(cairo);
}

void ray_drawing_numbers(const RayDrawing *drawing) {
    RayLabel labels[RAY_LABELS_MAXIMUM];
    LabelBox boxes[RAY_LABELS_MAXIMUM];
    size_t count = ray_drawing_labels(drawing, labels, boxes);
    double size = text_size(drawing);
    for (size_t i = 0; i < count; i++) {
        cairo_text_extents_t extents;
        cairo_set_font_size(drawing->cairo, size);
        cairo_text_extents(drawing->cairo, labels[i].text, &extents);
        boxes[i].width = extents.x_advance;
        boxes[i].height = size;
    }
    labels_place(boxes, count, drawing->view.width, drawing->view.height);
    for (size_t i = 0; i < count; i++) {
        if (boxes[i].is_placed) {
            draw_leader(drawing, &boxes[i]);
        }
    }
    for (size_t i = 0; i < count; i++) {
        if (boxes[i].is_placed) {
            // The base line of digits: they are as high as most of their size.
            ray_drawing_text(drawing, boxes[i].x, boxes[i].y + 0.85 * size, labels[i].text);
        }
    }
}

/* --- sphere tracing --------------------------------------------------------------------------- */

/** Opacity of a sphere of free distance. */
static const double SPHERE_ALPHA = 0.07;
/** Opacity of its edge. */
static const double SPHERE_EDGE_ALPHA = 0.8;
/** Colour of the spheres: Okabe and Ito's vermilion. */
static const unsigned SPHERE_COLOR = 0xD55E00;

void ray_drawing_march(const RayDrawing *drawing) {
    const RayTree *tree = drawing->tree;
    cairo_t *cairo = drawing->cairo;
    if (drawing->selected >= tree->count) {
        return;
    }
    const RayTreeNode *ray = &tree->nodes[drawing->selected];
    cairo_set_dash(cairo, NULL, 0, 0);
    cairo_set_line_width(cairo, line_thickness(drawing) / 2);
    for (size_t i = 0; i < ray->step_count; i++) {
        const RayMarchStep *step = &tree->steps[ray->first_step + i];
        Vec3d point = vec3d_add(ray->origin, vec3d_scale(ray->direction, step->distance));
        double x, y;
        if (projected_view_point(&drawing->view, point, &x, &y)) {
            double radius = step->radius * projected_view_scale(&drawing->view, point);
            cairo_new_path(cairo);
            cairo_arc(cairo, x, y, fmax(radius, 0.5), 0, 2 * M_PI);
            set_color(cairo, SPHERE_COLOR, SPHERE_ALPHA);
            cairo_fill_preserve(cairo);
            set_color(cairo, SPHERE_COLOR, SPHERE_EDGE_ALPHA);
            cairo_stroke(cairo);
        }
    }
}

/* --- picking ---------------------------------------------------------------------------------- */

/** @return The distance of a point from a line, pixels. */
static double distance_from_line(const ProjectedRay *line, double x, double y) {
    double along_x = line->x[1] - line->x[0], along_y = line->y[1] - line->y[0];
    double squared = along_x * along_x + along_y * along_y;
    double t = (x - line->x[0]) * along_x + (y - line->y[0]) * along_y;
    t = squared > 0 ? fmin(fmax(t / squared, 0), 1) : 0;
    return hypot(line->x[0] + t * along_x - x, line->y[0] + t * along_y - y);
}

size_t ray_drawing_at(const RayDrawing *drawing, double x, double y, double reach) {
    size_t found = RAY_DRAWING_UNSELECTED;
    ProjectedRay line;
    for (size_t i = 0; i < drawing->tree->count; i++) {
        if (ray_drawing_project(drawing, i, &line)) {
            double distance = distance_from_line(&line, x, y);
            if (distance < reach) {
                reach = distance;
                found = i;
            }
        }
    }
    return found;
}

/* --- marks ------------------------------------------------------------------------------------ */

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
