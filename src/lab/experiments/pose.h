/**
 * @file
 * @brief What experiments pose their cases with.
 */
#ifndef DIOPTRE_LAB_EXPERIMENTS_POSE_H
#define DIOPTRE_LAB_EXPERIMENTS_POSE_H

#include "lab/experiment.h"
#include "lab/stage.h"

/** Numbers one after the other, as a method's question wants them. */
typedef struct Writer {
    const NumberType *type; /**< What they are rounded to. */
    Quadruple *next;        /**< Where the next goes. */
} Writer;

/** @return The nearest point of a number type. @param type The type. @param v A point. */
Quad3 rounded(const NumberType *type, Quad3 v);

/** @return The vector that was written: rounded. @param[in,out] writer Where to. @param v It. */
Quad3 write_vector(Writer *writer, Quad3 v);

/** @return The number that was written: rounded. @param[in,out] writer Where to. @param x It. */
Quadruple write_number(Writer *writer, Quadruple x);

/** @return A place that is so far from the origin of the world, in no special direction, and that
 *          float can hold. @param far How far. */
Quad3 place_far(double far);

/** Numbers for a scene: three of a vector. @param v It. @param[out] numbers Its coordinates. */
void to_numbers(Quad3 v, double numbers[3]);

/**
 * @return Where a ray first meets a sphere, in quad precision: the discriminant from the nearest
 *         point of its line, the near root as a quotient. #QUAD_NONE where it does not.
 * @param origin     Where the ray starts.
 * @param direction  Which way, of any length.
 * @param center     The sphere's centre.
 * @param radius     Its radius.
 */
Quadruple sphere_truth(Quad3 origin, Quad3 direction, Quad3 center, Quadruple radius);

/** @return The scene of a sphere. @param center Its centre, as a double can hold it.
 *  @param radius Its radius. @param[out] error What is wrong. */
Scene *sphere_scene(Quad3 center, double radius, Error *error);

/** Asks an engine a ray. @param engine The engine. @param tracer Its tracer. @param ray Where it
 *  starts, and which way. @param[out] answer The answer. */
void engine_ask(const Engine *engine, const Tracer *tracer, const Quad3 ray[2], RayAnswer *answer);

/** @return Three numbers as a vector. @param numbers The numbers. */
Quad3 quad3_of(const Quadruple numbers[3]);

/** Said in place of a count by who meets something and does not say how often: engines. */
#define COUNT_UNKNOWN ((Quadruple)-1)

/** Judges how often a ray that leaves a solid meets its surface: once. See #Experiment.judge.
 *  @param posed Not looked at. @param answers Distance and count. @param[in,out] score The score.
 */
void judge_count(const Case *posed, const Quadruple *answers, Score *score);

/** Asks an engine for distance and count: 0 or #COUNT_UNKNOWN. See #Experiment.ask.
 *  @param engine The engine. @param tracer Its tracer. @param posed The case. @param[out] answers
 *  Distance and count. */
void ask_count(const Engine *engine, Tracer *tracer, const Case *posed, Quadruple *answers);

/** Judges a distance against the first number of the truth. See #Experiment.judge. @param posed The
 *  case. @param answers The distance. @param[in,out] score The score. */
void judge_distance(const Case *posed, const Quadruple *answers, Score *score);

#endif
