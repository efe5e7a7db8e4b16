/**
 * @file
 * @brief Objects: the inspector, outlines, and marks of lights.
 */
#include "view/gui/gui_internal.h"

namespace {

/** Radius of the mark of a light, in heights of letters. */
constexpr float LIGHT_RADIUS = 0.4F;
/** Rays of the mark of a light. */
constexpr int LIGHT_RAYS = 8;
/** Width of the inspector of objects, in heights of letters. */
constexpr float INSPECTOR_WIDTH = 16.5F;
/** Width of the two buttons of its title, in heights of letters. */
constexpr float TITLE_BUTTONS = 2;
/** Width of a widget in it, in heights of letters. */
constexpr float INSPECTOR_WIDGET_WIDTH = 7.7F;
/** Opacity of the inspector: no outline is seen through its words. */
constexpr float INSPECTOR_ALPHA = 0.97F;
/** Bytes of the inspector's title with the final zero. */
constexpr size_t INSPECTOR_TITLE_SIZE = 256;
/** Length of an arrow to a light outside the picture, in heights of letters. */
constexpr float ARROW_LENGTH = 1.2F;

/** @return Whether a panel of the last frame lies on a part of the window. */
bool is_covered(const ImRect &rect) {
    bool is_covered = false;
    for (const ImGuiWindow *window : ImGui::GetCurrentContext()->Windows) {
        is_covered = is_covered || (window->WasActive && !window->Hidden &&
                                    !window->IsFallbackWindow && window->Rect().Overlaps(rect));
    }
    return is_covered;
}

/** Writes a name with an outline, unless a panel lies there. @param center Middle of its upper
 *  edge. */
void draw_name(ImDrawList *list, ImVec2 center, const char *name) {
    ImVec2 size = ImGui::CalcTextSize(name);
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float left = fminf(fmaxf(center.x - size.x / 2, 0), fmaxf(display.x - size.x, 0));
    float top = fminf(fmaxf(center.y, 0), fmaxf(display.y - size.y, 0));
    if (is_covered(ImRect(left, top, left + size.x, top + size.y))) {
        return;
    }
    list->AddText(ImVec2(left + 1, top + 1), OUTLINE, name);
    list->AddText(ImVec2(left, top), TEXT, name);
    record_text(name, ImVec2(left, top), ImVec2(left + size.x, top + size.y), display_clip(),
                ImGui::GetFontSize());
}

/** @return The middle of the upper edge of a name behind an arrow, so that it touches the arrow at
 *  most. @param start The middle of the arrow's base. @param direction Where it points, of length
 *  1. */
ImVec2 name_behind(ImVec2 start, GuiPoint direction, const char *name) {
    const ImVec2 size = ImGui::CalcTextSize(name);
    const float half = ARROW_LENGTH * ImGui::GetFontSize() / 3;
    // How far the name's box reaches towards the arrow, and how far the base does along it.
    const float reach =
        fabsf(direction.x) * size.x / 2 + fabsf(direction.y) * size.y / 2 + half / 2;
    return ImVec2(start.x - reach * direction.x, start.y - reach * direction.y - size.y / 2);
}

/** Puts the inspector at the right of its area; at the left if it would lie on what it is about. It
 * moves only for that: the user may have put it elsewhere. @param width Its width. */
void place_inspector(const Gui *gui, const GuiInspectorPlace *place, float width) {
    const GuiRect &area = place->area;
    const ImVec2 thing(place->thing.x, place->thing.y);
    const float right = area.x + area.width - width;
    // In a narrow window it lies on it on either side: then on the side that is farther.
    bool is_left = place->has_thing && thing.x > fmaxf(right, area.x + area.width / 2);
    bool is_hidden = place->has_thing && place->is_new && gui->inspector.Contains(thing);
    ImGui::SetNextWindowPos(ImVec2(is_left ? area.x : right, area.y),
                            is_hidden ? ImGuiCond_Always : ImGuiCond_Appearing);
}

} // namespace

extern "C" {

void gui_mark_light(GuiPoint center, const char *name, bool is_selected) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    float radius = LIGHT_RADIUS * ImGui::GetFontSize(), width = is_selected ? 2.5F : 1.5F;
    ImU32 color = is_selected ? ACCENT : TEXT;
    ImVec2 middle(center.x, center.y);
    for (int i = 0; i < LIGHT_RAYS; i++) {
        float angle = static_cast<float>(i) * 2 * static_cast<float>(M_PI) / LIGHT_RAYS;
        ImVec2 direction(cosf(angle), sinf(angle));
        draw_outlined_line(
            list,
            ImVec2(middle.x + 1.4F * radius * direction.x, middle.y + 1.4F * radius * direction.y),
            ImVec2(middle.x + 2 * radius * direction.x, middle.y + 2 * radius * direction.y), color,
            width);
    }
    list->AddCircleFilled(middle, radius + 1, OUTLINE);
    list->AddCircleFilled(middle, radius, color);
    draw_name(list, ImVec2(middle.x, middle.y + 2.2F * radius), name);
}

GuiPoint gui_mark_outside(GuiPoint tip, GuiPoint direction, const char *name, bool is_selected) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    float length = ARROW_LENGTH * ImGui::GetFontSize(), half = length / 3;
    ImVec2 end(tip.x, tip.y);
    ImVec2 start(tip.x - length * direction.x, tip.y - length * direction.y);
    ImVec2 left(start.x - half * direction.y, start.y + half * direction.x);
    ImVec2 right(start.x + half * direction.y, start.y - half * direction.x);
    list->AddTriangleFilled(end, left, right, is_selected ? ACCENT : TEXT);
    list->AddTriangle(end, left, right, OUTLINE, 1.5F);
    draw_name(list, name_behind(start, direction, name), name);
    return {(start.x + end.x) / 2, (start.y + end.y) / 2};
}

bool gui_inspector_begin(const char *id, const char *title, const char *tooltip,
                         const GuiInspectorPlace *place) {
    const ImGuiIO &io = ImGui::GetIO();
    const GuiRect &area = place->area;
    float size = ImGui::GetFontSize(), width = fminf(INSPECTOR_WIDTH * size, io.DisplaySize.x);
    const float top = area.y, room = fmaxf(4 * size, area.height);
    char label[INSPECTOR_TITLE_SIZE];
    bool is_open = true;
    snprintf(label, sizeof label, "%s###%s", title, id);
    Gui *gui = current_gui();
    place_inspector(gui, place, width);
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, room));
    ImGui::SetNextWindowBgAlpha(INSPECTOR_ALPHA);
    focus_next_window(GUI_INSPECTOR);
    ImGui::Begin(label, &is_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                     navigation_flags(GUI_INSPECTOR) | ImGuiWindowFlags_NoFocusOnAppearing);
    if (ImGui::IsWindowAppearing()) {
        gui_request_frames(gui); // Its size is found in the first one, which does not show it.
    }
    show_tooltip(tooltip); // On the title.
    if (place->is_new) {
        ImGui::SetScrollY(0);
    }
    gui->takes_focus = gui->takes_focus || (place->is_new && gui->keyboard == GUI_INSPECTOR);
    choose_first_widget(GUI_INSPECTOR);
    gui->is_inspecting = true;
    // The window may have become smaller, or the letters larger: then it is whole again.
    const ImVec2 corner = ImGui::GetWindowPos();
    const float whole = io.DisplaySize.y - top;
    const float lowest = whole != gui->inspector_room
                             ? fmaxf(top, top + room - ImGui::GetWindowHeight())
                             : io.DisplaySize.y - 2 * size;
    gui->inspector_room = whole;
    ImGui::SetWindowPos(ImVec2(fmaxf(0, fminf(corner.x, io.DisplaySize.x - width)),
                               fmaxf(top, fminf(corner.y, lowest))));
    ImGui::PushItemWidth(INSPECTOR_WIDGET_WIDTH * size);
    return is_open;
}

GuiRect gui_inspector_rect() {
    const Gui *gui = current_gui();
    const ImRect &rect = gui->inspector;
    return gui->is_inspecting ? GuiRect{rect.Min.x, rect.Min.y, rect.GetWidth(), rect.GetHeight()}
                              : GuiRect{0, 0, 0, 0};
}

void gui_inspector_end() {
    ImGui::PopItemWidth();
    current_gui()->inspector = ImGui::GetCurrentWindow()->Rect();
    ImGui::End();
}

float gui_inspector_title_width() {
    const float size = ImGui::GetFontSize();
    return INSPECTOR_WIDTH * size - TITLE_BUTTONS * size - 4 * PADDING * size;
}

bool gui_inspector_section(const char *label, const char *tooltip, bool is_open_at_first) {
    bool is_open = ImGui::CollapsingHeader(label, is_open_at_first ? ImGuiTreeNodeFlags_DefaultOpen
                                                                   : ImGuiTreeNodeFlags_None);
    ImVec2 low = ImGui::GetItemRectMin(), size = ImGui::CalcTextSize(label);
    ImVec2 at(low.x + ImGui::GetTreeNodeToLabelSpacing(), low.y + ImGui::GetStyle().FramePadding.y);
    record_text(label, at, ImVec2(at.x + size.x, at.y + size.y),
                clipped(low, ImGui::GetItemRectMax()), ImGui::GetFontSize());
    show_tooltip(tooltip);
    return is_open;
}

bool gui_inspector_button(const char *label, const char *tooltip, bool is_enabled) {
    if (ImGui::GetCurrentWindow()->DC.CursorPosPrevLine.x >
        ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMin().x) {
        place_in_bar(button_width(label));
    }
    return gui_step_button(label, tooltip, is_enabled, false);
}

bool gui_edit_check(const char *label, double *number, const char *tooltip) {
    bool is_on = *number != 0;
    bool is_changed = ImGui::Checkbox(label, &is_on);
    *number = is_on ? 1 : 0;
    record_right_label(label);
    show_tooltip(tooltip);
    return is_changed;
}

bool gui_edit_choice(const char *label, double *number, const char *const *words,
                     const char *tooltip) {
    const int before = static_cast<int>(*number);
    if (begin_list(label, words[before], ImGuiComboFlags_None)) {
        for (int i = 0; words[i]; i++) {
            if (ImGui::Selectable(words[i], i == before)) {
                *number = i;
            }
        }
        ImGui::EndCombo();
    }
    const bool is_changed = static_cast<int>(*number) != before;
    record_right_label(label);
    show_tooltip(tooltip);
    return is_changed;
}

bool gui_is_editing() {
    return ImGui::IsAnyItemActive();
}

void gui_outline_line(GuiPoint from, GuiPoint to, const GuiRect *picture) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    list->PushClipRect(ImVec2(picture->x, picture->y),
                       ImVec2(picture->x + picture->width, picture->y + picture->height), true);
    draw_outlined_line(list, ImVec2(from.x, from.y), ImVec2(to.x, to.y), ACCENT, 1.5F);
    list->PopClipRect();
}

} // extern "C"
