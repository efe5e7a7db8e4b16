/**
 * @file
 * @brief The picture module: OpenImageIO behind a border of plain C.
 *
 * Inside, what goes wrong is thrown; at the border, `catch_exceptions` turns it into words. Nothing
 * is read of a file before its header was found to be sound, as OpenImageIO 2.4's own limits do not
 * hold.
 */
#include "assets/images/image_plugin.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <libintl.h>
#include <memory>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

namespace {

/** Colours of a pixel as they are handed over. */
constexpr int channels = 3;
/** Most channels of a file: red, green, blue and opacity. */
constexpr int channels_maximum = 4;
/** Rows read at once where the file does not cut itself into tiles: some hundred kilobytes. */
constexpr int default_strip_rows = 32;
/** Highest tiles that are read: any real file's are 64 or so. */
constexpr int tile_height_maximum = 1024;
/** The date in a file: none, as the same picture should give the same bytes. */
constexpr const char *no_date = "";

/**
 * Puts words into a message, in one line: OpenImageIO ends each of its sentences with a newline.
 * @param[out] message  The message.
 * @param words         The words.
 */
void set_message(ImagePluginMessage *message, std::string words) {
    words.erase(words.find_last_not_of('\n') + 1);
    std::replace(words.begin(), words.end(), '\n', ';');
    size_t length = words.copy(message->text, IMAGE_PLUGIN_MESSAGE_SIZE - 1);
    message->text[length] = '\0';
}

/**
 * Does some work at the border to C: whatever is thrown ends here.
 * @param[out] message  What is wrong.
 * @param work          The work.
 * @return What the work returns; false or NULL if anything is wrong.
 */
template <class Work>
auto catch_exceptions(ImagePluginMessage *message, Work work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc &) {
        set_message(message, gettext("no memory"));
    } catch (const std::exception &problem) {
        set_message(message, problem.what());
    } catch (...) {
        set_message(message, gettext("OpenImageIO failed without saying why"));
    }
    return {};
}

/**
 * Stops the work.
 * @param words  What is wrong, or empty.
 */
[[noreturn]] void throw_error(const std::string &words) {
    throw std::runtime_error(words.empty() ? gettext("OpenImageIO does not say why") : words);
}

/** Name of any file for OpenImageIO, which puts it into messages and opens nothing of that name. */
constexpr const char *file_name = "file";

/**
 * @return Words without the name that OpenImageIO has for a file: who reads them knows its name.
 * @param words  The words.
 */
std::string without_name(std::string words) {
    const std::string quoted = std::string("\"") + file_name + "\"";
    for (size_t at; (at = words.find(quoted)) != std::string::npos;) {
        words.replace(at, quoted.size(), gettext("the file"));
    }
    return words;
}

/**
 * Tells OpenImageIO to use no threads and to load no plugins.
 * @return true.
 */
bool configure_library() {
    // Starts a thread for each other core, and ends them at once.
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1); // None at all; 0 would be one a core.
    OIIO::attribute("plugin_searchpath", "");
    return true;
}

/**
 * Whether OpenImageIO is configured: when this module is loaded, as a worker can start no threads
 * once it reads a file. Where the system has none left, the worker ends here.
 */
[[maybe_unused]] const bool is_configured = configure_library();

/**
 * @return What is said of a file to be written.
 * @param format  The format.
 * @param source  The picture.
 */
OIIO::ImageSpec make_spec(const std::string &format, const ImagePluginSource &source) {
    OIIO::TypeDesc type = source.linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
    OIIO::ImageSpec spec(source.width, source.height, channels, type);
    for (const MetadataEntry *note = source.metadata; note->name; note++) {
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
void write_rows(OIIO::ImageOutput &output, const ImagePluginSource &source) {
    size_t size = static_cast<size_t>(source.width) * channels;
    for (int y = 0; y < source.height; y++) {
        size_t first = static_cast<size_t>(y) * size;
        bool is_written =
            source.linear
                ? output.write_scanline(y, 0, OIIO::TypeDesc::FLOAT, source.linear + first)
                : output.write_scanline(y, 0, OIIO::TypeDesc::UINT8, source.encoded + first);
        if (!is_written) {
            throw_error(output.geterror());
        }
    }
}

/**
 * Puts notes into the header of a Radiance file, as lines of comment: OpenImageIO writes none.
 * @param source          The picture.
 * @param[in,out] bytes   The file; its header begins with one line that says what it is.
 */
void add_comments(const ImagePluginSource &source, std::vector<unsigned char> &bytes) {
    std::string comments;
    for (const MetadataEntry *note = source.metadata; note->name; note++) {
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
void encode_into(const char *format, const ImagePluginSource &source,
                 std::vector<unsigned char> &bytes) {
    std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(format);
    if (!output) {
        throw_error(OIIO::geterror());
    }
    OIIO::Filesystem::IOVecOutput memory(bytes);
    if (!output->set_ioproxy(&memory) || !output->open(format, make_spec(format, source))) {
        throw_error(output->geterror());
    }
    write_rows(*output, source);
    if (!output->close()) {
        throw_error(output->geterror());
    }
    if (std::strcmp(format, "hdr") == 0) {
        add_comments(source, bytes);
    }
}

/**
 * Is ImagePlugin::encode: makes a file of a picture.
 * @param format        The format.
 * @param source        The picture.
 * @param[out] file     The file.
 * @param[out] message  What is wrong.
 * @return Whether it was made.
 */
bool encode(const char *format, const ImagePluginSource *source, EncodedImage *file,
            ImagePluginMessage *message) {
    *file = {};
    return catch_exceptions(message, [&] {
        auto bytes = std::make_unique<std::vector<unsigned char>>();
        encode_into(format, *source, *bytes);
        *file = {bytes->data(), bytes->size(), bytes.get()};
        bytes.release(); // From here on owned by the file.
        return true;
    });
}

/** Is ImagePlugin::release. @param file The file whose memory is given back. */
void free_encoded(EncodedImage *file) {
    delete static_cast<std::vector<unsigned char> *>(file->owner);
    *file = {};
}

/**
 * @return A sentence with numbers in it.
 * @param format  The sentence, as for printf.
 */
__attribute__((format(printf, 1, 2))) std::string format_message(const char *format, ...) {
    char words[IMAGE_PLUGIN_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, format, arguments);
    va_end(arguments);
    return words;
}

/** Stops the work unless a header is sound. @param spec What OpenImageIO says of the file. */
void check_header(const OIIO::ImageSpec &spec) {
    if (spec.width < 1 || spec.width > IMAGE_PLUGIN_SIZE_MAXIMUM || spec.height < 1 ||
        spec.height > IMAGE_PLUGIN_SIZE_MAXIMUM || spec.depth > 1) {
        throw_error(format_message(
            gettext("%d x %d x %d pixels: width and height must be 1 to %d, depth 1"), spec.width,
            spec.height, spec.depth, IMAGE_PLUGIN_SIZE_MAXIMUM));
    }
    if (spec.nchannels < 1 || spec.nchannels > channels_maximum || spec.deep) {
        throw_error(
            format_message(gettext("it has %d channels a pixel, not 1 to 4"), spec.nchannels));
    }
    if (spec.tile_height > tile_height_maximum) {
        throw_error(format_message(gettext("it is cut into tiles %d rows high"), spec.tile_height));
    }
}

} // namespace

/** Closes a stream. */
struct StreamCloser {
    /** @param stream The stream. */
    void operator()(FILE *stream) const { std::fclose(stream); }
};

/**
 * @return A stream of a descriptor, which stays open; throws what goes wrong.
 * @param file  The descriptor.
 */
FILE *open_stream(int file) {
    int copy = dup(file);
    FILE *stream = copy < 0 ? nullptr : fdopen(copy, "rb");
    if (!stream) {
        int reason = errno;
        if (copy >= 0) {
            close(copy);
        }
        throw_error(std::strerror(reason));
    }
    return stream;
}

/** A picture file that is open. */
struct ImageReader {
    /** @param file Its descriptor. */
    explicit ImageReader(int file)
        : stream(open_stream(file)), proxy(stream.get(), OIIO::Filesystem::IOProxy::Read) {}

    std::unique_ptr<FILE, StreamCloser> stream; /**< Its bytes. */
    OIIO::Filesystem::IOFile proxy;             /**< The same, for OpenImageIO. */
    std::unique_ptr<OIIO::ImageInput> input;    /**< The file. */
    OIIO::ImageSpec spec;                       /**< Its header. */
};

namespace {

/**
 * Opens a picture file and checks its header; throws what goes wrong.
 * @param file    Descriptor of the file.
 * @param format  The format.
 * @return The open file.
 */
std::unique_ptr<ImageReader> open_checked(int file, const char *format) {
    auto reader = std::make_unique<ImageReader>(file);
    reader->input = OIIO::ImageInput::create(format);
    if (!reader->input) {
        throw_error(OIIO::geterror());
    }
    OIIO::ImageSpec open_config;
    open_config.attribute("oiio:UnassociatedAlpha",
                          1); // Colours as stored, not darkened by opacity.
    if (!reader->input->set_ioproxy(&reader->proxy) ||
        !reader->input->open(file_name, reader->spec, open_config)) {
        throw_error(without_name(reader->input->geterror()));
    }
    check_header(reader->spec);
    return reader;
}

/** @return What the numbers of a file are. @param type Their type. */
PixelFormat pixel_format_of(OIIO::TypeDesc type) {
    if (type.is_floating_point()) {
        return PIXEL_FORMAT_LINEAR;
    }
    return type == OIIO::TypeDesc::UINT8 ? PIXEL_FORMAT_SRGB8 : PIXEL_FORMAT_SRGB16;
}

/**
 * Is ImagePlugin::open: opens a picture file.
 * @param file          Descriptor of the file.
 * @param format        The format.
 * @param[out] header   What is known of it.
 * @param[out] message  What is wrong.
 * @return The open file, or NULL.
 */
ImageReader *open(int file, const char *format, ImageHeader *header, ImagePluginMessage *message) {
    return catch_exceptions(message, [&] {
        std::unique_ptr<ImageReader> reader = open_checked(file, format);
        const OIIO::ImageSpec &spec = reader->spec;
        int band = spec.tile_width > 0 ? std::max(spec.tile_height, 1) : default_strip_rows;
        *header = {spec.width, spec.height, pixel_format_of(spec.format), band};
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
void read_strip(ImageReader &reader, int first, int count, OIIO::TypeDesc type, Sample *rgb) {
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
        throw_error(reader.input->geterror());
    }
    if (colors == 1) {
        size_t size = static_cast<size_t>(spec.width) * static_cast<size_t>(count) * channels;
        for (size_t i = 0; i < size; i += channels) {
            rgb[i + 1] = rgb[i + 2] = rgb[i];
        }
    }
}

/**
 * Is ImagePlugin::read_encoded: reads a band of rows as encoded steps.
 * @param reader        The open file.
 * @param first         First row.
 * @param count         How many rows.
 * @param[out] rgb      Their pixels.
 * @param[out] message  What is wrong.
 * @return Whether they were read.
 */
bool read_encoded(ImageReader *reader, int first, int count, uint8_t *rgb,
                  ImagePluginMessage *message) {
    return catch_exceptions(message, [&] {
        read_strip(*reader, first, count, OIIO::TypeDesc::UINT8, rgb);
        return true;
    });
}

/**
 * Is ImagePlugin::read_linear: reads a band of rows of the finer kinds.
 * @param reader        The open file.
 * @param first         First row.
 * @param count         How many rows.
 * @param[out] rgb      Their pixels.
 * @param[out] message  What is wrong.
 * @return Whether they were read.
 */
bool read_linear(ImageReader *reader, int first, int count, float *rgb,
                 ImagePluginMessage *message) {
    return catch_exceptions(message, [&] {
        read_strip(*reader, first, count, OIIO::TypeDesc::FLOAT, rgb);
        return true;
    });
}

/**
 * Is ImagePlugin::is_damaged. The readers of JPEG and TIFF fill what is missing, return that it was
 * read, and leave a message.
 * @param reader  The open file.
 * @return Whether there is a message.
 */
bool is_damaged(ImageReader *reader) {
    return reader->input->has_error();
}

/** Is ImagePlugin::close. @param reader The file to be closed, or NULL. */
void close(ImageReader *reader) {
    delete reader;
}

} // namespace

/** The one thing of the module that is seen from outside: #IMAGE_PLUGIN_SYMBOL. */
extern "C" __attribute__((visibility("default"))) const ImagePlugin dioptre_image_plugin = {
    IMAGE_PLUGIN_VERSION, encode, free_encoded, open, read_encoded, read_linear, is_damaged, close,
};
