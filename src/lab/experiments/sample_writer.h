/**
 * @file
 * @brief What several experiments need to generate and score samples.
 */
#ifndef DIOPTRE_LAB_EXPERIMENTS_SAMPLE_WRITER_H
#define DIOPTRE_LAB_EXPERIMENTS_SAMPLE_WRITER_H

#include "lab/experiment.h"
#include "lab/scene_fixture.h"

/** Writes the inputs of a method, number after number. */
typedef struct SampleWriter {
    const NumberType *type; /**< Numbers are rounded to this type. */
    Quadruple *next;        /**< Where the next one goes. */
} SampleWriter;

/** @return A vector rounded to a number type. */
Vec3q vec3q_round(const NumberType *type, Vec3q v);

/** Writes a vector. @return The vector, rounded. */
Vec3q sample_writer_vec3(SampleWriter *writer, Vec3q v);

/** Writes a number. @return The number, rounded. */
Quadruple sample_writer_number(SampleWriter *writer, Quadruple x);

/**
 * Writes the corners of a triangle and the transformation of Baldwin and Weber, as the methods of
 * the family `triangle` take them.
 */
void sample_writer_triangle(SampleWriter *writer, const Vec3q corners[3]);

/** @return A float point at a distance from the origin, in a direction without symmetry. */
Vec3q far_point(double distance);

/** @return #far_point truncated to whole coordinates: sums with small whole numbers are exact. */
Vec3q far_whole_point(double distance);

/** Converts a vector to doubles, for a scene. */
void vec3q_to_doubles(Vec3q v, double numbers[3]);

/** @return Three numbers as a vector. */
Vec3q vec3q_from_array(const Quadruple numbers[3]);

/**
 * @return The distance to a sphere in quad precision, by a stable quadratic; #QUAD_NO_HIT: a miss.
 * @param direction  Of any length.
 */
Quadruple sphere_expected(Vec3q origin, Vec3q direction, Vec3q center, Quadruple radius);

/** @return A scene with a sphere. @param center Its centre, which doubles represent. */
Scene *sphere_scene(Vec3q center, double radius, Error *error);

/** Is an #Experiment.create_scene: a unit sphere; its distance from the origin is the level. */
Scene *create_far_sphere_scene(const ExperimentSetup *setup, Error *error);

/** Traces a ray by an engine. @param ray Origin and direction. */
void intersect_ray(const Engine *engine, const Tracer *tracer, const Vec3q ray[2],
                   RayResult *answer);

/** In place of a number of hits: engines report only the nearest hit. */
#define COUNT_UNKNOWN ((Quadruple)-1)

/** Is an #Experiment.score_sample: a ray from inside a solid hits its surface once. */
void score_hit_count(const ExperimentSample *sample, const Quadruple *outputs, ScoreStats *score);

/** Is an #Experiment.query_engine: the distance, and 0 or #COUNT_UNKNOWN hits. */
void query_hit_count(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                     Quadruple *outputs);

/** Is an #Experiment.score_sample: a distance, expected first in #ExperimentSample.expected. */
void score_expected_distance(const ExperimentSample *sample, const Quadruple *outputs,
                             ScoreStats *score);

/** Is an #Experiment.score_sample: the absolute error of a number, or that it is NaN. */
void score_absolute_error(const ExperimentSample *sample, const Quadruple *outputs,
                          ScoreStats *score);

#endif
