/**
 * @file
 * @brief What experiments pose their cases with.
 */
#ifndef DIOPTRE_LAB_EXPERIMENTS_SAMPLE_WRITER_H
#define DIOPTRE_LAB_EXPERIMENTS_SAMPLE_WRITER_H

#include "lab/experiment.h"
#include "lab/scene_fixture.h"

/** Numbers one after the other, as a method's question wants them. */
typedef struct SampleWriter {
    const NumberType *type; /**< What they are rounded to. */
    Quadruple *next;        /**< Where the next goes. */
} SampleWriter;

/** @return The nearest point of a number type. */
Vec3q vec3q_round(const NumberType *type, Vec3q v);

/** @return The vector that was written: rounded. */
Vec3q sample_writer_vec3(SampleWriter *writer, Vec3q v);

/** @return The number that was written: rounded. */
Quadruple sample_writer_number(SampleWriter *writer, Quadruple x);

/** @return A place that is so far from the origin of the world, in no special direction, and that
 *  float can hold. */
Vec3q far_point(double distance);

/** Numbers for a scene: three of a vector. */
void vec3q_to_doubles(Vec3q v, double numbers[3]);

/**
 * @return Where a ray first meets a sphere, in quad precision: the discriminant from the nearest
 *         point of its line, the near root as a quotient. #QUAD_NO_HIT where it does not.
 * @param origin  Where the ray starts.
 * @param direction  Which way, of any length.
 */
Quadruple sphere_expected(Vec3q origin, Vec3q direction, Vec3q center, Quadruple radius);

/**
 * @return The scene of a sphere.
 * @param center  Its centre, as a double can hold it.
 */
Scene *sphere_scene(Vec3q center, double radius, Error *error);

/** Asks an engine a ray. @param ray Where it starts, and which way. */
void intersect_ray(const Engine *engine, const Tracer *tracer, const Vec3q ray[2],
                   RayResult *answer);

/** @return Three numbers as a vector. */
Vec3q vec3q_from_array(const Quadruple numbers[3]);

/** Said in place of a count by who meets something and does not say how often: engines. */
#define COUNT_UNKNOWN ((Quadruple)-1)

/** Judges how often a ray that leaves a solid meets its surface: once. See
 *  #Experiment.score_sample. */
void score_hit_count(const ExperimentSample *sample, const Quadruple *outputs, ScoreStats *score);

/** Asks an engine for distance and count: 0 or #COUNT_UNKNOWN. See #Experiment.query_engine. */
void query_hit_count(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                     Quadruple *outputs);

/** Judges a distance against the first number of the truth. See #Experiment.score_sample. */
void score_expected_distance(const ExperimentSample *sample, const Quadruple *outputs,
                             ScoreStats *score);

#endif
