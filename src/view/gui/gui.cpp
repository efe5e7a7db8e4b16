/**
 * @file
 * @brief The interface by Dear ImGui: creation, events, frames, and the letters.
 */
#include "view/gui/gui_internal.h"

#include <backends/imgui_impl_sdl.h>
#include <new>
#include <unistd.h>

namespace {

/** Size of headings, in heights of letters. */
constexpr float HEADING_SIZE = 1.2F;
/** The letters of English and French, and the signs of formulas, arrows and buttons. */
constexpr ImWchar LETTERS[] = {
    0x20,   0xff,   0x152,  0x153,  0x3b1,  0x3c9,  0x2010, 0x2027, 0x202f, 0x202f,
    0x2039, 0x203a, 0x2070, 0x207b, 0x2190, 0x2199, 0x21a9, 0x21ba, 0x21de, 0x21df,
    0x21e7, 0x21ea, 0x21f1, 0x21f2, 0x2212, 0x2212, 0x2248, 0x2248, 0x2260, 0x2265,
    0x232b, 0x232b, 0x23ce, 0x23ce, 0x258f, 0x258f, 0x25a0, 0x25ff, 0x2600, 0x263c,
    0x2699, 0x2699, 0x26a0, 0x26a0, 0x2713, 0x2717, 0x275a, 0x275a, 0};
/** The letters of headings. */
constexpr ImWchar HEADING_LETTERS[] = {0x20,   0xff,   0x152,  0x153,  0x3b1,  0x3c9,  0x2010,
                                       0x2027, 0x202f, 0x202f, 0x2190, 0x2193, 0x2212, 0x2212,
                                       0x2248, 0x2248, 0x2260, 0x2265, 0};

/** Sets colours and shapes of widgets. */
void set_style() {
    ImGui::StyleColorsDark();
    ImGuiStyle &style = ImGui::GetStyle();
    style.WindowBorderSize = 0;
    style.PopupBorderSize = 0;
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.06F, 0.07F, 0.11F, 0.84F);
    style.Colors[ImGuiCol_PopupBg] = ImVec4(0.06F, 0.07F, 0.11F, 1);
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

/** Frees the texture of the letters, and the panels that were drawn with it. */
void release_letters(Gui *gui) {
    forget_panels(&gui->kept);
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

} // namespace

Gui *current_gui() {
    return static_cast<Gui *>(ImGui::GetIO().UserData);
}

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
    gui_on_keymap(gui);
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
    const bool is_typed = handle_key_event(gui, event);
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

/**
 * Sets the position of the mouse to that of its last event.
 *
 * While a button is held, the SDL backend asks for the position on the screen, which SDL updates
 * by raw motion only: a pointer that a program moves, as a remote control does, would stand still.
 */
static void follow_mouse_events() {
    ImGuiIO &io = ImGui::GetIO();
    if (ImGui::IsMousePosValid(&io.MousePos)) {
        int x, y;
        SDL_GetMouseState(&x, &y);
        io.MousePos = ImVec2((float)x, (float)y);
    }
}

/** @return Whether a window belongs to a list that is open. */
static bool is_of_list(const ImGuiWindow *window) {
    while (window && !(window->Flags & ImGuiWindowFlags_Popup)) {
        window = window->ParentWindow;
    }
    return window != nullptr;
}

/**
 * Closes the list that is open when another widget is clicked, so that this click does what it does
 * without the list. Dear ImGui itself would only close the list, and the click would be lost.
 */
static void close_list_for_click(const Gui *gui) {
    const ImGuiContext &context = *ImGui::GetCurrentContext();
    bool is_open = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
    bool is_elsewhere = context.HoveredWindow && !is_of_list(context.HoveredWindow) &&
                        !gui->list_opener.Contains(context.IO.MousePos);
    if (is_open && is_elsewhere && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        ImGui::ClosePopupsOverWindow(nullptr, false);
        ImGui::FocusWindow(nullptr); // A list with the focus would still take the click.
    }
}

void gui_begin_frame(Gui *gui, float text_size) {
    ImGui::SetCurrentContext(gui->context);
    ImGui_ImplSDL2_NewFrame();
    follow_mouse_events();
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
    gui->is_inspecting = gui->has_bar = gui->is_number_chosen = false;
    ImGui::NewFrame();
    follow_mouse_rest(&gui->rest);
    if (gui->closes_list) {
        ImGui::ClosePopupsOverWindow(nullptr, false);
        gui->closes_list = false;
    }
    close_list_for_click(gui);
}

void gui_end_frame(Gui *gui) {
    ImGui::Render();
    if ((gui->keyboard == GUI_INSPECTOR && !gui->is_inspecting) ||
        (gui->keyboard == GUI_BAR && !gui->has_bar)) {
        take_keyboard(gui);
    }
    update_text_input(gui);
    const ImDrawData *data = ImGui::GetDrawData();
    if (gui->letters) {
        draw_frame(gui->renderer, data, &gui->kept);
    }
    gui->due_frames -= gui->due_frames > 0;
    gui->has_new_key = false;
}

void gui_request_frames(Gui *gui) {
    if (gui) {
        gui->due_frames = FRAMES_PER_EVENT;
    }
}

double gui_timeout(const Gui *gui, double now) {
    return gui && gui->rest.due_time > 0 ? fmax(0, gui->rest.due_time - now) : HUGE_VAL;
}

bool gui_has_mouse() {
    return ImGui::GetIO().WantCaptureMouse;
}

bool gui_mouse_has_moved() {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    return moved.x != 0 || moved.y != 0;
}

bool gui_is_mouse_released() {
    return ImGui::IsMouseReleased(ImGuiMouseButton_Left);
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

void gui_record_texts(Gui *gui, bool is_wanted) {
    gui->records_texts = is_wanted;
}

size_t gui_texts(const Gui *gui, const GuiText **texts) {
    *texts = gui->texts.Data;
    return static_cast<size_t>(gui->texts.Size);
}

} // extern "C"
