/**
 * @file
 * @brief Fuzz target: the writer of JSON. Whatever names and texts it gets, its line is JSON in
 * UTF-8, as a parser finds that shares nothing with it (RFC 8259, RFC 3629).
 */
#include "fuzz.h"

#include "base/json.h"

// --- a parser, which only accepts or rejects -----------------------------------------------------

/** Text that is being parsed. */
typedef struct Parser {
    const unsigned char *next; /**< The next byte. */
    const unsigned char *end;  /**< The end of the text. */
} Parser;

/** @return Whether the next byte is this one, which is skipped then. */
static bool skip(Parser *parser, unsigned char byte) {
    bool is_there = parser->next < parser->end && *parser->next == byte;
    parser->next += is_there;
    return is_there;
}

/** Skips blanks. */
static void skip_blanks(Parser *parser) {
    while (skip(parser, ' ') || skip(parser, '\n') || skip(parser, '\t') || skip(parser, '\r')) {
    }
}

/** @return Whether the next byte lies in a range; it is skipped then. */
static bool skip_range(Parser *parser, unsigned char first, unsigned char last) {
    bool is_there = parser->next < parser->end && *parser->next >= first && *parser->next <= last;
    parser->next += is_there;
    return is_there;
}

/** Skips a character of UTF-8 by the table of RFC 3629, section 4. @return Whether it is one. */
static bool skip_utf8(Parser *parser) {
    static const struct {
        unsigned char first, last; /**< Range of the first byte. */
        unsigned char second[2];   /**< Range of the second byte. */
        int tails;                 /**< Number of bytes 80 to BF after it. */
    } rows[] = {{0xC2, 0xDF, {0x80, 0xBF}, 0}, {0xE0, 0xE0, {0xA0, 0xBF}, 1},
                {0xE1, 0xEC, {0x80, 0xBF}, 1}, {0xED, 0xED, {0x80, 0x9F}, 1},
                {0xEE, 0xEF, {0x80, 0xBF}, 1}, {0xF0, 0xF0, {0x90, 0xBF}, 2},
                {0xF1, 0xF3, {0x80, 0xBF}, 2}, {0xF4, 0xF4, {0x80, 0x8F}, 2}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (skip_range(parser, rows[i].first, rows[i].last)) {
            bool is_valid = skip_range(parser, rows[i].second[0], rows[i].second[1]);
            for (int k = 0; k < rows[i].tails; k++) {
                is_valid = is_valid && skip_range(parser, 0x80, 0xBF);
            }
            return is_valid;
        }
    }
    return skip_range(parser, 0x20, 0x7F);
}

/** Parses what follows a backslash. @return Whether it is an escape. */
static bool parse_escape(Parser *parser) {
    if (!skip(parser, 'u')) {
        bool is_known = parser->next < parser->end && strchr("\"\\/bfnrt", *parser->next);
        parser->next += is_known;
        return is_known;
    }
    bool is_valid = true;
    for (int i = 0; i < 4; i++) {
        is_valid = is_valid && (skip_range(parser, '0', '9') || skip_range(parser, 'a', 'f') ||
                                skip_range(parser, 'A', 'F'));
    }
    return is_valid;
}

/** Parses a string. @return Whether it is one. */
static bool parse_string(Parser *parser) {
    bool is_valid = skip(parser, '"');
    while (is_valid && !skip(parser, '"')) {
        is_valid = skip(parser, '\\') ? parse_escape(parser) : skip_utf8(parser);
    }
    return is_valid;
}

/** Parses digits. @return Whether there is one at least. */
static bool parse_digits(Parser *parser) {
    bool has_digit = skip_range(parser, '0', '9');
    while (skip_range(parser, '0', '9')) {
    }
    return has_digit;
}

/** Parses a number. @return Whether it is one. */
static bool parse_number(Parser *parser) {
    skip(parser, '-');
    bool is_valid = skip(parser, '0') || parse_digits(parser);
    if (is_valid && skip(parser, '.')) {
        is_valid = parse_digits(parser);
    }
    if (is_valid && (skip(parser, 'e') || skip(parser, 'E'))) {
        is_valid = (skip(parser, '+') || skip(parser, '-') || true) && parse_digits(parser);
    }
    return is_valid;
}

static bool parse_value(Parser *parser);

/** Parses the members of an object or array up to its end. @return Whether all are valid. */
static bool parse_members(Parser *parser, unsigned char end, bool has_names) {
    bool is_valid = true, is_first = true;
    skip_blanks(parser);
    while (is_valid && !skip(parser, end)) {
        is_valid = is_first || skip(parser, ',');
        skip_blanks(parser);
        if (is_valid && has_names) {
            is_valid = parse_string(parser);
            skip_blanks(parser);
            is_valid = is_valid && skip(parser, ':');
        }
        is_valid = is_valid && parse_value(parser);
        skip_blanks(parser);
        is_first = false;
    }
    return is_valid;
}

/** Parses a word. @return Whether it is there. */
static bool parse_word(Parser *parser, const char *word) {
    size_t length = strlen(word);
    bool is_there =
        (size_t)(parser->end - parser->next) >= length && memcmp(parser->next, word, length) == 0;
    parser->next += is_there ? length : 0;
    return is_there;
}

/** Parses a value. @return Whether it is one. */
static bool parse_value(Parser *parser) {
    skip_blanks(parser);
    if (skip(parser, '{')) {
        return parse_members(parser, '}', true);
    }
    if (skip(parser, '[')) {
        return parse_members(parser, ']', false);
    }
    if (parser->next < parser->end && *parser->next == '"') {
        return parse_string(parser);
    }
    return parse_word(parser, "true") || parse_word(parser, "false") ||
           parse_word(parser, "null") || parse_number(parser);
}

// --- the target ----------------------------------------------------------------------------------

/** Deepest nesting that is written: the parser is recursive. */
enum { DEPTH_LIMIT = 16 };
/** Largest number of significant digits or decimals. */
enum { DIGITS_LIMIT = 20 };

/** A document that is being written. */
typedef struct Document {
    JsonWriter writer;           /**< The writer. */
    FuzzInput input;             /**< Decides what is written. */
    bool is_object[DEPTH_LIMIT]; /**< Whether an open container is an object. */
    int depth;                   /**< Number of open containers. */
} Document;

/** Takes a text up to its zero byte. @return It, to be freed with `free`. */
static char *take_text(FuzzInput *input) {
    const uint8_t *zero = input->size ? memchr(input->next, '\0', input->size) : NULL;
    size_t length = zero ? (size_t)(zero - input->next) : input->size;
    char *text = malloc(length + 1);
    FUZZ_REQUIRE(text);
    fuzz_take(input, text, length);
    text[length] = '\0';
    fuzz_take_byte(input);
    return text;
}

/** Writes a number. */
static void write_number(Document *document, const char *name, uint8_t kind) {
    double value;
    fuzz_take(&document->input, &value, sizeof value);
    int digits = fuzz_take_byte(&document->input) % DIGITS_LIMIT;
    if (kind % 3 == 0) {
        json_number(&document->writer, name, value, digits);
    } else if (kind % 3 == 1) {
        json_decimal(&document->writer, name, value, digits);
    } else {
        const double values[] = {value, -value, value * 3};
        json_numbers(&document->writer, name, values, 3, JSON_EXACT_DIGITS);
    }
}

/** Begins an object or an array. */
static void begin_container(Document *document, const char *name, bool is_object) {
    if (document->depth < DEPTH_LIMIT) {
        (is_object ? json_object_begin : json_array_begin)(&document->writer, name);
        document->is_object[document->depth++] = is_object;
    }
}

/** Ends the innermost object or array, but never the outermost. */
static void end_container(Document *document) {
    if (document->depth > 1) {
        bool is_object = document->is_object[--document->depth];
        (is_object ? json_object_end : json_array_end)(&document->writer);
    }
}

/** Writes the next value. */
static void write_value(Document *document) {
    uint8_t kind = fuzz_take_byte(&document->input);
    char *own_name = document->is_object[document->depth - 1] ? take_text(&document->input) : NULL;
    if (kind < 128) {
        char *text = take_text(&document->input);
        json_string(&document->writer, own_name, text);
        free(text);
    } else if (kind < 160) {
        write_number(document, own_name, kind);
    } else if (kind < 190) {
        begin_container(document, own_name, kind % 2);
    } else if (kind < 220) {
        end_container(document);
    } else if (kind < 230) {
        json_bool(&document->writer, own_name, kind % 2);
    } else if (kind < 240) {
        json_integer(&document->writer, own_name, -(long long)kind);
        json_count(&document->writer, own_name, kind);
    } else {
        json_null(&document->writer, own_name);
    }
    free(own_name);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    char *line = NULL;
    size_t length = 0;
    FILE *stream = open_memstream(&line, &length);
    Document document = {.writer = {.stream = stream}, .input = {data, size}};
    FUZZ_REQUIRE(stream);
    begin_container(&document, NULL, true);
    while (document.input.size > 0) {
        write_value(&document);
    }
    while (document.depth > 1) {
        end_container(&document);
    }
    json_line_end(&document.writer);
    FUZZ_REQUIRE(fclose(stream) == 0);
    Parser parser = {(const unsigned char *)line, (const unsigned char *)line + length};
    FUZZ_REQUIRE(parse_value(&parser));
    FUZZ_REQUIRE(parser.end - parser.next == 1 && *parser.next == '\n');
    free(line);
    return 0;
}
