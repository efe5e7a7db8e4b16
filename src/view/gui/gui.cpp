/**
 * @file
 * @brief The interface by Dear ImGui, drawn with SDL's renderer.
 *
 * Dear ImGui keeps one current context per process. Each function of a whole interface makes its
 * own the current one; the widgets between #gui_begin_frame and #gui_end_frame belong to it.
 */
#include "view/gui/gui.h"

#include <backends/imgui_impl_sdl.h>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <imgui.h>
#include <imgui_internal.h>
#include <new>

namespace {

/** Frames that are drawn after an event: Dear ImGui reacts to a click one frame later. */
constexpr int FRAMES_PER_EVENT = 3;
/** Padding of widgets, in heights of letters. */
constexpr float PADDING = 0.35F;
/** Radius of rounded corners, in heights of letters. */
constexpr float ROUNDING = 0.3F;
/** Widest line of a tooltip, in heights of letters. */
constexpr float TOOLTIP_WIDTH = 24;
/** Width of a slider, in heights of letters. */
constexpr float SLIDER_WIDTH = 7;
/** Radius of the mark of a light, in heights of letters. */
constexpr float LIGHT_RADIUS = 0.4F;
/** Rays of the mark of a light. */
constexpr int LIGHT_RAYS = 8;
/** Width at which notes of a legend are broken into lines, in heights of letters. */
constexpr float LEGEND_NOTE_WIDTH = 11;
/** Height of the bar of a legend, in heights of letters. */
constexpr float LEGEND_BAR_LINES = 11;
/** Length of an arrow to a light outside the picture, in heights of letters. */
constexpr float ARROW_LENGTH = 1.2F;
/** Space beside the text of a label, in heights of letters. */
constexpr float LABEL_PADDING = 0.12F;
/** Width of a ray in flight, in heights of letters. */
constexpr float FLIGHT_WIDTH = 0.22F;
/** Step by which rows of a list are moved to the right, in heights of letters. */
constexpr float ROW_INDENT = 0.7F;

/** Width of cards and of lists of steps, in heights of letters. */
constexpr float CARD_WIDTH = 32;
/** Width of a panel from which answers stand side by side, in heights of letters. */
constexpr float WIDE_PANEL = 24;
/** Bytes of an answer with its number. */
constexpr int ANSWER_SIZE = 1024;
/** Behaviour of panels and cards. */
constexpr ImGuiWindowFlags PANEL_FLAGS = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings;

/** The letters of English and French, and the signs of formulas, arrows and buttons. */
constexpr ImWchar LETTERS[] = {0x20,   0xff,   0x152,  0x153,  0x3b1,  0x3c9,  0x2010, 0x2027,
                               0x202f, 0x202f, 0x2039, 0x203a, 0x2190, 0x2199, 0x2212, 0x2212,
                               0x2248, 0x2248, 0x2260, 0x2265, 0x25a0, 0x25ff, 0x2630, 0x2630,
                               0x2713, 0x2713, 0x2717, 0x2717, 0x275a, 0x275a, 0};

/** Colour of what is on, and of lights. */
constexpr ImU32 ACCENT = IM_COL32(255, 205, 90, 255);
/** Colour of the right answer: told from #ACCENT by every eye. */
constexpr ImU32 RIGHT = IM_COL32(90, 180, 255, 255);
/** Colour of outlines on the picture: seen on light and dark ground. */
constexpr ImU32 OUTLINE = IM_COL32(0, 0, 0, 200);
/** Colour of headings. */
constexpr ImU32 HEADING = IM_COL32(140, 190, 255, 255);
/** Colour of text on the picture. */
constexpr ImU32 TEXT = IM_COL32(240, 240, 240, 255);

/** Sets colours and shapes of widgets. */
void set_style() {
    ImGui::StyleColorsDark();
    ImGuiStyle &style = ImGui::GetStyle();
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 0;
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.06F, 0.07F, 0.11F, 0.84F);
    style.Colors[ImGuiCol_PopupBg] = ImVec4(0.06F, 0.07F, 0.11F, 0.96F);
    style.Colors[ImGuiCol_Button] = ImVec4(1, 1, 1, 0.10F);
    style.Colors[ImGuiCol_ButtonHovered] = ImVec4(1, 1, 1, 0.24F);
    style.Colors[ImGuiCol_ButtonActive] = ImVec4(1, 1, 1, 0.36F);
    style.Colors[ImGuiCol_FrameBg] = style.Colors[ImGuiCol_Button];
    style.Colors[ImGuiCol_FrameBgHovered] = style.Colors[ImGuiCol_ButtonHovered];
    style.Colors[ImGuiCol_FrameBgActive] = style.Colors[ImGuiCol_ButtonActive];
    style.Colors[ImGuiCol_SliderGrab] = ImGui::ColorConvertU32ToFloat4(ACCENT);
    style.Colors[ImGuiCol_SliderGrabActive] = style.Colors[ImGuiCol_SliderGrab];
    style.Colors[ImGuiCol_Header] = style.Colors[ImGuiCol_ButtonHovered];
    style.Colors[ImGuiCol_HeaderHovered] = style.Colors[ImGuiCol_ButtonActive];
}

/** Shows a tooltip while the mouse is on the last widget. */
void show_tooltip(const char *text) {
    if (text && text[0] != '\0' && ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(TOOLTIP_WIDTH * ImGui::GetFontSize());
        ImGui::TextUnformatted(text);
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
}

/** Places the next widget of the bar: in the line, or in the next one where it is too wide. */
void place_in_bar(float width) {
    float next = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width;
    if (next < ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) {
        ImGui::SameLine();
    }
}

/** @return Width of a button with a label. */
float button_width(const char *label) {
    return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

} // namespace

struct Gui {
    ImGuiContext *context;  /**< Dear ImGui's state; owned. */
    SDL_Renderer *renderer; /**< The window's renderer. */
    const char *font;       /**< Path of the font. */
    SDL_Texture *letters;   /**< The letters; owned; null: none. */
    float letter_size;      /**< Their height, pixels of the screen; 0: none. */
    int due_frames;         /**< Frames to be drawn, see FRAMES_PER_EVENT. */
    bool closes_list;       /**< Whether the open list is closed in the next frame. */
};

namespace {

/** Frees the texture of the letters. */
void release_letters(Gui *gui) {
    if (gui->letters) {
        SDL_DestroyTexture(gui->letters);
    }
    gui->letters = nullptr;
    gui->letter_size = 0;
}

/** Draws the letters in another size. @param size Pixels of the screen. */
void create_letters(Gui *gui, float size) {
    ImFontAtlas *atlas = ImGui::GetIO().Fonts;
    unsigned char *pixels = nullptr;
    int width = 0, height = 0;
    release_letters(gui);
    atlas->Clear();
    if (!atlas->AddFontFromFileTTF(gui->font, size, nullptr, LETTERS)) {
        atlas->AddFontDefault();
    }
    atlas->GetTexDataAsRGBA32(&pixels, &width, &height);
    gui->letters = SDL_CreateTexture(gui->renderer, SDL_PIXELFORMAT_ABGR8888,
                                     SDL_TEXTUREACCESS_STATIC, width, height);
    if (gui->letters) {
        SDL_UpdateTexture(gui->letters, nullptr, pixels, 4 * width);
        SDL_SetTextureBlendMode(gui->letters, SDL_BLENDMODE_BLEND);
    }
    atlas->SetTexID(gui->letters);
    gui->letter_size = size;
}

/** Draws one list of commands, in units of the window. */
void draw_list(SDL_Renderer *renderer, const ImDrawList *list) {
    const char *vertices = reinterpret_cast<const char *>(list->VtxBuffer.Data);
    for (const ImDrawCmd &command : list->CmdBuffer) {
        const ImVec4 &clip = command.ClipRect;
        SDL_Rect rect = {static_cast<int>(clip.x), static_cast<int>(clip.y),
                         static_cast<int>(clip.z - clip.x), static_cast<int>(clip.w - clip.y)};
        const char *first = vertices + command.VtxOffset * sizeof(ImDrawVert);
        SDL_RenderSetClipRect(renderer, &rect);
        SDL_RenderGeometryRaw(
            renderer, static_cast<SDL_Texture *>(command.GetTexID()),
            reinterpret_cast<const float *>(first + offsetof(ImDrawVert, pos)), sizeof(ImDrawVert),
            reinterpret_cast<const SDL_Color *>(first + offsetof(ImDrawVert, col)),
            sizeof(ImDrawVert), reinterpret_cast<const float *>(first + offsetof(ImDrawVert, uv)),
            sizeof(ImDrawVert), static_cast<int>(list->VtxBuffer.Size - command.VtxOffset),
            list->IdxBuffer.Data + command.IdxOffset, static_cast<int>(command.ElemCount),
            sizeof(ImDrawIdx));
    }
}

/** Draws a line with an outline. */
void draw_outlined_line(ImDrawList *list, ImVec2 from, ImVec2 to, ImU32 color, float width) {
    list->AddLine(from, to, OUTLINE, width + 2);
    list->AddLine(from, to, color, width);
}

/** Writes a text, broken at spaces alone: Dear ImGui itself breaks numbers at their points. */
void text_at_spaces(const char *text) {
    const float available = ImGui::GetContentRegionAvail().x;
    while (*text != '\0') {
        const char *end = text;
        while (*end != '\0') {
            const char *next = end + 1;
            while (*next != '\0' && *next != ' ') {
                next++;
            }
            if (end != text && ImGui::CalcTextSize(text, next).x > available) {
                break;
            }
            end = next;
        }
        ImGui::TextUnformatted(text, end);
        text = *end == ' ' ? end + 1 : end;
    }
}

/** What the parts of a legend measure, pixels of the window. */
struct LegendLayout {
    float line;  /**< Height of a line. */
    float gap;   /**< Distance of parts, and from the edge. */
    float bar;   /**< Height of the bar; 0: none. */
    float width; /**< Width of the contents. */
    float notes; /**< Height of the notes. */
    int apart;   /**< Colours that are not on the bar. */
};

/** @return The layout of a legend. @param highest See #gui_legend. */
LegendLayout legend_layout(const GuiLegend *legend, float highest) {
    LegendLayout layout = {ImGui::GetFontSize(), PADDING * ImGui::GetFontSize(), 0, 0, 0, 0};
    const float swatch = 2 * layout.line + layout.gap;
    layout.width = fmaxf(ImGui::CalcTextSize(legend->title).x, ImGui::CalcTextSize(legend->unit).x);
    for (int i = 0; i < legend->swatch_count; i++) {
        layout.apart += legend->swatches[i].position < 0;
        layout.width =
            fmaxf(layout.width, swatch + ImGui::CalcTextSize(legend->swatches[i].text).x);
    }
    for (int i = 0; i < legend->note_count; i++) {
        float note = fminf(ImGui::CalcTextSize(legend->notes[i]).x, LEGEND_NOTE_WIDTH * layout.line);
        layout.width = fmaxf(layout.width, note);
    }
    for (int i = 0; i < legend->note_count; i++) {
        layout.notes +=
            ImGui::CalcTextSize(legend->notes[i], nullptr, false, layout.width).y + layout.gap / 2;
    }
    if (legend->bar_count > 0) {
        float lines = static_cast<float>(layout.apart) + 1 + (legend->unit[0] != '\0' ? 1 : 0);
        float rest = highest - lines * layout.line - layout.notes - 5 * layout.gap;
        layout.bar = fmaxf(fminf(LEGEND_BAR_LINES * layout.line, rest), 2 * layout.line);
    }
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
            list->AddText(ImVec2(low.x + 2 * layout.line + layout.gap, last), TEXT, tick.text);
        }
    }
}

/** Writes a name with an outline. @param center Middle of its upper edge. */
void draw_name(ImDrawList *list, ImVec2 center, const char *name) {
    ImVec2 size = ImGui::CalcTextSize(name);
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float left = fminf(fmaxf(center.x - size.x / 2, 0), fmaxf(display.x - size.x, 0));
    float top = fminf(fmaxf(center.y, 0), fmaxf(display.y - size.y, 0));
    list->AddText(ImVec2(left + 1, top + 1), OUTLINE, name);
    list->AddText(ImVec2(left, top), TEXT, name);
}

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
    return ImGui::CalcTextSize(text, nullptr, false, width - 2 * padding.x).y + 2 * padding.y;
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
    list->AddText(nullptr, 0,
                  ImVec2(corner.x + style.FramePadding.x, corner.y + style.FramePadding.y),
                  is_dim ? ImGui::GetColorU32(ImGuiCol_TextDisabled) : TEXT, text, nullptr,
                  size.x - 2 * style.FramePadding.x);
    ImGui::PopID();
    return is_clicked && answers.is_open;
}

} // namespace

extern "C" {

Gui *gui_create(SDL_Window *window, SDL_Renderer *renderer, const char *font) {
    Gui *gui = font ? new (std::nothrow) Gui() : nullptr;
    if (!gui) {
        return nullptr;
    }
    *gui = Gui{ImGui::CreateContext(), renderer, font, nullptr, 0, FRAMES_PER_EVENT, false};
    ImGui::SetCurrentContext(gui->context);
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    set_style();
    ImGui_ImplSDL2_InitForSDLRenderer(window);
    return gui;
}

void gui_destroy(Gui *gui) {
    if (gui) {
        ImGui::SetCurrentContext(gui->context);
        release_letters(gui);
        ImGui_ImplSDL2_Shutdown();
        ImGui::DestroyContext(gui->context);
        delete gui;
    }
}

void gui_on_device_reset(Gui *gui) {
    if (gui) {
        ImGui::SetCurrentContext(gui->context);
        release_letters(gui);
    }
}

bool gui_handle_event(Gui *gui, const SDL_Event *event) {
    if (!gui) {
        return false;
    }
    bool is_mouse = event->type == SDL_MOUSEMOTION || event->type == SDL_MOUSEBUTTONDOWN ||
                    event->type == SDL_MOUSEBUTTONUP || event->type == SDL_MOUSEWHEEL;
    ImGui::SetCurrentContext(gui->context);
    bool was_wanted = ImGui::GetIO().WantCaptureMouse;
    if (is_mouse || event->type == SDL_WINDOWEVENT) {
        ImGui_ImplSDL2_ProcessEvent(event);
    }
    if (is_mouse) {
        gui->due_frames = FRAMES_PER_EVENT;
    }
    return is_mouse && was_wanted;
}

bool gui_close_list(Gui *gui) {
    if (!gui) {
        return false;
    }
    ImGui::SetCurrentContext(gui->context);
    bool is_open = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
    gui->closes_list = is_open;
    gui->due_frames = FRAMES_PER_EVENT;
    return is_open;
}

bool gui_needs_frame(const Gui *gui) {
    return gui && gui->due_frames > 0;
}

void gui_begin_frame(Gui *gui, float text_size) {
    ImGui::SetCurrentContext(gui->context);
    ImGui_ImplSDL2_NewFrame();
    ImGuiIO &io = ImGui::GetIO();
    float pixels = roundf(text_size * io.DisplayFramebufferScale.y);
    if (pixels != gui->letter_size) {
        create_letters(gui, pixels);
    }
    io.FontGlobalScale = 1 / io.DisplayFramebufferScale.y;
    ImGuiStyle &style = ImGui::GetStyle();
    style.FramePadding = ImVec2(PADDING * text_size, PADDING * text_size / 2);
    style.ItemSpacing = ImVec2(PADDING * text_size, PADDING * text_size / 2);
    style.WindowPadding = style.ItemSpacing;
    style.FrameRounding = style.PopupRounding = style.GrabRounding = ROUNDING * text_size;
    ImGui::NewFrame();
    if (gui->closes_list) {
        ImGui::ClosePopupsOverWindow(nullptr, false);
        gui->closes_list = false;
    }
}

void gui_end_frame(Gui *gui) {
    ImGui::Render();
    const ImDrawData *data = ImGui::GetDrawData();
    ImVec2 scale = data->FramebufferScale;
    SDL_RenderSetScale(gui->renderer, scale.x, scale.y);
    for (int i = 0; gui->letters && i < data->CmdListsCount; i++) {
        draw_list(gui->renderer, data->CmdLists[i]);
    }
    SDL_RenderSetClipRect(gui->renderer, nullptr);
    SDL_RenderSetScale(gui->renderer, 1, 1);
    gui->due_frames -= gui->due_frames > 0;
}

float gui_text_size() {
    return ImGui::GetFontSize();
}

/* --- the bar ---------------------------------------------------------------------------------- */

void gui_bar_begin() {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(ImGui::GetIO().DisplaySize.x, 0));
    ImGui::Begin("bar", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::Dummy(ImVec2(0, 0));
}

float gui_bar_end() {
    float height = ImGui::GetWindowHeight();
    ImGui::End();
    return height;
}

bool gui_button(const char *label, const char *tooltip, bool is_on) {
    place_in_bar(button_width(label));
    if (is_on) {
        ImGui::PushStyleColor(ImGuiCol_Text, ACCENT);
    }
    bool is_clicked = ImGui::Button(label);
    if (is_on) {
        ImGui::PopStyleColor();
    }
    show_tooltip(tooltip);
    return is_clicked;
}

int gui_choice(const char *id, const char *const *names, int count, int selected,
               const char *tooltip) {
    const char *shown = selected >= 0 && selected < count ? names[selected] : "";
    int chosen = -1;
    float width = 0;
    for (int i = 0; i < count; i++) {
        width = fmaxf(width, button_width(names[i]));
    }
    place_in_bar(width);
    ImGui::PushID(id);
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("##list", shown,
                          ImGuiComboFlags_NoArrowButton | ImGuiComboFlags_HeightLargest)) {
        for (int i = 0; i < count; i++) {
            if (ImGui::Selectable(names[i], i == selected) && i != selected) {
                chosen = i;
            }
        }
        ImGui::EndCombo();
    } else {
        show_tooltip(tooltip);
    }
    ImGui::PopID();
    return chosen;
}

int gui_stepper(const char *id, const char *text, const char *widest, const char *tooltip) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    int step = 0;
    float width = ImGui::CalcTextSize(widest).x;
    place_in_bar(button_width("−") + button_width("+") + width + 2 * gap);
    ImGui::PushID(id);
    ImGui::BeginGroup();
    step -= ImGui::Button("−") ? 1 : 0;
    ImGui::SameLine(0, gap);
    ImGui::AlignTextToFramePadding();
    float left = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(text);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + width + gap);
    step += ImGui::Button("+") ? 1 : 0;
    ImGui::EndGroup();
    show_tooltip(tooltip);
    ImGui::PopID();
    return step;
}

bool gui_log_slider(const char *id, double *value, double low, double high, const char *text,
                    const char *tooltip) {
    float width = SLIDER_WIDTH * ImGui::GetFontSize();
    // Dear ImGui's own logarithmic scale ends at the precision of the text: 0.1 for one digit.
    double exponent = log10(*value), least = log10(low), most = log10(high);
    place_in_bar(width);
    ImGui::PushID(id);
    ImGui::SetNextItemWidth(width);
    bool is_changed = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &exponent, &least,
                                          &most, text, ImGuiSliderFlags_NoInput);
    if (is_changed) {
        *value = pow(10, exponent);
    }
    show_tooltip(tooltip);
    ImGui::PopID();
    return is_changed;
}

/* --- text and marks on the picture ------------------------------------------------------------ */

void gui_message(const char *id, const char *text, GuiPoint point, GuiSide side) {
    float width = ImGui::GetIO().DisplaySize.x - 2 * ImGui::GetFontSize();
    ImVec2 size = ImGui::CalcTextSize(text, nullptr, false, width);
    ImGui::SetNextWindowPos(ImVec2(point.x, point.y), ImGuiCond_Always,
                            ImVec2(0.5F, side == GUI_ABOVE ? 1.0F : 0.0F));
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + size.x + 1);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::End();
}

void gui_readout(const char *text, const unsigned char rgb[3], GuiPoint corner) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    float size = ImGui::GetFontSize(), gap = PADDING * size;
    float widest = ImGui::GetIO().DisplaySize.x - corner.x - 2 * size - 3 * gap;
    ImVec2 area = ImGui::CalcTextSize(text, nullptr, false, widest);
    ImVec2 low(corner.x, corner.y - area.y - 2 * gap);
    ImVec2 high(corner.x + area.x + 2 * size + 3 * gap, corner.y);
    list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_WindowBg));
    list->AddRectFilled(ImVec2(low.x + gap, low.y + gap),
                        ImVec2(low.x + gap + 2 * size, high.y - gap),
                        IM_COL32(rgb[0], rgb[1], rgb[2], 255));
    list->AddText(nullptr, 0, ImVec2(low.x + 2 * size + 2 * gap, low.y + gap), TEXT, text, nullptr,
                  widest);
}

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

void gui_mark_outside(GuiPoint tip, GuiPoint direction, const char *name, bool is_selected) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    float length = ARROW_LENGTH * ImGui::GetFontSize(), half = length / 3;
    ImVec2 end(tip.x, tip.y);
    ImVec2 start(tip.x - length * direction.x, tip.y - length * direction.y);
    ImVec2 left(start.x - half * direction.y, start.y + half * direction.x);
    ImVec2 right(start.x + half * direction.y, start.y - half * direction.x);
    list->AddTriangleFilled(end, left, right, is_selected ? ACCENT : TEXT);
    list->AddTriangle(end, left, right, OUTLINE, 1.5F);
    draw_name(list,
              ImVec2(start.x - length * direction.x, start.y - length * direction.y - length / 2),
              name);
}

/* --- lists of rays: rows, check boxes and text beside the picture ------------------------------
 */

void gui_list_begin(const char *id, GuiPoint corner, GuiPoint size) {
    ImGui::SetNextWindowPos(ImVec2(corner.x, corner.y));
    ImGui::SetNextWindowSize(ImVec2(size.x, size.y));
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
}

void gui_list_end() {
    ImGui::End();
}

void gui_list_heading(const char *text) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, HEADING);
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
}

void gui_list_text(const char *label, const char *text) {
    if (label[0] != '\0') {
        ImGui::PushStyleColor(ImGuiCol_Text, ACCENT);
        ImGui::TextUnformatted(label);
        ImGui::PopStyleColor();
        float left = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x;
        float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
        if (left + ImGui::CalcTextSize(text).x <= right) {
            ImGui::SameLine();
        }
    }
    text_at_spaces(text);
}

bool gui_list_row(int number, const char *text, int indent, const unsigned char rgb[3],
                  bool is_selected, bool is_revealed) {
    const float size = ImGui::GetFontSize(), left = ROW_INDENT * size * static_cast<float>(indent);
    ImGui::PushID(number);
    ImVec2 corner = ImGui::GetCursorScreenPos();
    bool is_clicked = ImGui::Selectable("##row", is_selected, 0, ImVec2(0, size));
    ImDrawList *list = ImGui::GetWindowDrawList();
    ImVec2 low(corner.x + left, corner.y + 0.2F * size);
    list->AddRectFilled(low, ImVec2(low.x + 0.6F * size, low.y + 0.6F * size),
                        IM_COL32(rgb[0], rgb[1], rgb[2], 255));
    list->AddRect(low, ImVec2(low.x + 0.6F * size, low.y + 0.6F * size), TEXT);
    list->AddText(ImVec2(low.x + size, corner.y), is_selected ? ACCENT : TEXT, text);
    if (is_revealed) {
        ImGui::SetScrollHereY();
    }
    if (left + size + ImGui::CalcTextSize(text).x > ImGui::GetContentRegionAvail().x) {
        show_tooltip(text);
    }
    ImGui::PopID();
    return is_clicked;
}

bool gui_list_check(const char *label, const unsigned char rgb[3], const char *tooltip,
                    bool is_on) {
    place_in_bar(button_width(label) + ImGui::GetFrameHeight());
    ImGui::PushStyleColor(ImGuiCol_CheckMark, IM_COL32(rgb[0], rgb[1], rgb[2], 255));
    bool is_clicked = ImGui::Checkbox(label, &is_on);
    ImGui::PopStyleColor();
    show_tooltip(tooltip);
    return is_clicked;
}

float gui_text_width(const char *text) {
    return ImGui::CalcTextSize(text).x;
}

void gui_label(const char *text, GuiPoint anchor, GuiPoint corner, bool is_bright) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    ImVec2 size = ImGui::CalcTextSize(text), low(corner.x, corner.y);
    float gap = LABEL_PADDING * size.y;
    ImVec2 high(low.x + size.x + gap, low.y + size.y);
    draw_outlined_line(list, ImVec2(anchor.x, anchor.y),
                       ImVec2(low.x + size.x / 2, low.y + size.y / 2), is_bright ? ACCENT : TEXT,
                       1);
    list->AddRectFilled(ImVec2(low.x - gap, low.y), high, is_bright ? ACCENT : OUTLINE,
                        ROUNDING * size.y);
    list->AddText(low, is_bright ? IM_COL32_BLACK : TEXT, text);
}

void gui_flight(GuiPoint from, GuiPoint to, const unsigned char rgb[3]) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    const float width = FLIGHT_WIDTH * ImGui::GetFontSize();
    ImVec2 start(from.x, from.y), end(to.x, to.y);
    list->AddLine(start, end, TEXT, 2 * width);
    list->AddLine(start, end, IM_COL32(rgb[0], rgb[1], rgb[2], 255), width);
    list->AddCircleFilled(end, 2 * width, OUTLINE);
    list->AddCircleFilled(end, 1.6F * width, ACCENT);
}

/* --- values on the picture -------------------------------------------------------------------- */

void gui_legend(const GuiLegend *legend, GuiPoint corner, float highest, bool is_right) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    LegendLayout layout = legend_layout(legend, highest);
    float lines = static_cast<float>(layout.apart) + (legend->unit[0] != '\0' ? 2 : 1);
    float height = lines * layout.line + layout.bar + layout.notes + 4 * layout.gap;
    float width = layout.width + 2 * layout.gap;
    ImVec2 low(is_right ? corner.x - width : corner.x, corner.y - height);
    list->AddRectFilled(low, ImVec2(low.x + width, corner.y),
                        ImGui::GetColorU32(ImGuiCol_WindowBg), ROUNDING * layout.line);
    ImVec2 at(low.x + layout.gap, low.y + layout.gap);
    list->AddText(at, ACCENT, legend->title);
    at.y += layout.line;
    if (legend->unit[0] != '\0') {
        list->AddText(at, TEXT, legend->unit);
        at.y += layout.line;
    }
    at.y += layout.gap;
    if (legend->bar_count > 0) {
        draw_legend_bar(list, legend, layout, at);
        at.y += layout.bar + layout.gap;
    }
    for (int i = 0; i < legend->swatch_count; i++) {
        const GuiSwatch &swatch = legend->swatches[i];
        if (swatch.position < 0) {
            const float edge = layout.line / 8;
            list->AddRectFilled(ImVec2(at.x, at.y + edge),
                                ImVec2(at.x + 2 * layout.line, at.y + layout.line - edge),
                                IM_COL32(swatch.rgb[0], swatch.rgb[1], swatch.rgb[2], 255));
            list->AddText(ImVec2(at.x + 2 * layout.line + layout.gap, at.y), TEXT, swatch.text);
            at.y += layout.line;
        }
    }
    for (int i = 0; i < legend->note_count; i++) {
        const char *note = legend->notes[i];
        list->AddText(nullptr, 0, at, TEXT, note, nullptr, layout.width);
        at.y +=
            ImGui::CalcTextSize(note, nullptr, false, layout.width).y + layout.gap / 2;
    }
}

void gui_ring(GuiPoint center, float radius) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    ImVec2 middle(center.x, center.y);
    list->AddCircle(middle, radius, OUTLINE, 0, 5);
    list->AddCircle(middle, radius, IM_COL32(255, 255, 255, 255), 0, 2);
}

/* --- lessons ---------------------------------------------------------------------------------- */

void gui_panel_begin(const char *id, GuiPoint corner, GuiPoint size) {
    ImGui::SetNextWindowPos(ImVec2(corner.x, corner.y));
    ImGui::SetNextWindowSize(ImVec2(size.x, size.y));
    ImGui::Begin(id, nullptr, PANEL_FLAGS);
}

void gui_panel_end() {
    ImGui::End();
}

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
    ImGui::Begin(id, nullptr, PANEL_FLAGS | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleColor();
}

void gui_heading(const char *text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ACCENT);
    gui_paragraph(text);
    ImGui::PopStyleColor();
}

void gui_paragraph(const char *text) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
}

void gui_item(const char *text) {
    ImGui::Bullet();
    ImGui::SameLine();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
}

void gui_same_line() {
    ImGui::SameLine();
}

bool gui_step_button(const char *label, const char *tooltip, bool is_enabled, bool is_marked) {
    ImGui::BeginDisabled(!is_enabled);
    if (is_marked) {
        ImGui::PushStyleColor(ImGuiCol_Text, ACCENT);
    }
    bool is_clicked = ImGui::Button(label);
    if (is_marked) {
        ImGui::PopStyleColor();
    }
    ImGui::EndDisabled();
    show_tooltip(tooltip);
    return is_clicked;
}

bool gui_step_list_begin(const char *label, const char *tooltip) {
    if (ImGui::Button(label)) {
        ImGui::OpenPopup("steps");
    }
    show_tooltip(tooltip);
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float width = fminf(CARD_WIDTH * ImGui::GetFontSize(), display.x);
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0), ImVec2(width, display.y / 2));
    return ImGui::BeginPopup("steps");
}

bool gui_step_list_entry(size_t index, const char *text, bool is_present) {
    ImGui::PushID(static_cast<int>(index));
    bool is_clicked = ImGui::Selectable("##entry", is_present);
    if (is_present && ImGui::IsWindowAppearing()) {
        ImGui::SetScrollHereY();
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
    float width = (whole - gaps) / static_cast<float>(columns);
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
