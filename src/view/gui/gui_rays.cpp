/**
 * @file
 * @brief Lists of rays, and rays on the picture.
 */
#include "view/gui/gui_internal.h"

#include <new>

namespace {

/** Space beside the text of a label, in heights of letters. */
constexpr float LABEL_PADDING = 0.12F;
/** Width of a ray in flight, in heights of letters. */
constexpr float FLIGHT_WIDTH = 0.22F;
/** Step by which rows of a list are moved to the right, in heights of letters. */
constexpr float ROW_INDENT = 0.7F;
/** Largest part of a list's width for a label beside lines of text. */
constexpr float SHORT_LABEL_FRACTION = 0.3F;
/** Largest part of a list's width by which a row is moved. */
constexpr float INDENT_FRACTION = 0.2F;

/** Width of a row's colour with the gap behind it, in heights of letters. */
constexpr float ROW_COLOR_WIDTH = 0.75F;

/** @return The width of the longest word of a text, which no line can break. */
float widest_word(const char *text) {
    float widest = 0;
    while (*text) {
        const char *end = text + strcspn(text, " ");
        widest = fmaxf(widest, ImGui::CalcTextSize(text, end).x);
        text = end + strspn(end, " ");
    }
    return widest;
}

} // namespace

extern "C" {

void gui_list_begin(const char *id, GuiPoint corner, GuiPoint size) {
    begin_window(id, ImVec2(corner.x, corner.y), ImVec2(size.x, size.y),
                 ImGuiWindowFlags_NoBringToFrontOnFocus);
    current_gui()->has_whole_lines = true;
}

void gui_row_begin(const char *id, GuiPoint corner, float width) {
    ImGui::SetNextWindowPos(ImVec2(corner.x, corner.y));
    ImGui::SetNextWindowSize(ImVec2(width, 0));
    ImGui::Begin(id, nullptr,
                 PANEL_FLAGS | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoFocusOnAppearing);
    push_bar_spacing();
    ImGui::Dummy(ImVec2(0, 0));
    if (ImGui::IsWindowAppearing()) {
        gui_request_frames(current_gui()); // What lies below it learns its height.
    }
}

void gui_list_text(const char *label, const char *text) {
    if (label[0] != '\0') {
        gui_paragraph(label, GUI_COLOR_ACCENT, 1);
        float left = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x;
        float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
        float label_width = ImGui::GetItemRectSize().x, whole = right - ImGui::GetItemRectMin().x;
        bool has_short_label = label_width <= SHORT_LABEL_FRACTION * whole &&
                               text_extent(text, right - left).x <= right - left;
        if (has_short_label || left + ImGui::CalcTextSize(text).x <= right) {
            ImGui::SameLine();
        }
    }
    gui_paragraph(text, GUI_COLOR_TEXT, 1);
}

bool gui_list_row(int number, const char *text, int indent, const unsigned char rgb[3],
                  bool is_selected, bool is_revealed) {
    const float size = ImGui::GetFontSize(), width = ImGui::GetContentRegionAvail().x;
    const float colored = ROW_COLOR_WIDTH * size;
    const float free_width = fmaxf(0, width - colored - widest_word(text));
    const float left = fminf(ROW_INDENT * size * static_cast<float>(indent),
                             fminf(INDENT_FRACTION * width, free_width));
    ImGui::PushID(number);
    ImVec2 corner = ImGui::GetCursorScreenPos();
    float room = width - left - colored;
    bool is_clicked =
        ImGui::Selectable("##row", is_selected, 0, ImVec2(0, text_extent(text, room).y));
    ImDrawList *list = ImGui::GetWindowDrawList();
    ImVec2 low(corner.x + left, corner.y + 0.2F * size);
    if (is_line_shown(list, roundf(corner.y))) {
        const ImVec2 high(low.x + 0.6F * size, low.y + 0.6F * size);
        list->AddRectFilled(low, high, IM_COL32(rgb[0], rgb[1], rgb[2], 255));
        list->AddRect(low, high, TEXT);
    }
    put_text(ImVec2(low.x + colored, corner.y), room, is_selected ? ACCENT : TEXT, text);
    if (is_revealed) {
        // Always the same place, wherever the list was scrolled to.
        const float scrolled = ImGui::GetScrollY() - ImGui::GetWindowPos().y;
        const float top = ImGui::GetItemRectMin().y + scrolled;
        const float bottom = ImGui::GetItemRectMax().y + scrolled,
                    height = ImGui::GetWindowHeight();
        bool is_on_first_page = bottom + ImGui::GetStyle().WindowPadding.y <= height;
        ImGui::SetScrollY(is_on_first_page ? 0 : floorf(fmaxf(0, (top + bottom) / 2 - height / 2)));
        gui_request_frames(current_gui()); // The list knows its height in the next one.
    }
    ImGui::PopID();
    return is_clicked;
}

void gui_rows_begin(int count, int revealed) {
    const float pitch =
        floorf(ImGui::GetTextLineHeightWithSpacing()); // Lines begin at whole pixels.
    if (revealed >= 0) {
        ImGui::SetScrollFromPosY(ImGui::GetCursorPosY() - ImGui::GetScrollY() +
                                 (static_cast<float>(revealed) + 0.5F) * pitch);
        gui_request_frames(current_gui()); // The list knows its height in the next one.
    }
    std::unique_ptr<ImGuiListClipper> &clipper = current_gui()->clipper;
    clipper.reset(new (std::nothrow) ImGuiListClipper());
    if (clipper) {
        clipper->Begin(count, pitch);
    }
}

bool gui_rows_next(int *first, int *end) {
    std::unique_ptr<ImGuiListClipper> &clipper = current_gui()->clipper;
    if (!clipper || !clipper->Step()) {
        clipper.reset();
        return false;
    }
    *first = clipper->DisplayStart;
    *end = clipper->DisplayEnd;
    return true;
}

bool gui_list_check(const char *label, const unsigned char rgb[3], const char *tooltip,
                    bool is_on) {
    place_in_bar(button_width(label) + ImGui::GetFrameHeight());
    ImGui::PushStyleColor(ImGuiCol_CheckMark, IM_COL32(rgb[0], rgb[1], rgb[2], 255));
    bool is_clicked = ImGui::Checkbox(label, &is_on);
    ImGui::PopStyleColor();
    record_right_label(label);
    show_tooltip(tooltip);
    return is_clicked;
}

void gui_label(const char *text, GuiPoint anchor, GuiPoint corner, bool is_bright) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    ImVec2 size = ImGui::CalcTextSize(text), low(corner.x, corner.y);
    float gap = LABEL_PADDING * size.y;
    ImVec2 high(low.x + size.x + gap, low.y + size.y);
    draw_outlined_line(list, ImVec2(anchor.x, anchor.y),
                       ImVec2(low.x + size.x / 2, low.y + size.y / 2), is_bright ? ACCENT : TEXT,
                       1);
    list->AddRectFilled(ImVec2(low.x - gap, low.y), high, is_bright ? ACCENT : OUTLINE,
                        ROUNDING * size.y);
    put_text(list, low, 0, is_bright ? IM_COL32_BLACK : TEXT, text);
}

void gui_flight(GuiPoint from, GuiPoint to, const unsigned char rgb[3]) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    const float width = FLIGHT_WIDTH * ImGui::GetFontSize();
    ImVec2 start(from.x, from.y), end(to.x, to.y);
    list->AddLine(start, end, TEXT, 2 * width);
    list->AddLine(start, end, IM_COL32(rgb[0], rgb[1], rgb[2], 255), width);
    list->AddCircleFilled(end, 2 * width, OUTLINE);
    list->AddCircleFilled(end, 1.6F * width, ACCENT);
}

} // extern "C"
