/**
 * @file
 * @brief The interface by Dear ImGui, drawn with SDL's renderer.
 *
 * Dear ImGui keeps one current context per process. Each function of a whole interface makes its
 * own the current one; the widgets between #gui_begin_frame and #gui_end_frame belong to it.
 */
#include "view/gui/gui.h"

#include "view/gui/typeface.h"

#include <backends/imgui_impl_sdl.h>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <imgui.h>
#include <imgui_internal.h>
#include <new>
#include <unistd.h>

namespace {

/** Frames that are drawn after an event: Dear ImGui reacts to a click one frame later. */
constexpr int FRAMES_PER_EVENT = 3;
/** Padding of widgets and panels, in heights of letters: 8 pixels in letters of 20. */
constexpr float PADDING = 0.4F;
/** Radius of rounded corners, in heights of letters. */
constexpr float ROUNDING = 0.3F;
/** Size of headings, in heights of letters. */
constexpr float HEADING_SIZE = 1.2F;
/** Size of very large letters, in heights of letters. */
constexpr float TITLE_SIZE = 2.2F;
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
/** Opacity of a panel that fills its room: the picture is hardly seen through it. */
constexpr float PANEL_ALPHA = 0.95F;
/** Most columns of a list. */
constexpr int COLUMNS_MAXIMUM = 4;
/** Smallest width of a thumbnail, in heights of letters. */
constexpr float THUMBNAIL_WIDTH = 8.5F;
/** Height of a thumbnail, in widths. */
constexpr float THUMBNAIL_RATIO = 0.75F;
/** Most lines of a thumbnail's name. */
constexpr int NAME_LINES = 2;
/** Smallest letters on a key, fraction of the window's height, and pixels. */
constexpr float KEY_TEXT_FRACTION = 1 / 30.0F;
/** See KEY_TEXT_FRACTION. */
constexpr float KEY_TEXT_MINIMUM = 14;
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
/** Width of the numbers of a chart's left axis, in heights of letters. */
constexpr float CHART_NUMBER_WIDTH = 2.5F;
/** Most labels of points that do not overlap. */
constexpr int CHART_LABELS_MAXIMUM = 32;
/** Room at the end of an axis, decades. */
constexpr double CHART_HEADROOM = 0.15;
/** Least part of a chart's height for the points. */
constexpr float CHART_PLOT_FRACTION = 0.45F;
/** Height of the bar of a legend, in heights of letters. */
constexpr float LEGEND_BAR_LINES = 11;
/** Width of the inspector of objects, in heights of letters. */
constexpr float INSPECTOR_WIDTH = 15;
/** Width of a widget in it, in heights of letters. */
constexpr float INSPECTOR_WIDGET_WIDTH = 8;
/** How much a pixel of a drag changes the brightness of a colour. */
constexpr float COLOR_DRAG = 0.01F;
/** Colours are rounded to this fraction of 1. */
constexpr double COLOR_GRAINS = 10000;
/** Bytes of the inspector's title with the final zero. */
constexpr size_t INSPECTOR_TITLE_SIZE = 256;
/** Length of an arrow to a light outside the picture, in heights of letters. */
constexpr float ARROW_LENGTH = 1.2F;
/** Height of a bar of progress, in heights of letters. */
constexpr float PROGRESS_HEIGHT = 0.3F;
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
constexpr ImWchar LETTERS[] = {
    0x20,   0xff,   0x152,  0x153,  0x3b1,  0x3c9,  0x2010, 0x2027, 0x202f, 0x202f, 0x2039, 0x203a,
    0x2190, 0x2199, 0x21a9, 0x21ba, 0x21de, 0x21df, 0x21e7, 0x21ea, 0x21f1, 0x21f2, 0x2212, 0x2212,
    0x2248, 0x2248, 0x2260, 0x2265, 0x232b, 0x232b, 0x23ce, 0x23ce, 0x258f, 0x258f, 0x25a0, 0x25ff,
    0x2600, 0x263c, 0x2699, 0x2699, 0x26a0, 0x26a0, 0x2713, 0x2717, 0x275a, 0x275a, 0};
/** The letters of headings. */
constexpr ImWchar HEADING_LETTERS[] = {0x20,   0xff,   0x152,  0x153,  0x3b1,  0x3c9,  0x2010,
                                       0x2027, 0x202f, 0x202f, 0x2190, 0x2193, 0x2212, 0x2212,
                                       0x2248, 0x2248, 0x2260, 0x2265, 0};

/** The palette, by #GuiColor. Groups are distinct for colour-blind viewers too. */
constexpr ImU32 PALETTE[GUI_COLOR_COUNT] = {
    IM_COL32(240, 240, 240, 255), IM_COL32(150, 156, 170, 255), IM_COL32(255, 205, 90, 255),
    IM_COL32(150, 200, 255, 255), IM_COL32(255, 160, 130, 255), IM_COL32(255, 205, 90, 255),
    IM_COL32(120, 190, 255, 255), IM_COL32(90, 215, 170, 255),  IM_COL32(255, 145, 110, 255),
    IM_COL32(205, 205, 215, 255), IM_COL32(225, 165, 215, 255), IM_COL32(215, 225, 120, 255)};
/** Colour of what is on, and of lights. */
constexpr ImU32 ACCENT = PALETTE[GUI_COLOR_ACCENT];
/** Colour of the right answer: told from #ACCENT by every eye. */
constexpr ImU32 RIGHT = IM_COL32(90, 180, 255, 255);
/** Colour of outlines on the picture: seen on light and dark ground. */
constexpr ImU32 OUTLINE = IM_COL32(0, 0, 0, 200);
/** Colour of the lines of a chart. */
constexpr ImU32 GRID = IM_COL32(255, 255, 255, 60);
/** Colour of text on the picture. */
constexpr ImU32 TEXT = PALETTE[GUI_COLOR_TEXT];
/** Colour of keys without a command, and of thumbnails that are not drawn yet. */
constexpr ImU32 EMPTY = IM_COL32(42, 46, 58, 255);
/** Colour of a row under the mouse. */
constexpr ImU32 HOVERED = IM_COL32(255, 255, 255, 36);
/** Colour of the selected row. */
constexpr ImU32 SELECTED = IM_COL32(255, 205, 90, 60);

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
    ImGuiContext *context;    /**< Dear ImGui's state; owned. */
    SDL_Renderer *renderer;   /**< The window's renderer. */
    const Typeface *typeface; /**< The typeface. */
    SDL_Texture *letters;     /**< The letters; owned; null: none. */
    float letter_size;        /**< Their height, pixels of the screen; 0: none. */
    ImFont *heading;          /**< The letters of headings. */
    SDL_Cursor *ring;         /**< The mouse as a ring; owned; null: as usual. */
    int due_frames;           /**< Frames to be drawn, see FRAMES_PER_EVENT. */
    bool closes_list;         /**< Whether the open list is closed in the next frame. */
    bool records_texts;       /**< Whether #texts are recorded. */
    ImVector<GuiText> texts;  /**< The texts of the frame. */
};

namespace {

/** Frees the ring. */
void release_ring(Gui *gui) {
    if (gui->ring) {
        SDL_FreeCursor(gui->ring);
        gui->ring = nullptr;
    }
}

/** @return A ring as a cursor; null: SDL has none. @param size Pixels. */
SDL_Cursor *create_ring(int size) {
    const float middle = static_cast<float>(size) / 2, width = middle / 4;
    SDL_Surface *surface =
        SDL_CreateRGBSurfaceWithFormat(0, size, size, 32, SDL_PIXELFORMAT_ARGB8888);
    if (!surface) {
        return nullptr;
    }
    for (int y = 0; y < size; y++) {
        Uint32 *row = reinterpret_cast<Uint32 *>(static_cast<char *>(surface->pixels) +
                                                 static_cast<ptrdiff_t>(y) * surface->pitch);
        for (int x = 0; x < size; x++) {
            float radius = hypotf(static_cast<float>(x) + 0.5F - middle,
                                  static_cast<float>(y) + 0.5F - middle);
            float depth = fabsf(radius - (middle - width));
            row[x] = depth < width / 2 ? 0xffffcd5a : depth < width ? 0xc0000000 : 0;
        }
    }
    SDL_Cursor *cursor = SDL_CreateColorCursor(surface, size / 2, size / 2);
    SDL_FreeSurface(surface);
    return cursor;
}

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

/** A slider from 0 to 1, or a number that is dragged if it may be larger. @return Whether the user
 *  has changed it. */
bool drag_or_slide(const char *id, double *number, double high) {
    const double low = 0;
    return high <= 1 ? ImGui::SliderScalar(id, ImGuiDataType_Double, number, &low, &high, "%.3f",
                                           ImGuiSliderFlags_AlwaysClamp)
                     : ImGui::DragScalar(id, ImGuiDataType_Double, number, COLOR_DRAG, &low, &high,
                                         "%.3f", ImGuiSliderFlags_AlwaysClamp);
}

/** @return Whether an event is of the keyboard. */
bool is_keyboard_event(const SDL_Event *event) {
    return event->type == SDL_KEYDOWN || event->type == SDL_KEYUP || event->type == SDL_TEXTINPUT;
}

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
    ImFont *regular = atlas->AddFontFromFileTTF(gui->typeface->regular, size, nullptr, LETTERS);
    regular = regular ? regular : atlas->AddFontDefault();
    bool has_bold = access(gui->typeface->bold, R_OK) == 0;
    gui->heading = has_bold ? atlas->AddFontFromFileTTF(gui->typeface->bold, HEADING_SIZE * size,
                                                        nullptr, HEADING_LETTERS)
                            : nullptr;
    gui->heading = gui->heading ? gui->heading : regular;
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

/** @return The interface whose frame is drawn. */
Gui *current_gui() {
    return static_cast<Gui *>(ImGui::GetIO().UserData);
}

/** Records a text for tests. @param clip What is seen of its surroundings. */
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
    record.panel = window->ID;
    record.scrolls = (window->Flags & ImGuiWindowFlags_NoScrollbar) == 0;
    gui->texts.push_back(record);
}

/** @return What can be seen of a box in the window. */
ImVec4 clipped(ImVec2 low, ImVec2 high) {
    const ImVec4 &clip = ImGui::GetWindowDrawList()->_ClipRectStack.back();
    return ImVec4(fmaxf(low.x, clip.x), fmaxf(low.y, clip.y), fminf(high.x, clip.z),
                  fminf(high.y, clip.w));
}

/** Records the label of the last widget, which is cut where the widget ends. */
void record_label(const char *label) {
    ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImVec2 size = ImGui::CalcTextSize(label);
    float left = (low.x + high.x - size.x) / 2, top = (low.y + high.y - size.y) / 2;
    record_text(label, ImVec2(left, top), ImVec2(left + size.x, top + size.y), clipped(low, high),
                ImGui::GetFontSize());
}

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

/** @return The size of a text. @param width See #line_end. */
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

/** Writes a text into the window. @param width See #line_end. */
void put_text(ImVec2 corner, float width, ImU32 color, const char *text) {
    ImDrawList *list = ImGui::GetWindowDrawList();
    const float size = ImGui::GetFontSize();
    ImVec2 at(roundf(corner.x), roundf(corner.y)), extent = text_extent(text, width);
    record_text(text, at, ImVec2(at.x + extent.x, at.y + extent.y), list->_ClipRectStack.back(),
                size);
    while (*text != '\0') {
        const char *end = line_end(text, width);
        list->AddText(at, color, text, end);
        at.y += size;
        text = *end != '\0' ? end + 1 : end;
    }
}

/** Begins a window without a frame of its own. */
void begin_window(const char *id, ImVec2 corner, ImVec2 size, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos(ImVec2(floorf(corner.x), floorf(corner.y)));
    ImGui::SetNextWindowSize(ImVec2(ceilf(size.x), ceilf(size.y)));
    ImGui::Begin(id, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     flags);
}

/* --- rows ------------------------------------------------------------------------------------- */

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

/** @return A colour that is darker. */
ImU32 darker(ImU32 color) {
    ImVec4 mixed = ImGui::ColorConvertU32ToFloat4(color);
    const float factor = 0.36F;
    return ImGui::ColorConvertFloat4ToU32(
        ImVec4(mixed.x * factor, mixed.y * factor, mixed.z * factor, 1));
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

/** Draws the picture of a thumbnail, or its message, and its name. @param low Upper left corner. */
void draw_thumbnail(const GuiThumbnail *thumbnail, ImVec2 low, float width, float picture_height,
                    bool is_hovered) {
    const float size = ImGui::GetFontSize(), pad = PADDING * size;
    ImDrawList *list = ImGui::GetWindowDrawList();
    ImVec2 high(low.x + width, low.y + picture_height + 3 * pad + NAME_LINES * size);
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

/** Draws a line with an outline. */
void draw_outlined_line(ImDrawList *list, ImVec2 from, ImVec2 to, ImU32 color, float width) {
    list->AddLine(from, to, OUTLINE, width + 2);
    list->AddLine(from, to, color, width);
}

/** Writes a text as an item of the window, broken at spaces alone. */
void text_at_spaces(const char *text) {
    const float width = ImGui::GetContentRegionAvail().x;
    ImVec2 corner = ImGui::GetCursorScreenPos();
    put_text(corner, width, ImGui::GetColorU32(ImGuiCol_Text), text);
    ImGui::Dummy(text_extent(text, width));
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
        float note =
            fminf(ImGui::CalcTextSize(legend->notes[i]).x, LEGEND_NOTE_WIDTH * layout.line);
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

/** Writes a text in lines. @return Its height. */
float draw_wrapped(ImDrawList *list, ImVec2 at, ImU32 color, const char *text, float width) {
    list->AddText(nullptr, 0, at, color, text, nullptr, width);
    return ImGui::CalcTextSize(text, nullptr, false, width).y;
}

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

/** Draws a line at each power of ten, with its number. */
void draw_chart_grid(ImDrawList *list, const ChartArea &area) {
    const float line = ImGui::GetFontSize();
    char text[16];
    for (double x = area.x.low; x <= area.x.high; x++) {
        ImVec2 at = chart_position(area, pow(10, x), 0);
        snprintf(text, sizeof text, "%g", pow(10, x));
        list->AddLine(ImVec2(at.x, area.low.y), ImVec2(at.x, area.high.y), GRID);
        list->AddText(ImVec2(at.x - ImGui::CalcTextSize(text).x / 2, area.high.y), TEXT, text);
    }
    for (double y = area.y.low; y <= area.y.high; y++) {
        ImVec2 at = chart_position(area, 0, pow(10, y));
        snprintf(text, sizeof text, "%g", pow(10, y));
        list->AddLine(ImVec2(area.low.x, at.y), ImVec2(area.high.x, at.y), GRID);
        list->AddText(ImVec2(area.low.x - ImGui::CalcTextSize(text).x - line / 4, at.y - line / 2),
                      TEXT, text);
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
        list->AddText(label, point.is_front ? ACCENT : TEXT, point.label);
        if (labelled < CHART_LABELS_MAXIMUM) {
            labels[labelled++] = label;
        }
    }
}

/** Lists the points, the last ones where not all fit. @param bottom Lower end of the list.
 *  @return Its upper end. */
float draw_chart_list(ImDrawList *list, const GuiChart *chart, ImVec2 low, float bottom) {
    const float line = ImGui::GetFontSize();
    for (int i = chart->count; i-- > 0 && bottom - line > low.y;) {
        const GuiChartPoint &point = chart->points[i];
        bottom -= line;
        list->AddText(ImVec2(low.x, bottom), point.is_front ? ACCENT : TEXT, point.label);
        list->AddText(ImVec2(low.x + 2 * line, bottom), point.is_front ? ACCENT : TEXT, point.name);
    }
    return bottom;
}

/** Writes a name with an outline. @param center Middle of its upper edge. */
void draw_name(ImDrawList *list, ImVec2 center, const char *name) {
    ImVec2 size = ImGui::CalcTextSize(name);
    ImVec2 display = ImGui::GetIO().DisplaySize;
    float left = fminf(fmaxf(center.x - size.x / 2, 0), fmaxf(display.x - size.x, 0));
    float top = fminf(fmaxf(center.y, 0), fmaxf(display.y - size.y, 0));
    list->AddText(ImVec2(left + 1, top + 1), OUTLINE, name);
    list->AddText(ImVec2(left, top), TEXT, name);
    record_text(name, ImVec2(left, top), ImVec2(left + size.x, top + size.y),
                ImVec4(0, 0, display.x, display.y), ImGui::GetFontSize());
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

Gui *gui_create(SDL_Window *window, SDL_Renderer *renderer) {
    const Typeface *typeface = typeface_find();
    Gui *gui = typeface ? new (std::nothrow) Gui() : nullptr;
    if (!gui) {
        return nullptr;
    }
    gui->context = ImGui::CreateContext();
    gui->renderer = renderer;
    gui->typeface = typeface;
    gui->due_frames = FRAMES_PER_EVENT;
    ImGui::SetCurrentContext(gui->context);
    ImGuiIO &io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.UserData = gui;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    set_style();
    ImGui_ImplSDL2_InitForSDLRenderer(window);
    return gui;
}

void gui_destroy(Gui *gui) {
    if (gui) {
        ImGui::SetCurrentContext(gui->context);
        release_letters(gui);
        release_ring(gui);
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
    bool is_typed = ImGui::GetIO().WantTextInput && is_keyboard_event(event);
    if (is_typed) {
        ImGui_ImplSDL2_ProcessEvent(event);
        gui->due_frames = FRAMES_PER_EVENT;
    }
    return (is_mouse && was_wanted) || is_typed;
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
    style.WindowPadding = ImVec2(PADDING * text_size, PADDING * text_size);
    style.ScrollbarSize = PADDING * 2 * text_size;
    style.FrameRounding = style.PopupRounding = style.GrabRounding = style.ScrollbarRounding =
        style.WindowRounding = ROUNDING * text_size;
    gui->texts.resize(0);
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

void gui_request_frames(Gui *gui) {
    if (gui) {
        gui->due_frames = FRAMES_PER_EVENT;
    }
}

void gui_set_cursor(GuiCursor cursor) {
    static const ImGuiMouseCursor cursors[] = {ImGuiMouseCursor_Hand, ImGuiMouseCursor_ResizeAll,
                                               ImGuiMouseCursor_ResizeEW};
    ImGui::SetMouseCursor(cursors[cursor]);
}

void gui_set_ring(Gui *gui, bool is_wanted) {
    ImGui::SetCurrentContext(gui->context);
    ImGuiIO &io = ImGui::GetIO();
    release_ring(gui);
    io.ConfigFlags &= ~ImGuiConfigFlags_NoMouseCursorChange;
    gui->ring = is_wanted ? create_ring(2 * static_cast<int>(gui->letter_size)) : nullptr;
    if (gui->ring) {
        io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
        SDL_SetCursor(gui->ring);
    }
}

void gui_title(const char *text, GuiPoint top) {
    ImDrawList *list = ImGui::GetForegroundDrawList();
    ImFont *font = current_gui()->heading;
    const float size = TITLE_SIZE * ImGui::GetFontSize(), pad = PADDING * size;
    ImVec2 extent = font->CalcTextSizeA(size, FLT_MAX, 0, text);
    ImVec2 at(roundf(top.x - extent.x / 2), roundf(top.y + pad));
    list->AddRectFilled(ImVec2(at.x - pad, top.y),
                        ImVec2(at.x + extent.x + pad, at.y + extent.y + pad),
                        ImGui::GetColorU32(ImGuiCol_WindowBg), ROUNDING * size);
    list->AddText(font, size, at, ACCENT, text);
}

void gui_record_texts(Gui *gui, bool is_wanted) {
    gui->records_texts = is_wanted;
}

size_t gui_texts(const Gui *gui, const GuiText **texts) {
    *texts = gui->texts.Data;
    return static_cast<size_t>(gui->texts.Size);
}

/* --- panels ----------------------------------------------------------------------------------- */

GuiColor gui_group_color(int group) {
    const int count = GUI_COLOR_COUNT - GUI_COLOR_GROUP;
    return static_cast<GuiColor>(GUI_COLOR_GROUP + (group > 0 ? group - 1 : 0) % count);
}

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

void gui_panel_begin(const char *id, const GuiRect *room) {
    ImGui::SetNextWindowBgAlpha(PANEL_ALPHA);
    begin_window(id, ImVec2(room->x, room->y), ImVec2(room->width, room->height), 0);
    if (ImGui::IsWindowAppearing()) {
        gui_request_frames(current_gui()); // The scroll bar comes when the height is known.
    }
}

void gui_panel_end() {
    ImGui::End();
}

float gui_panel_width() {
    return ImGui::GetContentRegionAvail().x;
}

void gui_heading(const char *text) {
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PushFont(current_gui()->heading);
    ImVec2 corner = ImGui::GetCursorScreenPos(), size = text_extent(text, width);
    put_text(corner, width, PALETTE[GUI_COLOR_HEADING], text);
    ImGui::PopFont();
    ImGui::Dummy(size);
}

void gui_paragraph(const char *text, GuiColor color, int lines) {
    const float width = ImGui::GetContentRegionAvail().x;
    ImVec2 size = text_extent(text, width);
    size.y = fmaxf(size.y, static_cast<float>(lines) * ImGui::GetFontSize());
    put_text(ImGui::GetCursorScreenPos(), width, PALETTE[color], text);
    ImGui::Dummy(size);
}

GuiCell gui_rows(const GuiRow *rows, size_t count, GuiCell selected) {
    return show_rows(rows, count, COLUMNS_MAXIMUM, selected);
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
    return floorf((width + gap) / static_cast<float>(*columns) - gap);
}

GuiMouse gui_thumbnail(int id, const GuiThumbnail *thumbnail, int column, float width) {
    const float size = ImGui::GetFontSize(), pad = PADDING * size;
    const float picture_height = roundf((width - 2 * pad) * THUMBNAIL_RATIO);
    const float height = picture_height + 3 * pad + NAME_LINES * size;
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
    }
    if (ImGui::IsItemVisible()) {
        draw_thumbnail(thumbnail, low, width, picture_height, is_hovered);
    }
    if (is_hovered) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    return is_clicked ? GUI_CLICKED : is_hovered ? GUI_HOVERED : GUI_IDLE;
}

/* --- the bar ---------------------------------------------------------------------------------- */

void gui_bar_begin(bool is_folded) {
    ImGui::SetNextWindowPos(ImVec2(0, 0));
    ImGui::SetNextWindowSize(ImVec2(is_folded ? 0 : ImGui::GetIO().DisplaySize.x, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
    ImGui::Begin("bar", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
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
    record_label(label);
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
        if (ImGui::IsWindowAppearing()) {
            gui_request_frames(current_gui()); // The list finds its size.
        }
        for (int i = 0; i < count; i++) {
            if (ImGui::Selectable(names[i], i == selected) && i != selected) {
                chosen = i;
            }
        }
        ImGui::EndCombo();
    } else {
        record_label(shown);
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
    record_label(text);
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
    record_label(text);
    show_tooltip(tooltip);
    ImGui::PopID();
    return is_changed;
}

/* --- text and marks on the picture ------------------------------------------------------------ */

void gui_message(const char *id, const char *text, GuiPoint point, GuiSide side) {
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    float widest = ImGui::GetIO().DisplaySize.x - 2 * ImGui::GetFontSize() - 2 * pad.x;
    ImVec2 size = text_extent(text, widest);
    ImVec2 whole(size.x + 2 * pad.x + 1, size.y + 2 * pad.y);
    ImVec2 corner(point.x - whole.x / 2, point.y - (side == GUI_ABOVE ? whole.y : 0));
    begin_window(id, corner, whole, ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoScrollbar);
    put_text(ImGui::GetCursorScreenPos(), size.x + 1, TEXT, text);
    ImGui::End();
}

float gui_readout_height() {
    return (1 + 2 * PADDING) * ImGui::GetFontSize();
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
    ImVec2 at(low.x + 2 * size + 2 * gap, low.y + gap);
    list->AddText(nullptr, 0, at, TEXT, text, nullptr, widest);
    record_text(text, at, ImVec2(at.x + area.x, at.y + area.y),
                ImVec4(0, 0, ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y), size);
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
    gui_heading(text);
}

void gui_list_text(const char *label, const char *text) {
    if (label[0] != '\0') {
        const float width = ImGui::GetContentRegionAvail().x;
        ImVec2 size = text_extent(label, width);
        put_text(ImGui::GetCursorScreenPos(), width, ACCENT, label);
        ImGui::Dummy(size);
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
    put_text(ImVec2(low.x + size, corner.y), 0, is_selected ? ACCENT : TEXT, text);
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
    list->AddRectFilled(low, ImVec2(low.x + width, corner.y), ImGui::GetColorU32(ImGuiCol_WindowBg),
                        ROUNDING * layout.line);
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
        at.y += ImGui::CalcTextSize(note, nullptr, false, layout.width).y + layout.gap / 2;
    }
}

void gui_ring(GuiPoint center, float radius) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    ImVec2 middle(center.x, center.y);
    list->AddCircle(middle, radius, OUTLINE, 0, 5);
    list->AddCircle(middle, radius, IM_COL32(255, 255, 255, 255), 0, 2);
}

void gui_pixels(const GuiPixels *pixels, GuiPoint point, float top) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float line = ImGui::GetFontSize(), gap = PADDING * line;
    const float columns = static_cast<float>(pixels->columns);
    const float rows = static_cast<float>(pixels->rows);
    float cell = fmaxf(floorf(fminf(line, 0.45F * display.y / rows)), 3);
    float width = fmaxf(cell * columns, ImGui::CalcTextSize(pixels->caption).x) + 2 * gap;
    float height = cell * rows + line + 3 * gap;
    float left =
        point.x + 2 * line + width < display.x ? point.x + 2 * line : point.x - 2 * line - width;
    float upper = point.y + height / 2 < display.y ? point.y - height / 2 : display.y - height;
    ImVec2 low(fmaxf(left, 0), fmaxf(upper, top));
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
    list->AddText(ImVec2(low.x + gap, at.y + cell * rows + gap), TEXT, pixels->caption);
}

void gui_chart(const GuiChart *chart, GuiPoint corner, GuiPoint size) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    const float line = ImGui::GetFontSize(), gap = PADDING * line;
    ImVec2 low(corner.x, corner.y), high(corner.x + size.x, corner.y + size.y);
    list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_PopupBg), ROUNDING * line);
    const float width = size.x - 2 * gap;
    ImVec2 at(low.x + gap, low.y + gap);
    at.y += draw_wrapped(list, at, ACCENT, chart->title, width);
    at.y += draw_wrapped(list, at, TEXT, chart->y_label, width);
    float bottom = high.y - gap;
    for (int i = chart->note_count; i-- > 0;) {
        bottom -= ImGui::CalcTextSize(chart->notes[i], nullptr, false, width).y;
        draw_wrapped(list, ImVec2(at.x, bottom), TEXT, chart->notes[i], width);
    }
    float list_top = at.y + CHART_PLOT_FRACTION * size.y;
    bottom = draw_chart_list(list, chart, ImVec2(at.x, list_top), bottom - gap);
    ChartArea area = {ImVec2(at.x + CHART_NUMBER_WIDTH * line, at.y + gap),
                      ImVec2(high.x - 2 * line, bottom - 2 * line - 2 * gap),
                      chart_range(chart, true), chart_range(chart, false)};
    ImVec2 label = ImGui::CalcTextSize(chart->x_label);
    list->AddText(ImVec2(area.high.x - label.x, area.high.y + line + gap / 2), TEXT,
                  chart->x_label);
    draw_chart_grid(list, area);
    draw_chart_front(list, chart, area);
    draw_chart_points(list, chart, area);
}

/* --- lessons ---------------------------------------------------------------------------------- */

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
    // The height is whole pixels, that of the text is not: no scroll bar for less than one.
    const ImGuiWindow *card = ImGui::FindWindowByName(id);
    bool is_whole = card && card->ContentSize.y + 2 * letter < display.y;
    ImGui::Begin(id, nullptr,
                 PANEL_FLAGS | ImGuiWindowFlags_AlwaysAutoResize |
                     (is_whole ? ImGuiWindowFlags_NoScrollbar : 0));
    ImGui::PopStyleColor();
}

void gui_item(const char *text) {
    ImGui::Bullet();
    ImGui::SameLine();
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
}

void gui_same_line(const char *label) {
    place_in_bar(button_width(label));
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

/* --- progress --------------------------------------------------------------------------------- */

void gui_progress_bar(GuiPoint corner, float width, float fraction) {
    ImDrawList *list = ImGui::GetBackgroundDrawList();
    float height = PROGRESS_HEIGHT * ImGui::GetFontSize();
    ImVec2 low(corner.x, corner.y - height), high(corner.x + width, corner.y);
    list->AddRectFilled(low, high, OUTLINE);
    list->AddRectFilled(low, ImVec2(corner.x + width * fraction, corner.y), ACCENT);
}

/* --- the inspector of objects ----------------------------------------------------------------- */

bool gui_inspector_begin(const char *id, const char *title, float top) {
    const ImGuiIO &io = ImGui::GetIO();
    float size = ImGui::GetFontSize(), width = fminf(INSPECTOR_WIDTH * size, io.DisplaySize.x);
    char label[INSPECTOR_TITLE_SIZE];
    bool is_open = true;
    snprintf(label, sizeof label, "%s###%s", title, id);
    ImGui::SetNextWindowPos(ImVec2(io.DisplaySize.x - width, top), ImGuiCond_Appearing);
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0),
                                        ImVec2(width, fmaxf(4 * size, io.DisplaySize.y - top)));
    ImGui::Begin(label, &is_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    // The window may have become smaller, or the letters larger.
    ImVec2 corner = ImGui::GetWindowPos();
    ImGui::SetWindowPos(ImVec2(fmaxf(0, fminf(corner.x, io.DisplaySize.x - width)),
                               fmaxf(0, fminf(corner.y, io.DisplaySize.y - 2 * size))));
    ImGui::PushItemWidth(INSPECTOR_WIDGET_WIDTH * size);
    return is_open;
}

void gui_inspector_end() {
    ImGui::PopItemWidth();
    ImGui::End();
}

bool gui_inspector_section(const char *label, bool is_open_at_first) {
    return ImGui::CollapsingHeader(label,
                                   is_open_at_first ? ImGuiTreeNodeFlags_DefaultOpen
                                                    : ImGuiTreeNodeFlags_None);
}

void gui_inspector_text(const char *text) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
}

bool gui_inspector_button(const char *label, const char *tooltip) {
    if (ImGui::GetCurrentWindow()->DC.CursorPosPrevLine.x >
        ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMin().x) {
        place_in_bar(button_width(label));
    }
    bool is_clicked = ImGui::Button(label);
    show_tooltip(tooltip);
    return is_clicked;
}

bool gui_edit_numbers(const char *label, double *numbers, int count, double low, double high,
                      double speed, const char *tooltip) {
    bool is_changed =
        ImGui::DragScalarN(label, ImGuiDataType_Double, numbers, count,
                           static_cast<float>(speed), &low, &high, count > 1 ? "%.3g" : "%.4g",
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat);
    show_tooltip(tooltip);
    return is_changed;
}

bool gui_edit_slider(const char *label, double *number, double low, double high,
                     const char *tooltip) {
    bool is_changed = ImGui::SliderScalar(label, ImGuiDataType_Double, number, &low, &high, "%.3f",
                                          ImGuiSliderFlags_AlwaysClamp);
    show_tooltip(tooltip);
    return is_changed;
}

bool gui_edit_color(const char *label, double rgb[3], double high, const char *tooltip) {
    float encoded[3], swatch = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
    double largest = fmax(rgb[0], fmax(rgb[1], rgb[2])), brightness = largest;
    ImGui::PushID(label);
    ImGui::SetNextItemWidth(ImGui::CalcItemWidth() - swatch - gap);
    bool is_scaled = drag_or_slide("##brightness", &brightness, high);
    for (int i = 0; is_scaled && i < 3; i++) {
        rgb[i] = round_color(largest > 0 ? rgb[i] / largest * brightness : brightness);
    }
    show_tooltip(tooltip);
    for (int i = 0; i < 3; i++) {
        encoded[i] = static_cast<float>(srgb_encode(rgb[i]));
    }
    ImGui::SameLine(0, gap);
    bool is_picked = ImGui::ColorEdit3(
        "##color", encoded,
        ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR | ImGuiColorEditFlags_NoOptions |
            ImGuiColorEditFlags_PickerHueBar | ImGuiColorEditFlags_NoInputs);
    for (int i = 0; is_picked && i < 3; i++) {
        rgb[i] = fmin(fmax(round_color(srgb_decode(static_cast<double>(encoded[i]))), 0), high);
    }
    show_tooltip(tooltip);
    ImGui::SameLine(0, gap);
    ImGui::TextUnformatted(label);
    ImGui::PopID();
    return is_scaled || is_picked;
}

bool gui_edit_check(const char *label, double *number, const char *tooltip) {
    bool is_on = *number != 0;
    bool is_changed = ImGui::Checkbox(label, &is_on);
    *number = is_on ? 1 : 0;
    show_tooltip(tooltip);
    return is_changed;
}

bool gui_edit_choice(const char *label, double *number, const char *const *words,
                     const char *tooltip) {
    int count = 0, chosen = static_cast<int>(*number);
    while (words[count]) {
        count++;
    }
    bool is_changed = ImGui::Combo(label, &chosen, words, count);
    *number = chosen;
    show_tooltip(tooltip);
    return is_changed;
}

bool gui_is_editing() {
    return ImGui::IsAnyItemActive();
}

void gui_outline_line(GuiPoint from, GuiPoint to) {
    draw_outlined_line(ImGui::GetBackgroundDrawList(), ImVec2(from.x, from.y), ImVec2(to.x, to.y),
                       ACCENT, 1.5F);
}

} // extern "C"
