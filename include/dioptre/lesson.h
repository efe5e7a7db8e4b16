/**
 * @file
 * @brief A lesson: a sequence of actions in the window, with their times, and captions.
 *
 * A lesson is plain data in one block of memory, which a worker process can create and send like a
 * scene.
 */
#ifndef DIOPTRE_LESSON_H
#define DIOPTRE_LESSON_H

#include "base/error.h"
#include "dioptre/scene.h"

#include <limits.h>
#include <stddef.h>
#include <stdint.h>

/** Largest number of steps of a lesson. */
enum { LESSON_STEPS_MAXIMUM = 65536 };
/** Largest size of all texts of a lesson, bytes. */
enum { LESSON_TEXT_MAXIMUM = 1 << 20 };
/** Largest number of questions of a lesson. */
enum { LESSON_QUESTIONS_MAXIMUM = 64 };
/** Number of choices of a question: one key each, 1 to 9. */
enum { LESSON_CHOICES_MINIMUM = 2, LESSON_CHOICES_MAXIMUM = 9 };
/** Largest number of sentences about what a lesson teaches: they fit on the end card. */
enum { LESSON_LEARNT_MAXIMUM = 6 };
/** Largest number of lights that #LESSON_DRAG can name. */
enum { LESSON_LIGHTS_MAXIMUM = 1000000 };
/** Largest number of rays that #LESSON_RAY can name. */
enum { LESSON_RAYS_MAXIMUM = 1000000 };
/** Largest wait, seconds. */
#define LESSON_WAIT_MAXIMUM 3600.0

/** A text in the languages of the program; owned by the lesson. */
typedef struct LessonText {
    const char *english; /**< UTF-8; NULL: none. */
    const char *french;  /**< UTF-8; NULL: none. */
} LessonText;

/** The kinds of steps. */
typedef enum {
    LESSON_PRESS,   /**< The key of a command goes down. */
    LESSON_RELEASE, /**< The key of a move goes up. */
    LESSON_SPEED,   /**< The speed of moves changes: Shift, Ctrl. */
    LESSON_TURN,    /**< The camera rotates: the mouse is dragged. */
    LESSON_ORBIT,   /**< The camera rotates around a point: the right button is held. */
    LESSON_PAN,     /**< The camera moves in the plane of its picture: the middle one is held. */
    LESSON_ZOOM,    /**< The field of view changes: the wheel. */
    LESSON_SIZE,    /**< The window changes its size. */
    LESSON_PIXEL,   /**< The rays of a pixel are shown: a click. */
    LESSON_WALK,    /**< The rays of a pixel nearby are shown: Ctrl and an arrow. */
    LESSON_RAY,     /**< One of these rays is chosen: a click on it. */
    LESSON_MARK,    /**< A pixel is marked in the picture. */
    LESSON_BAR,     /**< The bar between two pictures is dragged. */
    LESSON_DRAG,    /**< A light is dragged in the picture. */
    LESSON_SELECT,  /**< An object is selected. */
    LESSON_SET,     /**< A field of an object gets a value. */
    LESSON_MOVE,    /**< An object is moved. */
    LESSON_CAPTION, /**< A caption is shown. */
    LESSON_ASK,     /**< A question is shown: the lesson waits for a prediction. */
    LESSON_EXPLAIN, /**< What was asked has been seen: the answer is shown. */
    LESSON_SNAPSHOT /**< The finished picture is saved, if the lesson plays unattended. */
} LessonStepKind;

/** A question about what will be seen next: predict, observe, explain. */
typedef struct LessonQuestion {
    LessonText text;                            /**< The question. */
    int choice_count;                           /**< Number of #choices. */
    LessonText choices[LESSON_CHOICES_MAXIMUM]; /**< The answers to choose from. */
    int right;                                  /**< Index of the right one. */
    LessonText because;                         /**< Why it is right. */
} LessonQuestion;

/** Units of #LessonStep.time per second. */
enum { MILLISECONDS_PER_SECOND = 1000 };

/** One step. */
typedef struct LessonStep {
    LessonStepKind kind; /**< Its kind. */
    int64_t time;        /**< Its time, milliseconds from the beginning. */
    int action; /**< The command of #LESSON_PRESS and #LESSON_RELEASE: an index into the names that
                   the lesson was read with. Index of the light of #LESSON_DRAG, of the ray of
                   #LESSON_RAY, of the question of #LESSON_ASK and #LESSON_EXPLAIN. Number of the
                   object of #LESSON_SELECT, #LESSON_SET and #LESSON_MOVE, see
                   SceneOverride::number; 0: none. */
    double x; /**< Speed factor; degrees to the right; notches of the wheel; width in screen units;
                 fraction of the picture's width; pixels to the right; scene units along x, or to
                 the right for #LESSON_PAN. -1 for #LESSON_SELECT without a pixel. */
    double y; /**< Degrees up; height in screen units; fraction of the picture's height, from the
                 top; pixels down; scene units along y. */
    double z; /**< Scene units along z, of #LESSON_DRAG and #LESSON_MOVE. With #x and #y the
                 numbers of #LESSON_SET. */
    double center[3];      /**< The point of #LESSON_ORBIT, scene units. */
    int keyword;           /**< Keyword of the object, see SceneOverride::keyword. */
    int row;               /**< Field of #LESSON_SET, see SceneOverride::row. */
    bool continues;        /**< Whether undo takes the step before it back, too. */
    LessonText text;       /**< Text of a caption. */
    bool waits_for_viewer; /**< Whether a caption pauses the lesson. */
} LessonStep;

/** Render settings at the beginning; unset values are those of command line and scene. */
typedef struct LessonSettings {
    int samples;       /**< Samples per pixel; 0: unset. */
    int depth;         /**< Depth of reflections and refractions; -1: unset. */
    int offset;        /**< An #OffsetStrategy; -1: unset. */
    double epsilon;    /**< Scene units; negative: unset. */
    int width;         /**< Width of the window, screen units; 0: unset. */
    int height;        /**< Height of the window, screen units; 0: unset. */
    double time;       /**< The scene's `t`, seconds. */
    double move_speed; /**< Scene units per second of a held key; 0: unset, half the distance to the
                            camera's target. */
    const char *engine; /**< Name of the engine, owned by the lesson; NULL: unset. */
} LessonSettings;

/** A lesson. */
typedef struct Lesson {
    char scene[PATH_MAX];                     /**< File of its scene; empty: not read yet. */
    LessonText title;                         /**< Its title. */
    size_t learnt_count;                      /**< Number of #learnt. */
    LessonText learnt[LESSON_LEARNT_MAXIMUM]; /**< What it teaches, a sentence each. */
    size_t question_count;                    /**< Number of #questions. */
    LessonQuestion questions[LESSON_QUESTIONS_MAXIMUM]; /**< Its questions, as they are asked. */
    LessonSettings initial_settings;                    /**< Render settings at the beginning. */
    size_t count;                                       /**< Number of steps. */
    LessonStep steps[LESSON_STEPS_MAXIMUM];             /**< The steps, in the order of time. */
    size_t text_used;                                   /**< Number of used bytes of #text. */
    char text[LESSON_TEXT_MAXIMUM];                     /**< All texts. */
} Lesson;

/**
 * Creates an empty lesson.
 * @param[out] error  What is wrong.
 * @return The lesson, to be freed with #lesson_destroy; NULL without memory.
 */
Lesson *lesson_create(Error *error);

/**
 * Creates an empty lesson at a given address, in a worker process.
 * @param address     The address.
 * @param[out] error  What is wrong.
 * @return The lesson; NULL if the address is not free.
 */
Lesson *lesson_create_at(void *address, Error *error);

/**
 * @return Bytes in use of the block of a lesson, all that another process needs.
 * @param lesson  The lesson.
 */
size_t lesson_block_size(const Lesson *lesson);

/**
 * Checks every pointer, index, number and flag of a lesson that another process has made.
 * @param lesson        The lesson, at the address where it was made.
 * @param size          Bytes that the process sent.
 * @param action_count  Number of names that #LessonStep.action counts.
 * @param[out] error    What is wrong (#STATUS_SCENE).
 * @return Whether it is valid.
 */
bool lesson_validate(const Lesson *lesson, size_t size, int action_count, Error *error);

/**
 * Checks that a scene has the objects and lights that the steps of a lesson name. Scenes that
 * depend on time are not checked.
 * @param[out] error  What is missing (#STATUS_SCENE).
 * @return Whether it has.
 */
bool lesson_check_scene(const Lesson *lesson, const Scene *scene, Error *error);

/** Frees a lesson. @param lesson The lesson, or NULL. */
void lesson_destroy(Lesson *lesson);

/**
 * Adds a step.
 * @param lesson      The lesson.
 * @param step        The step, not before the last one; copied.
 * @param[out] error  What is wrong.
 * @return false if the lesson is full.
 */
bool lesson_add(Lesson *lesson, const LessonStep *step, Error *error);

/**
 * Stores a text.
 * @param lesson      The lesson.
 * @param text        The text, UTF-8; copied.
 * @param[out] error  What is wrong.
 * @return The copy, owned by the lesson; NULL if the lesson is full.
 */
const char *lesson_store_text(Lesson *lesson, const char *text, Error *error);

/**
 * Adds a question, and the step that asks it.
 * @param lesson      The lesson.
 * @param question    The question; copied.
 * @param time        Time of the step, milliseconds; not before the last one.
 * @param[out] error  What is wrong.
 * @return false if the lesson is full.
 */
bool lesson_add_question(Lesson *lesson, const LessonQuestion *question, int64_t time,
                         Error *error);

/** @return Index of the first question with the same text: itself, or one asked before.
 *  @param question Index of a question. */
size_t lesson_first_asked(const Lesson *lesson, size_t question);

/** @return A text in one language, else in the other; empty without any. */
const char *lesson_text_localized(const LessonText *text, bool is_french);

#endif
