/**
 * @file
 * @brief Panels that fill a room, keys of a keyboard, and thumbnails.
 */
#include "view/gui/gui_internal.h"

namespace {

/** Opacity of a panel that fills its room: the picture is hardly seen through it. */
constexpr float PANEL_ALPHA = 0.95F;
/** Smallest width of a thumbnail, in heights of letters. */
constexpr float THUMBNAIL_WIDTH = 8.5F;
/** Height of a thumbnail, in widths. */
constexpr float THUMBNAIL_RATIO = 0.75F;
/** Fewest and most lines of a thumbnail's name. */
constexpr int NAME_LINES = 2, NAME_LINES_MAXIMUM = 4;
/** Smallest letters on a key, fraction of the window's height, and pixels. */
constexpr float KEY_TEXT_FRACTION = 1 / 30.0F;
/** See KEY_TEXT_FRACTION. */
constexpr float KEY_TEXT_MINIMUM = 14;
/** Bytes of what is searched, with a caret and the final zero. */
constexpr size_t SEARCH_SIZE = 128;
/** The caret of what is typed. */
constexpr char CARET[] = "\xe2\x96\x8f";
/** Colour of keys without a command, and of thumbnails that are not drawn yet. */
constexpr ImU32 EMPTY = IM_COL32(42, 46, 58, 255);

/** Writes a text in the middle of a box, in letters that fit. */
void put_fitted_text(ImVec2 low, ImVec2 high, ImU32 color, const char *text) {
    const float usual = ImGui::GetFontSize();
    const float least =
        fminf(usual, fmaxf(KEY_TEXT_MINIMUM, KEY_TEXT_FRACTION * ImGui::GetIO().DisplaySize.y));
    const float room = high.x - low.x - 2;
    ImVec2 natural = ImGui::CalcTextSize(text);
    float size = natural.x > room ? fmaxf(least, usual * room / natural.x) : usual;
    ImVec2 extent(natural.x * size / usual, size);
    ImVec2 at(roundf((low.x + high.x - extent.x) / 2), roundf((low.y + high.y - extent.y) / 2));
    ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), size, at, color, text);
    record_text(text, at, ImVec2(at.x + extent.x, at.y + extent.y), clipped(low, high), size);
}

/** @return Height of the picture of a thumbnail. */
float thumbnail_picture_height(float width) {
    const float pad = PADDING * ImGui::GetFontSize();
    return roundf((width - 2 * pad) * THUMBNAIL_RATIO);
}

/** @return Height of a thumbnail with its name. @param name Height of the name. */
float thumbnail_height(float width, float name) {
    return thumbnail_picture_height(width) + 3 * PADDING * ImGui::GetFontSize() + name;
}

/** Begins a panel. See #gui_panel_begin. */
void begin_panel(const char *id, const GuiRect *room, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowBgAlpha(PANEL_ALPHA);
    begin_window(id, ImVec2(room->x, room->y), ImVec2(room->width, room->height), flags);
    if (ImGui::IsWindowAppearing()) {
        gui_request_frames(current_gui()); // The scroll bar comes when the height is known.
    }
}

/** Draws the picture of a thumbnail, or its message, and its name. @param low Upper left corner. */
void draw_thumbnail(const GuiThumbnail *thumbnail, ImVec2 low, float width, bool is_hovered) {
    const float size = ImGui::GetFontSize(), pad = PADDING * size;
    const float picture_height = thumbnail_picture_height(width);
    ImDrawList *list = ImGui::GetWindowDrawList();
    ImVec2 high(low.x + width, low.y + thumbnail_height(width, thumbnail->name_height));
    ImVec2 first(low.x + pad, low.y + pad), last(high.x - pad, low.y + pad + picture_height);
    if (is_hovered || thumbnail->is_selected) {
        list->AddRectFilled(low, high, thumbnail->is_selected ? SELECTED : HOVERED,
                            ROUNDING * size);
    }
    if (thumbnail->texture) {
        list->AddImage(thumbnail->texture, first, last);
    } else {
        list->AddRectFilled(first, last, EMPTY, ROUNDING * size);
    }
    if (thumbnail->message) {
        list->PushClipRect(first, last, true);
        put_text(ImVec2(first.x + pad / 2, first.y + pad / 2), last.x - first.x - pad,
                 PALETTE[thumbnail->color], thumbnail->message);
        list->PopClipRect();
    }
    if (thumbnail->is_selected) {
        list->AddRect(low, high, ACCENT, ROUNDING * size, 0, 2);
    }
    list->PushClipRect(ImVec2(first.x, last.y), high, true);
    put_text(ImVec2(first.x, last.y + pad), last.x - first.x,
             thumbnail->is_selected ? ACCENT : TEXT, thumbnail->name);
    list->PopClipRect();
}

} // namespace

void draw_outlined_line(ImDrawList *list, ImVec2 from, ImVec2 to, ImU32 color, float width) {
    list->AddLine(from, to, OUTLINE, width + 2);
    list->AddLine(from, to, color, width);
}

void begin_window(const char *id, ImVec2 corner, ImVec2 size, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos(ImVec2(floorf(corner.x), floorf(corner.y)));
    ImGui::SetNextWindowSize(ImVec2(ceilf(size.x), ceilf(size.y)));
    ImGui::Begin(id, nullptr, PANEL_FLAGS | ImGuiWindowFlags_NoFocusOnAppearing | flags);
}

ImDrawList *begin_value(const char *id, ImVec2 low, ImVec2 high) {
    begin_window(id, low, ImVec2(high.x - low.x + 1, high.y - low.y + 1),
                 ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImDrawList *list = ImGui::GetWindowDrawList();
    list->PushClipRect(low, high);
    return list;
}

void end_value(ImDrawList *list) {
    list->PopClipRect();
    ImGui::End();
}

ImU32 darker(ImU32 color) {
    ImVec4 mixed = ImGui::ColorConvertU32ToFloat4(color);
    const float factor = 0.36F;
    return ImGui::ColorConvertFloat4ToU32(
        ImVec4(mixed.x * factor, mixed.y * factor, mixed.z * factor, 1));
}

extern "C" {

GuiColor gui_group_color(int group) {
    const int count = GUI_COLOR_COUNT - GUI_COLOR_GROUP;
    return static_cast<GuiColor>(GUI_COLOR_GROUP + (group > 0 ? group - 1 : 0) % count);
}

void gui_panel_begin(const char *id, const GuiRect *room) {
    begin_panel(id, room, 0);
}

void gui_gallery_begin(const char *id, const GuiRect *room) {
    begin_panel(id, room, ImGuiWindowFlags_NoScrollWithMouse);
    const float wheel = ImGui::GetIO().MouseWheel;
    if (wheel != 0 && ImGui::IsWindowHovered()) {
        int columns;
        const float width = gui_thumbnail_width(&columns);
        const float line = thumbnail_height(width, NAME_LINES * ImGui::GetFontSize()) +
                           ImGui::GetStyle().ItemSpacing.y;
        ImGui::SetScrollY(fmaxf(0, ImGui::GetScrollY() - wheel * line));
    }
}

void gui_scroll_to_top() {
    ImGui::SetScrollY(0);
}

void gui_scroll_pages(int pages) {
    if (pages == 0) {
        return; // The panel may have been scrolled in this frame.
    }
    const float page = fmaxf(ImGui::GetWindowHeight() - 2 * ImGui::GetFontSize(), 1);
    const float wanted = ImGui::GetScrollY() + static_cast<float>(pages) * page;
    ImGui::SetScrollY(fmaxf(0, fminf(wanted, ImGui::GetScrollMaxY())));
    gui_request_frames(current_gui()); // It moves in the next one.
}

void gui_at_right(const char *label) {
    const float width = button_width(label), left = ImGui::GetItemRectMax().x;
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (left + ImGui::GetStyle().ItemSpacing.x + width <= right) {
        ImGui::SameLine(right - width - ImGui::GetWindowPos().x);
    }
}

void gui_search_box(const char *text, const char *hint) {
    const ImGuiStyle &style = ImGui::GetStyle();
    ImVec2 low = ImGui::GetCursorScreenPos();
    ImVec2 high(low.x + ImGui::GetContentRegionAvail().x, low.y + ImGui::GetFrameHeight());
    const float room = high.x - low.x - 2 * style.FramePadding.x;
    char shown[SEARCH_SIZE];
    snprintf(shown, sizeof shown, "%s%s", text, CARET);
    ImDrawList *list = ImGui::GetWindowDrawList();
    list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), style.FrameRounding);
    list->AddRect(low, high, ACCENT, style.FrameRounding);
    ImVec2 at(low.x + style.FramePadding.x, low.y + style.FramePadding.y);
    list->PushClipRect(low, high, true);
    put_text(at, 0, ACCENT, shown);
    if (text[0] == '\0' && ImGui::CalcTextSize(hint).x + ImGui::CalcTextSize(CARET).x < room) {
        at.x += ImGui::CalcTextSize(CARET).x;
        put_text(at, 0, PALETTE[GUI_COLOR_FAINT], hint);
    }
    list->PopClipRect();
    ImGui::Dummy(ImVec2(high.x - low.x, high.y - low.y));
}

void gui_panel_end() {
    current_gui()->has_whole_lines = false;
    ImGui::End();
}

float gui_panel_width() {
    return ImGui::GetContentRegionAvail().x;
}

GuiPoint gui_canvas(float height) {
    ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy(ImVec2(ImGui::GetContentRegionAvail().x, height));
    return GuiPoint{corner.x, corner.y};
}

GuiMouse gui_key(const GuiRect *rect, const char *cap, GuiColor color, bool is_on) {
    ImVec2 low(rect->x, rect->y), high(rect->x + rect->width, rect->y + rect->height);
    ImDrawList *list = ImGui::GetWindowDrawList();
    bool is_used = color != GUI_COLOR_FAINT;
    bool is_hovered = is_used && ImGui::IsMouseHoveringRect(low, high) && ImGui::IsWindowHovered();
    const float rounding = ImGui::GetStyle().FrameRounding;
    list->AddRectFilled(low, high, is_used ? darker(PALETTE[color]) : EMPTY, rounding);
    if (is_hovered || is_on) {
        list->AddRect(low, high, PALETTE[color], rounding, 0, 2);
    }
    put_fitted_text(low, high, PALETTE[color], cap);
    if (is_hovered) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    return is_hovered && ImGui::IsMouseClicked(0) ? GUI_CLICKED
           : is_hovered                           ? GUI_HOVERED
                                                  : GUI_IDLE;
}

float gui_thumbnail_width(int *columns) {
    const float width = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
    int fitting = static_cast<int>((width + gap) / (THUMBNAIL_WIDTH * ImGui::GetFontSize() + gap));
    *columns = fitting > 1 ? fitting : 1;
    // A button has at least one pixel.
    return fmaxf(1, floorf((width + gap) / static_cast<float>(*columns) - gap));
}

float gui_thumbnail_name_height(const char *name, float width) {
    const float size = ImGui::GetFontSize();
    const float height = text_extent(name, width - 2 * PADDING * size).y;
    return fminf(fmaxf(height, NAME_LINES * size), NAME_LINES_MAXIMUM * size);
}

GuiMouse gui_thumbnail(int id, const GuiThumbnail *thumbnail, int column, float width,
                       bool *is_seen) {
    const float height = thumbnail_height(width, thumbnail->name_height);
    if (column > 0) {
        ImGui::SameLine();
    }
    ImGui::PushID(id);
    ImVec2 low = ImGui::GetCursorScreenPos();
    bool is_clicked = ImGui::InvisibleButton("scene", ImVec2(width, height));
    bool is_hovered = ImGui::IsItemHovered();
    ImGui::PopID();
    if (thumbnail->scrolls_to_it) {
        ImGui::SetScrollHereY();
        gui_request_frames(current_gui()); // It moves in the next one.
    }
    *is_seen = ImGui::IsItemVisible();
    if (*is_seen) {
        draw_thumbnail(thumbnail, low, width, is_hovered);
    }
    if (is_hovered) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    return is_clicked ? GUI_CLICKED : is_hovered ? GUI_HOVERED : GUI_IDLE;
}

} // extern "C"
