/**
 * @file
 * @brief Rows of labels and texts, in columns.
 */
#include "view/gui/gui_internal.h"

namespace {

/** Distance of two lines of a list, in heights of letters. */
constexpr float LINE_PITCH = 1.3F;
/** Width of a swatch, in heights of letters. */
constexpr float SWATCH_WIDTH = 2;
/** Gap between two columns, in heights of letters. */
constexpr float COLUMN_GAP = 1;
/** Largest part of a row for its label. */
constexpr float LABEL_FRACTION = 0.55F;
/** Padding left and right of a key in a list, in heights of letters. */
constexpr float KEY_PADDING = 0.25F;
/** Most columns of a list. */
constexpr int COLUMNS_MAXIMUM = 4;

/** Rows in columns: where they lie. */
struct RowLayout {
    int columns;                        /**< Number of columns. */
    size_t starts[COLUMNS_MAXIMUM + 1]; /**< First row of each, then the number of rows. */
    float labels[COLUMNS_MAXIMUM];      /**< Width of the labels of each, with the gap. */
    float texts[COLUMNS_MAXIMUM];       /**< Width of the texts of each. */
};

/** @return The end of a key's name in a label. */
const char *key_end(const char *label) {
    const char *end = strstr(label, GUI_KEY_GAP);
    return end ? end : label + strlen(label);
}

/** @return The width of a label. */
float label_width(const GuiRow &row) {
    const float size = ImGui::GetFontSize();
    if (row.has_swatch) {
        return SWATCH_WIDTH * size;
    }
    if (!row.has_keys) {
        return row.label[0] != '\0' ? ImGui::CalcTextSize(row.label).x : 0;
    }
    float width = 0;
    for (const char *key = row.label; *key;) {
        const char *end = key_end(key);
        width += ImGui::CalcTextSize(key, end).x + 3 * KEY_PADDING * size;
        key = *end ? end + strlen(GUI_KEY_GAP) : end;
    }
    return width;
}

/** @return The height of a row. @param label Width of the labels. @param text Width of the texts.
 */
float row_height(const GuiRow &row, float label, float text) {
    const float size = ImGui::GetFontSize(), gap = (LINE_PITCH - 1) * size;
    if (row.is_heading) {
        ImGui::PushFont(current_gui()->heading);
        float height = text_extent(row.text, label + text).y;
        ImGui::PopFont();
        return height + 2 * gap;
    }
    float height = row.text[0] != '\0' ? text_extent(row.text, text).y : size;
    if (!row.has_keys && !row.has_swatch && row.label[0] != '\0') {
        height = fmaxf(height, text_extent(row.label, fmaxf(label - COLUMN_GAP * size, 1)).y);
    }
    return height + gap;
}

/** Finds the widths of a column's labels and texts. @param width Width of the column. @return Its
 *  width; at most #width. */
float fit_column(const GuiRow *rows, size_t first, size_t end, float width, float *label,
                 float *text) {
    const float gap = COLUMN_GAP * ImGui::GetFontSize();
    float heading = 0;
    *label = *text = 0;
    for (size_t i = first; i < end; i++) {
        if (rows[i].is_heading) {
            ImGui::PushFont(current_gui()->heading);
            heading = fmaxf(heading, ImGui::CalcTextSize(rows[i].text).x);
            ImGui::PopFont();
            continue;
        }
        float own = label_width(rows[i]);
        *label = fmaxf(*label, own > 0 ? own + gap : 0);
        *text = fmaxf(*text, ImGui::CalcTextSize(rows[i].text).x);
    }
    if (*label + *text > width) {
        *label = fminf(*label, LABEL_FRACTION * width);
    }
    *text = ceilf(fminf(fmaxf(*text, heading - *label), width - *label)) + 1;
    return fminf(*label + *text, width);
}

/** Breaks rows into columns of about equal length, at headings. */
void break_columns(const GuiRow *rows, size_t count, int columns, RowLayout *layout) {
    layout->columns = columns;
    layout->starts[0] = 0;
    for (int i = 1; i < columns; i++) {
        size_t even = count * static_cast<size_t>(i) / static_cast<size_t>(columns);
        size_t before = even, after = even;
        while (after < count && !rows[after].is_heading) {
            after++;
        }
        while (before > layout->starts[i - 1] && !rows[before].is_heading) {
            before--;
        }
        bool is_before = before > layout->starts[i - 1] && even - before < after - even;
        layout->starts[i] = is_before ? before : after;
    }
    layout->starts[columns] = count;
}

/** Lays rows out, in as many columns as fit. @param most Most columns. @param[out] size Size of
 *  all. */
RowLayout lay_out_rows(const GuiRow *rows, size_t count, float width, int most, ImVec2 *size) {
    const float gap = COLUMN_GAP * ImGui::GetFontSize();
    RowLayout layout = {};
    for (int columns = most; columns >= 1; columns--) {
        break_columns(rows, count, columns, &layout);
        *size = ImVec2(-gap, 0);
        for (int i = 0; i < columns; i++) {
            float height = 0;
            size->x += gap + fit_column(rows, layout.starts[i], layout.starts[i + 1],
                                        columns > 1 ? FLT_MAX : width, &layout.labels[i],
                                        &layout.texts[i]);
            for (size_t row = layout.starts[i]; row < layout.starts[i + 1]; row++) {
                height += row_height(rows[row], layout.labels[i], layout.texts[i]);
            }
            size->y = fmaxf(size->y, height);
        }
        if (size->x <= width) {
            break;
        }
    }
    return layout;
}

/** Draws the keys of a label. @param selected The key that is selected; -1: none. @return The key
 *  under the mouse; -1: none. */
int draw_keys(const GuiRow &row, ImVec2 corner, int selected) {
    const float size = ImGui::GetFontSize(), pad = KEY_PADDING * size;
    ImDrawList *list = ImGui::GetWindowDrawList();
    ImU32 color = PALETTE[row.color ? row.color : GUI_COLOR_ACCENT];
    int index = 0, hovered = -1;
    for (const char *key = row.label; *key; index++) {
        const char *end = key_end(key);
        char name[GUI_LABEL_SIZE];
        ImFormatString(name, sizeof name, "%.*s", static_cast<int>(end - key), key);
        ImVec2 high(corner.x + ImGui::CalcTextSize(name).x + 2 * pad, corner.y + size);
        list->AddRectFilled(corner, high, darker(color), ROUNDING * size);
        if (index == selected) {
            list->AddRect(corner, high, color, ROUNDING * size, 0, 2);
        }
        put_text(ImVec2(corner.x + pad, corner.y), 0, color, name);
        hovered = ImGui::IsMouseHoveringRect(corner, high) ? index : hovered;
        corner.x = high.x + pad;
        key = *end ? end + strlen(GUI_KEY_GAP) : end;
    }
    return hovered;
}

/** Draws one row. @return The key under the mouse. */
int draw_row(const GuiRow &row, ImVec2 corner, float label, float text, int selected) {
    const float size = ImGui::GetFontSize(), gap = (LINE_PITCH - 1) * size / 2;
    if (row.is_heading) {
        ImGui::PushFont(current_gui()->heading);
        put_text(ImVec2(corner.x, corner.y + 2 * gap), label + text,
                 PALETTE[row.color ? row.color : GUI_COLOR_HEADING], row.text);
        ImGui::PopFont();
        return -1;
    }
    ImVec2 at(corner.x, corner.y + gap);
    int key = -1;
    if (row.has_swatch) {
        ImVec2 high(corner.x + SWATCH_WIDTH * size, corner.y + size + 2 * gap);
        ImGui::GetWindowDrawList()->AddRectFilled(
            corner, high, IM_COL32(row.swatch[0], row.swatch[1], row.swatch[2], 255));
    } else if (row.has_keys) {
        key = draw_keys(row, at, selected);
    } else if (row.label[0] != '\0') {
        put_text(at, fmaxf(label - COLUMN_GAP * size, 1),
                 PALETTE[row.color ? row.color : GUI_COLOR_ACCENT], row.label);
    }
    put_text(ImVec2(at.x + label, at.y), text, TEXT, row.text);
    return key;
}

/** @return Whether the selected row is another than in the frame before. */
bool is_selection_new(int row) {
    int *last = ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("selected"), -1);
    if (ImGui::IsWindowAppearing()) { // It was scrolled before it was closed.
        ImGui::SetScrollY(0);
        *last = -1;
    }
    bool is_new = row >= 0 && *last != row;
    *last = row;
    return is_new;
}

/** Shows rows. See #gui_rows. */
GuiCell show_rows(const GuiRow *rows, size_t count, int most, GuiCell selected) {
    ImVec2 size, origin = ImGui::GetCursorScreenPos();
    RowLayout layout = lay_out_rows(rows, count, ImGui::GetContentRegionAvail().x, most, &size);
    GuiCell clicked = {-1, 0};
    bool is_new = is_selection_new(selected.row);
    float x = origin.x;
    for (int column = 0; column < layout.columns; column++) {
        const float label = layout.labels[column], text = layout.texts[column];
        float y = origin.y;
        for (size_t i = layout.starts[column]; i < layout.starts[column + 1]; i++) {
            const GuiRow &row = rows[i];
            const float height = row_height(row, label, text);
            bool is_selected = static_cast<int>(i) == selected.row, is_hovered = false;
            ImVec2 low(x, y), high(x + label + text, y + height);
            if (row.is_clickable) {
                is_hovered = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(low, high);
            }
            if (is_hovered || is_selected) {
                ImGui::GetWindowDrawList()->AddRectFilled(
                    ImVec2(low.x - PADDING * ImGui::GetFontSize() / 2, low.y), high,
                    is_selected ? SELECTED : HOVERED, ROUNDING * ImGui::GetFontSize());
            }
            int key = draw_row(row, low, label, text, is_selected ? selected.key : -1);
            if (is_hovered) {
                ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
            }
            if (is_hovered && ImGui::IsMouseClicked(0)) {
                clicked = GuiCell{static_cast<int>(i), key > 0 ? key : 0};
            }
            if (is_selected && is_new) {
                ImGui::SetScrollFromPosY(y + height / 2 - ImGui::GetWindowPos().y);
            }
            y += height;
        }
        x += label + text + COLUMN_GAP * ImGui::GetFontSize();
    }
    ImGui::Dummy(size);
    return clicked;
}

} // namespace

extern "C" {

float gui_rows_panel_height(const GuiRow *rows, size_t count, float width) {
    const float pad = 2 * ImGui::GetStyle().WindowPadding.x;
    ImVec2 size;
    lay_out_rows(rows, count, width - pad, 1, &size);
    return size.y + pad;
}

GuiCell gui_rows_panel(const char *id, const GuiPlace *place, const GuiRow *rows, size_t count,
                       GuiCell selected, GuiRect *extent) {
    const GuiRect &room = place->room;
    const float pad = 2 * ImGui::GetStyle().WindowPadding.x, bar = ImGui::GetStyle().ScrollbarSize;
    ImVec2 size;
    lay_out_rows(rows, count, room.width - pad, 1, &size);
    bool scrolls = size.y + pad > room.height;
    if (scrolls) {
        lay_out_rows(rows, count, room.width - pad - bar, 1, &size);
        size.x += bar;
    }
    ImVec2 whole(fminf(ceilf(size.x) + pad, room.width),
                 fminf(ceilf(size.y) + pad, fmaxf(room.height, 1)));
    ImVec2 corner(room.x + place->x * (room.width - whole.x),
                  room.y + place->y * (room.height - whole.y));
    bool is_clickable = false;
    for (size_t i = 0; i < count; i++) {
        is_clickable = is_clickable || rows[i].is_clickable;
    }
    begin_window(
        id, corner, whole,
        (scrolls ? ImGuiWindowFlags_AlwaysVerticalScrollbar : ImGuiWindowFlags_NoScrollbar) |
            (scrolls || is_clickable ? 0 : ImGuiWindowFlags_NoInputs));
    if (extent) {
        *extent = GuiRect{corner.x, corner.y, whole.x, whole.y};
    }
    GuiCell cell = show_rows(rows, count, 1, selected);
    ImGui::End();
    return cell;
}

GuiCell gui_rows(const GuiRow *rows, size_t count, GuiCell selected) {
    return show_rows(rows, count, COLUMNS_MAXIMUM, selected);
}

} // extern "C"
