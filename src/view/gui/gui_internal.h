/**
 * @file
 * @brief What the files of the interface share: its state, colours, text and windows.
 *
 * Dear ImGui keeps one current context per process. Each function of a whole interface makes its
 * own the current one; the widgets between #gui_begin_frame and #gui_end_frame belong to it.
 */
#ifndef DIOPTRE_VIEW_GUI_GUI_INTERNAL_H
#define DIOPTRE_VIEW_GUI_GUI_INTERNAL_H

#include "view/gui/gui.h"
#include "view/gui/gui_draw.h"
#include "view/gui/typeface.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <imgui.h>
#include <imgui_internal.h>
#include <memory>

/** Frames that are drawn after an event: Dear ImGui reacts to a click one frame later. */
constexpr int FRAMES_PER_EVENT = 3;
/** Padding of widgets and panels, in heights of letters: 8 pixels in letters of 20. */
constexpr float PADDING = 0.4F;
/** Radius of rounded corners, in heights of letters. */
constexpr float ROUNDING = 0.3F;
/** Behaviour of panels and cards. */
constexpr ImGuiWindowFlags PANEL_FLAGS = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings;
/** The palette, by #GuiColor. Groups are distinct for colour-blind viewers too. */
constexpr ImU32 PALETTE[GUI_COLOR_COUNT] = {
    IM_COL32(240, 240, 240, 255), IM_COL32(150, 156, 170, 255), IM_COL32(255, 205, 90, 255),
    IM_COL32(150, 200, 255, 255), IM_COL32(255, 160, 130, 255), IM_COL32(220, 178, 130, 255),
    IM_COL32(255, 205, 90, 255),  IM_COL32(120, 190, 255, 255), IM_COL32(90, 215, 170, 255),
    IM_COL32(255, 145, 110, 255), IM_COL32(205, 205, 215, 255), IM_COL32(225, 165, 215, 255),
    IM_COL32(165, 155, 255, 255), IM_COL32(215, 225, 120, 255)};
/** Colour of what is on, and of lights. */
constexpr ImU32 ACCENT = PALETTE[GUI_COLOR_ACCENT];
/** Colour of outlines on the picture: seen on light and dark ground. */
constexpr ImU32 OUTLINE = IM_COL32(0, 0, 0, 200);
/** Colour of text on the picture. */
constexpr ImU32 TEXT = PALETTE[GUI_COLOR_TEXT];
/** Colour of a row under the mouse. */
constexpr ImU32 HOVERED = IM_COL32(255, 255, 255, 36);
/** Colour of the selected row. */
constexpr ImU32 SELECTED = IM_COL32(255, 205, 90, 60);

/** The colour in the picker, as hue, saturation and value. */
struct PickedColor {
    float encoded[3];  /**< The colour, with the curve of sRGB. */
    double hue;        /**< Degrees, from red by yellow. */
    double saturation; /**< 0: grey; 1: pure. */
    double value;      /**< The largest channel, encoded. */
};

/** When tooltips may come: once the mouse has moved on after a click or a key, and rests on a
 *  widget. */
struct MouseRest {
    ImVec2 place;     /**< Where the mouse is. */
    double since;     /**< Since when, seconds. */
    bool has_clicked; /**< Whether it has not moved on since a click or a key. */
    ImVec2 click;     /**< Where that was. */
    ImRect silenced;  /**< The widget that was clicked, until the mouse leaves it. */
    ImRect hinted;    /**< The widget whose tooltip is shown, until the mouse leaves it. */
    double due_time;  /**< When a tooltip comes if the mouse stays, seconds; 0: none does. */
};

struct Gui {
    ImGuiContext *context;    /**< Dear ImGui's state; owned. */
    SDL_Renderer *renderer;   /**< The window's renderer. */
    const Typeface *typeface; /**< The typeface. */
    SDL_Texture *letters;     /**< The letters; owned; null: none. */
    float letter_size;        /**< Their height, pixels of the screen; 0: none. */
    KeptPanel *kept;          /**< The panels that are kept as pictures; owned. */
    ImFont *heading;          /**< The letters of headings. */
    SDL_Cursor *ring;         /**< The mouse as a ring; owned; null: as usual. */
    int due_frames;           /**< Frames to be drawn, see FRAMES_PER_EVENT. */
    bool has_new_key;         /**< Whether a key went down or up since the last frame. */
    GuiKeyboard keyboard;     /**< What has the keyboard. */
    bool is_inspecting;       /**< Whether this frame shows the inspector. */
    bool has_bar;             /**< Whether it shows the bar. */
    ImRect inspector;         /**< Where, if so. */
    float inspector_room;     /**< Its greatest height when it was shown last, pixels. */
    bool is_number_chosen;    /**< Whether keys have chosen a number, which Enter lets type. */
    bool has_text_input;      /**< Whether the system is asked for letters. */
    SDL_Scancode plain_key;   /**< The last key that went down without Shift and its like; unknown:
                                   another one has. */
    bool takes_focus;         /**< Whether it takes the focus in the next frame. */
    bool closes_list;         /**< Whether the open list is closed in the next frame. */
    ImRect list_opener;       /**< The widget that has opened the list. */
    MouseRest rest;           /**< When tooltips may come. */
    PickedColor picked;       /**< The colour in the picker. */
    std::unique_ptr<ImGuiListClipper> clipper; /**< Finds which rows of a long list are in sight;
                                                    null: no such list is written. */
    bool has_whole_lines;    /**< Whether the present panel shows no part of a line. */
    bool records_texts;      /**< Whether #texts are recorded. */
    ImVector<GuiText> texts; /**< The texts of the frame. */
};

/** @return The interface whose frame is drawn. */
Gui *current_gui();

/** Handles an event of the keyboard. @return Whether it is for the interface alone. */
bool handle_key_event(Gui *gui, const SDL_Event *event);

/** Takes the keyboard from the panel that has it. */
void take_keyboard(Gui *gui);

/** Asks the system for letters while a number is typed, and only then: else a key that moves things
 *  would open its list of accents. */
void update_text_input(Gui *gui);

/** Takes the tooltip away, until the mouse moves on. */
void silence_tooltips(MouseRest *rest);

/** Follows the mouse, at the beginning of a frame. */
void follow_mouse_rest(MouseRest *rest);

/** Shows a tooltip while the mouse rests on the last widget, or keys have chosen that. */
void show_tooltip(const char *text);

/** Records a text for tests. @param clip What is seen of its surroundings. */
void record_text(const char *text, ImVec2 low, ImVec2 high, const ImVec4 &clip, float size);

/** @return What can be seen of a box in the present panel. */
ImVec4 clipped(ImVec2 low, ImVec2 high);

/** Records the label of the last widget, which is cut where the widget ends. */
void record_label(const char *label);

/** Records the label of the last widget, which stands at its left end. */
void record_left_label(const char *label);

/** Records the label of the last widget, which stands at its right end. */
void record_right_label(const char *label);

/** @return The size of a text. @param width Width of lines; 0: they are not broken. */
ImVec2 text_extent(const char *text, float width);

/** @return Whether a line of text is shown: in a list only if it is not cut. @param top Its upper
 * end. */
bool is_line_shown(const ImDrawList *list, float top);

/** Writes a text. @param width See #text_extent. @return Its size. */
ImVec2 put_text(ImDrawList *list, ImVec2 corner, float width, ImU32 color, const char *text);

/** Writes a text into the present panel. @param width See #text_extent. @return Its size. */
ImVec2 put_text(ImVec2 corner, float width, ImU32 color, const char *text);

/** @return What can be seen of a text on the picture: what is in the window. */
ImVec4 display_clip();

/** Begins a window without a frame of its own. */
void begin_window(const char *id, ImVec2 corner, ImVec2 size, ImGuiWindowFlags flags);

/** Begins what lies on the picture below all panels and lets the mouse through: a panel without a
 *  ground, so that it is kept as a picture (see gui_draw.cpp). @return The list to draw into. */
ImDrawList *begin_value(const char *id, ImVec2 low, ImVec2 high);

/** Ends it. */
void end_value(ImDrawList *list);

/** @return A colour that is darker. */
ImU32 darker(ImU32 color);

/** Has the widgets of a bar stand nearer to each other, until #gui_bar_end. */
void push_bar_spacing();

/** Places the next widget of the bar: in the line, or in the next one where it is too wide. */
void place_in_bar(float width);

/** @return Width of a button with a label. */
float button_width(const char *label);

/** Has the next window take the focus, if a panel was just given the keyboard. @param panel What
 * the window is. */
void focus_next_window(GuiKeyboard panel);

/** @return ImGuiWindowFlags_NoNav unless a panel has the keyboard. */
ImGuiWindowFlags navigation_flags(GuiKeyboard panel);

/** Chooses the first widget of the present window, if the panel was just given the keyboard. */
void choose_first_widget(GuiKeyboard panel);

/** Begins a list to choose from, as ImGui::BeginCombo does. @param shown What is chosen. @return
 *  Whether it is open: its entries follow, then ImGui::EndCombo. */
bool begin_list(const char *label, const char *shown, ImGuiComboFlags flags);

/** Shows a button that opens a menu; one per window. @param is_below Whether it opens below the
 *  button, else where there is room. @return Whether it is open: its entries follow, then
 *  ImGui::EndPopup. */
bool begin_menu(const char *label, const char *tooltip, bool is_below);

/** Notes that a list is open below a widget. @param opener The widget. */
void note_open_list(const ImRect &opener);

/** How a number is shown and changed. */
struct NumberField {
    double low;             /**< Its least value. */
    double high;            /**< Its largest value. */
    float speed;            /**< How much a pixel of a drag changes it; 0: it is a slider. */
    const char *format;     /**< As for printf. */
    ImGuiSliderFlags flags; /**< More flags of Dear ImGui. */
};

/** A number that the user drags, slides or types, without a label. @return Whether it has changed.
 */
bool edit_number(const char *id, double *number, const NumberField &field);

/** @return Whether numbers that are typed have a sign: a point and a comma are both the decimal
 * one.
 */
bool is_sign_of_number(ImWchar sign);

/** Writes a label right of the last widget. */
void put_label(const char *label);

/** A button with a tooltip. @param is_marked Whether its words stand out. @param width Its width,
 *  whose words may change; 0: that of its words. @return Whether it was clicked. */
bool push_button(const char *label, const char *tooltip, bool is_marked, float width = 0);

/** Draws a line with an outline. */
void draw_outlined_line(ImDrawList *list, ImVec2 from, ImVec2 to, ImU32 color, float width);

#endif
