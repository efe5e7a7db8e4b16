/**
 * @file
 * @brief The names of offset strategies and number types.
 */
#include "view/state/settings_words.h"

#include "base/language.h"

#include <stdio.h>

const char *offset_strategy_word(OffsetStrategy offset) {
    static const char *const words[] = {[OFFSET_NONE] = NC_("offset", "none"),
                                        [OFFSET_FIXED] = NC_("offset", "fixed"),
                                        [OFFSET_BOUND] = NC_("offset", "bound")};
    return language_word(words[offset]);
}

const char *number_type_word(NumberType type) {
    static const char *const words[NUMBER_TYPE_COUNT] = {[NUMBER_FLOAT] = NC_("number", "float"),
                                                         [NUMBER_DOUBLE] = NC_("number", "double"),
                                                         [NUMBER_QUAD] = NC_("number", "quad")};
    return language_word(words[type]);
}

void engine_words_write(const char *name, char words[ENGINE_WORDS_SIZE]) {
    const Engine *engine = engine_find(name, NULL);
    if (engine) {
        snprintf(words, ENGINE_WORDS_SIZE, "%s (%s)", number_type_word(number_type_of(engine)),
                 name);
    } else {
        snprintf(words, ENGINE_WORDS_SIZE, "%s", name);
    }
}
