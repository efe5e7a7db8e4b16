/**
 * @file
 * @brief Numbers that are dragged, slid or typed, written as readers of the language write them.
 *
 * Dear ImGui writes numbers with a point. It still rounds them by its own text, so that a drag
 * gives the same bits in every language, but that text is not seen: the one that is seen is ours. A
 * number that is typed may have a point or a comma.
 */
#include "view/gui/gui_internal.h"

extern "C" {
#include "base/language.h"
}

namespace {

/** Bytes of a number with the final zero. */
constexpr size_t NUMBER_SIZE = 64;

/** @return The decimal sign of the language. */
char decimal_sign() {
    return language_is_french() ? ',' : '.';
}

/** Lets only the signs of numbers through; a point and a comma are both the decimal sign. See
 *  ImGuiInputTextCallback. */
int filter_number(ImGuiInputTextCallbackData *data) {
    const ImWchar typed = data->EventChar;
    if (typed == '.' || typed == ',') {
        data->EventChar = static_cast<ImWchar>(decimal_sign());
    }
    return is_sign_of_number(typed) ? 0 : 1;
}

/** Gives a text that is typed the decimal sign: Dear ImGui has begun it with a point. */
void use_decimal_sign(ImGuiInputTextState *state) {
    for (int i = 0; i < state->CurLenW; i++) {
        state->TextW[i] =
            state->TextW[i] == '.' ? static_cast<ImWchar>(decimal_sign()) : state->TextW[i];
    }
}

/** Writes a number as text of the language. */
void write_number(double number, const char *format, char text[NUMBER_SIZE]) {
    snprintf(text, NUMBER_SIZE, format, number);
    language_localize_numbers(text, NUMBER_SIZE);
}

/** @return The frame of the next number. */
ImRect next_frame() {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    return ImRect(low, ImVec2(low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight()));
}

/** The field of a number while it is typed. @return Whether the number has changed. */
bool type_number(const char *id, double *number, const NumberField &field) {
    ImGuiContext &context = *ImGui::GetCurrentContext();
    const ImGuiID item = ImGui::GetID(id);
    const ImRect frame = next_frame();
    char text[NUMBER_SIZE];
    double typed = 0;
    write_number(*number, field.format, text);
    use_decimal_sign(&context.InputTextState);
    if (!ImGui::ItemAdd(frame, item, &frame, ImGuiItemFlags_Inputable)) {
        return false;
    }
    const bool has_text = ImGui::InputTextEx(
        id, nullptr, text, static_cast<int>(sizeof text), frame.GetSize(),
        ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_NoMarkEdited |
            ImGuiInputTextFlags_MergedItem | ImGuiInputTextFlags_CallbackCharFilter,
        filter_number);
    // At the end, too: Esc gives back the text from before.
    const bool is_new = context.InputTextState.Edited || context.ActiveId != item;
    for (char *sign = text; *sign; sign++) {
        *sign = *sign == ',' ? '.' : *sign;
    }
    if (!has_text || !is_new || sscanf(text, "%lf", &typed) != 1) {
        return false;
    }
    typed = fmin(fmax(typed, field.low), field.high);
    const bool is_changed = typed < *number || typed > *number;
    *number = typed;
    return is_changed;
}

/** Writes a number into the middle of its frame. */
void draw_number(double number, const char *format, const ImRect &frame) {
    char text[NUMBER_SIZE];
    write_number(number, format, text);
    const ImVec2 size = ImGui::CalcTextSize(text), middle = frame.GetCenter();
    const ImVec2 at(middle.x - size.x / 2, middle.y - size.y / 2);
    ImGui::RenderTextClipped(frame.Min, frame.Max, text, nullptr, &size, ImVec2(0.5F, 0.5F));
    record_text(text, at, ImVec2(at.x + size.x, at.y + size.y), clipped(frame.Min, frame.Max),
                ImGui::GetFontSize());
}

} // namespace

bool is_sign_of_number(ImWchar sign) {
    return sign > 0 && sign < 128 && strchr("0123456789+-.,eE", static_cast<int>(sign));
}

bool edit_number(const char *id, double *number, const NumberField &field) {
    const ImGuiID item = ImGui::GetID(id);
    const ImRect frame = next_frame();
    const ImGuiSliderFlags flags = field.flags | ImGuiSliderFlags_AlwaysClamp;
    bool is_changed;
    if (ImGui::TempInputIsActive(item)) {
        is_changed = type_number(id, number, field);
    } else {
        ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32_BLACK_TRANS);
        is_changed = field.speed > 0
                         ? ImGui::DragScalar(id, ImGuiDataType_Double, number, field.speed,
                                             &field.low, &field.high, field.format, flags)
                         : ImGui::SliderScalar(id, ImGuiDataType_Double, number, &field.low,
                                               &field.high, field.format, flags);
        ImGui::PopStyleColor();
    }
    Gui *gui = current_gui();
    gui->is_number_chosen = gui->is_number_chosen || ImGui::GetCurrentContext()->NavId == item;
    if (!ImGui::TempInputIsActive(item)) {
        draw_number(*number, field.format, frame);
    }
    return is_changed;
}

void put_label(const char *label) {
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    record_right_label(label);
}

extern "C" {

bool gui_edit_numbers(const char *label, double *numbers, int count, double low, double high,
                      double speed, const char *tooltip) {
    const NumberField field = {low, high, static_cast<float>(speed), count > 1 ? "%.3g" : "%.4g",
                               ImGuiSliderFlags_NoRoundToFormat};
    bool is_changed = false;
    ImGui::BeginGroup();
    ImGui::PushID(label);
    ImGui::PushMultiItemsWidths(count, ImGui::CalcItemWidth());
    for (int i = 0; i < count; i++) {
        ImGui::PushID(i);
        if (i > 0) {
            ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        }
        is_changed = edit_number("##number", &numbers[i], field) || is_changed;
        ImGui::PopID();
        ImGui::PopItemWidth();
    }
    ImGui::PopID();
    put_label(label);
    ImGui::EndGroup();
    show_tooltip(tooltip);
    return is_changed;
}

bool gui_edit_slider(const char *label, double *number, double low, double high,
                     const char *tooltip) {
    ImGui::BeginGroup();
    ImGui::PushID(label);
    bool is_changed = edit_number("##number", number, NumberField{low, high, 0, "%.3f", 0});
    ImGui::PopID();
    put_label(label);
    ImGui::EndGroup();
    show_tooltip(tooltip);
    return is_changed;
}

} // extern "C"
