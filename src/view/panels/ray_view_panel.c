/**
 * @file
 * @brief Words and numbers of the view of rays: the list, the formulas, the sum, the numbers at the
 * rays.
 */
#include "view/panels/ray_view.h"

#include "base/language.h"
#include "base/typeset_numbers.h"
#include "render/ray_hit.h"
#include "view/gui/gui.h"
#include "view/panels/tooltip.h"

#include <libintl.h>
#include <stdio.h>

/** Rows of the list, at most: those around the chosen ray. */
enum { ROWS_MAXIMUM = 400 };
/** Bytes of a row with the final zero. */
enum { ROW_SIZE = 128 };
/** Most steps that a row is moved to the right. */
enum { INDENT_MAXIMUM = 6 };
/** Largest part of the view for the row of buttons. */
static const double BUTTONS_FRACTION_MAXIMUM = 0.3;

/** Adds how the colour of the pixel becomes one of the screen. @param text How, in words. */
static void add_screen_color(RayFormulas *sum, const char *text, const int code[3]) {
    if (sum->count < RAY_FORMULAS_MAXIMUM) {
        RayFormula *last = &sum->items[sum->count++];
        snprintf(last->label, sizeof last->label, "%s", gettext("on the screen"));
        snprintf(last->text, sizeof last->text, "%s %d %d %d", text, code[0], code[1], code[2]);
    }
}

/** Writes the numbers of formulas as readers of the language do. */
static void localize_formulas(RayFormulas *formulas) {
    for (size_t i = 0; i < formulas->count; i++) {
        typeset_numbers(formulas->items[i].text, sizeof formulas->items[i].text);
    }
}

void ray_view_write_text(RayView *ray_view, const RayViewInput *input, int x, int y) {
    Encoder encoder;
    const RenderSettings *settings = &input->viewport->settings;
    const Rgbd *color = &ray_view->ray_tree.nodes[0].color;
    const RayFormulaInput formulas = {input->scene, &ray_view->ray_tree,
                                      settings->trace.methods == 0};
    encoder_init(&encoder, (Encoding)settings->encoding);
    const int code[3] = {encoder_encode(&encoder, (float)color->red),
                         encoder_encode(&encoder, (float)color->green),
                         encoder_encode(&encoder, (float)color->blue)};
    // The picture's pixel is the mean of its samples.
    snprintf(ray_view->heading, sizeof ray_view->heading,
             gettext("Pixel (%d, %d), one ray: #%02x%02x%02x"), x, y, (unsigned)code[0],
             (unsigned)code[1], (unsigned)code[2]);
    ray_formulas_write(&formulas, ray_view->selected, &ray_view->formulas);
    localize_formulas(&ray_view->formulas);
    ray_sum_write(&formulas, ray_view->selected, &ray_view->sum);
    if (ray_view->selected == 0) {
        add_screen_color(&ray_view->sum,
                         settings->encoding == ENCODING_SRGB ? gettext("255 × its sRGB curve =")
                                                             : gettext("255 × it ="),
                         code);
    }
    localize_formulas(&ray_view->sum);
}

/* --- the list --------------------------------------------------------------------------------- */

/** Describes a ray: its kind, its share of its parent's light, and what it hits. */
static void describe_ray(const RayTree *tree, const Scene *scene, size_t index,
                         char text[ROW_SIZE]) {
    static const char *const kinds[] = {[RAY_REFLECTION] = N_("mirrored %.3g %%: %s"),
                                        [RAY_REFRACTION] = N_("refracted %.3g %%: %s")};
    const RayTreeNode *ray = &tree->nodes[index];
    char name[RAY_HIT_NAME_SIZE];
    int length = snprintf(text, ROW_SIZE, "%zu  ", index);
    char *rest = text + length;
    size_t size = ROW_SIZE - (size_t)length;
    ray_hit_name(scene, ray, name);
    if (ray->kind == RAY_CAMERA) {
        snprintf(rest, size, gettext("camera: %s"), name);
    } else if (ray->kind != RAY_SHADOW) {
        double share = fmax(ray->weight.red, fmax(ray->weight.green, ray->weight.blue));
        snprintf(rest, size, gettext(kinds[ray->kind]), 100 * share, name);
        typeset_numbers(rest, size);
    } else if (ray->shape >= 0) {
        snprintf(rest, size, gettext("lamp %d: behind %s"), ray->light + 1, name);
    } else {
        snprintf(rest, size,
                 ray->is_hit                 ? gettext("lamp %d: dark")
                 : ray_is_through_glass(ray) ? gettext("lamp %d: lit through glass")
                                             : gettext("lamp %d: lit"),
                 ray->light + 1);
    }
}

/** Splits a colour. @param color 0xRRGGBB. */
static void split_color(unsigned color, unsigned char rgb[3]) {
    rgb[0] = (unsigned char)(color >> 16);
    rgb[1] = (unsigned char)(color >> 8);
    rgb[2] = (unsigned char)color;
}

/** Shows the row of a ray. */
static void show_row(RayView *ray_view, const Scene *scene, size_t index) {
    const RayTreeNode *ray = &ray_view->ray_tree.nodes[index];
    bool is_selected = index == ray_view->selected;
    unsigned char rgb[3];
    char text[ROW_SIZE];
    split_color(ray_style(ray)->color, rgb);
    describe_ray(&ray_view->ray_tree, scene, index, text);
    if (gui_list_row((int)index, text, SDL_min(ray->depth, INDENT_MAXIMUM), rgb, is_selected,
                     is_selected && ray_view->frames_to_reveal > 0)) {
        ray_view->request.has_ray = true;
        ray_view->request.ray = index;
    }
}

/** Shows the rows of the rays, or of those around the chosen one. */
static void show_rows(RayView *ray_view, const Scene *scene) {
    size_t count = ray_view->ray_tree.count, selected = ray_view->selected;
    size_t first = selected > ROWS_MAXIMUM / 2 ? selected - ROWS_MAXIMUM / 2 : 0;
    size_t last = SDL_min(first + ROWS_MAXIMUM, count);
    for (size_t i = first; i < last; i++) {
        if (!(ray_view->hidden_kinds >> ray_view->ray_tree.nodes[i].kind & 1)) {
            show_row(ray_view, scene, i);
        }
    }
    if (last - first < count) {
        char text[ROW_SIZE];
        snprintf(text, sizeof text, gettext("%zu to %zu of %zu rays"), first, last - 1, count);
        gui_list_text("", text);
    }
    if (count > 0) {
        ray_view->frames_to_reveal = SDL_max(0, ray_view->frames_to_reveal - 1);
    }
}

/** Shows the check boxes of the kinds of rays. */
static void show_kinds(RayView *ray_view, const Help *help) {
    static const struct {
        const char *command; /**< What hides them. */
        const char *label;   /**< In English. */
        size_t style;        /**< Index of their style. */
    } kinds[RAY_KINDS] = {[RAY_CAMERA] = {"camera rays", N_("camera"), 0},
                          [RAY_SHADOW] = {"shadow rays", N_("shadow"), 3},
                          [RAY_REFLECTION] = {"mirrored rays", N_("mirrored"), 1},
                          [RAY_REFRACTION] = {"refracted rays", N_("refracted"), 2}};
    for (size_t i = 0; i < RAY_KINDS; i++) {
        char tooltip[TOOLTIP_SIZE];
        unsigned char rgb[3];
        split_color(i == RAY_CAMERA ? RAY_MARK_EYE : ray_styles()[kinds[i].style].color, rgb);
        if (gui_list_check(gettext(kinds[i].label), rgb,
                           tooltip_write(help, kinds[i].command, tooltip),
                           !(ray_view->hidden_kinds >> i & 1))) {
            ray_view->request.command = kinds[i].command;
        }
    }
}

/** Shows formulas, one below the other. */
static void show_formulas(const RayFormulas *formulas) {
    for (size_t i = 0; i < formulas->count; i++) {
        gui_list_text(formulas->items[i].label, formulas->items[i].text);
    }
    if (formulas->omitted > 0) {
        char text[ROW_SIZE];
        snprintf(text, sizeof text, gettext("and %zu more"), formulas->omitted);
        gui_list_text("", text);
    }
}

/** @return A rectangle as a corner. */
static GuiPoint corner_of(const SDL_Rect *rect) {
    return (GuiPoint){(float)rect->x, (float)rect->y};
}

/** @return A rectangle as a size. */
static GuiPoint size_of(const SDL_Rect *rect) {
    return (GuiPoint){(float)rect->w, (float)rect->h};
}

/** @return What the present drawing shows and what to do next, in English. */
static const char *hint_of(const RayView *ray_view) {
    static const char *const hints[] = {
        [RAY_PANE_NONE] = N_("Click a row or a ray: its formulas. Space: the next ray flies. Click "
                             "the small picture: another pixel. Esc: back to the picture."),
        [RAY_PANE_PLAN] = N_("The plan shows the rays from above. A drag turns the view beside "
                             "it; plan once more takes it away."),
        [RAY_PANE_MARCH] = N_("Each ball is free of surfaces: the ray steps to its edge. Choose "
                              "another ray; march once more takes it away."),
        [RAY_PANE_MICROSCOPE] = N_("The hit point magnified: change offset or number type, and "
                                   "see where the next ray starts.")};
    return ray_view->pane < sizeof hints / sizeof *hints && hints[ray_view->pane]
               ? hints[ray_view->pane]
               : hints[RAY_PANE_NONE];
}

/** Shows the list of rays. */
static void show_list(RayView *ray_view, const Scene *scene, const SDL_Rect *rect) {
    gui_list_begin("rays", corner_of(rect), size_of(rect));
    gui_heading(ray_view->heading);
    show_rows(ray_view, scene);
    if (ray_view->shows_hint) {
        gui_paragraph(gettext(hint_of(ray_view)), GUI_COLOR_FAINT, 1);
    }
    gui_panel_end();
}

void ray_view_show_buttons(RayView *ray_view, const Help *help) {
    const struct {
        const char *command; /**< What the button does. */
        const char *label;   /**< In English. */
        bool is_on;          /**< Whether it is shown. */
    } buttons[] = {{"rays", N_("✕ close"), false},
                   {"fly ray", N_("next ray"), false},
                   {"ray plan", N_("plan"), ray_view->pane == RAY_PANE_PLAN},
                   {"ray march", N_("march"), ray_view->pane == RAY_PANE_MARCH},
                   {"hit microscope", N_("microscope"), ray_view->pane == RAY_PANE_MICROSCOPE},
                   {"arrows", N_("arrows"), ray_view->is_along_light}};
    for (size_t i = 0; i < sizeof buttons / sizeof *buttons; i++) {
        char tooltip[TOOLTIP_SIZE];
        if (gui_button(gettext(buttons[i].label), tooltip_write(help, buttons[i].command, tooltip),
                       buttons[i].is_on)) {
            ray_view->request.command = buttons[i].command;
        }
    }
    show_kinds(ray_view, help);
}

void ray_view_show_own_row(RayView *ray_view, const Help *help, const SDL_Rect *area) {
    gui_row_begin("ray buttons", (GuiPoint){(float)area->x, (float)area->y}, (float)area->w);
    ray_view_show_buttons(ray_view, help);
    double fraction = (double)gui_bar_end() / SDL_max(1, area->h);
    ray_view_set_buttons(ray_view, SDL_min(fraction, BUTTONS_FRACTION_MAXIMUM));
}

/** Shows the formulas of the chosen ray, and its sum below them. @param is_new Whether it was just
 *  chosen. */
static void show_chosen(const RayView *ray_view, const SDL_Rect *rect, bool is_new) {
    const RayTreeNode *ray = &ray_view->ray_tree.nodes[ray_view->selected];
    char text[ROW_SIZE];
    gui_list_begin("formulas", corner_of(rect), size_of(rect));
    if (is_new) {
        gui_scroll_to_top();
    }
    gui_scroll_pages(ray_view->pages_to_scroll);
    snprintf(text, sizeof text, gettext("Ray %zu: %s"), ray_view->selected,
             gettext(ray_style(ray)->name));
    gui_heading(text);
    show_formulas(&ray_view->formulas);
    snprintf(text, sizeof text, gettext("The sum of ray %zu"), ray_view->selected);
    gui_heading(text);
    show_formulas(&ray_view->sum);
    gui_panel_end();
}

/* --- over the picture ------------------------------------------------------------------------- */

/** Shows the chosen ray in flight. @param fraction How far, 0 to 1. */
static void show_flight(const RayDrawing *drawing, const SDL_Rect *view, double scale,
                        double fraction) {
    ProjectedRay line;
    unsigned char rgb[3];
    if (fraction >= 1 || !ray_drawing_project(drawing, drawing->selected, &line)) {
        return;
    }
    split_color(ray_style(&drawing->tree->nodes[drawing->selected])->color, rgb);
    double x = line.x[0] + fraction * (line.x[1] - line.x[0]);
    double y = line.y[0] + fraction * (line.y[1] - line.y[0]);
    gui_flight(
        (GuiPoint){(float)(view->x + line.x[0] / scale), (float)(view->y + line.y[0] / scale)},
        (GuiPoint){(float)(view->x + x / scale), (float)(view->y + y / scale)}, rgb);
}

/** Shows the numbers of the rays. @param view In screen units. @param scale Pixels per unit. */
static void show_numbers(const RayDrawing *drawing, const SDL_Rect *view, double scale) {
    RayLabel labels[RAY_LABELS_MAXIMUM];
    LabelBox boxes[RAY_LABELS_MAXIMUM];
    size_t count = ray_drawing_labels(drawing, labels, boxes);
    for (size_t i = 0; i < count; i++) {
        boxes[i].from_x /= scale;
        boxes[i].from_y /= scale;
        boxes[i].to_x /= scale;
        boxes[i].to_y /= scale;
        boxes[i].width = (double)gui_text_width(labels[i].text);
        boxes[i].height = (double)gui_text_size();
    }
    labels_place(boxes, count, view->w, view->h);
    for (size_t i = count; i-- > 0;) {
        const LabelBox *box = &boxes[i];
        if (box->is_placed) {
            GuiPoint anchor = {(float)(view->x + box->anchor_x), (float)(view->y + box->anchor_y)};
            gui_label(labels[i].text, anchor,
                      (GuiPoint){(float)(view->x + box->x), (float)(view->y + box->y)},
                      labels[i].ray == drawing->selected);
        }
    }
}

void ray_view_show_widgets(RayView *ray_view, const Scene *scene, const SDL_Rect *area,
                           double scale) {
    RayViewLayout layout = ray_view_layout(ray_view, area);
    SDL_Rect pixels = {0, 0, (int)(layout.view.w * scale), (int)(layout.view.h * scale)};
    if (ray_view->ray_tree.count == 0) {
        return;
    }
    RayDrawing drawing = ray_view_drawing(ray_view, &pixels);
    show_flight(&drawing, &layout.view, scale, ray_view_flight(ray_view, clock_now_seconds()));
    show_numbers(&drawing, &layout.view, scale);
    const bool is_new = ray_view->frames_to_reveal > 0;
    show_list(ray_view, scene, &layout.list);
    show_chosen(ray_view, &layout.formulas, is_new);
    ray_view->pages_to_scroll = 0;
}
