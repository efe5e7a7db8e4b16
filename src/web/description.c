/**
 * @file
 * @brief What the picture of the window shows, as JSON: the page makes words of it, for those who
 * do not see it.
 */
#include "web/description.h"

#include "base/json.h"
#include "dioptre/scene_words.h"

#include <libintl.h>
#include <stdlib.h>

/** Most classes of shapes. */
enum { CLASSES_MAXIMUM = 64 };
/** Significant digits of coordinates. */
enum { DIGITS = 3 };

/** Writes how many shapes there are of each class, and of which materials. */
static void write_shapes(const Scene *scene, JsonWriter *json) {
    size_t counts[CLASSES_MAXIMUM] = {0}, mirrors = 0, glass = 0;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const SceneMaterial *material = &scene->materials[scene->shapes[i].material_index];
        bool is_glass = scene_material_is_transparent(material);
        counts[scene->shapes[i].class_index]++;
        glass += is_glass;
        mirrors += !is_glass && scene_material_is_reflective(material);
    }
    json_object_begin(json, "shapes");
    for (size_t kind = 0; scene_shape_keywords[kind]; kind++) {
        if (counts[kind]) {
            json_count(json, scene_word(scene_shape_keywords[kind]->name), counts[kind]);
        }
    }
    json_object_end(json);
    json_count(json, "mirrors", mirrors);
    json_count(json, "glass", glass);
    json_count(json, "lights", scene->light_count);
}

/** Writes the shape in the middle of the picture; none where there is none. */
static void write_middle(const Scene *scene, const Viewport *viewport, JsonWriter *json) {
    PixelReading reading;
    if (renderer_read_pixel(viewport->renderer, viewport->width / 2, viewport->height / 2,
                            &reading) &&
        reading.shape >= 0 && (size_t)reading.shape < scene->shape_count) {
        size_t kind = scene->shapes[reading.shape].class_index;
        json_string(json, "middle", scene_word(scene_shape_keywords[kind]->name));
    }
}

char *description_write(App *app) {
    const Viewport *viewport = window_active_viewport(&app->window);
    const Scene *scene = app->scene;
    char *text = NULL;
    size_t size = 0;
    JsonWriter json = {.stream = open_memstream(&text, &size)};
    if (!json.stream) {
        return NULL;
    }
    json_object_begin(&json, NULL);
    write_shapes(scene, &json);
    json_numbers(&json, "position", &scene->camera.position.x, 3, DIGITS);
    json_numbers(&json, "direction", &scene->camera.direction.x, 3, DIGITS);
    json_string(&json, "layer",
                viewport->layer == LAYER_SHADED ? "" : gettext(layer_name(viewport->layer)));
    write_middle(scene, viewport, &json);
    json_object_end(&json);
    fclose(json.stream);
    return text;
}
