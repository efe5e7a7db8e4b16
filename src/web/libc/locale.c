/**
 * @file
 * @brief Languages of the page: setlocale and gettext, over a catalogue of translations in memory.
 *
 * They stand in for musl's, which know no LC_MESSAGES but "C". The catalogue is a file of msgfmt:
 * tables of sorted originals and their translations.
 */
#include <libintl.h>
#include <limits.h>
#include <locale.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** First word of a catalogue. */
static const uint32_t CATALOGUE_MAGIC = 0x950412de;

/** Header of a catalogue. All numbers are little-endian, as wasm is. */
typedef struct CatalogueHeader {
    uint32_t magic;        /**< #CATALOGUE_MAGIC. */
    uint32_t revision;     /**< 0. */
    uint32_t count;        /**< Number of texts. */
    uint32_t originals;    /**< Offset of the table of originals. */
    uint32_t translations; /**< Offset of the table of translations. */
} CatalogueHeader;

/** An entry of a table. */
typedef struct CatalogueEntry {
    uint32_t length; /**< Bytes of the text, without its final zero. */
    uint32_t offset; /**< Offset of the text. */
} CatalogueEntry;

/** The language and its catalogue: of the process, as in every C library. */
static struct {
    atomic_bool is_translated; /**< Whether LC_MESSAGES is not "C". */
    char path[PATH_MAX];       /**< The catalogue. */
    pthread_once_t once;       /**< Loads it at first use. */
    const char *bytes;         /**< Its bytes; NULL: there is none. Never freed. */
} language = {.once = PTHREAD_ONCE_INIT};

/** Sets the language of LC_MESSAGES; other categories stay "C". See setlocale(3). */
char *setlocale(int category, const char *name) {
    static char c_name[] = "C", translated_name[] = "C.UTF-8";
    if (category != LC_MESSAGES) {
        return c_name;
    }
    if (name) {
        atomic_store(&language.is_translated, strcmp(name, "C") != 0);
    }
    return atomic_load(&language.is_translated) ? translated_name : c_name;
}

/** Sets the folder of the translations into French. See bindtextdomain(3). @return The folder. */
char *bindtextdomain(const char *domain, const char *folder) {
    snprintf(language.path, sizeof language.path, "%s/fr/LC_MESSAGES/%s.mo", folder, domain);
    return language.path;
}

/** Does nothing: the catalogue is in UTF-8. @return NULL */
char *bind_textdomain_codeset(const char *domain, const char *codeset) {
    return NULL;
}

/** Does nothing: there is one domain. @return NULL */
char *textdomain(const char *domain) {
    return NULL;
}

/** Reads the catalogue. */
static void load_catalogue(void) {
    FILE *file = fopen(language.path, "rb");
    if (!file) {
        return;
    }
    fseek(file, 0, SEEK_END);
    long size = ftell(file);
    rewind(file);
    char *bytes = size > (long)sizeof(CatalogueHeader) ? malloc((size_t)size) : NULL;
    if (bytes && fread(bytes, 1, (size_t)size, file) == (size_t)size &&
        ((const CatalogueHeader *)bytes)->magic == CATALOGUE_MAGIC) {
        language.bytes = bytes;
    }
    fclose(file);
}

/** @return The translation of a text, found by halves; NULL: there is none. */
static const char *find_translation(const char *text) {
    pthread_once(&language.once, load_catalogue);
    const char *bytes = language.bytes;
    if (!bytes || !atomic_load(&language.is_translated)) {
        return NULL;
    }
    const CatalogueHeader *header = (const void *)bytes;
    const CatalogueEntry *originals = (const void *)(bytes + header->originals);
    const CatalogueEntry *translations = (const void *)(bytes + header->translations);
    uint32_t low = 0, high = header->count;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        int order = strcmp(text, bytes + originals[middle].offset);
        if (order == 0) {
            return bytes + translations[middle].offset;
        }
        low = order > 0 ? middle + 1 : low;
        high = order > 0 ? high : middle;
    }
    return NULL;
}

/** Translates a text. See gettext(3). */
char *gettext(const char *text) {
    const char *found = find_translation(text);
    return (char *)(uintptr_t)(found && found[0] ? found : text);
}

/** Translates a text that depends on a number; French has one plural, from 2. See ngettext(3). */
char *ngettext(const char *singular, const char *plural, unsigned long number) {
    const char *found = find_translation(singular);
    if (found && found[0]) {
        return (char *)(uintptr_t)(number > 1 ? found + strlen(found) + 1 : found);
    }
    return (char *)(uintptr_t)(number == 1 ? singular : plural);
}
