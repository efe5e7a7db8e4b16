/**
 * @file
 * @brief The graphical user interface over the picture: buttons, lists, sliders, text and marks.
 *
 * A C header over Dear ImGui, which the C++ files beside it alone include. It is an immediate-mode
 * interface: each frame calls one function per widget, which draws it and returns what the user did
 * with it. All functions are called by the thread of the window. Labels and tooltips are already
 * translated.
 */
#ifndef DIOPTRE_VIEW_GUI_GUI_H
#define DIOPTRE_VIEW_GUI_GUI_H

#include <SDL.h>
#include <stdbool.h>
#include <stdint.h>

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

/** A part of the window, units of the window. */
typedef struct GuiRect {
    float x;      /**< Left end. */
    float y;      /**< Upper end. */
    float width;  /**< Width. */
    float height; /**< Height. */
} GuiRect;

/**
 * Creates the interface of a window, with the typeface that is installed.
 * @return The interface, to be freed with #gui_destroy; NULL without typeface or memory.
 */
Gui *gui_create(SDL_Window *window, SDL_Renderer *renderer);

/** Frees an interface. @param gui The interface, or NULL. */
void gui_destroy(Gui *gui);

/** Forgets the texture of the letters: the graphics device was reset. */
void gui_on_device_reset(Gui *gui);

/** Finds the letters of shortcuts, such as Ctrl+A, on the keyboard in use: it is another one now.
 *  @param gui The interface, or NULL. */
void gui_on_keymap(Gui *gui);

/**
 * Tells the interface of an event.
 * @return Whether the event is for the interface alone: the mouse is over a widget or holds one.
 */
bool gui_handle_event(Gui *gui, const SDL_Event *event);

/** What the keyboard can be given to. */
typedef enum {
    GUI_PICTURE,   /**< The picture: its keys are commands. */
    GUI_INSPECTOR, /**< The inspector of objects. */
    GUI_BAR        /**< The bar. */
} GuiKeyboard;

/** Gives the keyboard to a panel until Esc, or until it is closed; takes it back from one that has
 *  it. @return Whether it has it now. */
bool gui_give_keyboard(Gui *gui, GuiKeyboard panel);

/** Takes the keyboard back from the panel that has it, if any. @param gui NULL: does nothing. */
void gui_take_keyboard(Gui *gui);

/** @return What has the keyboard. @param gui NULL: the picture has it. */
GuiKeyboard gui_keyboard(const Gui *gui);

/** Scrolls the present panel. @param pages Pages down, less a line each; negative: up. */
void gui_scroll_pages(int pages);

/** Closes the list that is open. @return Whether there was one. */
bool gui_close_list(Gui *gui);

/** @return Whether the interface must be drawn again, as an event may have changed it. */
bool gui_needs_frame(const Gui *gui);

/** @return Seconds until the interface changes by itself, as a tooltip comes; infinite: it does
 * not.
 *  @param gui The interface, or NULL. */
double gui_timeout(const Gui *gui, double now);

/** Begins a frame. @param text_size Height of the letters, pixels of the window. */
void gui_begin_frame(Gui *gui, float text_size);

/** Ends the frame and draws it. */
void gui_end_frame(Gui *gui);

/** @return The height of the letters, pixels of the window. */
float gui_text_size(void);

/** @return Whether a frame must be drawn before the next event is handled: Dear ImGui 1.86 looks at
 * the keys once per frame, and would miss one that went down and up in between. */
bool gui_awaits_frame(const Gui *gui);

/** Has some more frames drawn: what is shown has changed, and panels find their size. */
void gui_request_frames(Gui *gui);

/** The shapes of the mouse. */
typedef enum {
    GUI_CURSOR_HAND,    /**< Something can be taken or clicked. */
    GUI_CURSOR_MOVE,    /**< Something is moved. */
    GUI_CURSOR_SIDEWAYS /**< Something can be moved left and right. */
} GuiCursor;

/** @return Whether the mouse is over a widget or a panel. */
bool gui_has_mouse(void);

/** Sets the shape of the mouse for this frame, unless it is over a widget. */
void gui_set_cursor(GuiCursor cursor);

/** Shows the mouse as a large ring, which a class sees, or as usual. */
void gui_set_ring(Gui *gui, bool is_wanted);

/** Writes a text in very large letters. @param top Middle of its upper edge. @return Its lower end.
 */
float gui_title(const char *text, GuiPoint top);

/* --- the palette ------------------------------------------------------------------------------ */

/** The colours of text and marks. */
typedef enum {
    GUI_COLOR_TEXT,                       /**< Text. */
    GUI_COLOR_FAINT,                      /**< What matters less. */
    GUI_COLOR_ACCENT,                     /**< What is chosen or on; labels. */
    GUI_COLOR_HEADING,                    /**< Headings. */
    GUI_COLOR_ERROR,                      /**< Errors. */
    GUI_COLOR_GROUP,                      /**< The first group of commands; the others follow. */
    GUI_COLOR_COUNT = GUI_COLOR_GROUP + 9 /**< Number of colours. */
} GuiColor;

/** @return The colour of a group of commands. @param group From 1; beyond the last it begins anew.
 */
GuiColor gui_group_color(int group);

/* --- panels ----------------------------------------------------------------------------------- */

/** Bytes of a row's label with the final zero. */
enum { GUI_LABEL_SIZE = 96 };
/** Two spaces, which part the names of keys in a label. */
#define GUI_KEY_GAP "  "

/** One row of a panel: a heading, or a label and a text. */
typedef struct GuiRow {
    bool is_heading;            /**< Whether it is a heading. */
    char label[GUI_LABEL_SIZE]; /**< Label, UTF-8; empty: none. */
    bool has_keys;              /**< Whether the label names keys, parted by #GUI_KEY_GAP. */
    const char *text;           /**< Its text, UTF-8; not owned. */
    GuiColor color;             /**< Colour of a heading or of keys; 0: the usual one. */
    bool has_swatch;            /**< Whether a colour stands in place of the label. */
    uint8_t swatch[3];          /**< That colour, sRGB. */
    bool is_clickable;          /**< Whether it can be clicked. */
} GuiRow;

/** Where a panel lies. */
typedef struct GuiPlace {
    GuiRect room; /**< The part of the window that it may fill. */
    float x;      /**< Where it lies in its room: 0 at the left, 1 at the right. */
    float y;      /**< The same: 0 at the top, 1 at the bottom. */
} GuiPlace;

/** A row, and a key of its label. */
typedef struct GuiCell {
    int row; /**< Index of the row; -1: none. */
    int key; /**< Index of the key in the label. */
} GuiCell;

/** A panel as large as its rows; it scrolls if they do not fit. @param[out] extent Where it lies;
 *  NULL: not wanted. @return The cell that was clicked. */
GuiCell gui_rows_panel(const char *id, const GuiPlace *place, const GuiRow *rows, size_t count,
                       GuiCell selected, GuiRect *extent);

/** @return The height of a panel of rows in a room of some width. */
float gui_rows_panel_height(const GuiRow *rows, size_t count, float width);

/** Begins a panel that fills a room; what is too high scrolls. */
void gui_panel_begin(const char *id, const GuiRect *room);

/** Has the present panel show its upper end. */
void gui_scroll_to_top(void);

/** Puts the next widget at the right end of the present line, or of the next one where it has no
 *  room. @param label Its words. */
void gui_at_right(const char *label);

/** Shows what is searched in a box with a caret, as wide as the line. @param text What is typed;
 *  empty: the hint is shown. */
void gui_search_box(const char *text, const char *hint);

/** Ends the panel. */
void gui_panel_end(void);

/** @return The width for what a panel contains. */
float gui_panel_width(void);

/** Writes a heading. */
void gui_heading(const char *text);

/** Writes a text, in several lines where it is long. @param lines Lines that it fills at least. */
void gui_paragraph(const char *text, GuiColor color, int lines);

/** Rows in as many columns as fit side by side; columns begin with headings. The selected cell is
 *  scrolled to when it changes. @return The cell that was clicked. */
GuiCell gui_rows(const GuiRow *rows, size_t count, GuiCell selected);

/** Begins a drawing of a height in the panel. @return Its upper left corner. */
GuiPoint gui_canvas(float height);

/** What the mouse does with something. */
typedef enum {
    GUI_IDLE,    /**< Nothing. */
    GUI_HOVERED, /**< It is over it. */
    GUI_CLICKED  /**< It has clicked on it. */
} GuiMouse;

/** @return Whether the mouse was moved since the last frame. */
bool gui_mouse_has_moved(void);

/** @return Whether the left mouse button has gone up in this frame: what was pressed in it was by
 *  the mouse, not by keys. */
bool gui_is_mouse_released(void);

/** Draws a key of a keyboard. @param cap What is printed on it. @param color Its colour;
 *  #GUI_COLOR_FAINT: it does nothing. @param is_on Whether it is selected. */
GuiMouse gui_key(const GuiRect *rect, const char *cap, GuiColor color, bool is_on);

/** Begins a panel of thumbnails: the wheel goes on by one line of them. See #gui_panel_begin. */
void gui_gallery_begin(const char *id, const GuiRect *room);

/** What a picture of a list shows. */
typedef struct GuiThumbnail {
    SDL_Texture *texture; /**< The picture; NULL: none yet. */
    const char *name;     /**< Name below it. */
    float
        name_height; /**< Room for the name: the largest #gui_thumbnail_name_height of its line. */
    const char *message; /**< Text in place of the picture; NULL: none. */
    GuiColor color;      /**< Colour of that text. */
    bool is_selected;    /**< Whether it is selected. */
    bool scrolls_to_it;  /**< Whether the panel scrolls to it. */
} GuiThumbnail;

/** @return Width of a thumbnail when as many as fit stand side by side in a panel. @param[out]
 *  columns How many that are. */
float gui_thumbnail_width(int *columns);

/** @return Height of the name of a thumbnail: two lines of text, or up to four that it needs.
 * @param width Width of the thumbnail. */
float gui_thumbnail_name_height(const char *name, float width);

/** Draws a picture of a list. @param column Its column; 0 begins a new line. @param[out] is_seen
 *  Whether any part of it is in sight. */
GuiMouse gui_thumbnail(int id, const GuiThumbnail *thumbnail, int column, float width,
                       bool *is_seen);

/* --- the bar ---------------------------------------------------------------------------------- */

/** Begins the bar at the upper edge of the window. Its widgets follow, then #gui_bar_end. @param
 *  is_folded Whether it is only as wide as they are. */
void gui_bar_begin(bool is_folded);

/** Ends the bar. @return Its height, pixels of the window. */
float gui_bar_end(void);

/** A button. @param is_on Whether it shows what is on. @return Whether it was clicked. */
bool gui_button(const char *label, const char *tooltip, bool is_on);

/** A button whose words say what it would do now, as wide as the wider ones: the bar stays still.
 *  @param labels Its words while it is off, and while it is on. @return Whether it was clicked. */
bool gui_toggle(const char *const labels[2], const char *tooltip, bool is_on);

/**
 * A list of which one entry is chosen.
 * @param id        Unique to this list in its bar; not shown.
 * @param names     The entries, as the bar shows the chosen one.
 * @param explained The entries, as the open list shows them.
 * @param selected  Index of the chosen one.
 * @return The index that the user has chosen now; -1: none.
 */
int gui_choice(const char *id, const char *const *names, const char *const *explained, int count,
               int selected, const char *tooltip);

/** A button that opens a menu. @return Whether it is open: its entries follow, then #gui_menu_end.
 */
bool gui_menu_begin(const char *label, const char *tooltip);

/** An entry of the menu. @return Whether it was clicked. */
bool gui_menu_entry(const char *text);

/** Ends the menu that is open. */
void gui_menu_end(void);

/** A number with a button on each side. @param widest The widest text that keys give it, so that
 * the bar does not move. @return -1 or 1: the user wants less or more; else 0. */
int gui_stepper(const char *id, const char *text, const char *widest, const char *tooltip);

/**
 * A slider with a logarithmic scale.
 * @param[in,out] value  The value, which the user may change; above 0.
 * @param low            Smallest value, above 0.
 * @param high           Largest value.
 * @param text           The text on the slider, without `%`.
 * @param is_in_use      Whether the value has an effect; it is pale without.
 * @return Whether the user has changed it.
 */
bool gui_log_slider(const char *id, double *value, double low, double high, const char *text,
                    bool is_in_use, const char *tooltip);

/* --- text and marks on the picture ------------------------------------------------------------ */

/** Where a box lies at a point. */
typedef enum {
    GUI_BELOW, /**< Its upper edge touches the point. */
    GUI_ABOVE  /**< Its lower edge does. */
} GuiSide;

/** Writes a message in a box, which is centred at a point. @param room The largest width. */
void gui_message(const char *id, const char *text, float room, GuiPoint point, GuiSide side);

/** @return Width and height of what #gui_message shows. */
GuiPoint gui_message_size(const char *text, float room);

/** The place of a readout. */
typedef struct GuiReadoutPlace {
    GuiPoint corner; /**< Its lower left corner, or its upper one. */
    float right;     /**< Where its lines end at most. */
    GuiSide side;    /**< Whether it lies above that corner, or below it. */
} GuiReadoutPlace;

/** @return Where #gui_readout lies. */
GuiRect gui_readout_rect(const char *text, const GuiReadoutPlace *place);

/** Shows a colour and a text beside it, in lines as wide as there is room. @param id Unique to it;
 *  not shown. @param rgb The colour, sRGB. */
void gui_readout(const char *id, const char *text, const unsigned char rgb[3],
                 const GuiReadoutPlace *place);

/** Marks a light: a sun with a name below. @param is_selected Whether keys move it. */
void gui_mark_light(GuiPoint center, const char *name, bool is_selected);

/** Marks where a light outside the picture is. @param tip Tip of the arrow. @param direction Where
 *  it points, of length 1. @return The middle of the arrow. */
GuiPoint gui_mark_outside(GuiPoint tip, GuiPoint direction, const char *name, bool is_selected);

/* --- what a frame has written, for tests --------------------------------------------------------
 */

/** Bytes of a recorded text with the final zero; a longer one is cut. */
enum { GUI_RECORD_SIZE = 128 };

/** A text that was written. */
typedef struct GuiText {
    char text[GUI_RECORD_SIZE]; /**< The text. */
    GuiRect rect;               /**< Where it lies. */
    GuiRect clip;               /**< What of it can be seen. */
    float size;                 /**< Height of its letters. */
    bool scrolls;               /**< Whether it is in a panel that can scroll. */
} GuiText;

/** Has texts recorded from the next frame on, or no more. */
void gui_record_texts(Gui *gui, bool is_wanted);

/** @return Number of texts of the last frame. @param[out] texts The texts, until the next frame. */
size_t gui_texts(const Gui *gui, const GuiText **texts);

/* --- lists of rays: rows, check boxes and text beside the picture ------------------------------
 */

/** Begins a list with a dark ground, which scrolls, and shows no line in part. Its rows follow,
 * then #gui_panel_end. */
void gui_list_begin(const char *id, GuiPoint corner, GuiPoint size);

/** Begins a row of buttons, as high as they need. Its widgets follow, then #gui_bar_end. */
void gui_row_begin(const char *id, GuiPoint corner, float width);

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

/** Begins rows of one line each, of which only those in sight are written; the present panel
 * scrolls over all. @param count Their number. @param revealed One that is scrolled to; -1: none.
 */
void gui_rows_begin(int count, int revealed);

/** Finds rows to write now. @param[out] first The first one. @param[out] end Behind the last one.
 *  @return false once there are none left, which ends them. */
bool gui_rows_next(int *first, int *end);

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
    const char *title;             /**< What is shown. */
    const char *unit;              /**< Its unit and scale; empty: none. */
    const unsigned char (*bar)[3]; /**< Colours of the bar, from its lower end; sRGB. */
    int bar_count;                 /**< Number of them; 0: there is no bar. */
    const GuiSwatch *swatches;     /**< Ticks of the bar from its upper end, then colours. */
    int swatch_count;              /**< Number of them. */
    const char *const *notes;      /**< What else is to be said. */
    int note_count;                /**< Number of them. */
} GuiLegend;

/** Where a legend lies. */
typedef struct GuiLegendPlace {
    GuiPoint corner;      /**< Its lower corner, on the side that #is_right says. */
    float highest;        /**< Largest height, pixels of the window: the bar shrinks. */
    float usual;          /**< Width to which words are broken into lines, where they fit. */
    float widest;         /**< Largest width. */
    bool is_right;        /**< Whether the corner is the right one. */
    const GuiRect *taken; /**< Panels that it must not touch: they were asked for. */
    int taken_count;      /**< Number of them. */
} GuiLegendPlace;

/** Draws a legend, unless it would touch what is taken or has no room for its words. @param id
 * Unique to it; not shown. @return Where it lies; of height 0: nowhere. */
GuiRect gui_legend(const char *id, const GuiLegend *legend, const GuiLegendPlace *place);

/** Draws a ring around a pixel, seen on light and dark ground. */
void gui_ring(GuiPoint center, float radius);

/** Pixels as squares. */
typedef struct GuiPixels {
    const unsigned char *rgb; /**< Their colours, sRGB, row by row. */
    int columns;              /**< Squares to the right, odd. */
    int rows;                 /**< Squares down, odd. */
    const char *caption;      /**< What the one in the middle shows. */
} GuiPixels;

/**
 * Draws pixels as squares with lines between them; the one in the middle has a frame.
 * @param point  What they are of; they lie beside it, inside the window.
 * @param top     Upper edge of the free part of the window.
 * @param bottom  Its lower edge.
 */
void gui_pixels(const GuiPixels *pixels, GuiPoint point, float top, float bottom);

/** A point of a chart. */
typedef struct GuiChartPoint {
    char label[4];    /**< Beside it in the chart. */
    const char *name; /**< What the label stands for: a row of the list. */
    double x;         /**< To the right, above 0. */
    double y;         /**< Up, at least 0. */
    bool is_front;    /**< Whether it is part of the front. */
    bool is_shown;    /**< Whether it is the one that is on screen. */
} GuiChartPoint;

/** A chart with two logarithmic axes. */
typedef struct GuiChart {
    const char *title;           /**< What it shows. */
    const char *x_label;         /**< What its lower axis measures, with unit. */
    const char *y_label;         /**< What its left axis measures, with unit. */
    const GuiChartPoint *points; /**< The points. */
    int count;                   /**< Number of them. */
    const char *reason;          /**< Why there are none; NULL: it need not be said. */
    const char *const *notes;    /**< What else is to be said. */
    int note_count;              /**< Number of them. */
} GuiChart;

/** Draws a chart: points with labels, a line through the front, a list of as many points as fit,
 * the last ones. @param corner Its upper left corner.
 *  @param size Its width and height. */
void gui_chart(const GuiChart *chart, GuiPoint corner, GuiPoint size);

/* --- lessons ---------------------------------------------------------------------------------- */

/** Begins a card in the middle of the window, as high as its text. #gui_panel_end follows. */
void gui_card_begin(const char *id);

/** Writes an item of a list in as many lines as it needs. */
void gui_item(const char *text);

/** Puts the next widget into the line of the last one, where it has room. @param label Its words.
 */
void gui_same_line(const char *label);

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

/* --- progress --------------------------------------------------------------------------------- */

/** A thin bar that fills from the left. @param corner Its lower left corner. @param fraction How
 *  much of it is full, 0 to 1. */
void gui_progress_bar(GuiPoint corner, float width, float fraction);

/* --- the inspector of objects ----------------------------------------------------------------- */

/** Where the inspector lies, and where what it is about. */
typedef struct GuiInspectorPlace {
    GuiRect area;   /**< The part of the window in which it lies at first. */
    bool has_thing; /**< Whether #thing is known. */
    GuiPoint thing; /**< Where the thing is seen: the inspector keeps clear of it. */
    bool is_new;    /**< Whether another thing was just chosen. */
} GuiInspectorPlace;

/**
 * Begins a panel at an edge of the window, which can be moved and closed. Its widgets follow, then
 * #gui_inspector_end.
 * @param id       Unique to it; not shown.
 * @param tooltip  Of its title.
 * @return false if the user closes it.
 */
bool gui_inspector_begin(const char *id, const char *title, const char *tooltip,
                         const GuiInspectorPlace *place);

/** @return Where this frame shows the inspector, or the last one did; of width 0: nowhere. */
GuiRect gui_inspector_rect(void);

/** Ends the panel. */
void gui_inspector_end(void);

/** @return The room for the inspector's title, and for that of a part of it. */
float gui_inspector_title_width(void);

/** Begins a part of a panel, which can be folded. @return Whether it is open. */
bool gui_inspector_section(const char *label, const char *tooltip, bool is_open_at_first);

/** A button in a panel. @param is_enabled Whether it can be clicked. @return Whether it was. */
bool gui_inspector_button(const char *label, const char *tooltip, bool is_enabled);

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
 *  light. @param high Largest value of a channel. @param words For hue, saturation, value, red,
 * green and blue, which are numbers below the picker, as keys do not reach its square. @return
 * Whether the user has changed it. */
bool gui_edit_color(const char *label, double rgb[3], double high, const char *const words[6],
                    const char *tooltip);

/** A check box. @return Whether the user has changed it. */
bool gui_edit_check(const char *label, double *number, const char *tooltip);

/** A list of words, of which one is chosen. @param[in,out] number Its index. @param words Ended by
 *  NULL. @return Whether the user has changed it. */
bool gui_edit_choice(const char *label, double *number, const char *const *words,
                     const char *tooltip);

/** @return Whether the user holds a widget, or types into one. */
bool gui_is_editing(void);

/** Draws a line on the picture: a part of the outline of what is selected. @param picture Where the
 *  picture is; what leaves it is not drawn. */
void gui_outline_line(GuiPoint from, GuiPoint to, const GuiRect *picture);

#ifdef __cplusplus
}
#endif

#endif
