/**
 * @file
 * @brief The language that the program speaks.
 *
 * glibc takes the words of the language that LANGUAGE names, unless LC_MESSAGES is the locale "C":
 * then they stay English. "C.UTF-8" is on every system, whatever locales were made there. So
 * LANGUAGE is set once, while there is one thread, and LC_MESSAGES goes to and fro between these
 * two. glibc locks setlocale and gettext against each other.
 */
#include "base/language.h"

#include "base/executable_dir.h"

#include <libintl.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** What the words are filed under. */
static const char TEXT_DOMAIN[] = "dioptre";
/** A locale in which words are looked up. */
static const char TRANSLATED_LOCALE[] = "C.UTF-8";
/** The locale in which they are not. */
static const char ENGLISH_LOCALE[] = "C";

/** @return The name of the user's locale for messages, as POSIX finds it; empty: none is set. */
static const char *locale_name(void) {
    static const char *const variables[] = {"LC_ALL", "LC_MESSAGES", "LANG"};
    for (size_t i = 0; i < sizeof variables / sizeof *variables; i++) {
        const char *value = getenv(variables[i]);
        if (value && *value) {
            return value;
        }
    }
    return "";
}

/**
 * @return Whether the first of a list of languages that the program speaks is French.
 * @param list  Names such as `fr_CH.UTF-8` or `fr`, with colons between them.
 */
static bool is_french_first(const char *list) {
    while (*list) {
        size_t length = strcspn(list, "_.@:");
        if (length == 2 && (strncmp(list, "fr", 2) == 0 || strncmp(list, "en", 2) == 0)) {
            return list[0] == 'f';
        }
        list += strcspn(list, ":");
        list += *list == ':';
    }
    return false;
}

/** @return Whether the user wants French. Who asks for the locale "C" by its name wants what every
 *          script can rely on: English, whatever else is set. */
static bool is_french_wanted(void) {
    const char *locale = locale_name(), *list = getenv("LANGUAGE");
    if (strcmp(locale, "C") == 0 || strcmp(locale, "POSIX") == 0) {
        return false;
    }
    return is_french_first(list && *list ? list : locale);
}

/** Binds the domain to the catalogues: beside the program, or where they are installed. The worker
 *  is installed one folder deeper than the program. */
static void bind_text_domain(void) {
    static const char *const places[] = {"locale", "../share/locale", "../../share/locale"};
    char folder[PATH_MAX];
    char path[PATH_MAX + sizeof "/../../share/locale"];
    if (!executable_dir(folder)) {
        return;
    }
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        snprintf(path, sizeof path, "%s/%s", folder, places[i]);
        if (access(path, R_OK) == 0) {
            break;
        }
    }
    bindtextdomain(TEXT_DOMAIN, path);
    bind_textdomain_codeset(TEXT_DOMAIN, "UTF-8");
    textdomain(TEXT_DOMAIN);
}

void language_init(void) {
    language_init_as(is_french_wanted());
}

void language_init_as(bool is_french) {
    bind_text_domain();
    setenv("LANGUAGE", "fr", 1);
    setlocale(LC_MESSAGES, is_french ? TRANSLATED_LOCALE : ENGLISH_LOCALE);
}

void language_toggle(void) {
    setlocale(LC_MESSAGES, language_is_french() ? ENGLISH_LOCALE : TRANSLATED_LOCALE);
}

bool language_is_french(void) {
    return strcmp(setlocale(LC_MESSAGES, NULL), ENGLISH_LOCALE) != 0;
}

int language_text_width(const char *text) {
    int width = 0;
    for (const char *c = text; *c; c++) {
        width += (*c & 0xC0) != 0x80; // Not the second byte of a letter, nor the third.
    }
    return width;
}
