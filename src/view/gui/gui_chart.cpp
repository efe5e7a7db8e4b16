/**
 * @file
 * @brief A chart with two logarithmic axes.
 */
#include "view/gui/gui_internal.h"

extern "C" {
#include "base/language.h"
}

namespace {

/** Fewest lines of text that a plot is high. */
constexpr float PLOT_LINES_MINIMUM = 2;
/** Width of the numbers of a chart's left axis, in heights of letters. */
constexpr float CHART_NUMBER_WIDTH = 2.5F;
/** Most labels of points that do not overlap. */
constexpr int CHART_LABELS_MAXIMUM = 32;
/** Room at the end of an axis, decades. */
constexpr double CHART_HEADROOM = 0.15;
/** Least part of a chart's height for the points. */
constexpr float CHART_PLOT_FRACTION = 0.45F;
/** Colour of the lines of a chart. */
constexpr ImU32 GRID = IM_COL32(255, 255, 255, 60);

/** The ends of an axis: powers of ten. */
struct ChartRange {
    double low;  /**< Logarithm to base 10 of its lower end. */
    double high; /**< Of its upper end. */
};

/** Where the points of a chart lie. */
struct ChartArea {
    ImVec2 low;   /**< Upper left corner. */
    ImVec2 high;  /**< Lower right corner. */
    ChartRange x; /**< Lower axis. */
    ChartRange y; /**< Left axis. */
};

/** @return The ends of an axis: the powers of ten around all numbers above 0. */
ChartRange chart_range(const GuiChart *chart, bool is_x) {
    ChartRange range = {HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < chart->count; i++) {
        double value = is_x ? chart->points[i].x : chart->points[i].y;
        if (value > 0) {
            range.low = fmin(range.low, floor(log10(value)));
            // Room for the label above the highest point.
            range.high = fmax(range.high, ceil(log10(value) + CHART_HEADROOM));
        }
    }
    if (range.low > range.high) {
        range = ChartRange{0, 1};
    }
    range.high = fmax(range.high, range.low + 1);
    return range;
}

/** @return Where a point lies; 0 lies at the end of its axis. */
ImVec2 chart_position(const ChartArea &area, double x, double y) {
    double right = x > 0 ? (log10(x) - area.x.low) / (area.x.high - area.x.low) : 0;
    double up = y > 0 ? (log10(y) - area.y.low) / (area.y.high - area.y.low) : 0;
    return ImVec2(area.low.x + static_cast<float>(right) * (area.high.x - area.low.x),
                  area.high.y - static_cast<float>(up) * (area.high.y - area.low.y));
}

/** Draws a line at each power of ten, with its number where that has room. */
void draw_chart_grid(ImDrawList *list, const ChartArea &area) {
    const float line = ImGui::GetFontSize();
    char text[16];
    float last = area.low.x - 2 * line;
    for (double x = area.x.low; x <= area.x.high; x++) {
        ImVec2 at = chart_position(area, pow(10, x), 0);
        snprintf(text, sizeof text, "%g", pow(10, x));
        language_localize_numbers(text, sizeof text);
        list->AddLine(ImVec2(at.x, area.low.y), ImVec2(at.x, area.high.y), GRID);
        float half = ImGui::CalcTextSize(text).x / 2;
        if (at.x - half > last + line / 4) {
            put_text(list, ImVec2(at.x - half, area.high.y + line / 2), 0, TEXT, text);
            last = at.x + half;
        }
    }
    last = area.high.y + line;
    for (double y = area.y.low; y <= area.y.high; y++) {
        ImVec2 at = chart_position(area, 0, pow(10, y));
        snprintf(text, sizeof text, "%g", pow(10, y));
        language_localize_numbers(text, sizeof text);
        list->AddLine(ImVec2(area.low.x, at.y), ImVec2(area.high.x, at.y), GRID);
        float left = area.low.x - ImGui::CalcTextSize(text).x - line / 4;
        if (at.y + line / 2 <= last) {
            put_text(list, ImVec2(left, at.y - line / 2), 0, TEXT, text);
            last = at.y - line / 2;
        }
    }
}

/** @return The point of the front that comes after one, to the right; null: none. */
const GuiChartPoint *next_of_front(const GuiChart *chart, const GuiChartPoint *last) {
    const GuiChartPoint *next = nullptr;
    for (int i = 0; i < chart->count; i++) {
        const GuiChartPoint *point = &chart->points[i];
        if (point->is_front && (!last || point->x > last->x) && (!next || point->x < next->x)) {
            next = point;
        }
    }
    return next;
}

/** Draws the line through the front. */
void draw_chart_front(ImDrawList *list, const GuiChart *chart, const ChartArea &area) {
    const GuiChartPoint *last = next_of_front(chart, nullptr);
    while (last) {
        const GuiChartPoint *next = next_of_front(chart, last);
        if (next) {
            list->AddLine(chart_position(area, last->x, last->y),
                          chart_position(area, next->x, next->y), ACCENT, 2);
        }
        last = next;
    }
}

/** Draws the points with their labels, above each other where they would overlap. */
void draw_chart_points(ImDrawList *list, const GuiChart *chart, const ChartArea &area) {
    const float line = ImGui::GetFontSize(), radius = line / 4;
    ImVec2 labels[CHART_LABELS_MAXIMUM];
    int labelled = 0;
    for (int i = 0; i < chart->count; i++) {
        const GuiChartPoint &point = chart->points[i];
        ImVec2 at = chart_position(area, point.x, point.y);
        ImVec2 label(at.x + 2 * radius, at.y - line);
        for (int k = 0; k < labelled; k++) {
            bool is_over =
                fabsf(labels[k].y - label.y) < line && fabsf(labels[k].x - label.x) < line;
            if (is_over) {
                label.y = labels[k].y - line;
                k = -1; // Those before may be in the way now.
            }
        }
        list->AddCircleFilled(at, radius, point.is_front ? ACCENT : TEXT);
        list->AddCircle(at, radius + (point.is_shown ? 3 : 1), point.is_shown ? TEXT : OUTLINE, 0,
                        2);
        if (label.y > area.low.y - line && label.y < area.high.y) {
            put_text(list, label, 0, point.is_front ? ACCENT : TEXT, point.label);
        }
        if (labelled < CHART_LABELS_MAXIMUM) {
            labels[labelled++] = label;
        }
    }
}

/** Lists the points, the last ones where not all fit. @param bottom Lower end of the list. @param
 *  width Its width. @return Its upper end. */
float draw_chart_list(ImDrawList *list, const GuiChart *chart, ImVec2 low, float bottom,
                      float width) {
    const float left = 2 * ImGui::GetFontSize();
    for (int i = chart->count; i-- > 0;) {
        const GuiChartPoint &point = chart->points[i];
        const ImU32 color = point.is_front ? ACCENT : TEXT;
        const float height = text_extent(point.name, width - left).y;
        if (bottom - height <= low.y) {
            break;
        }
        bottom -= height;
        put_text(list, ImVec2(low.x, bottom), 0, color, point.label);
        put_text(list, ImVec2(low.x + left, bottom), width - left, color, point.name);
    }
    return bottom;
}

} // namespace

extern "C" {

void gui_chart(const GuiChart *chart, GuiPoint corner, GuiPoint size) {
    const float line = ImGui::GetFontSize(), gap = PADDING * line;
    ImVec2 low(corner.x, corner.y), high(corner.x + size.x, corner.y + size.y);
    ImDrawList *list = begin_value("chart", low, high);
    list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_PopupBg), ROUNDING * line);
    const float width = size.x - 2 * gap;
    ImVec2 at(low.x + gap, low.y + gap);
    at.y += put_text(list, at, width, ACCENT, chart->title).y;
    at.y += put_text(list, at, width, TEXT, chart->y_label).y;
    float bottom = high.y - gap;
    for (int i = chart->note_count; i-- > 0;) {
        bottom -= text_extent(chart->notes[i], width).y;
        put_text(list, ImVec2(at.x, bottom), width, TEXT, chart->notes[i]);
    }
    float list_top = at.y + CHART_PLOT_FRACTION * size.y;
    bottom = draw_chart_list(list, chart, ImVec2(at.x, list_top), bottom - gap, width);
    ChartArea area = {ImVec2(at.x + CHART_NUMBER_WIDTH * line, at.y + line),
                      ImVec2(high.x - 2 * line, bottom - 2.5F * line - 2 * gap),
                      chart_range(chart, true), chart_range(chart, false)};
    if (area.high.y - area.low.y > PLOT_LINES_MINIMUM * line) { // Else the list alone has room.
        ImVec2 label = ImGui::CalcTextSize(chart->x_label);
        put_text(list, ImVec2(area.high.x - label.x, area.high.y + 1.5F * line + gap / 2), 0, TEXT,
                 chart->x_label);
        draw_chart_grid(list, area);
        draw_chart_front(list, chart, area);
        draw_chart_points(list, chart, area);
    }
    if (chart->count == 0 && chart->reason) {
        const float room = high.x - low.x - 2 * gap;
        const float half = text_extent(chart->reason, room).y / 2;
        const float middle = fmaxf((area.low.y + area.high.y) / 2, area.low.y + half);
        ImVec2 corner_of_reason(low.x + gap, middle - half);
        list->AddRectFilled(corner_of_reason,
                            ImVec2(corner_of_reason.x + room, corner_of_reason.y + 2 * half),
                            ImGui::GetColorU32(ImGuiCol_PopupBg));
        put_text(list, corner_of_reason, room, ACCENT, chart->reason);
    }
    end_value(list);
}

} // extern "C"
