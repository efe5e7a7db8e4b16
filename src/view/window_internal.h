/**
 * @file
 * @brief What the files of the window share: where things are, and what one frame shows.
 */
#ifndef DIOPTRE_VIEW_WINDOW_INTERNAL_H
#define DIOPTRE_VIEW_WINDOW_INTERNAL_H

#include "view/window.h"

/* --- where things are: window_layout.c ----------------------------------------------------------
 */

/** @return Pixels per screen unit: more than 1 on a HiDPI screen. */
double window_pixels_per_unit(const Window *window);

/** @return The part of the window below the toolbar, pixels. */
SDL_Rect window_area_below_toolbar(const Window *window);

/** Divides the window between picture and lesson panel: it stands beside the picture where there is
 *  room, else below. @param[in,out] area The part below the toolbar; becomes that of the picture.
 *  @return The part of the panel, pixels; empty: it is closed. */
SDL_Rect window_split_off_panel(const Window *window, SDL_Rect *area);

/** @return A rectangle of pixels in screen units. */
SDL_Rect window_to_units(const Window *window, SDL_Rect rect);

/** @return #window_area in screen units. */
GuiRect window_area_units(const Window *window);

/** @return The part of the window for panels: below the bar, or below its button if it is folded.
 */
GuiRect window_area_below_button(const Window *window);

/** @return The same with the part of the lesson's panel: for what covers both. */
GuiRect window_whole_below_button(const Window *window);

/** Finds the height of letters of the next frame, by the height below the bar. */
void window_settle_text_size(Window *window);

/** @return The height of letters of this frame, screen units; 0 before the first one. */
float window_text_size(const Window *window);

/** Folds the bar if it takes too much of the window. @return Whether it did. */
bool window_fold_large_toolbar(Window *window);

/* --- one frame ----------------------------------------------------------------------------------
 */

/** Draws the pictures, or the rays. */
void window_draw_pictures(Window *window);

/** Shows panels, buttons, lists, marks and messages over the picture. */
void window_show_widgets(Window *window);

/** Shows panels alone, without buttons, marks and messages: for a picture of the screen. */
void window_show_panels_alone(Window *window);

/** Shows settings and costs of the pictures, in the upper corners of an area, and notes where they
 *  lie. */
void window_show_huds(Window *window, const GuiRect *area);

/** @return Whether the picture is on screen, and nothing lies over it. */
bool window_picture_is_shown(const Window *window);

/** @return Whether a column of the picture shows the right one of two. */
bool window_is_right_side(const Window *window, int column);

/** Shows legends, rings, magnifier and chart: what belongs to a picture of the screen, too. The
 *  legends keep clear of what #window_show_huds has shown. */
void window_show_values(Window *window);

/** @return The part of the window for what lies beside the inspector, screen units: the wider side.
 */
SDL_Rect window_area_beside_inspector(const Window *window);

/** @return Whether two parts of the window have any part in common. */
bool rects_overlap(const GuiRect *a, const GuiRect *b);

/** Shows notice and caption. @param area The part of the window for them, screen units. @return
 *  Where what lies at its lower edge begins. */
float window_show_captions(Window *window, const GuiRect *area);

/** Places the magnifier. */
void window_follow_mouse(Window *window);

/** Reads what the pixel under the mouse shows, or the one that is magnified, and finds where the
 *  readout lies. Once per frame, as it traces a ray; after the inspector, beside which it lies. */
void window_read_pixel(Window *window);

/** @return The middle of a pixel of the picture, screen units. */
GuiPoint window_pixel_place(const Window *window, const PixelPosition *pixel);

/** @return A part of the window without the readout, which lies at one of its edges. @param area
 * The part of the window for the picture, or one as high. */
GuiRect window_area_beside_readout(const Window *window, GuiRect area);

/** Shows what #window_read_pixel has read. */
void window_show_readout(const Window *window);

/** Shows how far a pass is that takes long, at the lower edge of the picture. */
void window_show_progress(Window *window);

/** @return Seconds until that bar, or the number of a legend, moves; #WINDOW_NO_TIMEOUT: there is
 *  none. */
double window_progress_timeout(const Window *window, double now);

/* --- messages: window_messages.c ----------------------------------------------------------------
 */

/** Shows the messages at the lower edge: the newest one, else the hint. @param bottom Lower end of
 *  the room for them. */
void window_show_messages(const Window *window, float bottom);

/** @return The height that the messages take at the lower edge, screen units. */
float window_messages_height(const Window *window);

/** Shows that a lesson is recorded, in the upper right corner of the picture. */
void window_show_recording_sign(const Window *window, int width);

/** @return Whether what is shown has changed by itself since it was shown. */
bool window_widgets_are_due(Window *window, double now);

/** @return Seconds until it changes by itself; see #window_timeout. */
double window_widgets_timeout(const Window *window, double now);

#endif
