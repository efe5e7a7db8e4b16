/**
 * @file
 * @brief The picture module: OpenImageIO behind a border of plain C.
 *
 * Inside, what goes wrong is thrown; at the border, `guarded` turns it into words. Nothing is read
 * of a file before its header was found to be sound, as OpenImageIO 2.4's own limits do not hold.
 */
#include "assets/images_module.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdarg>
#include <cstring>
#include <libintl.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/** Colours of a pixel as they are handed over. */
constexpr int channels = 3;
/** Most channels of a file: red, green, blue and opacity. */
constexpr int channels_maximum = 4;
/** Rows read at once where the file does not cut itself into tiles: some hundred kilobytes. */
constexpr int plain_band = 32;
/** Highest tiles that are read: any real file's are 64 or so. */
constexpr int tile_maximum = 1024;
/** The date in a file: none, as the same picture should give the same bytes. */
constexpr const char *no_date = "";

/**
 * Puts words into a message, in one line: OpenImageIO ends each of its sentences with a newline.
 * @param[out] message  The message.
 * @param words         The words.
 */
void tell(ImagesMessage *message, std::string words) {
    words.erase(words.find_last_not_of('\n') + 1);
    std::replace(words.begin(), words.end(), '\n', ';');
    size_t length = words.copy(message->text, IMAGES_MESSAGE_SIZE - 1);
    message->text[length] = '\0';
}

/**
 * Does some work at the border to C: whatever is thrown ends here.
 * @param[out] message  What is wrong.
 * @param work          The work.
 * @return What the work returns; false or NULL if anything is wrong.
 */
template <class Work> auto guarded(ImagesMessage *message, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc &) {
        tell(message, gettext("no memory"));
    } catch (const std::exception &problem) {
        tell(message, problem.what());
    } catch (...) {
        tell(message, gettext("OpenImageIO failed without saying why"));
    }
    return {};
}

/**
 * Stops the work.
 * @param words  What is wrong, or empty.
 */
[[noreturn]] void fail(const std::string &words) {
    throw std::runtime_error(words.empty() ? gettext("OpenImageIO does not say why") : words);
}

/**
 * @return Words without the path that a file was opened by: who reads them knows its name.
 * @param words  The words.
 * @param path   The path.
 */
std::string without_path(std::string words, const std::string &path) {
    const std::string quoted = "\"" + path + "\"";
    for (size_t at; (at = words.find(quoted)) != std::string::npos;) {
        words.replace(at, quoted.size(), gettext("the file"));
    }
    return words;
}

/**
 * Tells OpenImageIO to start no threads and to load no plugins. Threads would be missing, and be
 * waited for in vain, in the child process that reads pictures.
 */
void set_up() {
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1); // None at all; 0 would be one a core.
    OIIO::attribute("plugin_searchpath", "");
}

/**
 * @return What is said of a file to be written.
 * @param format  The format.
 * @param source  The picture.
 */
OIIO::ImageSpec describe(const std::string &format, const ImagesSource &source) {
    OIIO::TypeDesc type = source.light ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    OIIO::ImageSpec spec(source.width, source.height, channels, type);
    for (const PictureNote *note = source.notes; note->name; note++) {
        spec.attribute(note->name, note->value);
    }
    if (format == "jpeg") {
        spec.attribute("jpeg:subsampling", "4:4:4"); // Colour as sharp as brightness.
    }
    if (format == "tiff" || format == "openexr") {
        spec.attribute("DateTime", no_date); // Otherwise they put in the time of day.
    }
    return spec;
}

/**
 * Writes the rows of a picture.
 * @param output  The open file.
 * @param source  The picture.
 */
void write_rows(OIIO::ImageOutput &output, const ImagesSource &source) {
    size_t size = static_cast<size_t>(source.width) * channels;
    for (int y = 0; y < source.height; y++) {
        size_t first = static_cast<size_t>(y) * size;
        bool is_written =
            source.light ? output.write_scanline(y, 0, OIIO::TypeDesc::FLOAT, source.light + first)
                         : output.write_scanline(y, 0, OIIO::TypeDesc::UINT8, source.steps + first);
        if (!is_written) {
            fail(output.geterror());
        }
    }
}

/**
 * Puts notes into the header of a Radiance file, as lines of comment: OpenImageIO writes none.
 * @param source          The picture.
 * @param[in,out] bytes   The file; its header begins with one line that says what it is.
 */
void add_comments(const ImagesSource &source, std::vector<unsigned char> &bytes) {
    std::string comments;
    for (const PictureNote *note = source.notes; note->name; note++) {
        comments += std::string("# ") + note->name + "=" + note->value + "\n";
    }
    auto first_line = std::find(bytes.begin(), bytes.end(), '\n');
    if (first_line != bytes.end()) {
        bytes.insert(first_line + 1, comments.begin(), comments.end());
    }
}

/**
 * Makes a file of a picture; throws what goes wrong.
 * @param format      The format.
 * @param source      The picture.
 * @param[out] bytes  The file.
 */
void encode_into(const char *format, const ImagesSource &source,
                 std::vector<unsigned char> &bytes) {
    set_up();
    std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) {
        fail(OIIO::geterror());
    }
    OIIO::Filesystem::IOVecOutput memory(bytes);
    if (!output->set_ioproxy(&memory) || !output->open(format, describe(format, source))) {
        fail(output->geterror());
    }
    write_rows(*output, source);
    if (!output->close()) {
        fail(output->geterror());
    }
    if (std::strcmp(format, "hdr") == 0) {
        add_comments(source, bytes);
    }
}

/**
 * Is ImagesModule::encode: makes a file of a picture.
 * @param format        The format.
 * @param source        The picture.
 * @param[out] file     The file.
 * @param[out] message  What is wrong.
 * @return Whether it was made.
 */
bool encode(const char *format, const ImagesSource *source, ImagesFile *file,
            ImagesMessage *message) {
    *file = {};
    return guarded(message, [&] {
        auto bytes = std::make_unique<std::vector<unsigned char>>();
        encode_into(format, *source, *bytes);
        *file = {bytes->data(), bytes->size(), bytes.get()};
        bytes.release(); // From here on owned by the file.
        return true;
    });
}

/** Is ImagesModule::release. @param file The file whose memory is given back. */
void release(ImagesFile *file) {
    delete static_cast<std::vector<unsigned char> *>(file->owner);
    *file = {};
}

/**
 * @return A sentence with numbers in it.
 * @param format  The sentence, as for printf.
 */
__attribute__((format(printf, 1, 2))) std::string sentence(const char *format, ...) {
    char words[IMAGES_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    return words;
}

/** Stops the work unless a header is sound. @param spec What OpenImageIO says of the file. */
void check_header(const OIIO::ImageSpec &spec) {
    if (spec.width < 1 || spec.width > IMAGES_SIZE_MAXIMUM || spec.height < 1 ||
        spec.height > IMAGES_SIZE_MAXIMUM || spec.depth > 1) {
        fail(sentence(gettext("%d x %d x %d pixels: width and height must be 1 to %d, depth 1"),
                      spec.width, spec.height, spec.depth, IMAGES_SIZE_MAXIMUM));
    }
    if (spec.nchannels < 1 || spec.nchannels > channels_maximum || spec.deep) {
        fail(sentence(gettext("it has %d channels a pixel, not 1 to 4"), spec.nchannels));
    }
    if (spec.tile_height > tile_maximum) {
        fail(sentence(gettext("it is cut into tiles %d rows high"), spec.tile_height));
    }
}

} // namespace

/** A picture file that is open. */
struct ImagesReader {
    std::unique_ptr<OIIO::ImageInput> input; /**< The file. */
    OIIO::ImageSpec spec;                    /**< Its header. */
};

namespace {

/**
 * Opens a picture file and checks its header; throws what goes wrong.
 * @param path    The file.
 * @param format  The format.
 * @return The open file.
 */
std::unique_ptr<ImagesReader> open_checked(const char *path, const char *format) {
    set_up();
    auto reader = std::make_unique<ImagesReader>();
    reader->input = OIIO::ImageInput::create(format);
    if (!reader->input) {
        fail(OIIO::geterror());
    }
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1); // Colours as stored, not darkened by opacity.
    if (!reader->input->open(path, reader->spec, wishes)) {
        fail(without_path(reader->input->geterror(), path));
    }
    check_header(reader->spec);
    return reader;
}

/** @return What the numbers of a file are. @param type Their type. */
ImagesKind kind_of(OIIO::TypeDesc type) {
    if (type.is_floating_point()) {
        return IMAGES_LIGHT;
    }
    return type == OIIO::TypeDesc::UINT8 ? IMAGES_STEPS : IMAGES_FINE;
}

/**
 * Is ImagesModule::open: opens a picture file.
 * @param path          The file.
 * @param format        The format.
 * @param[out] header   What is known of it.
 * @param[out] message  What is wrong.
 * @return The open file, or NULL.
 */
ImagesReader *open(const char *path, const char *format, ImagesHeader *header,
                   ImagesMessage *message) {
    return guarded(message, [&] {
        std::unique_ptr<ImagesReader> reader = open_checked(path, format);
        const OIIO::ImageSpec &spec = reader->spec;
        int band = spec.tile_width > 0 ? std::max(spec.tile_height, 1) : plain_band;
        *header = {spec.width, spec.height, kind_of(spec.format), band};
        return reader.release();
    });
}

/**
 * Reads a band of rows, all three colours; throws what goes wrong.
 * @tparam Sample     Type of a colour: uint8_t or float.
 * @param reader      The open file.
 * @param first       First row.
 * @param count       How many rows.
 * @param type        The same type, as OpenImageIO names it.
 * @param[out] rgb    Their pixels.
 */
template <class Sample>
void read_band(ImagesReader &reader, int first, int count, OIIO::TypeDesc type, Sample *rgb) {
    const OIIO::ImageSpec &spec = reader.spec;
    int colors = spec.nchannels < channels ? 1 : channels; // One, or one and opacity: grey.
    int y = spec.y + first;
    OIIO::stride_t pixel = channels * sizeof(Sample);
    OIIO::stride_t row = pixel * spec.width;
    bool is_read =
        spec.tile_width > 0
            ? reader.input->read_tiles(0, 0, spec.x, spec.x + spec.width, y, y + count, spec.z,
                                       spec.z + 1, 0, colors, type, rgb, pixel, row)
            : reader.input->read_scanlines(0, 0, y, y + count, spec.z, 0, colors, type, rgb, pixel,
                                           row);
    if (!is_read) {
        fail(reader.input->geterror());
    }
    if (colors == 1) {
        size_t size = static_cast<size_t>(spec.width) * static_cast<size_t>(count) * channels;
        for (size_t i = 0; i < size; i += channels) {
            rgb[i + 1] = rgb[i + 2] = rgb[i];
        }
    }
}

/**
 * Is ImagesModule::read_steps: reads a band of rows as encoded steps.
 * @param reader        The open file.
 * @param first         First row.
 * @param count         How many rows.
 * @param[out] rgb      Their pixels.
 * @param[out] message  What is wrong.
 * @return Whether they were read.
 */
bool read_steps(ImagesReader *reader, int first, int count, uint8_t *rgb, ImagesMessage *message) {
    return guarded(message, [&] {
        read_band(*reader, first, count, OIIO::TypeDesc::UINT8, rgb);
        return true;
    });
}

/**
 * Is ImagesModule::read_light: reads a band of rows of the finer kinds.
 * @param reader        The open file.
 * @param first         First row.
 * @param count         How many rows.
 * @param[out] rgb      Their pixels.
 * @param[out] message  What is wrong.
 * @return Whether they were read.
 */
bool read_light(ImagesReader *reader, int first, int count, float *rgb, ImagesMessage *message) {
    return guarded(message, [&] {
        read_band(*reader, first, count, OIIO::TypeDesc::FLOAT, rgb);
        return true;
    });
}

/** Is ImagesModule::close. @param reader The file to be closed, or NULL. */
void close(ImagesReader *reader) {
    delete reader;
}

} // namespace

/** The one thing of the module that is seen from outside: #IMAGES_MODULE_SYMBOL. */
extern "C" __attribute__((visibility("default"))) const ImagesModule dioptre_images_module = {
    IMAGES_MODULE_VERSION, encode, release, open, read_steps, read_light, close,
};
