/**
 * @file
 * @brief Drawing a frame: letters and triangles of Dear ImGui, and panels that are kept as
 * pictures.
 *
 * SDL's software renderer needs 2 ms for the triangles of the toolbar and 0.1 ms for its picture.
 * Most panels are the same in most frames, so each is drawn into a picture of its own, which stays
 * until a triangle of it changes. A graphics card draws triangles at once and keeps nothing.
 */
#include "view/gui/gui_draw.h"

#include <climits>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <imgui_internal.h>
#include <new>

namespace {

/** Largest part of the window that a kept panel covers: a larger one hides what moves, and its
 *  picture would take more memory and time than it saves. */
constexpr float KEPT_AREA_MAXIMUM = 0.34F;
/** Steps per pixel in which SDL's software renderer places corners. */
constexpr float STEPS_PER_PIXEL = 2;

/**
 * @return The largest triangle, twice its area, that SDL's software renderer can fill from a
 * texture. It multiplies that number, in its steps, by the place in the texture, and the product
 * must not leave an int: with the panels of a screen of 3840x2160 it did, and what was read lay
 * beside the texture.
 */
float largest_textured(SDL_Texture *texture) {
    int width = 1, height = 1;
    SDL_QueryTexture(texture, nullptr, nullptr, &width, &height);
    return static_cast<float>(INT_MAX) / (STEPS_PER_PIXEL * STEPS_PER_PIXEL) /
           static_cast<float>(width > height ? width : height);
}

/** @return Whether a triangle is larger than that and has one colour: it needs no texture. @param
 *  vertices Those of its command. @param index Its three indices. */
bool needs_no_texture(const ImDrawVert *vertices, const ImDrawIdx *index, float largest) {
    const ImDrawVert &a = vertices[index[0]], &b = vertices[index[1]], &c = vertices[index[2]];
    const float area =
        (b.pos.x - a.pos.x) * (c.pos.y - a.pos.y) - (b.pos.y - a.pos.y) * (c.pos.x - a.pos.x);
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    const auto is_white = [white](const ImDrawVert &vertex) {
        return vertex.uv.x == white.x && vertex.uv.y == white.y;
    };
    return fabsf(area) > largest && is_white(a) && is_white(b) && is_white(c);
}

/** Draws some triangles of a command. @param texture Null: their colours alone. @param first Index
 * of their first corner. @param count Number of corners. */
void draw_run(SDL_Renderer *renderer, const ImDrawList *list, const ImDrawCmd &command,
              SDL_Texture *texture, unsigned first, unsigned count) {
    const char *vertices = reinterpret_cast<const char *>(list->VtxBuffer.Data + command.VtxOffset);
    if (count > 0) {
        SDL_RenderGeometryRaw(
            renderer, texture,
            reinterpret_cast<const float *>(vertices + offsetof(ImDrawVert, pos)),
            sizeof(ImDrawVert),
            reinterpret_cast<const SDL_Color *>(vertices + offsetof(ImDrawVert, col)),
            sizeof(ImDrawVert),
            reinterpret_cast<const float *>(vertices + offsetof(ImDrawVert, uv)),
            sizeof(ImDrawVert), static_cast<int>(list->VtxBuffer.Size - command.VtxOffset),
            list->IdxBuffer.Data + command.IdxOffset + first, static_cast<int>(count),
            sizeof(ImDrawIdx));
    }
}

/** Draws the triangles of a list, units of the window. */
void draw_triangles(SDL_Renderer *renderer, const ImDrawList *list) {
    SDL_BlendMode blending = SDL_BLENDMODE_NONE;
    SDL_GetRenderDrawBlendMode(renderer, &blending);
    SDL_SetRenderDrawBlendMode(renderer, SDL_BLENDMODE_BLEND); // Of triangles without a texture.
    for (const ImDrawCmd &command : list->CmdBuffer) {
        const ImVec4 &clip = command.ClipRect;
        SDL_Rect rect = {static_cast<int>(clip.x), static_cast<int>(clip.y),
                         static_cast<int>(clip.z - clip.x), static_cast<int>(clip.w - clip.y)};
        auto *texture = static_cast<SDL_Texture *>(command.GetTexID());
        const float largest = largest_textured(texture);
        const ImDrawVert *vertices = list->VtxBuffer.Data + command.VtxOffset;
        const ImDrawIdx *indices = list->IdxBuffer.Data + command.IdxOffset;
        SDL_RenderSetClipRect(renderer, &rect);
        unsigned first = 0;
        bool was_plain = false;
        for (unsigned i = 0; i < command.ElemCount; i += 3) {
            const bool is_plain = needs_no_texture(vertices, indices + i, largest);
            if (is_plain != was_plain) {
                draw_run(renderer, list, command, was_plain ? nullptr : texture, first, i - first);
                first = i;
            }
            was_plain = is_plain;
        }
        draw_run(renderer, list, command, was_plain ? nullptr : texture, first,
                 command.ElemCount - first);
    }
    SDL_RenderSetClipRect(renderer, nullptr);
    SDL_SetRenderDrawBlendMode(renderer, blending);
}

/** Finds what a list covers. @return false if it covers nothing. */
bool find_rect(const ImDrawList *list, ImVec2 display, SDL_Rect *rect) {
    ImRect bounds(display, ImVec2(0, 0));
    for (const ImDrawVert &vertex : list->VtxBuffer) {
        bounds.Add(vertex.pos);
    }
    ImRect clips(display, ImVec2(0, 0));
    for (const ImDrawCmd &command : list->CmdBuffer) {
        clips.Add(ImRect(command.ClipRect));
    }
    bounds.ClipWith(clips);
    bounds.ClipWith(ImRect(ImVec2(0, 0), display));
    rect->x = static_cast<int>(bounds.Min.x);
    rect->y = static_cast<int>(bounds.Min.y);
    rect->w = static_cast<int>(ceilf(bounds.Max.x)) - rect->x;
    rect->h = static_cast<int>(ceilf(bounds.Max.y)) - rect->y;
    return rect->w > 0 && rect->h > 0;
}

/** @return Whether a list is a small panel with nothing but letters and shapes: other pictures, as
 *  in the list of scenes, change under the same triangles. */
bool is_kept(const ImDrawData *data, const ImDrawList *list, const SDL_Rect &rect) {
    float area = static_cast<float>(rect.w) * static_cast<float>(rect.h);
    // Marks and rings lie anywhere on the picture, and move with it.
    bool is_panel =
        list != ImGui::GetBackgroundDrawList() && list != ImGui::GetForegroundDrawList();
    bool has_pictures = false;
    for (const ImDrawCmd &command : list->CmdBuffer) {
        has_pictures = has_pictures || command.GetTexID() != ImGui::GetIO().Fonts->TexID;
    }
    return is_panel && !has_pictures &&
           area <= KEPT_AREA_MAXIMUM * data->DisplaySize.x * data->DisplaySize.y;
}

/** @return Whether two vectors hold the same bytes. */
template <typename Type> bool is_same(const ImVector<Type> &a, const ImVector<Type> &b) {
    return a.Size == b.Size && memcmp(a.Data, b.Data, static_cast<size_t>(a.size_in_bytes())) == 0;
}

/** @return The picture that is kept of a list; a new one is empty; null: no memory. */
KeptPanel *find_panel(KeptPanel **kept, const ImDrawList *list) {
    while (*kept && (*kept)->list != list) {
        kept = &(*kept)->next;
    }
    if (!*kept) {
        *kept = new (std::nothrow) KeptPanel();
        if (*kept) {
            (*kept)->list = list;
        }
    }
    return *kept;
}

/** Frees the first of a list of panels. @return The others. */
KeptPanel *free_panel(KeptPanel *panel) {
    KeptPanel *next = panel->next;
    if (panel->picture) {
        SDL_DestroyTexture(panel->picture);
    }
    delete panel;
    return next;
}

/** Makes colours that are multiplied by their opacity, as drawing on nothing leaves them, plain
 *  ones, as SDL blends them. */
void divide_by_opacity(Uint32 *pixels, size_t count) {
    for (size_t i = 0; i < count; i++) {
        Uint32 opacity = pixels[i] >> 24, color = 0;
        for (int shift = 0; shift < 24 && opacity > 0; shift += 8) {
            Uint32 channel = ((pixels[i] >> shift & 255) * 255 + opacity / 2) / opacity;
            color |= (channel < 255 ? channel : 255) << shift;
        }
        pixels[i] = opacity << 24 | color;
    }
}

/** Draws a panel on nothing. @return false if SDL failed. */
bool draw_picture(SDL_Renderer *renderer, KeptPanel *panel) {
    const SDL_Rect &rect = panel->rect;
    const int pitch = 4 * rect.w;
    const size_t count = static_cast<size_t>(rect.w) * static_cast<size_t>(rect.h);
    Uint32 *pixels = static_cast<Uint32 *>(SDL_malloc(4 * count));
    SDL_Rect viewport = {-rect.x, -rect.y, rect.x + rect.w, rect.y + rect.h};
    bool is_drawn = pixels && SDL_SetRenderTarget(renderer, panel->picture) == 0;
    if (is_drawn) {
        SDL_SetRenderDrawColor(renderer, 0, 0, 0, 0);
        SDL_RenderClear(renderer);
        SDL_RenderSetViewport(renderer, &viewport);
        draw_triangles(renderer, panel->list);
        SDL_RenderSetViewport(renderer, nullptr);
        is_drawn =
            SDL_RenderReadPixels(renderer, nullptr, SDL_PIXELFORMAT_ARGB8888, pixels, pitch) == 0;
        SDL_SetRenderTarget(renderer, nullptr);
    }
    if (is_drawn) {
        divide_by_opacity(pixels, count);
        is_drawn = SDL_UpdateTexture(panel->picture, nullptr, pixels, pitch) == 0;
    }
    SDL_free(pixels);
    return is_drawn;
}

/** Draws a panel anew that has changed. @return false if SDL failed. */
bool update_panel(SDL_Renderer *renderer, KeptPanel *panel, const SDL_Rect &rect) {
    const ImDrawList *list = panel->list;
    if (panel->picture && is_same(panel->vertices, list->VtxBuffer) &&
        is_same(panel->indices, list->IdxBuffer) && is_same(panel->commands, list->CmdBuffer)) {
        return true;
    }
    if (panel->picture && (panel->rect.w != rect.w || panel->rect.h != rect.h)) {
        SDL_DestroyTexture(panel->picture);
        panel->picture = nullptr;
    }
    if (!panel->picture) {
        panel->picture = SDL_CreateTexture(renderer, SDL_PIXELFORMAT_ARGB8888,
                                           SDL_TEXTUREACCESS_TARGET, rect.w, rect.h);
    }
    panel->rect = rect;
    panel->vertices = list->VtxBuffer;
    panel->indices = list->IdxBuffer;
    panel->commands = list->CmdBuffer;
    bool is_drawn = panel->picture && draw_picture(renderer, panel);
    if (!is_drawn && panel->picture) {
        SDL_DestroyTexture(panel->picture);
        panel->picture = nullptr;
    }
    return is_drawn;
}

/** Shows a list by its picture. @return false if it is none to be kept, or SDL failed. */
bool show_panel(SDL_Renderer *renderer, const ImDrawData *data, const ImDrawList *list,
                KeptPanel **kept) {
    SDL_Rect rect;
    if (!find_rect(list, data->DisplaySize, &rect) || !is_kept(data, list, rect)) {
        return false;
    }
    KeptPanel *panel = find_panel(kept, list);
    if (!panel || !update_panel(renderer, panel, rect)) {
        return false;
    }
    panel->is_shown = true;
    SDL_SetTextureBlendMode(panel->picture, SDL_BLENDMODE_BLEND);
    return SDL_RenderCopy(renderer, panel->picture, nullptr, &panel->rect) == 0;
}

/** Frees the panels that the frame has not shown. */
void forget_hidden(KeptPanel **kept) {
    while (*kept) {
        bool is_shown = (*kept)->is_shown;
        (*kept)->is_shown = false;
        if (is_shown) {
            kept = &(*kept)->next;
        } else {
            *kept = free_panel(*kept);
        }
    }
}

} // namespace

void draw_frame(SDL_Renderer *renderer, const ImDrawData *data, KeptPanel **kept) {
    ImVec2 scale = data->FramebufferScale;
    SDL_RendererInfo info;
    bool keeps_panels = SDL_GetRendererInfo(renderer, &info) == 0 &&
                        (info.flags & SDL_RENDERER_SOFTWARE) && scale.x == 1 && scale.y == 1;
    SDL_RenderSetScale(renderer, scale.x, scale.y);
    for (int i = 0; i < data->CmdListsCount; i++) {
        const ImDrawList *list = data->CmdLists[i];
        if (!keeps_panels || !show_panel(renderer, data, list, kept)) {
            draw_triangles(renderer, list);
        }
    }
    SDL_RenderSetScale(renderer, 1, 1);
    forget_hidden(kept);
}

void forget_panels(KeptPanel **kept) {
    while (*kept) {
        *kept = free_panel(*kept);
    }
}
