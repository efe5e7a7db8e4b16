/**
 * @file
 * @brief Lessons: cards, steps, and answers to questions.
 */
#include "view/gui/gui_internal.h"

namespace {

/** Width of a card's border, pixels. */
constexpr float CARD_BORDER = 2;
/** Width of cards and of lists of steps, in heights of letters. */
constexpr float CARD_WIDTH = 32;
/** Width of a panel from which answers stand side by side, in heights of letters. */
constexpr float WIDE_PANEL = 24;
/** Bytes of an answer with its number. */
constexpr int ANSWER_SIZE = 1024;
/** Colour of the right answer: told from #ACCENT by every eye. */
constexpr ImU32 RIGHT = IM_COL32(90, 180, 255, 255);

/** Writes an answer with its number, and a sign once it is known to be right or wrong. */
void write_answer(const GuiAnswers &answers, int index, char text[ANSWER_SIZE]) {
    const char *sign = "";
    if (answers.right >= 0) {
        sign = index == answers.right    ? "\xe2\x9c\x93 "
               : index == answers.chosen ? "\xe2\x9c\x97 "
                                         : "";
    }
    snprintf(text, ANSWER_SIZE, "%d  %s%s", index + 1, sign, answers.texts[index]);
}

/** @return Height of an answer in a given width. */
float answer_height(const GuiAnswers &answers, int index, float width) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    char text[ANSWER_SIZE];
    write_answer(answers, index, text);
    return text_extent(text, width - 2 * padding.x).y + 2 * padding.y;
}

/** Draws an answer as a button. @return Whether it was clicked. */
bool draw_answer(const GuiAnswers &answers, int index, ImVec2 size) {
    const ImGuiStyle &style = ImGui::GetStyle();
    char text[ANSWER_SIZE];
    bool is_marked = index == answers.chosen || index == answers.right;
    bool is_dim = !answers.is_open && !is_marked;
    write_answer(answers, index, text);
    ImGui::PushID(index);
    ImGui::BeginDisabled(!answers.is_open);
    ImVec2 corner = ImGui::GetCursorScreenPos();
    bool is_clicked = ImGui::InvisibleButton("answer", size);
    ImGuiCol color = ImGui::IsItemActive()    ? ImGuiCol_ButtonActive
                     : ImGui::IsItemHovered() ? ImGuiCol_ButtonHovered
                                              : ImGuiCol_Button;
    ImGui::EndDisabled();
    ImVec2 end(corner.x + size.x, corner.y + size.y);
    ImDrawList *list = ImGui::GetWindowDrawList();
    list->AddRectFilled(corner, end, ImGui::GetColorU32(color), style.FrameRounding);
    if (is_marked) {
        list->AddRect(corner, end, index == answers.right ? RIGHT : ACCENT, style.FrameRounding, 0,
                      2);
    }
    put_text(ImVec2(corner.x + style.FramePadding.x, corner.y + style.FramePadding.y),
             size.x - 2 * style.FramePadding.x,
             is_dim ? ImGui::GetColorU32(ImGuiCol_TextDisabled) : TEXT, text);
    ImGui::PopID();
    return is_clicked && answers.is_open;
}

} // namespace

extern "C" {

void gui_card_begin(const char *id) {
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float letter = ImGui::GetFontSize();
    float width = fminf(CARD_WIDTH * letter, display.x - letter);
    ImGui::SetNextWindowPos(ImVec2(display.x / 2, display.y / 2), ImGuiCond_Always,
                            ImVec2(0.5F, 0.5F));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0),
                                        ImVec2(width, fmaxf(letter, display.y - letter)));
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    // It lies half on the picture, half on the black of the lesson's panel.
    ImGui::PushStyleColor(ImGuiCol_Border, PALETTE[GUI_COLOR_FAINT]);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, CARD_BORDER);
    // The height is whole pixels, that of the text is not: no scroll bar for less than one.
    const ImGuiWindow *card = ImGui::FindWindowByName(id);
    bool is_whole = card && card->ContentSize.y + 2 * letter < display.y;
    ImGui::Begin(id, nullptr,
                 PANEL_FLAGS | ImGuiWindowFlags_AlwaysAutoResize |
                     (is_whole ? ImGuiWindowFlags_NoScrollbar : 0));
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
}

void gui_item(const char *text) {
    ImGui::Bullet();
    ImGui::SameLine();
    gui_paragraph(text, GUI_COLOR_TEXT, 1);
}

void gui_same_line(const char *label) {
    place_in_bar(button_width(label));
}

bool gui_step_button(const char *label, const char *tooltip, bool is_enabled, bool is_marked) {
    ImGui::BeginDisabled(!is_enabled);
    bool is_clicked = push_button(label, tooltip, is_marked);
    ImGui::EndDisabled();
    return is_clicked;
}

bool gui_step_list_begin(const char *label, const char *tooltip) {
    return begin_menu(label, tooltip, false);
}

bool gui_step_list_entry(size_t index, const char *text, bool is_present) {
    ImGui::PushID(static_cast<int>(index));
    bool is_clicked = ImGui::Selectable("##entry", is_present);
    if (is_present && ImGui::IsWindowAppearing()) {
        ImGui::SetScrollHereY();
        gui_request_frames(current_gui()); // It moves in the next one.
    }
    ImGui::SameLine(0, 0);
    if (is_present) {
        ImGui::PushStyleColor(ImGuiCol_Text, ACCENT);
    }
    ImGui::TextUnformatted(text);
    if (is_present) {
        ImGui::PopStyleColor();
    }
    ImGui::PopID();
    return is_clicked;
}

void gui_step_list_end() {
    ImGui::EndPopup();
}

int gui_answers(const GuiAnswers *answers) {
    const ImGuiStyle &style = ImGui::GetStyle();
    float whole = ImGui::GetContentRegionAvail().x;
    int columns = 1, clicked = -1;
    if (whole > WIDE_PANEL * ImGui::GetFontSize()) {
        columns = answers->count <= 2 || answers->count == 4 ? 2 : 3;
    }
    float gaps = static_cast<float>(columns - 1) * style.ItemSpacing.x;
    float width = fmaxf(1, (whole - gaps) / static_cast<float>(columns)); // Of a button, at least.
    for (int row = 0; row < answers->count; row += columns) {
        int end = row + columns < answers->count ? row + columns : answers->count;
        float height = 0;
        for (int i = row; i < end; i++) {
            height = fmaxf(height, answer_height(*answers, i, width));
        }
        for (int i = row; i < end; i++) {
            if (i > row) {
                ImGui::SameLine();
            }
            clicked = draw_answer(*answers, i, ImVec2(width, height)) ? i : clicked;
        }
    }
    return clicked;
}

} // extern "C"
