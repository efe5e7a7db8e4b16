/**
 * @file
 * @brief The bar.
 */
#include "view/gui/gui_internal.h"

namespace {

/** Width of a slider, in heights of letters. */
constexpr float SLIDER_WIDTH = 6;
/** Gap between two widgets of a bar, in heights of letters: with that of panels, the words of a
 *  French bar would need a fourth row. */
constexpr float BAR_GAP = 0.2F;
/** Space beside the words of such a widget, in heights of letters. */
constexpr float BAR_PADDING = 0.3F;
/** Bytes of a button's words with the final zero. */
constexpr size_t BUTTON_SIZE = 256;
/** Largest width of a menu, in heights of letters. */
constexpr float MENU_WIDTH = 32;
/** Opacity of the knob of a slider with a number on it, of 255. */
constexpr int KNOB_ALPHA = 120;
/** Size of the triangle that tells a list from a button, in heights of letters. */
constexpr float TRIANGLE_SIZE = 0.18F;

/** Draws a triangle that points down at the right end of the last widget. */
void draw_triangle() {
    const float size = TRIANGLE_SIZE * ImGui::GetFontSize();
    ImVec2 high = ImGui::GetItemRectMax();
    float right = high.x - ImGui::GetStyle().FramePadding.x / 2;
    float middle = (ImGui::GetItemRectMin().y + high.y) / 2;
    ImGui::GetWindowDrawList()->AddTriangleFilled(
        ImVec2(right - 2 * size, middle - size / 2), ImVec2(right, middle - size / 2),
        ImVec2(right - size, middle + size / 2), PALETTE[GUI_COLOR_FAINT]);
}

/** Pushes a padding of whole pixels: else Dear ImGui makes a list too low by less than one, and
 * lets it scroll. */
void push_whole_padding() {
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(pad.x, roundf(pad.y)));
}

} // namespace

void push_bar_spacing() {
    const ImGuiStyle &style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        ImVec2(BAR_GAP * ImGui::GetFontSize(), style.ItemSpacing.y));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        ImVec2(BAR_PADDING * ImGui::GetFontSize(), style.FramePadding.y));
}

void place_in_bar(float width) {
    float next = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width;
    if (next < ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) {
        ImGui::SameLine();
    }
}

float button_width(const char *label) {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

void focus_next_window(GuiKeyboard panel) {
    if (current_gui()->takes_focus && current_gui()->keyboard == panel) {
        ImGui::SetNextWindowFocus();
    }
}

ImGuiWindowFlags navigation_flags(GuiKeyboard panel) {
    return current_gui()->keyboard == panel ? ImGuiWindowFlags_None : ImGuiWindowFlags_NoNav;
}

void choose_first_widget(GuiKeyboard panel) {
    Gui *gui = current_gui();
    if (gui->takes_focus && gui->keyboard == panel) {
        ImGuiWindow *window = ImGui::GetCurrentWindow();
        // It has not the focus yet if it got new content in this frame, such as another thing while
        // one of its lists was open: Dear ImGui would end the program.
        ImGui::FocusWindow(window);
        ImGui::NavInitWindow(window, true);
        ImGui::GetCurrentContext()->NavDisableHighlight = false;
        gui->takes_focus = false;
    }
}

bool begin_list(const char *label, const char *shown, ImGuiComboFlags flags) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = ImGui::CalcItemWidth();
    push_whole_padding();
    bool is_open = ImGui::BeginCombo(label, shown, flags);
    ImGui::PopStyleVar();
    if (is_open) {
        note_open_list(ImRect(low, ImVec2(low.x + width, low.y + ImGui::GetFrameHeight())));
    }
    return is_open;
}

bool begin_menu(const char *label, const char *tooltip, bool is_below) {
    if (push_button(label, tooltip, false)) {
        ImGui::OpenPopup("menu");
    }
    if (!ImGui::IsPopupOpen("menu")) {
        return false;
    }
    const ImRect button(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    note_open_list(button);
    if (is_below) {
        ImGui::SetNextWindowPos(button.GetBL());
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = fminf(MENU_WIDTH * ImGui::GetFontSize(), display.x);
    ImGui::SetNextWindowSizeConstraints(ImVec2(0, 0), ImVec2(width, display.y));
    push_whole_padding();
    bool is_open = ImGui::BeginPopup("menu");
    ImGui::PopStyleVar();
    if (is_open && ImGui::IsWindowAppearing()) {
        gui_request_frames(current_gui()); // The menu finds its size.
    }
    return is_open;
}

void note_open_list(const ImRect &opener) {
    current_gui()->list_opener = opener;
}

bool push_button(const char *label, const char *tooltip, bool is_marked, float width) {
    char text[BUTTON_SIZE];
    snprintf(text, sizeof text, width > 0 ? "%s###toggle" : "%s", label);
    if (is_marked) {
        ImGui::PushStyleColor(ImGuiCol_Text, ACCENT);
    }
    bool is_clicked = ImGui::Button(text, ImVec2(width, 0));
    if (is_marked) {
        ImGui::PopStyleColor();
    }
    record_label(label);
    show_tooltip(tooltip);
    return is_clicked;
}

extern "C" {

void gui_bar_begin(bool is_folded) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(is_folded ? 0 : ImGui::GetIO().DisplaySize.x, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    focus_next_window(GUI_BAR);
    ImGui::Begin("bar", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | navigation_flags(GUI_BAR));
    ImGui::PopStyleVar();
    choose_first_widget(GUI_BAR);
    current_gui()->has_bar = true;
    push_bar_spacing();
    ImGui::Dummy(ImVec2(0, 0));
}

float gui_bar_end() {
    float height = ImGui::GetWindowHeight();
    ImGui::PopStyleVar(2);
    if (current_gui()->keyboard == GUI_BAR) {
        // The arrow right of the last button of a row goes to the next row.
        ImGui::NavMoveRequestTryWrapping(ImGui::GetCurrentWindow(), ImGuiNavMoveFlags_WrapX);
    }
    ImGui::End();
    return height;
}

bool gui_button(const char *label, const char *tooltip, bool is_on) {
    place_in_bar(button_width(label));
    return push_button(label, tooltip, is_on);
}

bool gui_toggle(const char *const labels[2], const char *tooltip, bool is_on) {
    const float width = fmaxf(button_width(labels[0]), button_width(labels[1]));
    place_in_bar(width);
    ImGui::PushID(labels[0]); // Keys that have chosen it keep it.
    const bool is_clicked = push_button(labels[is_on ? 1 : 0], tooltip, is_on, width);
    ImGui::PopID();
    return is_clicked;
}

int gui_choice(const char *id, const char *const *names, const char *const *explained, int count,
               int selected, const char *tooltip) {
    const char *shown = selected >= 0 && selected < count ? names[selected] : "";
    int chosen = -1;
    float width = 0;
    for (int i = 0; i < count; i++) {
        width = fmaxf(width, button_width(names[i]));
    }
    width += 2 * TRIANGLE_SIZE * ImGui::GetFontSize(); // The triangle lies beside the words.
    place_in_bar(width);
    ImGui::PushID(id);
    ImGui::SetNextItemWidth(width);
    if (begin_list("##list", shown,
                   ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLargest)) {
        if (ImGui::IsWindowAppearing()) {
            gui_request_frames(current_gui()); // The list finds its size.
        }
        for (int i = 0; i < count; i++) {
            if (ImGui::Selectable(explained[i], i == selected) && i != selected) {
                chosen = i;
            }
        }
        ImGui::EndCombo();
    } else {
        draw_triangle();
        record_left_label(shown);
        show_tooltip(tooltip);
    }
    ImGui::PopID();
    return chosen;
}

bool gui_menu_begin(const char *label, const char *tooltip) {
    place_in_bar(button_width(label));
    return begin_menu(label, tooltip, true);
}

bool gui_menu_entry(const char *text) {
    return ImGui::Selectable(text);
}

void gui_menu_end() {
    ImGui::EndPopup();
}

int gui_stepper(const char *id, const char *text, const char *widest, const char *tooltip) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    int step = 0;
    float width = fmaxf(ImGui::CalcTextSize(widest).x, ImGui::CalcTextSize(text).x);
    place_in_bar(button_width("−") + button_width("+") + width + 2 * gap);
    ImGui::PushID(id);
    ImGui::BeginGroup();
    step -= ImGui::Button("−") ? 1 : 0;
    ImGui::SameLine(0, gap);
    ImGui::AlignTextToFramePadding();
    float left = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(text);
    record_label(text);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + width + gap);
    step += ImGui::Button("+") ? 1 : 0;
    ImGui::EndGroup();
    show_tooltip(tooltip);
    ImGui::PopID();
    return step;
}

bool gui_log_slider(const char *id, double *value, double low, double high, const char *text,
                    bool is_in_use, const char *tooltip) {
    float width = SLIDER_WIDTH * ImGui::GetFontSize();
    // Dear ImGui's own logarithmic scale ends at the precision of the text: 0.1 for one digit.
    double exponent = log10(*value), least = log10(low), most = log10(high);
    place_in_bar(width);
    ImGui::PushID(id);
    ImGui::SetNextItemWidth(width);
    // The number is read through the knob.
    const ImU32 knob = (ACCENT & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, KNOB_ALPHA);
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, is_in_use ? 1 : ImGui::GetStyle().DisabledAlpha);
    ImGui::PushStyleColor(ImGuiCol_SliderGrab, knob);
    ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, knob);
    bool is_changed = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &exponent, &least,
                                          &most, text, ImGuiSliderFlags_NoInput);
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar();
    if (is_changed) {
        *value = pow(10, exponent);
    }
    record_label(text);
    show_tooltip(tooltip);
    ImGui::PopID();
    return is_changed;
}

} // extern "C"
