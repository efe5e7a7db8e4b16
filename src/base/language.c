/**
 * @file
 * @brief The language of the program's messages.
 *
 * glibc translates to the language in LANGUAGE, unless the locale of LC_MESSAGES is "C". "C.UTF-8"
 * exists on every system. LANGUAGE is therefore set once, before other threads start, and
 * LC_MESSAGES is switched between these two locales. glibc synchronises setlocale and gettext.
 */
#include "base/language.h"

#include "base/executable_dir.h"

#include <ctype.h>
#include <libintl.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** Domain of the translations (gettext). */
static const char TEXT_DOMAIN[] = "dioptre";
/** Ends the context of a word of #NC_, as gettext has it. */
static const char CONTEXT_END = '\004';
/** Locale in which messages are translated. */
static const char TRANSLATED_LOCALE[] = "C.UTF-8";
/** Locale in which they are not. */
static const char ENGLISH_LOCALE[] = "C";

/** @return Name of the user's locale for messages, by the rules of POSIX; empty: none is set. */
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
 * @return Whether the first supported language of a list is French.
 * @param list  Names such as `fr_CH.UTF-8` or `fr`, separated by colons.
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

/**
 * @return Whether the user's settings ask for French. The locale "C" always means English, so that
 *         scripts can depend on it.
 */
static bool is_french_wanted(void) {
    const char *locale = locale_name(), *list = getenv("LANGUAGE");
    if (strcmp(locale, "C") == 0 || strcmp(locale, "POSIX") == 0) {
        return false;
    }
    return is_french_first(list && *list ? list : locale);
}

/**
 * Sets the folder of the translations: beside the program, or where they are installed. The worker
 * is installed one folder deeper.
 */
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
    bind_textdomain_codeset("libc", "UTF-8"); // strerror(), strsignal()
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

void language_preload(void) {
    const char *any_text = TEXT_DOMAIN;
    gettext(any_text);
}

void language_toggle(void) {
    setlocale(LC_MESSAGES, language_is_french() ? ENGLISH_LOCALE : TRANSLATED_LOCALE);
}

bool language_is_french(void) {
    return strcmp(setlocale(LC_MESSAGES, NULL), ENGLISH_LOCALE) != 0;
}

/** @return Whether a number begins here. */
static bool is_number(const char *text) {
    text += *text == '-' || *text == '+';
    return isdigit((unsigned char)*text) || strncmp(text, "inf", 3) == 0 ||
           strncmp(text, "nan", 3) == 0;
}

void language_localize_numbers(char *text, size_t size) {
    /** A comma would be read as a decimal one; the space before the semicolon does not break. */
    static const char between[] = "\xc2\xa0; ";
    /** The comma and the space that it replaces. */
    const size_t replaced = strlen(", ");
    const bool is_wanted = language_is_french();
    int depth = 0;
    for (char *c = text; is_wanted && *c; c++) {
        const unsigned char before = c > text ? (unsigned char)c[-1] : '\0';
        depth = *c == '(' ? depth + 1 : *c == ')' && depth > 0 ? depth - 1 : depth;
        if (*c == '.' && isdigit(before) && isdigit((unsigned char)c[1])) {
            *c = ',';
        } else if (*c == ',' && c[1] == ' ' && depth > 0 && isalnum(before) &&
                   is_number(c + replaced) && strlen(text) + sizeof between - replaced <= size) {
            memmove(c + strlen(between), c + replaced, strlen(c + replaced) + 1);
            memcpy(c, between, strlen(between));
            c += strlen(between) - 1;
        }
    }
}

const char *language_word(const char *word) {
    const char *translated = gettext(word), *end = strchr(translated, CONTEXT_END);
    return end ? end + 1 : translated;
}

int language_text_width(const char *text) {
    int width = 0;
    for (const char *c = text; *c; c++) {
        width += (*c & 0xC0) != 0x80; // Count the first byte of each character only.
    }
    return width;
}
