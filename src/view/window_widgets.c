/**
 * @file
 * @brief Buttons, lists, marks and panels over the picture: one frame of them.
 */
#include "view/window_internal.h"

#include <math.h>

/** How near to a light's mark the mouse takes hold of it, in heights of letters. */
static const float MARK_REACH = 0.9F;

void window_set_state(Window *window, const WindowState *state) {
    window->state = *state;
}

/** Lays the bar out: that of the rays, if they are shown, has another height. */
static void layout_bar(Window *window) {
    const float height = window->toolbar.height;
    const WindowState *state = &window->state;
    RenderSettings settings = window_requested_settings(window);
    ToolbarContent content = {.help = &window->help,
                              .settings = &settings,
                              .layer = window_active_viewport(window)->layer,
                              .split = window->split.mode,
                              .shows_settings = window->shows_settings,
                              .rays = window->ray_view.is_open ? &window->ray_view : NULL,
                              .shows_chart = window->settings_chart.is_open,
                              .shows_magnifier = window->magnifier.is_on,
                              .lists_things = window->object_inspector.lists,
                              .is_animated = state->is_animated,
                              .is_running = state->is_running,
                              .is_recording = state->is_recording,
                              .is_playing = state->is_playing,
                              .shows_scenes = window->browser.is_open,
                              .can_undo = state->can_undo,
                              .can_redo = state->can_redo};
    toolbar_show(&window->toolbar, &content);
    if (window->ray_view.is_open && height != window->toolbar.height) {
        ray_view_on_room_changed(&window->ray_view);
        gui_request_frames(window->gui);
    }
}

/** Shows the bar, but not in a presentation, and not its button alone where that would cover the
 *  words of a lesson or of rays. */
static void show_toolbar(Window *window) {
    Toolbar *toolbar = &window->toolbar;
    bool has_words = window->lesson_panel.lesson || window->ray_view.is_open;
    if (!window->is_presenting && !(toolbar->is_folded && has_words)) {
        layout_bar(window);
    } else {
        toolbar->height = 0;
    }
    if (!window->ray_view.is_open || toolbar->height == 0) {
        toolbar->usual_height = toolbar->height;
    }
}

/** Gives the mouse the shape of what it does: a hand over a light, arrows at the bar between two
 *  pictures and while something is dragged. */
static void show_cursor(const Window *window) {
    int x = 0, y = 0;
    double right = 0, down = 0;
    Uint32 buttons = SDL_GetMouseState(&x, &y);
    bool is_inside = SDL_GetMouseFocus() == window->sdl.window && !window->help.is_open &&
                     !window->browser.is_open &&
                     window_picture_position(window, x, y, &right, &down);
    if (!is_inside) {
        return;
    }
    bool is_at_bar = !window->ray_view.is_open && window_is_at_bar(window, right);
    if (window->split.is_dragged || is_at_bar) {
        gui_set_cursor(GUI_CURSOR_SIDEWAYS);
    } else if (buttons & SDL_BUTTON_LMASK) {
        gui_set_cursor(GUI_CURSOR_MOVE);
    } else if (window_light_at(window, x, y)) {
        gui_set_cursor(GUI_CURSOR_HAND);
    }
}

/** Shows the marks of the lights: also in a presentation, and where the window is too small for the
 *  toolbar; but not below the name of a layer, for as long as that is shown. */
static void show_light_marks(Window *window) {
    const bool is_free = !window->ray_view.is_open && window->layer_name.text[0] == '\0';
    if (is_free && !window->hides_toolbar && window->state.scene) {
        SDL_Rect picture = window_to_units(window, window_picture_rect(window));
        light_marks_show(&window->light_marks, window->state.scene, &picture,
                         window->state.selected_light);
    }
}

/** Shows the help, and requests the command that is clicked there. */
static void show_help(Window *window, const GuiRect *area) {
    help_show(&window->help, area);
    if (window->help.requested) {
        window->toolbar.command = window->help.requested->name;
        window->toolbar.repetitions = 1;
        window->toolbar.continues = false;
        window->help.requested = NULL;
    }
}

/** Shows the selected object's outline and inspector. */
static void show_object_inspector(Window *window) {
    const WindowState *state = &window->state;
    ObjectInspector *inspector = &window->object_inspector;
    SDL_Rect picture = window_to_units(window, window_picture_rect(window));
    SceneObject object;
    bool is_light = inspector->number > 0 && !scene_object_is_shape(inspector->keyword) &&
                    scene_object_find(state->scene, inspector->keyword, inspector->number, &object);
    if (!state->scene || window->ray_view.is_open) {
        return;
    }
    object_inspector_outline(inspector, state->scene, &picture);
    const ObjectInspectorContent content = {.scene = state->scene,
                                            .history = state->edits,
                                            .is_light_moved =
                                                is_light && state->is_light_moved[object.index],
                                            .is_read_only = state->is_playing,
                                            .can_undo = state->can_undo,
                                            .can_redo = state->can_redo,
                                            .area = window_area_below_button(window),
                                            .picture = picture,
                                            .pixel = {window->ray_view.x, window->ray_view.y}};
    object_inspector_show(inspector, &content);
}

/** Shows list, formulas and numbers of the rays, if they are shown. */
static void show_rays(Window *window) {
    bool is_covered = window->help.is_open || window->browser.is_open;
    if (window->ray_view.is_open && !is_covered && window->state.scene) {
        double scale = window_pixels_per_unit(window);
        SDL_Rect area = window_to_units(window, window_area(window));
        int x = 0, y = 0;
        size_t hovered = 0;
        SDL_GetMouseState(&x, &y);
        bool is_hovered = !gui_has_mouse() && SDL_GetMouseFocus() == window->sdl.window &&
                          window_ray_at(window, x, y, &hovered);
        window->ray_view.hovered = is_hovered ? hovered + 1 : 0;
        window->ray_view.shows_hint = !window->is_presenting && !window->lesson_panel.lesson;
        ray_view_show_widgets(&window->ray_view, window->state.scene, &area, scale);
        if (window->toolbar.is_folded || window->is_presenting) {
            ray_view_show_own_row(&window->ray_view, &window->help, &area);
        } else {
            ray_view_set_buttons(&window->ray_view, 0);
        }
    }
}

/** Shows the panel of the lesson that plays. */
static void show_lesson_panel(Window *window) {
    SDL_Rect area = window_area_below_toolbar(window),
             panel = window_split_off_panel(window, &area);
    if (window->lesson_panel.lesson) {
        panel = window_to_units(window, panel);
        lesson_panel_show(&window->lesson_panel, &panel);
    }
}

/** Shows the name of a new layer in a presentation. @param[in,out] area The part of the window for
 *  panels; becomes that below the name. */
static void show_layer_name(const Window *window, GuiRect *area) {
    if (window->layer_name.text[0] != '\0') {
        GuiPoint top = {area->x + area->width / 2, area->y + gui_text_size()};
        float taken = gui_title(window->layer_name.text, top) - area->y;
        area->y += taken;
        area->height = SDL_max(1, area->height - taken);
    }
}

/** Shows what lies over the picture and over the rays. @param area The part of the window for
 * panels.
 *  @return Where what lies at its lower edge begins. */
static float show_over_picture(Window *window, GuiRect area) {
    const GuiReadoutPlace empty = {{area.x, area.y + area.height}, area.x + area.width, GUI_ABOVE};
    area.height = SDL_max(1, area.height - gui_readout_rect("", &empty).height);
    show_light_marks(window);
    show_object_inspector(window);
    window_follow_mouse(window);
    window_read_pixel(window);
    const Readout *readout = &window->readout;
    const bool is_low = readout->is_shown && !readout->is_above;
    const float readout_top = is_low ? readout->rect.y : area.y + area.height;
    GuiRect above_message = readout->is_above ? window_area_beside_readout(window, area) : area;
    above_message.height = SDL_max(1, above_message.height - window_messages_height(window));
    window_show_huds(window, &above_message);
    window_show_values(window);
    window_show_readout(window);
    show_rays(window);
    window_show_progress(window);
    show_lesson_panel(window);
    return fminf(readout_top, window_show_captions(window, &area));
}

void window_show_widgets(Window *window) {
    int width = 0;
    if (!window->gui) {
        return;
    }
    SDL_GetWindowSize(window->sdl.window, &width, NULL);
    window_settle_text_size(window);
    gui_begin_frame(window->gui, window_text_size(window));
    show_toolbar(window);
    show_cursor(window);
    GuiRect area = window_area_below_button(window);
    show_layer_name(window, &area);
    float bottom = area.y + area.height;
    window->light_marks.count = 0;
    if (window->help.is_open || window->browser.is_open) {
        gui_take_keyboard(window->gui);           // They have keys of their own.
        area = window_whole_below_button(window); // The words of a lesson are not shown meanwhile.
        bottom = area.y + area.height;
    }
    if (window->help.is_open) {
        show_help(window, &area);
    } else if (window->browser.is_open) {
        browser_show(&window->browser, window->sdl.renderer, &area);
    } else {
        bottom = show_over_picture(window, area);
    }
    window_show_recording_sign(window, width);
    window_show_messages(window, bottom);
    gui_end_frame(window->gui);
}

bool window_ray_at(const Window *window, int x, int y, size_t *ray) {
    double scale = window_pixels_per_unit(window);
    SDL_Rect area = window_area(window);
    return ray_view_ray_at(&window->ray_view, (x + 0.5) * scale, (y + 0.5) * scale, &area, ray);
}

void window_show_panels_alone(Window *window) {
    if (!window->gui) {
        return;
    }
    GuiRect area = window_area_units(window);
    gui_begin_frame(window->gui, window_text_size(window));
    window_read_pixel(window);
    window_show_huds(window, &area);
    window_show_values(window);
    show_rays(window);
    window_show_captions(window, &area);
    gui_end_frame(window->gui);
    gui_request_frames(window->gui);
}

const LightMark *window_light_at(const Window *window, int x, int y) {
    return light_marks_at(&window->light_marks, (GuiPoint){(float)x, (float)y},
                          MARK_REACH * window_text_size(window));
}

bool window_drag_offset(const Window *window, size_t light, GuiPoint from, GuiPoint to,
                        bool is_along, Vec3d *offset) {
    SDL_Rect picture = window_to_units(window, window_picture_rect(window));
    return window->state.scene && light_marks_drag_offset(window->state.scene, light, &picture,
                                                          from, to, is_along, offset);
}

bool window_drag_offset_at(const Window *window, Vec3d point, const PictureDrag *drag,
                           Vec3d *offset) {
    SDL_Rect picture = window_to_units(window, window_picture_rect(window));
    return window->state.scene &&
           picture_drag_offset_at(&window->state.scene->camera, point, &picture, drag, offset);
}
