/**
 * @file
 * @brief A survey: what the rays of pixels do, in numbers instead of colours.
 */
#ifndef DIOPTRE_SURVEY_H
#define DIOPTRE_SURVEY_H

#include <stdint.h>

/** What is wanted besides what the camera's rays meet first; these can be added up. */
enum {
    SURVEY_LIGHT = 1, /**< All rays are followed: colour, rays spent, lamps, the next surfaces. */
    SURVEY_STEPS = 2, /**< The marching steps of the camera's rays. */
    SURVEY_PLACE = 4  /**< Where on a picture they meet the surfaces. */
};

/** Lamps that are told apart; of the others nothing is noted. */
enum { SURVEY_LAMPS = 64 };

/** Rays that go on from the first surface: mirrored and refracted. */
enum { SURVEY_NEXT = 2 };

/** What is known of a pixel: of its camera's ray, and of what became of it. */
typedef struct SurveyPoint {
    int shape;             /**< Place of the shape that it meets first; -1: none. */
    double distance;       /**< How far away, scene units; infinite where nothing is met. */
    double normal[3];      /**< The surface's unit normal there, outwards; zero where none is. */
    double place[2];       /**< Where on a picture: (u, v); with #SURVEY_PLACE. */
    double color[3];       /**< What it brings back, linear; with #SURVEY_LIGHT. */
    uint32_t rays;         /**< Rays of the pixel, of all kinds; with #SURVEY_LIGHT. */
    uint32_t steps;        /**< Steps that its march took; with #SURVEY_STEPS. */
    uint64_t asked;        /**< Bit i: whether lamp i was asked there. */
    uint64_t dark;         /**< Bit i: whether something stood between. */
    int next[SURVEY_NEXT]; /**< What the rays that go on meet, as #shape says it: the mirrored one
                                first. */
    uint32_t next_count;   /**< How many go on. */
} SurveyPoint;

#endif
