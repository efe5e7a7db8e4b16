/**
 * @file
 * @brief Drawing rays: thick lines with a light border, so that they are seen on any ground.
 */
#include "view/panels/ray_overlay.h"

/** Thickness of a ray, as a share of the room's height; at least a pixel and a half. */
static const double LINE_THICKNESS = 1.0 / 240;
/** How many times as thick the chosen ray is. */
static const double SELECTED_FACTOR = 2;
/** How many times as thick as its line a border is. */
static const double BORDER_FACTOR = 2.2;
/** Height of a ray's number, in thicknesses. */
static const double NUMBER_HEIGHT = 7;
/** Rays whose numbers are drawn, at most: more would hide the rest. */
enum { RAY_NUMBERS_MAXIMUM = 30 };

/** What draws in a room of the window. */
typedef struct RayPainter {
    SDL_Renderer *renderer; /**< What draws in the window. */
    double x;               /**< Left edge of the room, pixels. */
    double y;               /**< Upper edge. */
    double thickness;       /**< Of a ray, pixels. */
    SDL_Color color;        /**< What it draws in. */
} RayPainter;

/** @return A pen of a colour. */
static RayPainter painter_with_color(const RayPainter *painter, unsigned color, Uint8 alpha) {
    RayPainter other = *painter;
    other.color = (SDL_Color){(Uint8)(color >> 16), (Uint8)(color >> 8), (Uint8)color, alpha};
    return other;
}

/** Fills a shape of four corners. @param corners Its corners in turn, x and y. */
static void fill_quad(const RayPainter *painter, const double corners[8]) {
    static const int triangles[] = {0, 1, 2, 0, 2, 3};
    SDL_Vertex vertices[4];
    for (int i = 0; i < 4; i++) {
        vertices[i] = (SDL_Vertex){.position = {(float)(painter->x + corners[2 * i]),
                                                (float)(painter->y + corners[2 * i + 1])},
                                   .color = painter->color};
    }
    SDL_RenderGeometry(painter->renderer, NULL, vertices, 4, triangles, 6);
}

/** Draws a piece of a line. @param from Where the piece begins, pixels along it. */
static void draw_segment(const RayPainter *painter, const ProjectedRay *line, double from,
                         double to, double thickness) {
    double x = line->x[1] - line->x[0], y = line->y[1] - line->y[0], length = hypot(x, y);
    if (!(length > 0)) {
        return;
    }
    double u = x / length, v = y / length, half = thickness / 2;
    double ax = line->x[0] + u * from, ay = line->y[0] + v * from;
    double bx = line->x[0] + u * to, by = line->y[0] + v * to;
    const double corners[] = {ax - v * half, ay + u * half, bx - v * half, by + u * half,
                              bx + v * half, by - u * half, ax + v * half, ay - u * half};
    fill_quad(painter, corners);
}

/** Draws a line, whole or in dashes. */
static void draw_line(const RayPainter *painter, const ProjectedRay *line, const RayStyle *style,
                      double thickness) {
    double length = hypot(line->x[1] - line->x[0], line->y[1] - line->y[0]);
    if (style->dash <= 0) {
        draw_segment(painter, line, 0, length, thickness);
        return;
    }
    double dash = style->dash * painter->thickness, period = dash + style->gap * painter->thickness;
    for (double position = 0; position < length; position += period) {
        draw_segment(painter, line, position, fmin(position + dash, length), thickness);
    }
}

/** Draws an arrowhead on a line. @param thickness Of the line, pixels. */
static void draw_arrow(const RayPainter *painter, const ProjectedRay *line, double thickness) {
    /** Thicknesses that it is long; share of the line where its point is. */
    const double size = 5 * thickness, share = 0.6;
    double x = line->x[1] - line->x[0], y = line->y[1] - line->y[0], length = hypot(x, y);
    if (length < 3 * size) {
        return;
    }
    double u = x / length * size, v = y / length * size;
    double px = line->x[0] + share * x, py = line->y[0] + share * y;
    const double corners[] = {px,     py,     px - u - 0.45 * v, py - v + 0.45 * u,
                              px - u, py - v, px - u + 0.45 * v, py - v - 0.45 * u};
    fill_quad(painter, corners);
}

/** Keeps a line to what can be on screen, so that its dashes are few. @return Whether any of it may
 *  be seen. */
static bool clip_line(ProjectedRay *line, const SDL_Rect *rect) {
    double first = 0, last = 1;
    const double from[] = {line->x[0], line->y[0]};
    const double delta[] = {line->x[1] - line->x[0], line->y[1] - line->y[0]};
    const double size[] = {rect->w, rect->h};
    // Liang and Barsky: the shares of the way at which it crosses the edges.
    for (int axis = 0; axis < 2; axis++) {
        if (delta[axis] == 0) {
            continue;
        }
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

/**
 * Draws a ray.
 * @param line  Where it is seen.
 * @param is_selected  Whether it is the chosen one.
 */
static void draw_ray(const RayPainter *painter, const ProjectedRay *line, const RayTreeNode *ray,
                     bool is_selected) {
    const RayStyle *style = ray_style(ray), whole = {0};
    double thickness = painter->thickness * (is_selected ? SELECTED_FACTOR : 1);
    RayPainter border = painter_with_color(painter, 0xffffff, is_selected ? 255 : 190);
    RayPainter ink = painter_with_color(painter, style->color, 255);
    draw_line(&border, line, &whole, thickness * BORDER_FACTOR);
    draw_line(&ink, line, style, thickness);
    draw_arrow(&ink, line, thickness);
}

/* --- numbers: seven strokes a digit, which need no font -----------------------------------------
 */

/** Strokes of a digit: from the corner x, y to another, in half heights from its upper left one. */
static const double segments[7][4] = {{0, 0, 1, 0}, {1, 0, 1, 1}, {1, 1, 1, 2}, {0, 2, 1, 2},
                                      {0, 1, 0, 2}, {0, 0, 0, 1}, {0, 1, 1, 1}};
/** Which strokes each digit has: bit i for stroke i. */
static const unsigned char digit_segments[10] = {0x3f, 0x06, 0x5b, 0x4f, 0x66,
                                                 0x6d, 0x7d, 0x07, 0x7f, 0x6f};

/**
 * Draws a digit.
 * @param half  Half of its height, pixels.
 * @param thickness  Of its strokes, pixels.
 */
static void draw_digit(const RayPainter *painter, int digit, double x, double y, double half,
                       double thickness) {
    for (int i = 0; i < 7; i++) {
        const double *s = segments[i];
        if (digit_segments[digit] >> i & 1) {
            ProjectedRay line = {.x = {x + s[0] * half, x + s[2] * half},
                                 .y = {y + s[1] * half, y + s[3] * half}};
            // The ends go over the corners by half of the thickness.
            draw_segment(painter, &line, -thickness / 2, half + thickness / 2, thickness);
        }
    }
}

/**
 * Draws a number with a border.
 * @param number  It, at least 0.
 * @param x  Middle of its left edge.
 */
static void draw_number(const RayPainter *painter, size_t number, double x, double y) {
    char text[24];
    SDL_snprintf(text, sizeof text, "%zu", number);
    double half = NUMBER_HEIGHT * painter->thickness / 2;
    const RayPainter painters[] = {painter_with_color(painter, 0xffffff, 255),
                                   painter_with_color(painter, 0x000000, 255)};
    const double thick[] = {2.6 * painter->thickness, 0.8 * painter->thickness};
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; text[i]; i++) {
            draw_digit(&painters[pass], text[i] - '0', x + 1.7 * half * i, y - half, half,
                       thick[pass]);
        }
    }
}

/* --- all of it ----------------------------------------------------------------------------------
 */

/** Draws a spot. @param half Half of its size, pixels. */
static void draw_marker(const RayPainter *painter, double x, double y, double half) {
    const double corners[] = {x - half, y, x, y - half, x + half, y, x, y + half};
    fill_quad(painter, corners);
}

/** Draws a spot where a point is seen. */
static void mark_point(const RayPainter *painter, const ProjectedView *projected, Vec3d point,
                       unsigned color) {
    double x, y;
    if (projected_view_point(projected, point, &x, &y)) {
        RayPainter border = painter_with_color(painter, 0x000000, 255),
                   ink = painter_with_color(painter, color, 255);
        draw_marker(&border, x, y, 4 * painter->thickness);
        draw_marker(&ink, x, y, 2.8 * painter->thickness);
    }
}

/** Draws all rays, those that come first in the tree last. */
static void draw_rays(const RayPainter *painter, const RayOverlay *overlay,
                      const ProjectedView *projected, const SDL_Rect *rect) {
    const RayTree *ray_tree = overlay->ray_tree;
    ProjectedRay line;
    for (size_t i = ray_tree->count; i-- > 0;) {
        if (orbit_camera_project_ray(overlay->orbit, projected, &ray_tree->nodes[i], &line) &&
            clip_line(&line, rect)) {
            draw_ray(painter, &line, &ray_tree->nodes[i], i == overlay->selected);
        }
    }
    for (size_t i = 0; i < ray_tree->count && i < RAY_NUMBERS_MAXIMUM; i++) {
        if (orbit_camera_project_ray(overlay->orbit, projected, &ray_tree->nodes[i], &line) &&
            clip_line(&line, rect)) {
            draw_number(painter, i, (line.x[0] + line.x[1]) / 2 + 3 * painter->thickness,
                        (line.y[0] + line.y[1]) / 2 - 4 * painter->thickness);
        }
    }
}

void ray_overlay_draw(const RayOverlay *overlay, SDL_Renderer *renderer, const SDL_Rect *rect) {
    ProjectedView projected = orbit_camera_project(overlay->orbit, rect->w, rect->h);
    RayPainter painter = {
        renderer, rect->x, rect->y, fmax(1.5, LINE_THICKNESS * rect->h), {0, 0, 0, 255}};
    SDL_RenderSetClipRect(renderer, rect);
    SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_BLEND);
    draw_rays(&painter, overlay, &projected, rect);
    mark_point(&painter, &projected, overlay->ray_tree->nodes[0].origin, 0xffffff);
    for (size_t i = 0; i < overlay->light_count; i++) {
        mark_point(&painter, &projected, overlay->light_positions[i], 0xf0e442);
    }
    SDL_RenderSetClipRect(renderer, NULL);
}

void ray_overlay_mark_pixel(SDL_Renderer *renderer, double x, double y, double size) {
    const RayPainter painters[] = {{renderer, x, y, 0, {0, 0, 0, 255}},
                                   {renderer, x, y, 0, {255, 255, 255, 255}}};
    const double thick[] = {fmax(4, size / 5), fmax(2, size / 10)};
    for (int pass = 0; pass < 2; pass++) {
        for (int arm = 0; arm < 4; arm++) {
            double along = arm & 1 ? 1 : -1, across = arm & 2;
            ProjectedRay line = {.x = {0, across != 0 ? 0 : along * size},
                                 .y = {0, across != 0 ? along * size : 0}};
            draw_segment(&painters[pass], &line, size / 3, size, thick[pass]);
        }
    }
}
