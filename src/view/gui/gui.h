/**
 * @file
 * @brief The graphical user interface over the picture: buttons, lists, sliders, text and marks.
 *
 * A C header over Dear ImGui, which gui.cpp alone includes. It is an immediate-mode interface: each
 * frame calls one function per widget, which draws it and returns what the user did with it. All
 * functions are called by the thread of the window. Labels and tooltips are already translated.
 */
#ifndef DIOPTRE_VIEW_GUI_GUI_H
#define DIOPTRE_VIEW_GUI_GUI_H

#include <SDL.h>
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The interface of one window. */
typedef struct Gui Gui;

/** A position in the window, pixels from its upper left corner. */
typedef struct GuiPoint {
    float x; /**< To the right. */
    float y; /**< Down. */
} GuiPoint;

/**
 * Creates the interface of a window.
 * @param font  Path of the font file, TrueType.
 * @return The interface, to be freed with #gui_destroy; NULL without font or memory.
 */
Gui *gui_create(SDL_Window *window, SDL_Renderer *renderer, const char *font);

/** Frees an interface. @param gui The interface, or NULL. */
void gui_destroy(Gui *gui);

/** Forgets the texture of the letters: the graphics device was reset. */
void gui_on_device_reset(Gui *gui);

/**
 * Tells the interface of an event.
 * @return Whether the event is for the interface alone: the mouse is over a widget or holds one.
 */
bool gui_handle_event(Gui *gui, const SDL_Event *event);

/** Closes the list that is open. @return Whether there was one. */
bool gui_close_list(Gui *gui);

/** @return Whether the interface must be drawn again, as an event may have changed it. */
bool gui_needs_frame(const Gui *gui);

/** Begins a frame. @param text_size Height of the letters, pixels of the window. */
void gui_begin_frame(Gui *gui, float text_size);

/** Ends the frame and draws it. */
void gui_end_frame(Gui *gui);

/** @return The height of the letters, pixels of the window. */
float gui_text_size(void);

/* --- the bar ---------------------------------------------------------------------------------- */

/** Begins the bar at the upper edge of the window. Its widgets follow, then #gui_bar_end. */
void gui_bar_begin(void);

/** Ends the bar. @return Its height, pixels of the window. */
float gui_bar_end(void);

/** A button. @param is_on Whether it shows what is on. @return Whether it was clicked. */
bool gui_button(const char *label, const char *tooltip, bool is_on);

/**
 * A list of which one entry is chosen.
 * @param id        Unique to this list in its bar; not shown.
 * @param names     The entries.
 * @param selected  Index of the chosen one.
 * @return The index that the user has chosen now; -1: none.
 */
int gui_choice(const char *id, const char *const *names, int count, int selected,
               const char *tooltip);

/** A number with a button on each side. @param widest The widest text that it may have, so that the
 *  bar does not move. @return -1 or 1: the user wants less or more; else 0. */
int gui_stepper(const char *id, const char *text, const char *widest, const char *tooltip);

/**
 * A slider with a logarithmic scale.
 * @param[in,out] value  The value, which the user may change; above 0.
 * @param low            Smallest value, above 0.
 * @param high           Largest value.
 * @param text           The text on the slider, without `%`.
 * @return Whether the user has changed it.
 */
bool gui_log_slider(const char *id, double *value, double low, double high, const char *text,
                    const char *tooltip);

/* --- text and marks on the picture ------------------------------------------------------------ */

/** Where a box lies at a point. */
typedef enum {
    GUI_BELOW, /**< Its upper edge touches the point. */
    GUI_ABOVE  /**< Its lower edge does. */
} GuiSide;

/** Writes a message in a box, which is centred at a point. */
void gui_message(const char *id, const char *text, GuiPoint point, GuiSide side);

/** Shows a colour and a text beside it. @param rgb The colour, sRGB. @param corner The lower left
 *  corner. */
void gui_readout(const char *text, const unsigned char rgb[3], GuiPoint corner);

/** Marks a light: a sun with a name below. @param is_selected Whether keys move it. */
void gui_mark_light(GuiPoint center, const char *name, bool is_selected);

/** Marks where a light outside the picture is. @param tip Tip of the arrow. @param direction Where
 *  it points, of length 1. */
void gui_mark_outside(GuiPoint tip, GuiPoint direction, const char *name, bool is_selected);

/* --- lists of rays: rows, check boxes and text beside the picture ------------------------------
 */

/** Begins a list with a dark ground, which scrolls. Its rows follow, then #gui_list_end. */
void gui_list_begin(const char *id, GuiPoint corner, GuiPoint size);

/** Ends a list. */
void gui_list_end(void);

/** A heading. */
void gui_list_heading(const char *text);

/** A line of a label and a text, which is broken where it is too long. @param label Empty: none. */
void gui_list_text(const char *label, const char *text);

/**
 * A row that can be clicked, with a colour before it.
 * @param number       Unique to this row in its list; not shown.
 * @param indent       How far it is moved to the right, in steps.
 * @param rgb          The colour, sRGB.
 * @param is_selected  Whether it is the chosen one.
 * @param is_revealed  Whether the list scrolls until it is in sight.
 * @return Whether it was clicked.
 */
bool gui_list_row(int number, const char *text, int indent, const unsigned char rgb[3],
                  bool is_selected, bool is_revealed);

/** A check box with a colour, beside the one before where there is room. @return Whether it was
 *  clicked. */
bool gui_list_check(const char *label, const unsigned char rgb[3], const char *tooltip, bool is_on);

/** @return Width of a text, pixels of the window. */
float gui_text_width(const char *text);

/** Writes a text on the picture, with a line to what it names. @param corner Of the text, upper
 *  left. @param is_bright Whether it stands out. */
void gui_label(const char *text, GuiPoint anchor, GuiPoint corner, bool is_bright);

/** Draws a ray in flight: a bright line with a spot at its end. @param rgb Its colour, sRGB. */
void gui_flight(GuiPoint from, GuiPoint to, const unsigned char rgb[3]);

/* --- panels with widgets ---------------------------------------------------------------------- */

/**
 * Begins a panel at the right edge of the window, which can be moved and closed. Its widgets
 * follow, then #gui_panel_end.
 * @param id     Unique to it; not shown.
 * @param top    Upper edge at first, pixels of the window.
 * @return false if the user closes it.
 */
bool gui_panel_begin(const char *id, const char *title, float top);

/** Ends the panel. */
void gui_panel_end(void);

/** Begins a part of a panel, which can be folded. @return Whether it is open. */
bool gui_section(const char *label, bool is_open_at_first);

/** Writes lines of text into a panel. */
void gui_text(const char *text);

/** A button in a panel. @return Whether it was clicked. */
bool gui_panel_button(const char *label, const char *tooltip);

/**
 * Numbers that are dragged with the mouse, or typed after a click with Ctrl.
 * @param[in,out] numbers  The numbers.
 * @param speed            How much a pixel of the drag changes them.
 * @return Whether the user has changed them.
 */
bool gui_edit_numbers(const char *label, double *numbers, int count, double low, double high,
                      double speed, const char *tooltip);

/** A slider from one number to another. @return Whether the user has changed it. */
bool gui_edit_slider(const char *label, double *number, double low, double high,
                     const char *tooltip);

/** A colour: its brightness, which is its largest channel, and a picker. @param[in,out] rgb Linear
 *  light. @param high Largest value of a channel. @return Whether the user has changed it. */
bool gui_edit_color(const char *label, double rgb[3], double high, const char *tooltip);

/** A check box. @return Whether the user has changed it. */
bool gui_edit_check(const char *label, double *number, const char *tooltip);

/** A list of words, of which one is chosen. @param[in,out] number Its index. @param words Ended by
 *  NULL. @return Whether the user has changed it. */
bool gui_edit_choice(const char *label, double *number, const char *const *words,
                     const char *tooltip);

/** @return Whether the user holds a widget, or types into one. */
bool gui_is_editing(void);

/** Draws a line on the picture: a part of the outline of what is selected. */
void gui_outline_line(GuiPoint from, GuiPoint to);

#ifdef __cplusplus
}
#endif

#endif
