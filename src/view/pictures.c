/**
 * @file
 * @brief What keys do to the pictures.
 */
#include "view/pictures.h"

#include "dioptre/offset.h"

#include <libintl.h>

/** How far a key moves the bar between two pictures, as a share of the window's width. */
static const double BAR_STEP = 0.02;

/** Says in the title how the picture is drawn that keys change. @param[in,out] view The view. */
static void note_settings(View *view) {
    Sight *sight = stage_active(&view->stage);
    RenderSettings settings = view->stage.asked;
    tuning_apply(&sight->tuning, &settings);
    view_note(view, "%s, offset %s, epsilon %.3g, depth %d, samples %d, light: %s",
              settings.engine->name, offset_names[settings.trace.offset], settings.trace.epsilon,
              settings.trace.depth, settings.samples, gettext(tuning_light_name(settings.light)));
}

/** Moves the bar between two pictures by a step. @param[in,out] view The view. @param way 1 to the
 *  right, -1 to the left. */
static void move_bar(View *view, int way) {
    stage_move_bar(&view->stage, view->stage.split.bar + way * BAR_STEP);
}

void pictures_act(View *view, Action action) {
    Stage *stage = &view->stage;
    if (action_is_tuning(action)) {
        stage_tune(stage, action);
        note_settings(view);
    } else if (action >= ACTION_LAYER && action <= ACTION_LAYER_LAST) {
        stage_set_layer(stage, (Layer)(action - ACTION_LAYER));
    } else if (action == ACTION_AS_ASKED) {
        stage_untune(stage);
        note_settings(view);
    } else if (action == ACTION_SETTINGS) {
        stage_toggle_settings(stage);
    } else if (action == ACTION_SPLIT || action == ACTION_SPLIT_BACK) {
        stage_split(stage, action == ACTION_SPLIT ? 1 : -1);
    } else if (action == ACTION_SIDE) {
        stage_swap_active(stage);
    } else if (action == ACTION_BAR_LEFT || action == ACTION_BAR_RIGHT) {
        move_bar(view, action == ACTION_BAR_RIGHT ? 1 : -1);
    }
}
