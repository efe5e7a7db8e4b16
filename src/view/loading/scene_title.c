/**
 * @file
 * @brief Reading titles of scenes and lessons.
 */
#include "view/loading/scene_title.h"

#include "base/regular_file.h"

#include <SDL.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/** Bytes of a line that is read at once; the rest of a longer one counts as a line of its own. */
enum { LINE_SIZE = 1024 };
/** Lines of a file in which a lesson or its title is looked for. */
enum { LINES_MAXIMUM = 200 };
/** Bytes of a file up to which its name is looked for: a window that opens waits for it. */
static const int64_t NAMED_FILE_MAXIMUM = 1 << 20;

/** @return Whether a text begins with another. */
static bool begins_with(const char *text, const char *start) {
    return strncmp(text, start, strlen(start)) == 0;
}

/** @return A regular file for reading; NULL: it is none, as a FIFO, which would be waited for.
 *  @param largest Its largest size, bytes. */
static FILE *open_file(const char *path, int64_t largest) {
    Error error = {0};
    struct stat info;
    int file = regular_file_open(path, &info, &error);
    FILE *stream = file >= 0 && info.st_size <= largest ? fdopen(file, "r") : NULL;
    if (file >= 0 && !stream) {
        close(file);
    }
    return stream;
}

/** Reads a line without its end. @return false at the end of the file. */
static bool read_line(FILE *file, char line[LINE_SIZE]) {
    bool is_read = fgets(line, LINE_SIZE, file) != NULL;
    if (is_read) {
        line[strcspn(line, "\r\n")] = '\0';
    }
    return is_read;
}

/** Appends the text of a comment to a title. */
static void add_comment(const char *line, char title[SCENE_TITLE_SIZE]) {
    size_t used = strlen(title);
    const char *text = line + strspn(line, "- ");
    char rest[LINE_SIZE + 1];
    snprintf(rest, sizeof rest, "%s%s", used > 0 ? " " : "", text);
    SDL_utf8strlcpy(title + used, rest, SCENE_TITLE_SIZE - used);
}

/** Reads the title of a scene. @param mark Begins the line of the language that is wanted. */
static void read_scene_title(FILE *file, const char *mark, char title[SCENE_TITLE_SIZE]) {
    char line[LINE_SIZE], comment[SCENE_TITLE_SIZE] = "", english[SCENE_TITLE_SIZE] = "";
    bool is_beginning = true;
    while (title[0] == '\0' && read_line(file, line)) {
        is_beginning = is_beginning && begins_with(line, "-- ");
        if (begins_with(line, mark)) {
            add_comment(line + strlen(mark), title);
        } else if (begins_with(line, "-- en: ")) {
            add_comment(line + strlen("-- en: "), english);
        } else if (is_beginning) {
            add_comment(line, comment);
        }
    }
    char *end = strstr(comment, ". ");
    if (end) {
        end[1] = '\0';
    }
    if (title[0] == '\0') {
        SDL_utf8strlcpy(title, english[0] != '\0' ? english : comment, SCENE_TITLE_SIZE);
    }
}

/** Copies a text in quotes. @param from The quote before it, in a line. */
static void copy_quoted(const char *from, char title[SCENE_TITLE_SIZE]) {
    char text[LINE_SIZE];
    size_t length = 0;
    for (const char *c = from + 1; *c && *c != *from; c++) {
        c += *c == '\\' && c[1] ? 1 : 0;
        text[length++] = *c;
    }
    text[length] = '\0';
    SDL_utf8strlcpy(title, text, SCENE_TITLE_SIZE);
}

/** Reads the title of a lesson. @param key The field of the language that is wanted. */
static void read_lesson_title(FILE *file, const char *key, char title[SCENE_TITLE_SIZE]) {
    char line[LINE_SIZE];
    for (int i = 0; i < LINES_MAXIMUM && title[0] == '\0' && read_line(file, line); i++) {
        const char *field = strstr(line, "title");
        const char *text = field && strchr(field, '=') ? strchr(field, '=') + 1 : NULL;
        const char *named = text ? strstr(text, key) : NULL;
        const char *quote = text ? strpbrk(named ? named : text, "\"'") : NULL;
        if (quote) {
            copy_quoted(quote, title);
        }
    }
}

void scene_title_read(const char *path, bool is_lesson, bool is_french,
                      char title[SCENE_TITLE_SIZE]) {
    FILE *file = open_file(path, INT64_MAX);
    title[0] = '\0';
    if (file && is_lesson) {
        read_lesson_title(file, is_french ? "fr =" : "en =", title);
    } else if (file) {
        read_scene_title(file, is_french ? "-- fr: " : "-- en: ", title);
    }
    if (file) {
        fclose(file);
    }
}

void scene_title_read_name(const char *path, bool is_french, char *name, size_t size) {
    const char *mark = is_french ? "-- fr name: " : "-- en name: ";
    char line[LINE_SIZE];
    FILE *file = open_file(path, NAMED_FILE_MAXIMUM);
    bool is_found = false;
    while (file && !is_found && read_line(file, line)) {
        is_found = begins_with(line, mark);
    }
    if (is_found) {
        SDL_utf8strlcpy(name, line + strlen(mark), size);
    }
    if (file) {
        fclose(file);
    }
}

/** @return Whether a line calls a word of lessons. */
static bool calls(const char *line, const char *word) {
    const size_t length = strlen(word);
    return begins_with(line, word) && line[length] != '\0' && strchr(" ({\"'", line[length]);
}

/** Takes the first words of a lesson from a line, if they are there. @param language `en =` or
 *  `fr =`. @return Whether they are. */
static bool take_words(const char *line, const char *language, char words[SCENE_TITLE_SIZE]) {
    const char *text = strstr(line, language), *quote = text ? strpbrk(text, "\"'") : NULL;
    if (quote) {
        copy_quoted(quote, words);
        char *end = strpbrk(words, ".?!");
        while (end && end[1] != ' ' && end[1] != '\0') {
            end = strpbrk(end + 1, ".?!");
        }
        if (end) {
            end[1] = '\0';
        }
    }
    return quote != NULL;
}

void scene_title_read_summary(const char *path, bool is_french, LessonSummary *summary) {
    FILE *file = open_file(path, NAMED_FILE_MAXIMUM);
    char line[LINE_SIZE];
    int captions = 0;
    bool is_in_first = false;
    *summary = (LessonSummary){0};
    while (file && read_line(file, line)) {
        const bool is_caption = calls(line, "caption"), is_question = calls(line, "ask");
        summary->steps += is_caption || is_question;
        summary->questions += is_question;
        captions += is_caption;
        is_in_first = captions == 1 && (is_caption || (is_in_first && line[0] == ' '));
        // English comes before French, and is kept where there is none.
        if (is_in_first && !(is_french && take_words(line, "fr =", summary->first_words))) {
            take_words(line, "en =", summary->first_words);
        }
    }
    if (file) {
        fclose(file);
    }
}
