/**
 * @file
 * @brief A lesson: what is done in the window, and when, with words for the class.
 *
 * A lesson is plain data. It lives in one block of memory that a worker process can make and send,
 * as a scene does.
 */
#ifndef DIOPTRE_LESSON_H
#define DIOPTRE_LESSON_H

#include "dioptre/error.h"

#include <limits.h>
#include <stddef.h>
#include <stdint.h>

/** Most steps of a lesson. */
enum { LESSON_STEPS_MAXIMUM = 65536 };
/** Bytes that all words of a lesson may take. */
enum { LESSON_TEXT_MAXIMUM = 1 << 20 };
/** Longest time from a step to the next, seconds. */
#define LESSON_WAIT_MAXIMUM 3600.0

/** Words in the languages of the program; owned by the lesson. */
typedef struct LessonText {
    const char *english; /**< UTF-8; NULL: there are none. */
    const char *french;  /**< UTF-8; NULL: there are none. */
} LessonText;

/** What a step does. */
typedef enum {
    LESSON_PRESS,   /**< A key goes down: an action begins. */
    LESSON_RELEASE, /**< A key goes up: a move ends. */
    LESSON_SPEED,   /**< Moves go faster or slower: Shift, Ctrl. */
    LESSON_TURN,    /**< The camera turns: the mouse is dragged. */
    LESSON_ZOOM,    /**< The field of view gets narrower or wider: the wheel. */
    LESSON_SIZE,    /**< The window gets another size. */
    LESSON_PIXEL,   /**< The rays of a pixel are shown: a click. */
    LESSON_WALK,    /**< The rays of a pixel beside: Ctrl and an arrow. */
    LESSON_BAR,     /**< The bar between two pictures is dragged. */
    LESSON_CAPTION, /**< Words at the lower edge. */
    LESSON_SNAPSHOT /**< The finished picture is kept, where that is asked for. */
} LessonStepKind;

/** One thing that is done. */
typedef struct LessonStep {
    LessonStepKind kind;   /**< What. */
    int64_t time;          /**< When, milliseconds from the beginning. */
    int action;            /**< Which, for #LESSON_PRESS and #LESSON_RELEASE: its place in the list
                                of names that the lesson was read with. */
    double x;              /**< Factor of the speed; degrees to the right; notches of the wheel
                                    towards what is seen; width in the screen's units; share of the
                                    picture's width; pixels to the right. */
    double y;              /**< Degrees up; height in the screen's units; share of the picture's
                                 height, from its upper edge; pixels down. */
    LessonText text;       /**< A caption's words. */
    bool waits_for_viewer; /**< Whether a caption waits until the class has read it. */
} LessonStep;

/** How the scene is drawn at first; where nothing is said, as the command line and it say. */
typedef struct LessonSettings {
    int samples;        /**< Rays a pixel; 0: not said. */
    int depth;          /**< How often a ray may be mirrored or refracted; -1: not said. */
    int offset;         /**< An #OffsetStrategy; -1: not said. */
    double epsilon;     /**< Scene units; negative: not said. */
    int width;          /**< The window's; 0: not said. */
    int height;         /**< The window's; 0: not said. */
    double time;        /**< The scene's `t`, seconds. */
    const char *engine; /**< The engine's name; NULL: not said. Owned by the lesson. */
} LessonSettings;

/** A lesson. */
typedef struct Lesson {
    char scene[PATH_MAX];                   /**< Its scene's file; empty: none was said yet. */
    LessonText title;                       /**< What it is called. */
    LessonSettings initial_settings;        /**< How the scene is drawn at first. */
    size_t count;                           /**< How many steps. */
    LessonStep steps[LESSON_STEPS_MAXIMUM]; /**< What is done, in the order of time. */
    size_t text_used;                       /**< Bytes of #text that are taken. */
    char text[LESSON_TEXT_MAXIMUM];         /**< All words. */
} Lesson;

/** @return An empty lesson, to be given back with #lesson_destroy; NULL without memory.
 *  @param[out] error What is wrong. */
Lesson *lesson_create(Error *error);

/** Makes an empty lesson at an address of its own, in a worker process. @return NULL where the
 *  address is taken. */
Lesson *lesson_create_at(void *address, Error *error);

/** @return Bytes of a lesson's block that are used: all that another process needs of it. */
size_t lesson_block_size(const Lesson *lesson);

/** Gives a lesson back. @param lesson The lesson, or NULL. */
void lesson_destroy(Lesson *lesson);

/**
 * Adds a step.
 * @param[in,out] lesson  The lesson.
 * @param step            What is done; not before the last one; copied.
 * @param[out] error      That the lesson is full.
 * @return Whether it was added.
 */
bool lesson_add(Lesson *lesson, const LessonStep *step, Error *error);

/**
 * Keeps words.
 * @param[in,out] lesson  The lesson.
 * @param text           UTF-8; copied.
 * @param[out] error      That the lesson is full.
 * @return The copy, the lesson's; NULL if there is no room.
 */
const char *lesson_store_text(Lesson *lesson, const char *text, Error *error);

/** @return Words in one language, else in the other; empty without any. @param text The words.
 *  @param is_french Whether French is wanted. */
const char *lesson_text_localized(const LessonText *text, bool is_french);

#endif
