/**
 * @file
 * @brief The list of edits.
 */
#include "view/state/edit_history.h"

#include <stdlib.h>
#include <string.h>

/** Edits of the first allocation. */
enum { FIRST_CAPACITY = 64 };

void edit_history_deinit(EditHistory *history) {
    free(history->edits);
    *history = (EditHistory){.revision = history->revision + 1};
}

void edit_history_clear(EditHistory *history) {
    if (history->count > 0) {
        history->revision++;
    }
    history->count = history->done = history->base_count = 0;
}

/** Makes room for one more edit. @return false without memory, or if there are too many. */
static bool reserve(EditHistory *history, Error *error) {
    if (history->count == EDITS_MAXIMUM) {
        return error_set(error, STATUS_FAILED, "at most %d changes can be kept", EDITS_MAXIMUM);
    }
    if (history->count < history->capacity) {
        return true;
    }
    size_t capacity = history->capacity > 0 ? 2 * history->capacity : FIRST_CAPACITY;
    Edit *edits = realloc(history->edits, capacity * sizeof *edits);
    if (!edits) {
        return error_set(error, STATUS_FAILED, "no memory for a change");
    }
    history->edits = edits;
    history->capacity = capacity;
    return true;
}

/** @return The edit of a field in the last group in force; NULL: none. */
static Edit *find_in_group(EditHistory *history, const SceneOverride *field) {
    for (size_t i = history->done; i > history->base_count; i--) {
        Edit *edit = &history->edits[i - 1];
        if (scene_override_is_same_field(&edit->override, field)) {
            return edit;
        }
        if (!edit->continues) {
            return NULL;
        }
    }
    return NULL;
}

void edit_history_forget_undone(EditHistory *history) {
    history->count = history->done;
}

bool edit_history_add(EditHistory *history, const SceneOverride *override, bool continues,
                      Error *error) {
    edit_history_forget_undone(history);
    continues = continues && history->done > history->base_count;
    Edit *earlier = continues ? find_in_group(history, override) : NULL;
    if (earlier) {
        earlier->override = *override;
    } else {
        if (!reserve(history, error)) {
            return false;
        }
        history->edits[history->count++] = (Edit){.override = *override, .continues = continues};
        history->done = history->count;
    }
    history->revision++;
    return true;
}

bool edit_history_undo(EditHistory *history) {
    if (history->done == history->base_count) {
        return false;
    }
    do {
        history->done--;
    } while (history->done > history->base_count && history->edits[history->done].continues);
    history->revision++;
    return true;
}

bool edit_history_redo(EditHistory *history) {
    if (history->done == history->count) {
        return false;
    }
    do {
        history->done++;
    } while (history->done < history->count && history->edits[history->done].continues);
    history->revision++;
    return true;
}

size_t edit_history_in_force(const EditHistory *history) {
    return history->done - history->base_count;
}

const SceneOverride *edit_history_find(const EditHistory *history, const SceneOverride *field) {
    for (size_t i = history->done; i > 0; i--) {
        const Edit *edit = &history->edits[i - 1];
        if (scene_override_is_same_field(&edit->override, field)) {
            return edit->is_dormant ? NULL : &edit->override;
        }
    }
    return NULL;
}

size_t edit_history_overrides(const EditHistory *history, SceneOverride *overrides) {
    size_t count = 0;
    for (size_t i = 0; i < history->done; i++) {
        const SceneOverride *override = &history->edits[i].override;
        size_t k = history->edits[i].is_dormant ? SCENE_OVERRIDES_MAXIMUM : 0;
        while (k < count && !scene_override_is_same_field(&overrides[k], override)) {
            k++;
        }
        if (k < SCENE_OVERRIDES_MAXIMUM) {
            overrides[k] = *override;
            count = k == count ? count + 1 : count;
        }
    }
    return count;
}

bool edit_history_keep_original(EditHistory *history, const SceneOverride *original, Error *error) {
    for (size_t i = 0; i < history->base_count; i++) {
        if (scene_override_is_same_field(&history->edits[i].override, original)) {
            return true;
        }
    }
    if (!reserve(history, error)) {
        return false;
    }
    memmove(history->edits + 1, history->edits, history->count * sizeof *history->edits);
    history->edits[0] = (Edit){.override = *original, .is_dormant = true};
    history->count++;
    history->done++;
    history->base_count++;
    return true;
}

void edit_history_wake_originals(EditHistory *history, int keyword, int number) {
    for (size_t i = 0; i < history->base_count; i++) {
        const SceneOverride *override = &history->edits[i].override;
        if (override->keyword == keyword && override->number == number) {
            history->edits[i].is_dormant = false;
        }
    }
}
