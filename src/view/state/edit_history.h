/**
 * @file
 * @brief What the user has changed of a scene's objects, with undo and redo.
 *
 * An edit gives one field of one object a value. Edits that belong together, such as those of one
 * drag, are undone and done again at once. Without a screen.
 */
#ifndef DIOPTRE_VIEW_STATE_EDIT_HISTORY_H
#define DIOPTRE_VIEW_STATE_EDIT_HISTORY_H

#include "dioptre/scene_override.h"

/** Most edits of a history. */
enum { EDITS_MAXIMUM = 65536 };

/** An edit. */
typedef struct Edit {
    SceneOverride override; /**< The field and its value. */
    bool continues;         /**< Whether it belongs to the edit before it. */
    bool is_dormant;        /**< Whether it has no effect: the file still gives this value. */
} Edit;

/** All edits. Starts as `{0}`: none. */
typedef struct EditHistory {
    Edit *edits;       /**< The edits, oldest first; owned. */
    size_t count;      /**< Their number. */
    size_t capacity;   /**< Edits that #edits has room for. */
    size_t base_count; /**< The first edits, which no undo takes back: the values of the file. */
    size_t done;       /**< Number of edits in force; those after them are undone. */
    uint64_t revision; /**< Grows with every change of what is in force. */
} EditHistory;

/** Frees all edits. */
void edit_history_deinit(EditHistory *history);

/** Forgets all edits. */
void edit_history_clear(EditHistory *history);

/**
 * Adds an edit; what was undone is forgotten.
 * @param continues   Whether it belongs to the edit before it, if there is one in force. Such an
 *                    edit replaces an earlier one of the same field and group.
 * @param[out] error  No memory, or too many edits.
 * @return Whether it is added.
 */
bool edit_history_add(EditHistory *history, const SceneOverride *override, bool continues,
                      Error *error);

/** Forgets the edits that are undone: something else was changed. */
void edit_history_forget_undone(EditHistory *history);

/** Takes the last group of edits back. @return false if there is none. */
bool edit_history_undo(EditHistory *history);

/** Does the group of edits again that was taken back last. @return false if there is none. */
bool edit_history_redo(EditHistory *history);

/** @return Number of edits in force that can be undone. */
size_t edit_history_in_force(const EditHistory *history);

/** @return The value of a field, with the object and row of \p field; NULL: no edit in force. */
const SceneOverride *edit_history_find(const EditHistory *history, const SceneOverride *field);

/**
 * Lists the values in force, one per field.
 * @param[out] overrides  At most #SCENE_OVERRIDES_MAXIMUM; the oldest fields come first.
 * @return Their number.
 */
size_t edit_history_overrides(const EditHistory *history, SceneOverride *overrides);

/** Remembers the value that the file gives a field, unless it is known. @return Whether there was
 *  memory. */
bool edit_history_keep_original(EditHistory *history, const SceneOverride *original, Error *error);

/** The file gives an object other values now: undo leads back to its original ones. */
void edit_history_wake_originals(EditHistory *history, int keyword, int number);

#endif
