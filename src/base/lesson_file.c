/**
 * @file
 * @brief Telling lesson files from scene files, by their text.
 */
#include "base/lesson_file.h"

#include "base/regular_file.h"
#include "base/scene_name.h"

#include <ctype.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** Bytes of a file in which `lesson` must stand: the comment at its beginning is shorter. */
enum { HEAD_SIZE = 1 << 14 };

/** @return The end of a long bracket of Lua, such as `[==[ ]==]`; NULL: there is none here. */
static const char *skip_long_bracket(const char *text) {
    size_t level = text[0] == '[' ? strspn(text + 1, "=") : 0;
    if (text[0] != '[' || text[1 + level] != '[') {
        return NULL;
    }
    for (text += level + 2; *text; text++) {
        if (text[0] == ']' && strspn(text + 1, "=") == level && text[1 + level] == ']') {
            return text + level + 2;
        }
    }
    return text;
}

/** @return The end of a quoted string. @param text Its first quote. */
static const char *skip_string(const char *text) {
    char quote = *text++;
    while (*text && *text != quote && *text != '\n') {
        text += text[0] == '\\' && text[1] ? 2 : 1;
    }
    return *text ? text + 1 : text;
}

/** @return The end of the comment or string that begins here; NULL: none does. */
static const char *skip_opaque(const char *text) {
    if (text[0] == '-' && text[1] == '-') {
        const char *end = skip_long_bracket(text + 2);
        return end ? end : text + strcspn(text, "\n");
    }
    return text[0] == '"' || text[0] == '\'' ? skip_string(text) : skip_long_bracket(text);
}

/** @return Whether a character may be part of a name. */
static bool is_name_character(char c) {
    return isalnum((unsigned char)c) || c == '_';
}

bool lesson_file_is_text(const char *text) {
    static const char word[] = "lesson";
    const size_t length = sizeof word - 1;
    while (*text) {
        const char *end = skip_opaque(text);
        if (end) {
            text = end;
            continue;
        }
        size_t name = 0;
        while (is_name_character(text[name])) {
            name++;
        }
        const char *after = text + name + strspn(text + name, " \t\r\n");
        if (name == length && strncmp(text, word, length) == 0 && strchr("{(", *after) && *after) {
            return true;
        }
        text += name > 0 ? name : 1;
    }
    return false;
}

bool lesson_file_is(const char *path) {
    char head[HEAD_SIZE + 1];
    struct stat info;
    int file =
        scene_format_of(path) == SCENE_FORMAT_LUA ? regular_file_open(path, &info, NULL) : -1;
    ssize_t size = file >= 0 ? read(file, head, HEAD_SIZE) : 0;
    if (file >= 0) {
        close(file);
    }
    head[size > 0 ? size : 0] = '\0';
    return lesson_file_is_text(head);
}

bool lesson_file_next(const char *path, char next[PATH_MAX]) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    int length = (int)(name - path);
    struct dirent **files = NULL;
    char folder[PATH_MAX];
    bool is_found = false;
    snprintf(folder, sizeof folder, "%.*s", length, path);
    int count = scandir(length > 0 ? folder : ".", &files, NULL, alphasort);
    for (int i = 0; i < count; i++) {
        if (!is_found && strcoll(files[i]->d_name, name) > 0) {
            int size = snprintf(next, PATH_MAX, "%s%s", folder, files[i]->d_name);
            is_found = size < PATH_MAX && lesson_file_is(next);
        }
        free(files[i]);
    }
    free(files);
    return is_found;
}
