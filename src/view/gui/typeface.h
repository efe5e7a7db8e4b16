/**
 * @file
 * @brief The typeface of the interface: where its files are.
 */
#ifndef DIOPTRE_VIEW_GUI_TYPEFACE_H
#define DIOPTRE_VIEW_GUI_TYPEFACE_H

#ifdef __cplusplus
extern "C" {
#endif

/** A typeface in two weights, TrueType. */
typedef struct Typeface {
    const char *regular; /**< File of the regular weight. */
    const char *bold;    /**< File of the bold weight; it may be missing. */
} Typeface;

/** @return An installed typeface with the letters of French, signs and arrows; NULL: none. */
const Typeface *typeface_find(void);

#ifdef __cplusplus
}
#endif

#endif
