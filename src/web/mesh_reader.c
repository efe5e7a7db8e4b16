/**
 * @file
 * @brief The mesh module of the page: it runs the program of models/reader.c. It stands in for
 * dioptre-meshes.so.
 */
#include "web/mesh_reader.h"

#include "web/models.h"

#include <emscripten.h>
#include <libintl.h>
#include <stdio.h>
#include <stdlib.h>

/** Where the page puts the program. */
static const char READER_PATH[] = "/dioptre/models.wasm";
/** Triangles between two reports of progress. */
enum { PROGRESS_INTERVAL = 4096 };
/** Fraction of the work that is done when the triangles are there. */
static const double READ_FRACTION = 0.5;

/** What run_reader() returns if the program fails. */
#define READER_FAILED ((ModelTriangles *)(intptr_t)-1)

/**
 * Runs the program, whose bytes are given, on a model file: its format and its bytes. The program
 * has no system: each of its calls of one gets 0. What it does wrong ends it. It gives the
 * triangles, to be freed; NULL without memory; #READER_FAILED.
 */
EM_JS(
    ModelTriangles *, run_reader,
    (const char *program, size_t program_size, const char *extension, const char *bytes,
     size_t size),
    {
        try {
            var compiled = new WebAssembly.Module(HEAPU8.slice(program, program + program_size));
            var imports = {};
            WebAssembly.Module.imports(compiled).forEach(function(entry) {
                imports[entry.module] = imports[entry.module] || {};
                imports[entry.module][entry.name] = function() {
                    return 0;
                };
            });
            var reader = new WebAssembly.Instance(compiled, imports).exports;
            if (reader._initialize) {
                reader._initialize();
            }
            var put = function(from, length) {
                var to = reader.malloc(length);
                new Uint8Array(reader.memory.buffer).set(HEAPU8.subarray(from, from + length), to);
                return to;
            };
            var name = put(extension, 8);
            var model = reader.models_read(name, put(bytes, size), size);
            var length = model ? reader.models_size(model) : 0;
            var copy = length ? _malloc(length) : 0;
            if (copy) {
                HEAPU8.set(new Uint8Array(reader.memory.buffer, model, length), copy);
            }
            return copy;
        } catch (error) {
            console.log("a model: " + error);
            return -1;
        }
    });

/** Reads the bytes of the program. @param[out] size Their number. @return The bytes, to be freed;
 *  NULL: it is not there. */
static char *load_reader(size_t *size) {
    FILE *file = fopen(READER_PATH, "rb");
    if (!file) {
        return NULL;
    }
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char *bytes = malloc(*size);
    if (bytes && fread(bytes, 1, *size, file) != *size) {
        free(bytes);
        bytes = NULL;
    }
    fclose(file);
    return bytes;
}

/** Passes triangles to the sink. @return Whether it took all. */
static bool emit_triangles(const ModelTriangles *model, const MeshSink *sink) {
    for (size_t i = 0; i < model->count; i++) {
        if (!sink->add_triangle(sink->context, &model->corners[3 * i])) {
            return false;
        }
        if (i % PROGRESS_INTERVAL == 0) {
            double fraction = (double)i / model->count;
            sink->report_progress(sink->context, READ_FRACTION + (1 - READ_FRACTION) * fraction);
        }
    }
    return true;
}

/** Sets the message of a result. @return false, always. */
static bool set_message(MeshImportResult *result, const char *text) {
    snprintf(result->message, sizeof result->message, "%s", text);
    return false;
}

/** Reads a model file. See #MeshPlugin.read. */
static bool read_model(const MeshSource *source, const MeshSink *sink, MeshImportResult *result) {
    size_t size = 0;
    char extension[8];
    snprintf(extension, sizeof extension, "%s", source->extension);
    *result = (MeshImportResult){0};
    char *program = load_reader(&size);
    if (!program) {
        return set_message(result, gettext("the page could not fetch what reads such models"));
    }
    ModelTriangles *model = run_reader(program, size, extension, source->bytes, source->size);
    free(program);
    if (model == READER_FAILED) {
        return set_message(result, gettext("the library that reads models does not say why not"));
    }
    if (!model) {
        return set_message(result, gettext("it needs more memory than a model may take"));
    }
    *result = model->result;
    bool is_read = model->is_read && emit_triangles(model, sink);
    if (result->message[0]) {
        set_message(result, gettext(model->result.message));
    }
    free(model);
    return is_read;
}

const MeshPlugin web_mesh_plugin = {.version = MESH_PLUGIN_VERSION, .read = read_model};
