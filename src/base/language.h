/**
 * @file
 * @brief The language that the program speaks: English, or French through gettext.
 *
 * Words are English in the source. What takes a message (#error_set, #error_prefix and the
 * window's) looks it up by itself; words in tables are marked by N_ and looked up where they are
 * printed. `src/po/` has the translations. Numbers, keywords of the scene language, names in JSON
 * and exit statuses are the same in all languages.
 */
#ifndef DIOPTRE_BASE_LANGUAGE_H
#define DIOPTRE_BASE_LANGUAGE_H

#include <stdbool.h>

/** Marks words for the translators where they stand; the program sees the words alone. */
#define N_(words) words

/**
 * Speaks the user's language from now on: French where LANGUAGE, LC_ALL, LC_MESSAGES or LANG ask
 * for it, as gettext reads them, whether or not the system has that locale; otherwise English. Only
 * LC_MESSAGES is touched, and LANGUAGE in the environment. To be called before there are threads.
 */
void language_init(void);

/** Uses one language from now on, as #language_init does: in worker processes. */
void language_init_as(bool is_french);

/**
 * Speaks the other language from now on, in all threads. What was said before stays as it is.
 */
void language_toggle(void);

/** @return Whether it speaks French. */
bool language_is_french(void);

/** @return How many letters a text has: the columns that it takes on a terminal. */
int language_text_width(const char *text);

#endif
