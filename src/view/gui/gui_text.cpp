/**
 * @file
 * @brief Text: lines, headings, messages, tooltips, and its record for tests.
 */
#include "view/gui/gui_internal.h"

extern "C" {
#include "base/clock.h"
}

namespace {

/** Size of very large letters, in heights of letters. */
constexpr float TITLE_SIZE = 2.2F;
/** Seconds that the mouse rests on a widget until its tooltip comes. */
constexpr double REST_SECONDS = 0.35;
/** Distance from a click from which the mouse has moved on, in heights of letters. */
constexpr float MOVED_ON = 0.4F;
/** Distance of a tooltip from its widget, in heights of letters. */
constexpr float TOOLTIP_GAP = 0.25F;
/** Widest line of a tooltip, in heights of letters. */
constexpr float TOOLTIP_WIDTH = 24;
/** Room beside a panel from which a tooltip lies there, in heights of letters. */
constexpr float BESIDE_WIDTH = 12;
/** Largest height of a bar, of that of the display. */
constexpr float BAR_HEIGHT = 0.34F;
/** Largest distance of two bars that lie below each other, units of the window. */
constexpr float BAR_DISTANCE = 2;
/** Most bars below each other. */
constexpr int BARS_MAXIMUM = 3;

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

/** @return The largest width of the text of a message in a room. */
float message_width(float room) {
    return fmaxf(1, room - 2 * ImGui::GetFontSize() - 2 * ImGui::GetStyle().WindowPadding.x);
}

/** @return Whether a window is a row of widgets from one side of the display to the other. */
bool is_bar(const ImGuiWindow *window) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    return window->Size.x >= display.x && window->Size.y < BAR_HEIGHT * display.y;
}

/** @return Whether a window is seen that begins at a height, from one side to the other. */
bool begins_at(const ImGuiWindow *window, float top) {
    return window->WasActive && !window->Hidden && fabsf(window->Pos.y - top) < BAR_DISTANCE &&
           window->Size.x >= ImGui::GetIO().DisplaySize.x;
}

/** @return Where a tooltip of a bar has room: below it, and below the bars that lie there; at the
 *  lower edge of the display where a panel that is no bar begins there. @param height Of the
 * tooltip. */
float below_bars(const ImGuiWindow *bar, float height, float gap) {
    const float first = bar->Pos.y + bar->Size.y;
    float bottom = first;
    // They are not in the order from above: each may be the next one.
    for (int i = 0; i < BARS_MAXIMUM; i++) {
        for (const ImGuiWindow *window : ImGui::GetCurrentContext()->Windows) {
            const bool is_next = window != bar && begins_at(window, bottom);
            if (is_next && !is_bar(window) && bottom <= first) {
                return ImGui::GetIO().DisplaySize.y - height - gap;
            }
            bottom = is_next && is_bar(window) ? window->Pos.y + window->Size.y : bottom;
        }
    }
    return bottom + gap;
}

/** @return The width that a tooltip may have, with its padding: beside a panel where that is wide
 *  enough, else in the whole window. */
float tooltip_room() {
    const ImGuiWindow *window = ImGui::GetCurrentWindowRead();
    const float display = ImGui::GetIO().DisplaySize.x, size = ImGui::GetFontSize();
    const float beside = fmaxf(window->Pos.x, display - window->Pos.x - window->Size.x);
    return beside >= BESIDE_WIDTH * size ? beside - TOOLTIP_GAP * size : display;
}

/** @return Where the tooltip of the last widget lies: on neither it nor its neighbours. @param
 *  whole Its size. @param room See #tooltip_room. */
ImVec2 place_tooltip(ImVec2 whole, float room) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const float gap = TOOLTIP_GAP * ImGui::GetFontSize();
    const ImGuiWindow *window = ImGui::GetCurrentWindowRead();
    if (room < display.x) {
        const float right = window->Pos.x + window->Size.x;
        const bool is_left = window->Pos.x > display.x - right;
        return ImVec2(is_left ? window->Pos.x - gap - whole.x : right + gap,
                      fmaxf(0, fminf(low.y, display.y - whole.y)));
    }
    ImVec2 at(fmaxf(0, fminf(low.x, display.x - whole.x)),
              is_bar(window) ? below_bars(window, whole.y, gap) : high.y + gap);
    at.y = at.y + whole.y > display.y ? fmaxf(0, low.y - gap - whole.y) : at.y;
    return at;
}

/** @return Whether the tooltip of the last widget, which is hovered, is to be shown: the mouse
 * rests on it, and has not just clicked it, or what lay there before. Who clicks knows what a
 * widget does, and looks at what it has done. */
bool is_tooltip_due(MouseRest *rest) {
    const ImRect widget(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    const ImVec2 &mouse = ImGui::GetIO().MousePos;
    if (ImGui::GetCurrentContext()->NavDisableMouseHover) {
        return true; // Keys have chosen it.
    }
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        rest->silenced = widget;
    }
    if (rest->has_clicked || rest->silenced.Contains(mouse)) {
        return false;
    }
    if (!rest->hinted.Contains(mouse) && clock_now_seconds() - rest->since < REST_SECONDS) {
        rest->due_time = rest->since + REST_SECONDS;
        return false;
    }
    if (!rest->hinted.Contains(mouse)) {
        gui_request_frames(current_gui()); // The tooltip finds its size.
    }
    rest->hinted = widget;
    return true;
}

} // namespace

void silence_tooltips(MouseRest *rest) {
    rest->has_clicked = true;
    rest->click = ImGui::GetIO().MousePos;
    rest->hinted = ImRect();
}

void follow_mouse_rest(MouseRest *rest) {
    const ImVec2 &mouse = ImGui::GetIO().MousePos;
    const float moved_on = MOVED_ON * ImGui::GetFontSize();
    if (mouse.x != rest->place.x || mouse.y != rest->place.y) {
        rest->place = mouse;
        rest->since = clock_now_seconds();
    }
    if (ImGui::IsAnyMouseDown()) {
        silence_tooltips(rest);
    } else if (hypotf(mouse.x - rest->click.x, mouse.y - rest->click.y) > moved_on) {
        rest->has_clicked = false;
    }
    rest->silenced = rest->silenced.Contains(mouse) ? rest->silenced : ImRect();
    rest->hinted = rest->hinted.Contains(mouse) ? rest->hinted : ImRect();
    rest->due_time = 0;
}

void show_tooltip(const char *text) {
    if (!text || text[0] == '\0' || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) ||
        !is_tooltip_due(&current_gui()->rest)) {
        return;
    }
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    const float room = tooltip_room();
    const float width = fminf(TOOLTIP_WIDTH * ImGui::GetFontSize(), room - 2 * pad.x);
    const ImVec2 extent = text_extent(text, width);
    ImGui::SetNextWindowPos(
        place_tooltip(ImVec2(extent.x + 2 * pad.x, extent.y + 2 * pad.y), room));
    ImGui::SetNextWindowBgAlpha(1);
    ImGui::BeginTooltip();
    put_text(ImGui::GetCursorScreenPos(), width, TEXT, text);
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

bool is_line_shown(const ImDrawList *list, float top) {
    const ImVec4 &clip = list->_ClipRectStack.back();
    return !current_gui()->has_whole_lines ||
           (top >= clip.y && top + ImGui::GetFontSize() <= clip.w);
}

ImVec2 put_text(ImDrawList *list, ImVec2 corner, float width, ImU32 color, const char *text) {
    const float size = ImGui::GetFontSize();
    const ImVec2 low(roundf(corner.x), roundf(corner.y)), extent = text_extent(text, width);
    ImVec4 seen = list->_ClipRectStack.back();
    float bottom = low.y;
    const char *line = text;
    for (float top = low.y; *line != '\0'; top += size) {
        const char *end = line_end(line, width);
        if (is_line_shown(list, top)) {
            list->AddText(ImVec2(low.x, top), color, line, end);
            bottom = top + size;
        } else if (bottom <= low.y) {
            seen.y = fmaxf(seen.y, top + size); // The line is above what is shown.
        }
        line = *end != '\0' ? end + 1 : end;
    }
    seen.w = current_gui()->has_whole_lines ? fmaxf(seen.y, fminf(seen.w, bottom)) : seen.w;
    record_text(text, low, ImVec2(low.x + extent.x, low.y + extent.y), seen, size);
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

GuiPoint gui_message_size(const char *text, float room) {
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    const ImVec2 size = text_extent(text, message_width(room));
    return GuiPoint{size.x + 2 * pad.x + 1, size.y + 2 * pad.y};
}

void gui_message(const char *id, const char *text, float room, GuiPoint point, GuiSide side) {
    const GuiPoint size = gui_message_size(text, room);
    const ImVec2 whole(size.x, size.y);
    ImVec2 corner(point.x - whole.x / 2, point.y - (side == GUI_ABOVE ? whole.y : 0));
    begin_window(id, corner, whole, ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar);
    // The inspector, which is clicked, would lie over it.
    ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    put_text(ImGui::GetCursorScreenPos(), message_width(room), TEXT, text);
    ImGui::End();
}

float gui_text_width(const char *text) {
    return ImGui::CalcTextSize(text).x;
}

} // extern "C"
