/**
 * @file
 * @brief The language that the program speaks.
 *
 * glibc takes the words of the language that LANGUAGE names, unless LC_MESSAGES is the locale "C":
 * then they stay English. "C.UTF-8" is on every system, whatever locales were made there. So
 * LANGUAGE is set once, while there is one thread, and LC_MESSAGES goes to and fro between these
 * two; setlocale and gettext keep out of each other's way by a lock of their own.
 */
#include "base/language.h"

#include "base/executable_dir.h"

#include <libintl.h>
#include <locale.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** What gettext and ngettext come to in libintl.h. @return See there. */
char *__real_dcgettext(const char *domain, const char *words, int category);
/** See #__real_dcgettext. @return See there. */
char *__real_dcngettext(const char *domain, const char *one, const char *more, unsigned long count,
                        int category);
/** Takes the place of dcgettext where the program is linked (see the Makefile). @return See there.
 */
char *__wrap_dcgettext(const char *domain, const char *words, int category);
/** Takes the place of dcngettext. @return See there. */
char *__wrap_dcngettext(const char *domain, const char *one, const char *more, unsigned long count,
                        int category);

/**
 * Held by threads that look words up or set the locale, and alone by a thread that forks: glibc's
 * own locks for that are not mended in a child, which would then wait for ever for a thread that it
 * does not have.
 */
static pthread_rwlock_t gettext_lock = PTHREAD_RWLOCK_WRITER_NONRECURSIVE_INITIALIZER_NP;

char *__wrap_dcgettext(const char *domain, const char *words, int category) {
    pthread_rwlock_rdlock(&gettext_lock);
    char *found = __real_dcgettext(domain, words, category);
    pthread_rwlock_unlock(&gettext_lock);
    return found;
}

char *__wrap_dcngettext(const char *domain, const char *one, const char *more, unsigned long count,
                        int category) {
    pthread_rwlock_rdlock(&gettext_lock);
    char *found = __real_dcngettext(domain, one, more, count, category);
    pthread_rwlock_unlock(&gettext_lock);
    return found;
}

/** Waits until nobody looks words up: this thread is about to fork. */
static void lock_before_fork(void) {
    pthread_rwlock_wrlock(&gettext_lock);
}

/** Lets others look words up again, after a fork. */
static void unlock_after_fork(void) {
    pthread_rwlock_unlock(&gettext_lock);
}

/** Makes the lock anew in a child: it is held there by a thread of the parent. */
static void reset_lock_in_child(void) {
    gettext_lock = (pthread_rwlock_t)PTHREAD_RWLOCK_WRITER_NONRECURSIVE_INITIALIZER_NP;
}

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

/** Says where the words are: beside the program, or where they were installed. */
static void bind_text_domain(void) {
    char folder[PATH_MAX];
    char path[PATH_MAX + sizeof "/../share/locale"];
    if (!executable_dir(folder)) {
        return;
    }
    snprintf(path, sizeof path, "%s/locale", folder);
    if (access(path, R_OK) != 0) {
        snprintf(path, sizeof path, "%s/../share/locale", folder);
    }
    bindtextdomain(TEXT_DOMAIN, path);
    bind_textdomain_codeset(TEXT_DOMAIN, "UTF-8");
    textdomain(TEXT_DOMAIN);
}

void language_init(void) {
    bool is_french = is_french_wanted();
    bind_text_domain();
    pthread_atfork(lock_before_fork, unlock_after_fork, reset_lock_in_child);
    setenv("LANGUAGE", "fr", 1);
    setlocale(LC_MESSAGES, is_french ? TRANSLATED_LOCALE : ENGLISH_LOCALE);
}

void language_toggle(void) {
    pthread_rwlock_rdlock(&gettext_lock);
    setlocale(LC_MESSAGES, language_is_french() ? ENGLISH_LOCALE : TRANSLATED_LOCALE);
    pthread_rwlock_unlock(&gettext_lock);
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
