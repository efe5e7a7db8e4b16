/**
 * @file
 * @brief What keys do to the pictures.
 */
#include "view/commands/view_commands.h"

#include "dioptre/offset_strategy.h"

#include <libintl.h>

/** How far a key moves the bar between two pictures, as a share of the window's width. */
static const double BAR_STEP = 0.02;

/** Says in the title how the picture is drawn that keys change. */
static void show_settings_status(App *app) {
    Viewport *viewport = window_active_viewport(&app->window);
    RenderSettings settings = app->window.base_settings;
    settings_override_apply(&viewport->overrides, &settings);
    app_set_status(app, "%s, offset %s, epsilon %.3g, depth %d, samples %d, light: %s",
                   settings.engine->name, offset_strategy_names[settings.trace.offset],
                   settings.trace.epsilon, settings.trace.depth, settings.samples,
                   gettext(light_mode_name(settings.lighting)));
}

/** Moves the bar between two pictures by a step. @param direction 1 to the right, -1 to the left.
 */
static void step_bar(App *app, int direction) {
    window_move_bar(&app->window, app->window.split.bar_position + direction * BAR_STEP);
}

void view_commands_run(App *app, Action action) {
    Window *window = &app->window;
    if (action_is_setting_change(action)) {
        window_override_setting(window, action);
        show_settings_status(app);
    } else if (action >= ACTION_LAYER_FIRST && action <= ACTION_LAYER_LAST) {
        window_set_layer(window, (Layer)(action - ACTION_LAYER_FIRST));
    } else if (action == ACTION_RESET_SETTINGS) {
        window_reset_overrides(window);
        show_settings_status(app);
    } else if (action == ACTION_TOGGLE_SETTINGS) {
        window_toggle_settings(window);
    } else if (action == ACTION_SPLIT_NEXT || action == ACTION_SPLIT_PREVIOUS) {
        window_cycle_split(window, action == ACTION_SPLIT_NEXT ? 1 : -1);
    } else if (action == ACTION_SWAP_SIDE) {
        window_swap_active(window);
    } else if (action == ACTION_BAR_LEFT || action == ACTION_BAR_RIGHT) {
        step_bar(app, action == ACTION_BAR_RIGHT ? 1 : -1);
    }
}
