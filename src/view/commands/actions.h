/**
 * @file
 * @brief What the commands of the table do; each has an argument there.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_ACTIONS_H
#define DIOPTRE_VIEW_COMMANDS_ACTIONS_H

#include "view/commands/commands.h"

/** Selects the next light for the light's keys. */
void action_select_next_light(App *app, int argument);

/** Changes between flying and walking. */
void action_toggle_walking(App *app, int argument);

/** Pauses the time, or lets it run. */
void action_toggle_time(App *app, int argument);

/** Pauses the time, and moves it some steps. */
void action_step_time(App *app, int steps);

/** Shows a layer. */
void action_set_layer(App *app, int layer);

/** Changes the offset strategy. See #settings_override_offset. */
void action_change_offset(App *app, int step);

/** Scales epsilon. See #settings_override_epsilon. */
void action_change_epsilon(App *app, int factor);

/** Changes the number type. See #settings_override_engine. */
void action_change_engine(App *app, int step);

/** Changes the lighting mode. See #settings_override_lighting. */
void action_change_lighting(App *app, int step);

/** Changes the depth. See #settings_override_depth. */
void action_change_depth(App *app, int step);

/** Changes the samples. See #settings_override_samples. */
void action_change_samples(App *app, int step);

/** Changes whose methods the picture is traced with. See #settings_override_methods. */
void action_change_methods(App *app, int step);

/** Sends rays through the centres or the corners of pixels. See #settings_override_pixel. */
void action_change_pixel(App *app, int step);

/** Shows or hides settings and costs. */
void action_toggle_settings(App *app, int argument);

/** Shows or hides the chart of settings. */
void action_toggle_chart(App *app, int argument);

/** Shows or hides the magnifier. */
void action_toggle_magnifier(App *app, int argument);

/** Takes all changes of settings, layers and the split view back. */
void action_reset_settings(App *app, int argument);

/** Shows one picture, two side by side, or their difference. */
void action_cycle_split(App *app, int step);

/** Makes the other of two pictures the active one. */
void action_swap_side(App *app, int argument);

/** Moves the bar between two pictures. */
void action_move_bar(App *app, int direction);

/** Takes the last change back. See #edits_undo. */
void action_undo(App *app, int argument);

/** Does the change again that was taken back. */
void action_redo(App *app, int argument);

/** Copies the selected object as text. */
void action_copy_object(App *app, int argument);

/** Writes the selected object into the scene file. */
void action_write_object(App *app, int argument);

/** Shows the rays of one pixel, or the picture again. */
void action_toggle_rays(App *app, int argument);

/** Chooses another ray. */
void action_select_ray(App *app, int step);

/** Lets the next ray fly along its path. */
void action_fly_ray(App *app, int argument);

/** Hides the rays of a kind, or shows them again. */
void action_toggle_ray_kind(App *app, int kind);

/** Turns the arrows of rays round. */
void action_turn_arrows(App *app, int argument);

/** Shows a drawing beside the rays, or takes it away. */
void action_toggle_ray_pane(App *app, int pane);

/** Puts the scene's own view back. */
void action_reset_view(App *app, int argument);

/** Requests a snapshot. It is taken when the picture is finished, so the time is paused. */
void action_request_snapshot(App *app, int argument);

/** Saves what is on the screen. */
void action_save_screen(App *app, int argument);

/** Prints camera and lights as text of the scene language, and puts it on the clipboard. */
void action_copy_view(App *app, int argument);

/** Makes the letters larger or smaller. */
void action_scale_text(App *app, int steps);

/** Changes the language. A faulty scene is loaded again, for its error in that language. */
void action_switch_language(App *app, int argument);

/** Opens the list of scenes, or closes it. @param argument 1: at the lessons; then an open list
 * goes there. */
void action_browse_scenes(App *app, int argument);

/** Begins to record a lesson, or ends it. */
void action_toggle_recording(App *app, int argument);

/** Begins to type a caption. */
void action_begin_caption(App *app, int argument);

/** Opens or closes the help. */
void action_toggle_help(App *app, int argument);

/** Shows or hides the toolbar. */
void action_toggle_toolbar(App *app, int argument);

/** Begins or ends a presentation. */
void action_toggle_presentation(App *app, int argument);

/** Changes between the full screen and a window. */
void action_toggle_full_screen(App *app, int argument);

/** Closes what lies topmost: help, a lesson's end card, rays, chart, inspector, magnifier,
 * settings, two pictures, a layer, the full screen; at last the program. What a lesson shows stays.
 */
void action_leave(App *app, int argument);

/** Ends the lesson that plays, or else the program, where it can be ended (#way_out_exists); if
 * that would lose something, only when it is asked a second time. */
void action_quit(App *app, int argument);

/** Selects the next shape or light, or the one before. See #edits_select_next. */
void action_select_thing(App *app, int step);

/** Gives the keyboard to the inspector: Tab and arrows choose a field, Space or Enter changes it,
 *  Esc leaves it. */
void action_take_keyboard(App *app, int argument);

/** Shows the list of all things and gives it the keyboard; or closes it, if it is shown. */
void action_list_things(App *app, int argument);

/** Gives the keyboard to the toolbar, or takes it back. @param argument Unused. */
void action_take_toolbar(App *app, int argument);

/** Saves a copy of the scene file with all changes. */
void action_save_copy(App *app, int argument);

#endif
