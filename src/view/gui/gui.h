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

/** Shows a colour and a text beside it, in lines as wide as the window. @param rgb The colour,
 *  sRGB. @param corner The lower left corner. */
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

/* --- values on the picture -------------------------------------------------------------------- */

/** A colour of a legend, with its text. */
typedef struct GuiSwatch {
    unsigned char rgb[3]; /**< The colour, sRGB. */
    float position;       /**< Position on the bar, 0 to 1; below 0: it is below the bar. */
    const char *text;     /**< Its number or its meaning. */
} GuiSwatch;

/** A legend: a title, a bar of colours with ticks, colours by themselves, notes. */
typedef struct GuiLegend {
    const char *title;               /**< What is shown. */
    const char *unit;                /**< Its unit and scale; empty: none. */
    const unsigned char (*bar)[3];   /**< Colours of the bar, from its lower end; sRGB. */
    int bar_count;                   /**< Number of them; 0: there is no bar. */
    const GuiSwatch *swatches;       /**< Ticks of the bar from its upper end, then colours. */
    int swatch_count;                /**< Number of them. */
    const char *const *notes;        /**< What else is to be said. */
    int note_count;                  /**< Number of them. */
} GuiLegend;

/**
 * Draws a legend.
 * @param corner    Its lower corner, on the side that \p is_right says.
 * @param highest   Largest height, pixels of the window: the bar shrinks.
 * @param is_right  Whether the corner is the right one.
 */
void gui_legend(const GuiLegend *legend, GuiPoint corner, float highest, bool is_right);

/** Draws a ring around a pixel, seen on light and dark ground. */
void gui_ring(GuiPoint center, float radius);

/* --- lessons ---------------------------------------------------------------------------------- */

/** Begins a panel that fills a rectangle of the window; what does not fit is scrolled.
 *  #gui_panel_end follows. @param corner Its upper left corner. @param size Its size. */
void gui_panel_begin(const char *id, GuiPoint corner, GuiPoint size);

/** Ends the panel. */
void gui_panel_end(void);

/** Begins a card in the middle of the window, as high as its text. #gui_panel_end follows. */
void gui_card_begin(const char *id);

/** Writes a heading. */
void gui_heading(const char *text);

/** Writes a text in as many lines as it needs. */
void gui_paragraph(const char *text);

/** Writes an item of a list in as many lines as it needs. */
void gui_item(const char *text);

/** Puts the next widget into the line of the last one. */
void gui_same_line(void);

/** A button that may be dimmed. @param is_enabled Whether it can be clicked. @param is_marked
 *  Whether it is the one to click now. @return Whether it was clicked. */
bool gui_step_button(const char *label, const char *tooltip, bool is_enabled, bool is_marked);

/** A button with a list. @param label Its words. @return Whether the list is open: its entries
 *  follow, then #gui_step_list_end. */
bool gui_step_list_begin(const char *label, const char *tooltip);

/** An entry of the list. @param index Its place, from 0. @param is_present Whether it is marked.
 *  @return Whether it was clicked. */
bool gui_step_list_entry(size_t index, const char *text, bool is_present);

/** Ends the list that is open. */
void gui_step_list_end(void);

/** The answers to a question. */
typedef struct GuiAnswers {
    const char *const *texts; /**< The answers. */
    int count;                /**< Number of answers. */
    int chosen;               /**< Index of the chosen one; -1: none. */
    int right;                /**< Index of the right one, to be shown; -1: not yet. */
    bool is_open;             /**< Whether one may be chosen. */
} GuiAnswers;

/** Shows answers with their numbers, side by side where there is room. @return Index of the one
 *  that was clicked; -1: none. */
int gui_answers(const GuiAnswers *answers);

#ifdef __cplusplus
}
#endif

#endif
