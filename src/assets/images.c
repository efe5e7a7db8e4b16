/**
 * @file
 * @brief Opens the picture module and moves pictures across its border.
 */
#include "assets/images.h"

#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** File name of the module. */
#define MODULE_FILE "dioptre-images.so"
/** Where the module is installed, seen from the folder of the program. */
#define INSTALLED_FOLDER "../lib/dioptre"
/** What still works without the module. */
#define BMP_WORKS "names that end in .bmp work without it"

/** Bytes a pixel in a #Picture. */
enum { CHANNELS = 3 };

/**
 * Forgets what the user's environment would have OpenImageIO load or do: whoever sends a scene to
 * a class must not choose which code runs there.
 */
static void forget_environment(void) {
    unsetenv("OIIO_LIBRARY_PATH");
    unsetenv("OPENIMAGEIO_OPTIONS");
}

/**
 * Finds the module's one symbol.
 * @param handle      The open module.
 * @param[out] error  What is wrong.
 * @return The module; NULL when it is not of this program's version.
 */
static const ImagesModule *find_symbol(void *handle, Error *error) {
    const ImagesModule *module = dlsym(handle, IMAGES_MODULE_SYMBOL);
    if (!module || module->version != IMAGES_MODULE_VERSION) {
        error_set(error, STATUS_FAILED,
                  "%s is of another version of this program: run make again; " BMP_WORKS,
                  MODULE_FILE);
        return NULL;
    }
    return module;
}

/**
 * Says whether the module is in a folder.
 * @param folder  The folder.
 * @return Whether it is, and can be read.
 */
static bool has_module(const char *folder) {
    char path[PATH_MAX];
    return snprintf(path, sizeof path, "%s/%s", folder, MODULE_FILE) < PATH_MAX &&
           access(path, R_OK) == 0;
}

const ImagesModule *images_load_from(const char *folder, Error *error) {
    if (!has_module(folder)) {
        error_set(error, STATUS_FAILED,
                  "all formats but BMP need the module %s, which is not in %s: install "
                  "libopenimageio-dev and run make; " BMP_WORKS,
                  MODULE_FILE, folder);
        return NULL;
    }
    char path[PATH_MAX];
    snprintf(path, sizeof path, "%s/%s", folder, MODULE_FILE);
    forget_environment();
    void *handle = dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!handle) {
        error_set(error, STATUS_FAILED,
                  "all formats but BMP need OpenImageIO, which cannot be loaded (%s): install "
                  "libopenimageio2.4; " BMP_WORKS,
                  dlerror());
        return NULL;
    }
    const ImagesModule *module = find_symbol(handle, error);
    dlclose(handle); // It stays loaded all the same: RTLD_NODELETE.
    return module;
}

/**
 * Finds the folder of the program.
 * @param[out] folder  The folder, without a slash at its end.
 * @return false when it cannot be found or its name is too long.
 */
static bool find_program_folder(char folder[PATH_MAX]) {
    ssize_t length = readlink("/proc/self/exe", folder, PATH_MAX - 1);
    if (length < 0) {
        return false;
    }
    folder[length] = '\0';
    char *slash = strrchr(folder, '/');
    if (!slash) {
        return false;
    }
    *slash = '\0';
    return true;
}

const ImagesModule *images_load(Error *error) {
    char beside[PATH_MAX];
    char installed[PATH_MAX + sizeof INSTALLED_FOLDER];
    if (!find_program_folder(beside)) {
        error_set(error, STATUS_FAILED,
                  "the program's own folder, where %s should be, cannot be found; " BMP_WORKS,
                  MODULE_FILE);
        return NULL;
    }
    snprintf(installed, sizeof installed, "%s/" INSTALLED_FOLDER, beside);
    bool is_installed = !has_module(beside) && has_module(installed);
    return images_load_from(is_installed ? installed : beside, error);
}

/**
 * Makes a picture file in memory.
 * @param module      The module.
 * @param format      The format.
 * @param is_linear   Whether it holds linear light.
 * @param picture     The picture.
 * @param[out] file   The file, to be given back.
 * @param[out] error  What is wrong.
 * @return Whether it was made.
 */
static bool encode(const ImagesModule *module, const char *format, bool is_linear,
                   const Picture *picture, ImagesFile *file, Error *error) {
    float light[256];
    for (int step = 0; step <= UINT8_MAX; step++) {
        light[step] = (float)encoding_decode(picture->encoding, step);
    }
    ImagesSource source = {
        .width = picture->width,
        .height = picture->height,
        .steps = picture->pixels,
        .light = is_linear ? light : NULL,
    };
    ImagesMessage message;
    return module->encode(format, &source, file, &message) ||
           error_set(error, STATUS_FAILED, "%s", message.text);
}

bool images_write(const ImagesModule *module, const char *format, bool is_linear,
                  const Picture *picture, FILE *stream, Error *error) {
    ImagesFile file;
    if (!encode(module, format, is_linear, picture, &file, error)) {
        return false;
    }
    bool is_fine = fwrite(file.bytes, 1, file.size, stream) == file.size ||
                   error_set(error, STATUS_FAILED, "%s", strerror(errno));
    module->release(&file);
    return is_fine;
}

/** A picture that is being read, band by band. */
typedef struct Reading {
    const ImagesModule *module; /**< The module. */
    ImagesReader *reader;       /**< The open file. */
    ImagesHeader header;        /**< What is known of it. */
    Encoder encoder;            /**< For linear light. */
    float *light;               /**< Room for a band of linear light. */
    Picture *picture;           /**< Where the pixels go. */
} Reading;

/**
 * Reads a band of rows.
 * @param reading       The picture that is being read.
 * @param first         First row.
 * @param[out] message  What is wrong.
 * @return Whether it was read.
 */
static bool read_band(const Reading *reading, int first, ImagesMessage *message) {
    int left = reading->header.height - first;
    int count = left < reading->header.band ? left : reading->header.band;
    size_t row = (size_t)reading->header.width * CHANNELS;
    uint8_t *steps = reading->picture->pixels + (size_t)first * row;
    if (!reading->header.is_linear) {
        return reading->module->read_steps(reading->reader, first, count, steps, message);
    }
    if (!reading->module->read_light(reading->reader, first, count, reading->light, message)) {
        return false;
    }
    for (size_t i = 0; i < row * (size_t)count; i++) {
        steps[i] = encoder_encode(&reading->encoder, reading->light[i]);
    }
    return true;
}

/**
 * Reads all bands.
 * @param reading     The picture that is being read.
 * @param[out] error  What is wrong.
 * @return Whether all were read.
 */
static bool read_bands(const Reading *reading, Error *error) {
    ImagesMessage message;
    for (int first = 0; first < reading->header.height; first += reading->header.band) {
        if (!read_band(reading, first, &message)) {
            return error_set(error, STATUS_SCENE, "%s", message.text);
        }
    }
    return true;
}

/**
 * Takes the memory that a picture needs.
 * @param[in,out] reading  The picture that is being read, its header known.
 * @param[out] error       What is wrong.
 * @return false without memory.
 */
static bool take_memory(Reading *reading, Error *error) {
    const ImagesHeader *header = &reading->header;
    if (!picture_init(reading->picture, header->width, header->height, error)) {
        return false;
    }
    if (header->is_linear) {
        encoder_init(&reading->encoder, ENCODING_SRGB);
        size_t row = (size_t)header->width * CHANNELS * sizeof *reading->light;
        reading->light = calloc((size_t)header->band, row);
    }
    return !header->is_linear || reading->light || error_set(error, STATUS_FAILED, "no memory");
}

bool images_read(const ImagesModule *module, const char *format, const char *path, Picture *picture,
                 Error *error) {
    *picture = (Picture){0};
    ImagesMessage message;
    Reading reading = {.module = module, .picture = picture};
    reading.reader = module->open(path, format, &reading.header, &message);
    if (!reading.reader) {
        return error_set(error, STATUS_SCENE, "%s", message.text);
    }
    bool is_read = take_memory(&reading, error) && read_bands(&reading, error);
    free(reading.light);
    module->close(reading.reader);
    if (!is_read) {
        picture_release(picture);
    }
    return is_read;
}
