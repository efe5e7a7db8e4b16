/**
 * @file
 * @brief The language of the program's messages: English, or French through gettext.
 *
 * The source contains English texts. Functions that take messages (#error_set, #error_prefix and
 * those of the window) translate them; texts in tables are marked by N_ and translated where they
 * are printed. The translations are in `src/po/`. Keywords of the scene language, names in JSON and
 * exit statuses are the same in all languages. So are numbers, but for those that the window shows:
 * see #language_localize_numbers.
 */
#ifndef DIOPTRE_BASE_LANGUAGE_H
#define DIOPTRE_BASE_LANGUAGE_H

#include <stdbool.h>
#include <stddef.h>

/** Marks a text for the translators; the program uses it unchanged. */
#define N_(words) words
/** The same for a word that another language has two words for; #language_word translates it.
 *  @param context  What it is said of. */
#define NC_(context, word) context "\004" word

/**
 * Sets the user's language: French if LANGUAGE, LC_ALL, LC_MESSAGES or LANG ask for it, by the
 * rules of gettext; else English. The locale need not be installed. It changes only LC_MESSAGES,
 * and LANGUAGE in the environment. To be called before other threads start.
 */
void language_init(void);

/**
 * Sets a language, like #language_init: for worker processes.
 * @param is_french  Whether it is French.
 */
void language_init_as(bool is_french);

/** Opens the translations now, for a process that will not be allowed to open files. */
void language_preload(void);

/** Switches to the other language, in all threads. */
void language_toggle(void);

/** Number of languages. */
enum { LANGUAGE_COUNT = 2 };

/** @return Whether the language is French: 0 or 1, the index of the language in an array. */
bool language_is_french(void);

/** @return A word in the user's language. @param word As #NC_ or #N_ mark it. */
const char *language_word(const char *word);

/**
 * Writes the numbers of a text as readers of the language do: in French with a decimal comma, and
 * with semicolons between the numbers in parentheses. For texts that the window shows; what goes
 * into a file, a scene or a pipe keeps its points, and so do names of files.
 * @param[in,out] text  The text, UTF-8.
 * @param size          Bytes that it may have with the final zero; where there is no room for the
 *                      signs between numbers, they stay.
 */
void language_localize_numbers(char *text, size_t size);

/**
 * @return Number of characters of a text, one column each on a terminal.
 * @param text  The text, UTF-8.
 */
int language_text_width(const char *text);

#endif
