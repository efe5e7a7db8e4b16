/**
 * @file
 * @brief Colours that are changed: brightness, a picker for the mouse, numbers for the keyboard.
 */
#include "view/gui/gui_internal.h"

namespace {

/** How much a pixel of a drag changes the brightness of a colour. */
constexpr float COLOR_DRAG = 0.01F;
/** The brightness of a colour, with a sun before it. */
constexpr char BRIGHTNESS[] = "\xe2\x98\xbc %.3f";
/** Width of the picker of colours, in heights of letters. */
constexpr float PICKER_WIDTH = 8;
/** Width of a number below it, in heights of letters. */
constexpr float CHANNEL_WIDTH = 5;
/** Degrees of the circle of hues. */
constexpr double HUES = 360;
/** Colours are rounded to this fraction of 1. */
constexpr double COLOR_GRAINS = 10000;
/** @return A channel encoded with the curve of sRGB, which goes on above 1. */
double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

/** @return A channel in linear light. */
double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
}

/** @return A channel rounded to a fraction of a step of 255: it is short in a file. */
double round_color(double linear) {
    return round(linear * COLOR_GRAINS) / COLOR_GRAINS;
}

/** @return A number from 0 on as a slider, or as one that is dragged if it may be above 1. */
NumberField light_field(double high, const char *format) {
    return NumberField{0, high, high <= 1 ? 0 : COLOR_DRAG, format, 0};
}

/** Shows a number of a colour. @param word Unique to it in the picker. @return Whether the user has
 *  changed it. */
bool edit_part(const char *word, double *number, const NumberField &field) {
    ImGui::PushID(word);
    ImGui::SetNextItemWidth(CHANNEL_WIDTH * ImGui::GetFontSize());
    const bool is_changed = edit_number("##number", number, field);
    ImGui::PopID();
    return is_changed;
}

/** Encodes a colour. @param rgb Linear. */
void encode_color(const double rgb[3], float encoded[3]) {
    for (int i = 0; i < 3; i++) {
        encoded[i] = static_cast<float>(srgb_encode(rgb[i]));
    }
}

/** Decodes a colour. @param[out] rgb Linear, from 0 to \p high. */
void decode_color(const float encoded[3], double high, double rgb[3]) {
    for (int i = 0; i < 3; i++) {
        rgb[i] = fmin(fmax(round_color(srgb_decode(static_cast<double>(encoded[i]))), 0), high);
    }
}

/** Finds hue, saturation and value of a colour. Grey has every hue, and black every saturation:
 *  then, and while a colour stays, they are what they were. @param encoded The colour. */
void find_hue(PickedColor *picked, const float encoded[3]) {
    if (memcmp(picked->encoded, encoded, sizeof picked->encoded) == 0) {
        return;
    }
    float hue, saturation, value;
    ImGui::ColorConvertRGBtoHSV(encoded[0], encoded[1], encoded[2], hue, saturation, value);
    picked->hue = saturation > 0 ? HUES * static_cast<double>(hue) : picked->hue;
    picked->saturation = value > 0 ? static_cast<double>(saturation) : picked->saturation;
    picked->value = static_cast<double>(value);
    memcpy(picked->encoded, encoded, sizeof picked->encoded);
}

/** Shows hue, saturation and value as numbers: what the square and the bar show, for keys. @param
 *  [in,out] rgb The colour, linear. @return Whether the user has changed it. */
bool edit_hue(double rgb[3], double high, const char *const words[3]) {
    PickedColor *picked = &current_gui()->picked;
    float encoded[3];
    encode_color(rgb, encoded);
    find_hue(picked, encoded);
    bool is_changed = edit_part(words[0], &picked->hue, NumberField{0, HUES, 0, "%.0f°", 0});
    put_label(words[0]);
    is_changed = edit_part(words[1], &picked->saturation, light_field(1, "%.3f")) || is_changed;
    put_label(words[1]);
    is_changed =
        edit_part(words[2], &picked->value, light_field(srgb_encode(high), "%.3f")) || is_changed;
    put_label(words[2]);
    if (is_changed) {
        ImGui::ColorConvertHSVtoRGB(
            static_cast<float>(picked->hue / HUES), static_cast<float>(picked->saturation),
            static_cast<float>(picked->value), encoded[0], encoded[1], encoded[2]);
        decode_color(encoded, high, rgb);
        encode_color(rgb, picked->encoded); // As the next frame finds it.
    }
    return is_changed;
}

/** Shows red, green and blue as numbers, which keys reach. @param[in,out] rgb The colour, linear.
 *  @return Whether the user has changed it. */
bool edit_channels(double rgb[3], double high, const char *const words[3]) {
    bool is_changed = false;
    for (int i = 0; i < 3; i++) {
        if (edit_part(words[i], &rgb[i], light_field(high, "%.3f"))) {
            rgb[i] = round_color(rgb[i]);
            is_changed = true;
        }
        if (i == 0) {
            ImGui::SetItemDefaultFocus();
        }
        put_label(words[i]);
    }
    return is_changed;
}

/** Shows the picker: a square and a bar for the mouse. @param[in,out] rgb The colour, linear.
 *  @return Whether the user has changed it. */
bool pick_by_mouse(double rgb[3], double high) {
    float encoded[3];
    encode_color(rgb, encoded);
    ImGui::SetNextItemWidth(PICKER_WIDTH * ImGui::GetFontSize());
    bool is_picked = ImGui::ColorPicker3(
        "##picker", encoded,
        ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoOptions |
            ImGuiColorEditFlags_PickerHueBar | ImGuiColorEditFlags_NoInputs |
            ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoLabel);
    if (is_picked) {
        decode_color(encoded, high, rgb);
    }
    return is_picked;
}

/** Shows a colour as a square, which opens a picker with a button that closes it. @param[in,out]
 *  rgb The colour, linear. @param words See #gui_edit_color. @return Whether the user has
 *  changed it. */
bool pick_color(double rgb[3], double high, float side, const char *const words[6]) {
    const ImVec4 shown(static_cast<float>(srgb_encode(rgb[0])),
                       static_cast<float>(srgb_encode(rgb[1])),
                       static_cast<float>(srgb_encode(rgb[2])), 1);
    bool is_picked = false;
    if (ImGui::ColorButton("##color", shown,
                           ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_NoDragDrop,
                           ImVec2(side, side))) {
        ImGui::OpenPopup("picker");
    }
    if (ImGui::IsPopupOpen("picker")) {
        note_open_list(ImRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()));
    }
    if (ImGui::BeginPopup("picker")) {
        is_picked = pick_by_mouse(rgb, high);
        is_picked = edit_hue(rgb, high, words) || is_picked;
        is_picked = edit_channels(rgb, high, words + 3) || is_picked;
        if (ImGui::Button("OK")) {
            ImGui::CloseCurrentPopup();
        }
        ImGui::EndPopup();
    }
    return is_picked;
}

} // namespace

extern "C" {

bool gui_edit_color(const char *label, double rgb[3], double high, const char *const words[6],
                    const char *tooltip) {
    const float swatch = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const double largest = fmax(rgb[0], fmax(rgb[1], rgb[2]));
    double brightness = largest;
    ImGui::PushID(label);
    ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - swatch - gap);
    bool is_scaled = edit_number("##brightness", &brightness, light_field(high, BRIGHTNESS));
    for (int i = 0; is_scaled && i < 3; i++) {
        rgb[i] = round_color(largest > 0 ? rgb[i] / largest * brightness : brightness);
    }
    show_tooltip(tooltip);
    ImGui::SameLine(0, gap);
    bool is_picked = pick_color(rgb, high, swatch, words);
    show_tooltip(tooltip);
    put_label(label);
    ImGui::PopID();
    return is_scaled || is_picked;
}

} // extern "C"
