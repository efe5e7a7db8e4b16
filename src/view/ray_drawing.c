/**
 * @file
 * @brief Drawing rays: thick lines with a light border, so that they are seen on any ground.
 */
#include "view/ray_drawing.h"

/** Thickness of a ray, as a share of the room's height; at least a pixel and a half. */
static const double THICKNESS = 1.0 / 240;
/** How many times as thick the chosen ray is. */
static const double CHOSEN = 2;
/** How many times as thick as its line a border is. */
static const double BORDER = 2.2;
/** Height of a ray's number, in thicknesses. */
static const double NUMBER = 7;
/** Rays whose numbers are drawn, at most: more would hide the rest. */
enum { NUMBERED_MAXIMUM = 30 };

/** What draws in a room of the window. */
typedef struct Pen {
    SDL_Renderer *renderer; /**< What draws in the window. */
    double x;               /**< Left edge of the room, pixels. */
    double y;               /**< Upper edge. */
    double thickness;       /**< Of a ray, pixels. */
    SDL_Color color;        /**< What it draws in. */
} Pen;

/** @return A pen of a colour. @param pen A pen. @param color 0xRRGGBB. @param alpha 0 to 255. */
static Pen pen_of(const Pen *pen, unsigned color, Uint8 alpha) {
    Pen other = *pen;
    other.color = (SDL_Color){(Uint8)(color >> 16), (Uint8)(color >> 8), (Uint8)color, alpha};
    return other;
}

/** Fills a shape of four corners. @param pen The pen. @param corners Its corners in turn, x and y.
 */
static void fill(const Pen *pen, const double corners[8]) {
    static const int triangles[] = {0, 1, 2, 0, 2, 3};
    SDL_Vertex vertices[4];
    for (int i = 0; i < 4; i++) {
        vertices[i] = (SDL_Vertex){
            .position = {(float)(pen->x + corners[2 * i]), (float)(pen->y + corners[2 * i + 1])},
            .color = pen->color};
    }
    SDL_RenderGeometry(pen->renderer, NULL, vertices, 4, triangles, 6);
}

/** Draws a piece of a line. @param pen The pen. @param line The line. @param from Where the piece
 *  begins, pixels along it. @param to Where it ends. @param thickness Pixels. */
static void draw_piece(const Pen *pen, const RayLine *line, double from, double to,
                       double thickness) {
    double x = line->x[1] - line->x[0], y = line->y[1] - line->y[0], length = hypot(x, y);
    if (!(length > 0)) {
        return;
    }
    double u = x / length, v = y / length, half = thickness / 2;
    double ax = line->x[0] + u * from, ay = line->y[0] + v * from;
    double bx = line->x[0] + u * to, by = line->y[0] + v * to;
    const double corners[] = {ax - v * half, ay + u * half, bx - v * half, by + u * half,
                              bx + v * half, by - u * half, ax + v * half, ay - u * half};
    fill(pen, corners);
}

/** Draws a line, whole or in dashes. @param pen The pen. @param line The line. @param style Its
 *  dashes. @param thickness Pixels. */
static void draw_line(const Pen *pen, const RayLine *line, const RayStyle *style,
                      double thickness) {
    double length = hypot(line->x[1] - line->x[0], line->y[1] - line->y[0]);
    if (style->dash <= 0) {
        draw_piece(pen, line, 0, length, thickness);
        return;
    }
    double dash = style->dash * pen->thickness, turn = dash + style->gap * pen->thickness;
    for (double at = 0; at < length; at += turn) {
        draw_piece(pen, line, at, fmin(at + dash, length), thickness);
    }
}

/** Draws an arrowhead on a line. @param pen The pen. @param line The line. @param thickness Of the
 *  line, pixels. */
static void draw_arrow(const Pen *pen, const RayLine *line, double thickness) {
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
    fill(pen, corners);
}

/** Keeps a line to what can be on screen, so that its dashes are few. @param[in,out] line The line.
 *  @param room The room. @return Whether any of it may be seen. */
static bool line_clip(RayLine *line, const SDL_Rect *room) {
    double first = 0, last = 1;
    const double from[] = {line->x[0], line->y[0]};
    const double way[] = {line->x[1] - line->x[0], line->y[1] - line->y[0]};
    const double size[] = {room->w, room->h};
    // Liang and Barsky: the shares of the way at which it crosses the edges.
    for (int axis = 0; axis < 2; axis++) {
        if (way[axis] == 0) {
            continue;
        }
        double near = -from[axis] / way[axis], far = (size[axis] - from[axis]) / way[axis];
        first = fmax(first, fmin(near, far));
        last = fmin(last, fmax(near, far));
    }
    line->x[1] = from[0] + last * way[0];
    line->y[1] = from[1] + last * way[1];
    line->x[0] = from[0] + first * way[0];
    line->y[0] = from[1] + first * way[1];
    return first < last;
}

/** Draws a ray. @param pen The pen. @param line Where it is seen. @param ray The ray.
 *  @param is_chosen Whether it is the chosen one. */
static void draw_ray(const Pen *pen, const RayLine *line, const ProbeRay *ray, bool is_chosen) {
    const RayStyle *style = ray_style(ray), whole = {0};
    double thickness = pen->thickness * (is_chosen ? CHOSEN : 1);
    Pen border = pen_of(pen, 0xffffff, is_chosen ? 255 : 190);
    Pen ink = pen_of(pen, style->color, 255);
    draw_line(&border, line, &whole, thickness * BORDER);
    draw_line(&ink, line, style, thickness);
    draw_arrow(&ink, line, thickness);
}

/* --- numbers: seven strokes a digit, which need no font -----------------------------------------
 */

/** Strokes of a digit: from the corner x, y to another, in half heights from its upper left one. */
static const double strokes[7][4] = {{0, 0, 1, 0}, {1, 0, 1, 1}, {1, 1, 1, 2}, {0, 2, 1, 2},
                                     {0, 1, 0, 2}, {0, 0, 0, 1}, {0, 1, 1, 1}};
/** Which strokes each digit has: bit i for stroke i. */
static const unsigned char digits[10] = {0x3f, 0x06, 0x5b, 0x4f, 0x66,
                                         0x6d, 0x7d, 0x07, 0x7f, 0x6f};

/** Draws a digit. @param pen The pen. @param digit 0 to 9. @param x Left edge. @param y Upper edge.
 *  @param half Half of its height, pixels. @param thickness Of its strokes, pixels. */
static void draw_digit(const Pen *pen, int digit, double x, double y, double half,
                       double thickness) {
    for (int i = 0; i < 7; i++) {
        const double *s = strokes[i];
        if (digits[digit] >> i & 1) {
            RayLine line = {.x = {x + s[0] * half, x + s[2] * half},
                            .y = {y + s[1] * half, y + s[3] * half}};
            // The ends go over the corners by half of the thickness.
            draw_piece(pen, &line, -thickness / 2, half + thickness / 2, thickness);
        }
    }
}

/** Draws a number with a border. @param pen The pen. @param number It, at least 0. @param x Middle
 *  of its left edge. @param y See there. */
static void draw_number(const Pen *pen, size_t number, double x, double y) {
    char text[24];
    SDL_snprintf(text, sizeof text, "%zu", number);
    double half = NUMBER * pen->thickness / 2;
    const Pen pens[] = {pen_of(pen, 0xffffff, 255), pen_of(pen, 0x000000, 255)};
    const double thick[] = {2.6 * pen->thickness, 0.8 * pen->thickness};
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; text[i]; i++) {
            draw_digit(&pens[pass], text[i] - '0', x + 1.7 * half * i, y - half, half, thick[pass]);
        }
    }
}

/* --- all of it ----------------------------------------------------------------------------------
 */

/** Draws a spot. @param pen The pen. @param x Its middle. @param y Its middle. @param half Half of
 *  its size, pixels. */
static void draw_spot(const Pen *pen, double x, double y, double half) {
    const double corners[] = {x - half, y, x, y - half, x + half, y, x, y + half};
    fill(pen, corners);
}

/** Draws a spot where a point is seen. @param pen The pen. @param sight The second camera.
 *  @param point The point. @param color 0xRRGGBB. */
static void mark_point(const Pen *pen, const RaySight *sight, Vector3 point, unsigned color) {
    double x, y;
    if (ray_sight_point(sight, point, &x, &y)) {
        Pen border = pen_of(pen, 0x000000, 255), ink = pen_of(pen, color, 255);
        draw_spot(&border, x, y, 4 * pen->thickness);
        draw_spot(&ink, x, y, 2.8 * pen->thickness);
    }
}

/** Draws all rays, those that come first in the tree last. @param pen The pen. @param drawing What.
 *  @param sight The second camera. @param room The room. */
static void draw_rays(const Pen *pen, const RayDrawing *drawing, const RaySight *sight,
                      const SDL_Rect *room) {
    const Probe *probe = drawing->probe;
    RayLine line;
    for (size_t i = probe->count; i-- > 0;) {
        if (ray_view_line(drawing->view, sight, &probe->rays[i], &line) && line_clip(&line, room)) {
            draw_ray(pen, &line, &probe->rays[i], i == drawing->chosen);
        }
    }
    for (size_t i = 0; i < probe->count && i < NUMBERED_MAXIMUM; i++) {
        if (ray_view_line(drawing->view, sight, &probe->rays[i], &line) && line_clip(&line, room)) {
            draw_number(pen, i, (line.x[0] + line.x[1]) / 2 + 3 * pen->thickness,
                        (line.y[0] + line.y[1]) / 2 - 4 * pen->thickness);
        }
    }
}

void ray_drawing_show(const RayDrawing *drawing, SDL_Renderer *renderer, const SDL_Rect *room) {
    RaySight sight = ray_view_sight(drawing->view, room->w, room->h);
    Pen pen = {renderer, room->x, room->y, fmax(1.5, THICKNESS * room->h), {0, 0, 0, 255}};
    SDL_RenderSetClipRect(renderer, room);
    SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_BLEND);
    draw_rays(&pen, drawing, &sight, room);
    mark_point(&pen, &sight, drawing->probe->rays[0].origin, 0xffffff);
    for (size_t i = 0; i < drawing->lamp_count; i++) {
        mark_point(&pen, &sight, drawing->lamps[i], 0xf0e442);
    }
    SDL_RenderSetClipRect(renderer, NULL);
}

void ray_drawing_mark(SDL_Renderer *renderer, double x, double y, double size) {
    const Pen pens[] = {{renderer, x, y, 0, {0, 0, 0, 255}},
                        {renderer, x, y, 0, {255, 255, 255, 255}}};
    const double thick[] = {fmax(4, size / 5), fmax(2, size / 10)};
    for (int pass = 0; pass < 2; pass++) {
        for (int arm = 0; arm < 4; arm++) {
            double along = arm & 1 ? 1 : -1, across = arm & 2;
            RayLine line = {.x = {0, across != 0 ? 0 : along * size},
                            .y = {0, across != 0 ? along * size : 0}};
            draw_piece(&pens[pass], &line, size / 3, size, thick[pass]);
        }
    }
}
