/**
 * @file
 * @brief Values on the picture: legends, the magnifier, the value of a pixel, progress.
 */
#include "view/gui/gui_internal.h"

namespace {

/** Width at which notes of a legend are broken into lines, in heights of letters. */
constexpr float LEGEND_NOTE_WIDTH = 11;
/** Height of the bar of a legend, in heights of letters. */
constexpr float LEGEND_BAR_LINES = 11;
/** Height of a bar of progress, in heights of letters. */
constexpr float PROGRESS_HEIGHT = 0.3F;

/** What the parts of a legend measure, pixels of the window. */
struct LegendLayout {
    float line;   /**< Height of a line. */
    float gap;    /**< Distance of parts, and from the edge. */
    float swatch; /**< Width of a colour with the gap behind it. */
    float width;  /**< Width of the contents. */
    float head;   /**< Height of title and unit. */
    float bar;    /**< Height of the bar; 0: none. */
    float apart;  /**< Height of the colours that are not on the bar. */
    float notes;  /**< Height of the notes. */
    ImVec2 whole; /**< Width and height with the edges. */
    bool fits;    /**< Whether no word is wider than its line, and it is not too high. */
};

/** @return The height of a text of a legend. @param width Width of its lines. */
float add_words(LegendLayout *layout, const char *text, float width) {
    const ImVec2 size = text_extent(text, width);
    layout->fits = layout->fits && size.x <= width;
    return size.y;
}

/** @return The width of a legend whose words are not broken, but for its notes. */
float legend_width(const GuiLegend *legend, float swatch, float line) {
    float width = fmaxf(ImGui::CalcTextSize(legend->title).x, ImGui::CalcTextSize(legend->unit).x);
    for (int i = 0; i < legend->swatch_count; i++) {
        width = fmaxf(width, swatch + ImGui::CalcTextSize(legend->swatches[i].text).x);
    }
    for (int i = 0; i < legend->note_count; i++) {
        width =
            fmaxf(width, fminf(ImGui::CalcTextSize(legend->notes[i]).x, LEGEND_NOTE_WIDTH * line));
    }
    return ceilf(width);
}

/** @return The layout of a legend. @param widest Its largest width. */
LegendLayout legend_layout(const GuiLegend *legend, const GuiLegendPlace *place, float widest) {
    LegendLayout layout = {};
    layout.fits = true;
    layout.line = ImGui::GetFontSize();
    layout.gap = PADDING * layout.line;
    layout.swatch = 2 * layout.line + layout.gap;
    layout.width = fminf(legend_width(legend, layout.swatch, layout.line),
                         fmaxf(widest - 2 * layout.gap, 2 * layout.swatch));
    layout.head = add_words(&layout, legend->title, layout.width);
    layout.head += legend->unit[0] != '\0' ? add_words(&layout, legend->unit, layout.width) : 0;
    for (int i = 0; i < legend->swatch_count; i++) {
        const GuiSwatch &swatch = legend->swatches[i];
        layout.apart +=
            swatch.position < 0 ? add_words(&layout, swatch.text, layout.width - layout.swatch) : 0;
    }
    for (int i = 0; i < legend->note_count; i++) {
        layout.notes += add_words(&layout, legend->notes[i], layout.width) + layout.gap / 2;
    }
    if (legend->bar_count > 0) {
        float rest = place->highest - layout.head - layout.apart - layout.notes - 5 * layout.gap;
        layout.bar = fmaxf(fminf(LEGEND_BAR_LINES * layout.line, rest), 2 * layout.line);
    }
    layout.whole = ImVec2(layout.width + 2 * layout.gap,
                          layout.head + layout.bar + layout.apart + layout.notes + 4 * layout.gap);
    layout.fits = layout.fits && layout.whole.y <= place->highest;
    return layout;
}

/** Draws the bar of a legend with its ticks. Numbers that would overlap are left out. @param low
 *  Its upper left corner. */
void draw_legend_bar(ImDrawList *list, const GuiLegend *legend, const LegendLayout &layout,
                     ImVec2 low) {
    const float width = layout.line, top = low.y + layout.line / 2;
    const float height = layout.bar - layout.line;
    float last = low.y - layout.line;
    for (int i = 0; i + 1 < legend->bar_count; i++) {
        const unsigned char *below = legend->bar[i], *above = legend->bar[i + 1];
        ImU32 dark = IM_COL32(below[0], below[1], below[2], 255);
        ImU32 light = IM_COL32(above[0], above[1], above[2], 255);
        float count = static_cast<float>(legend->bar_count - 1);
        float from = top + height * (1 - static_cast<float>(i + 1) / count);
        float to = top + height * (1 - static_cast<float>(i) / count);
        list->AddRectFilledMultiColor(ImVec2(low.x, from), ImVec2(low.x + width, to), light, light,
                                      dark, dark);
    }
    for (int i = 0; i < legend->swatch_count; i++) {
        const GuiSwatch &tick = legend->swatches[i];
        float y = top + height * (1 - tick.position);
        if (tick.position < 0) {
            continue;
        }
        list->AddLine(ImVec2(low.x + width, y), ImVec2(low.x + 1.5F * width, y), TEXT, 1.5F);
        if (y - layout.line / 2 >= last + layout.line) {
            last = y - layout.line / 2;
            put_text(list, ImVec2(low.x + layout.swatch, last), 0, TEXT, tick.text);
        }
    }
}

/** Draws the colours of a legend that are not on its bar, and its notes. */
void draw_legend_list(ImDrawList *list, const GuiLegend *legend, const LegendLayout &layout,
                      ImVec2 at) {
    for (int i = 0; i < legend->swatch_count; i++) {
        const GuiSwatch &swatch = legend->swatches[i];
        if (swatch.position < 0) {
            const float edge = layout.line / 8;
            list->AddRectFilled(ImVec2(at.x, at.y + edge),
                                ImVec2(at.x + 2 * layout.line, at.y + layout.line - edge),
                                IM_COL32(swatch.rgb[0], swatch.rgb[1], swatch.rgb[2], 255));
            at.y += put_text(list, ImVec2(at.x + layout.swatch, at.y), layout.width - layout.swatch,
                             TEXT, swatch.text)
                        .y;
        }
    }
    for (int i = 0; i < legend->note_count; i++) {
        at.y += put_text(list, at, layout.width, TEXT, legend->notes[i]).y + layout.gap / 2;
    }
}

/** Draws a legend. @param rect Where it lies. */
void draw_legend(const char *id, const GuiLegend *legend, const LegendLayout &layout,
                 const ImRect &rect) {
    ImDrawList *list = begin_value(id, rect.Min, rect.Max);
    list->AddRectFilled(rect.Min, rect.Max, ImGui::GetColorU32(ImGuiCol_WindowBg),
                        ROUNDING * layout.line);
    ImVec2 at(rect.Min.x + layout.gap, rect.Min.y + layout.gap);
    put_text(list, at, layout.width, ACCENT, legend->title);
    if (legend->unit[0] != '\0') {
        const float title = text_extent(legend->title, layout.width).y;
        put_text(list, ImVec2(at.x, at.y + title), layout.width, TEXT, legend->unit);
    }
    at.y += layout.head + layout.gap;
    if (legend->bar_count > 0) {
        draw_legend_bar(list, legend, layout, at);
        at.y += layout.bar + layout.gap;
    }
    draw_legend_list(list, legend, layout, at);
    end_value(list);
}

/** @return Whether a legend would touch what is taken. @param rect Where it would lie. */
bool is_taken(const GuiLegendPlace *place, const ImRect &rect) {
    bool touches = false;
    for (int i = 0; i < place->taken_count; i++) {
        const GuiRect &taken = place->taken[i];
        const ImRect panel(taken.x, taken.y, taken.x + taken.width, taken.y + taken.height);
        touches = touches || (taken.height > 0 && panel.Overlaps(rect));
    }
    return touches;
}

/** Narrowest readout beside the inspector, in heights of letters: else it lies below it. */
constexpr float READOUT_WIDTH_MINIMUM = 10;

/** @return The width of the text of a readout. @param[in,out] left Its left end; it becomes that
 *  right of the inspector if this lies at the left. @param right Its right end, at most. @param top
 *  Upper end of its first line. */
float readout_width(float *left, float right, float top) {
    const Gui *gui = current_gui();
    const ImRect &inspector = gui->inspector;
    const float size = ImGui::GetFontSize(), gap = PADDING * size;
    const bool is_beside =
        gui->is_inspecting && inspector.Min.y < top + size + 2 * gap && inspector.Max.y > top;
    if (is_beside && inspector.Min.x > *left + READOUT_WIDTH_MINIMUM * size) {
        right = inspector.Min.x;
    } else if (is_beside && inspector.Max.x + READOUT_WIDTH_MINIMUM * size < right) {
        *left = fmaxf(*left, inspector.Max.x);
    }
    return right - *left - 2 * size - 3 * gap;
}

/** @return Where a readout lies. See #gui_readout_rect. @param[out] width Width of its lines. */
ImRect place_readout(const char *text, const GuiReadoutPlace *place, float *width) {
    const float size = ImGui::GetFontSize(), gap = PADDING * size;
    const bool is_above = place->side == GUI_ABOVE;
    GuiPoint corner = place->corner;
    const float line = size + 2 * gap, top = is_above ? corner.y - line : corner.y;
    *width = readout_width(&corner.x, place->right, top);
    const ImVec2 extent = text_extent(text, *width);
    const float height = extent.y + 2 * gap;
    const ImVec2 low(corner.x, is_above ? corner.y - height : corner.y);
    return ImRect(low, ImVec2(low.x + extent.x + 2 * size + 3 * gap, low.y + height));
}

} // namespace

extern "C" {

GuiRect gui_readout_rect(const char *text, const GuiReadoutPlace *place) {
    float width;
    const ImRect rect = place_readout(text, place, &width);
    return GuiRect{rect.Min.x, rect.Min.y, rect.GetWidth(), rect.GetHeight()};
}

void gui_readout(const char *id, const char *text, const unsigned char rgb[3],
                 const GuiReadoutPlace *place) {
    const float size = ImGui::GetFontSize(), gap = PADDING * size;
    float width;
    const ImRect rect = place_readout(text, place, &width);
    const ImVec2 &low = rect.Min;
    ImDrawList *list = begin_value(id, low, rect.Max);
    list->AddRectFilled(low, rect.Max, ImGui::GetColorU32(ImGuiCol_WindowBg));
    list->AddRectFilled(ImVec2(low.x + gap, low.y + gap),
                        ImVec2(low.x + gap + 2 * size, rect.Max.y - gap),
                        IM_COL32(rgb[0], rgb[1], rgb[2], 255));
    put_text(list, ImVec2(low.x + 2 * size + 2 * gap, low.y + gap), width, TEXT, text);
    end_value(list);
}

GuiRect gui_legend(const char *id, const GuiLegend *legend, const GuiLegendPlace *place) {
    LegendLayout layout = legend_layout(legend, place, fminf(place->usual, place->widest));
    if (!layout.fits) {
        layout = legend_layout(legend, place, place->widest);
    }
    const ImVec2 &whole = layout.whole;
    const GuiPoint &corner = place->corner;
    ImVec2 low(place->is_right ? corner.x - whole.x : corner.x, corner.y - whole.y);
    const ImRect rect(low, ImVec2(low.x + whole.x, corner.y));
    if (!layout.fits || is_taken(place, rect)) {
        return GuiRect{corner.x, corner.y, 0, 0};
    }
    draw_legend(id, legend, layout, rect);
    return GuiRect{low.x, low.y, whole.x, whole.y};
}

void gui_ring(GuiPoint center, float radius) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    ImVec2 middle(center.x, center.y);
    list->AddCircle(middle, radius, OUTLINE, 0, 5);
    list->AddCircle(middle, radius, IM_COL32(255, 255, 255, 255), 0, 2);
}

void gui_pixels(const GuiPixels *pixels, GuiPoint point, float top, float bottom) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float line = ImGui::GetFontSize(), gap = PADDING * line;
    const float columns = static_cast<float>(pixels->columns);
    const float rows = static_cast<float>(pixels->rows);
    float cell = fmaxf(floorf(fminf(line, 0.45F * (bottom - top) / rows)), 3);
    float width = fmaxf(cell * columns, ImGui::CalcTextSize(pixels->caption).x) + 2 * gap;
    float height = cell * rows + line + 3 * gap;
    const Gui *gui = current_gui();
    // Beside the inspector, too.
    const float first =
        gui->is_inspecting && gui->inspector.Max.x <= point.x ? gui->inspector.Max.x : 0;
    const float last =
        gui->is_inspecting && gui->inspector.Min.x >= point.x ? gui->inspector.Min.x : display.x;
    float left =
        point.x + 2 * line + width < last ? point.x + 2 * line : point.x - 2 * line - width;
    float upper = point.y + height / 2 < bottom ? point.y - height / 2 : bottom - height;
    ImVec2 low(fmaxf(left, first), fmaxf(upper, top));
    list->AddRectFilled(low, ImVec2(low.x + width, low.y + height),
                        ImGui::GetColorU32(ImGuiCol_PopupBg), ROUNDING * line);
    ImVec2 at(low.x + (width - cell * columns) / 2, low.y + gap);
    for (int i = 0; i < pixels->columns * pixels->rows; i++) {
        const unsigned char *rgb = pixels->rgb + 3 * i;
        ImVec2 corner(at.x + cell * static_cast<float>(i % pixels->columns),
                      at.y + cell * static_cast<float>(i / pixels->columns));
        list->AddRectFilled(corner, ImVec2(corner.x + cell - 1, corner.y + cell - 1),
                            IM_COL32(rgb[0], rgb[1], rgb[2], 255));
    }
    ImVec2 middle(at.x + cell * floorf(columns / 2), at.y + cell * floorf(rows / 2));
    list->AddRect(ImVec2(middle.x - 2, middle.y - 2),
                  ImVec2(middle.x + cell + 1, middle.y + cell + 1), OUTLINE, 0, 0, 4);
    list->AddRect(ImVec2(middle.x - 1, middle.y - 1), ImVec2(middle.x + cell, middle.y + cell),
                  ACCENT, 0, 0, 2);
    put_text(list, ImVec2(low.x + gap, at.y + cell * rows + gap), 0, TEXT, pixels->caption);
}

void gui_progress_bar(GuiPoint corner, float width, float fraction) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    float height = PROGRESS_HEIGHT * ImGui::GetFontSize();
    ImVec2 low(corner.x, corner.y - height), high(corner.x + width, corner.y);
    list->AddRectFilled(low, high, OUTLINE);
    list->AddRectFilled(low, ImVec2(corner.x + width * fraction, corner.y), ACCENT);
}

} // extern "C"
