/**
 * @file
 * @brief Text: lines, headings, messages, tooltips, and its record for tests.
 */
#include "view/gui/gui_internal.h"

namespace {

/** Size of very large letters, in heights of letters. */
constexpr float TITLE_SIZE = 2.2F;
/** Distance of a tooltip from its widget, in heights of letters. */
constexpr float TOOLTIP_GAP = 0.25F;
/** Widest line of a tooltip, in heights of letters. */
constexpr float TOOLTIP_WIDTH = 24;

/** @return The end of the first line of a text: at a line's end or at a space, as Dear ImGui itself
 *  breaks numbers at their points. @param width Width of lines; 0: they are not broken. */
const char *line_end(const char *text, float width) {
    const char *end = text;
    while (*end != '\0' && *end != '\n') {
        const char *next = end + 1;
        while (*next != '\0' && *next != ' ' && *next != '\n') {
            next++;
        }
        if (width > 0 && end != text && ImGui::CalcTextSize(text, next).x > width) {
            break;
        }
        end = next;
    }
    return end;
}

/** @return The largest width of the text of a message. */
float message_width() {
    return ImGui::GetIO().DisplaySize.x - 2 * ImGui::GetFontSize() -
           2 * ImGui::GetStyle().WindowPadding.x;
}

} // namespace

void show_tooltip(const char *text) {
    if (!text || text[0] == '\0' || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) {
        return;
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize, pad = ImGui::GetStyle().WindowPadding;
    const float width = fminf(TOOLTIP_WIDTH * ImGui::GetFontSize(), display.x - 2 * pad.x);
    const ImVec2 extent = text_extent(text, width);
    const ImVec2 whole(extent.x + 2 * pad.x, extent.y + 2 * pad.y);
    const float gap = TOOLTIP_GAP * ImGui::GetFontSize();
    // Below the whole bar, so that it lies on none of its buttons; above what is too far down.
    const ImGuiWindow *window = ImGui::GetCurrentWindowRead();
    const bool is_bar = window->Pos.y <= 0 && window->Size.x >= display.x;
    ImVec2 low = ImGui::GetItemRectMin();
    ImVec2 at(fmaxf(0, fminf(low.x, display.x - whole.x)),
              (is_bar ? window->Pos.y + window->Size.y : ImGui::GetItemRectMax().y) + gap);
    at.y = at.y + whole.y > display.y ? fmaxf(0, low.y - gap - whole.y) : at.y;
    ImGui::SetNextWindowPos(at);
    ImGui::SetNextWindowBgAlpha(1);
    ImGui::BeginTooltip();
    ImVec2 corner = ImGui::GetCursorScreenPos();
    put_text(corner, width, TEXT, text);
    ImGui::Dummy(extent);
    ImGui::EndTooltip();
}

void record_text(const char *text, ImVec2 low, ImVec2 high, const ImVec4 &clip, float size) {
    Gui *gui = current_gui();
    if (!gui->records_texts || text[0] == '\0') {
        return;
    }
    const ImGuiWindow *window = ImGui::GetCurrentWindowRead();
    GuiText record = {};
    ImStrncpy(record.text, text, sizeof record.text);
    record.rect = GuiRect{low.x, low.y, high.x - low.x, high.y - low.y};
    record.clip = GuiRect{clip.x, clip.y, clip.z - clip.x, clip.w - clip.y};
    record.size = size;
    record.scrolls = !window->IsFallbackWindow && !(window->Flags & ImGuiWindowFlags_NoScrollbar);
    gui->texts.push_back(record);
}

ImVec4 clipped(ImVec2 low, ImVec2 high) {
    const ImVec4 &clip = ImGui::GetWindowDrawList()->_ClipRectStack.back();
    return ImVec4(fmaxf(low.x, clip.x), fmaxf(low.y, clip.y), fminf(high.x, clip.z),
                  fminf(high.y, clip.w));
}

void record_label(const char *label) {
    ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImVec2 size = ImGui::CalcTextSize(label);
    float left = (low.x + high.x - size.x) / 2, top = (low.y + high.y - size.y) / 2;
    record_text(label, ImVec2(left, top), ImVec2(left + size.x, top + size.y), clipped(low, high),
                ImGui::GetFontSize());
}

void record_left_label(const char *label) {
    ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImVec2 size = ImGui::CalcTextSize(label);
    float left = low.x + ImGui::GetStyle().FramePadding.x, top = (low.y + high.y - size.y) / 2;
    record_text(label, ImVec2(left, top), ImVec2(left + size.x, top + size.y), clipped(low, high),
                ImGui::GetFontSize());
}

void record_right_label(const char *label) {
    ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImVec2 size = ImGui::CalcTextSize(label);
    float top = (low.y + high.y - size.y) / 2;
    record_text(label, ImVec2(high.x - size.x, top), ImVec2(high.x, top + size.y),
                clipped(low, high), ImGui::GetFontSize());
}

ImVec2 text_extent(const char *text, float width) {
    ImVec2 size(0, 0);
    do {
        const char *end = line_end(text, width);
        size.x = fmaxf(size.x, ImGui::CalcTextSize(text, end).x);
        size.y += ImGui::GetFontSize();
        text = *end != '\0' ? end + 1 : end;
    } while (*text != '\0');
    return size;
}

ImVec2 put_text(ImDrawList *list, ImVec2 corner, float width, ImU32 color, const char *text) {
    const float size = ImGui::GetFontSize();
    ImVec2 at(roundf(corner.x), roundf(corner.y)), extent = text_extent(text, width);
    record_text(text, at, ImVec2(at.x + extent.x, at.y + extent.y), list->_ClipRectStack.back(),
                size);
    while (*text != '\0') {
        const char *end = line_end(text, width);
        list->AddText(at, color, text, end);
        at.y += size;
        text = *end != '\0' ? end + 1 : end;
    }
    return extent;
}

ImVec2 put_text(ImVec2 corner, float width, ImU32 color, const char *text) {
    return put_text(ImGui::GetWindowDrawList(), corner, width, color, text);
}

ImVec4 display_clip() {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    return ImVec4(0, 0, display.x, display.y);
}

extern "C" {

float gui_text_size() {
    return ImGui::GetFontSize();
}

float gui_title(const char *text, GuiPoint top) {
    ImDrawList *list = ImGui::GetForegroundDrawList();
    ImFont *font = current_gui()->heading;
    const float size = TITLE_SIZE * ImGui::GetFontSize(), pad = PADDING * size;
    ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, text);
    ImVec2 at(roundf(top.x - extent.x / 2), roundf(top.y + pad));
    list->AddRectFilled(ImVec2(at.x - pad, top.y),
                        ImVec2(at.x + extent.x + pad, at.y + extent.y + pad),
                        ImGui::GetColorU32(ImGuiCol_WindowBg), ROUNDING * size);
    list->AddText(font, size, at, ACCENT, text);
    record_text(text, at, ImVec2(at.x + extent.x, at.y + extent.y), display_clip(), size);
    return at.y + extent.y + pad;
}

void gui_heading(const char *text) {
    ImGui::PushFont(current_gui()->heading);
    ImVec2 size = put_text(ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail().x,
                           PALETTE[GUI_COLOR_HEADING], text);
    ImGui::PopFont();
    ImGui::Dummy(size);
}

void gui_paragraph(const char *text, GuiColor color, int lines) {
    ImVec2 size = put_text(ImGui::GetCursorScreenPos(), ImGui::GetContentRegionAvail().x,
                           PALETTE[color], text);
    size.y = fmaxf(size.y, static_cast<float>(lines) * ImGui::GetFontSize());
    ImGui::Dummy(size);
}

float gui_message_height(const char *text) {
    return text_extent(text, message_width()).y + 2 * ImGui::GetStyle().WindowPadding.y;
}

void gui_message(const char *id, const char *text, GuiPoint point, GuiSide side) {
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    ImVec2 size = text_extent(text, message_width());
    ImVec2 whole(size.x + 2 * pad.x + 1, size.y + 2 * pad.y);
    ImVec2 corner(point.x - whole.x / 2, point.y - (side == GUI_ABOVE ? whole.y : 0));
    begin_window(id, corner, whole, ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar);
    // The inspector, which is clicked, would lie over it.
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    put_text(ImGui::GetCursorScreenPos(), size.x + 1, TEXT, text);
    ImGui::End();
}

float gui_text_width(const char *text) {
    return ImGui::CalcTextSize(text).x;
}

} // extern "C"
