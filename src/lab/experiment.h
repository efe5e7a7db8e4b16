/**
 * @file
 * @brief An experiment: the same questions to all methods of a family, under a stress that grows.
 *
 * An experiment is one `const Experiment` and a line in experiments.c. It poses a case (the numbers
 * of one question or of several, and the truth about them), and judges the answers. Who is asked,
 * and in which number types, it does not know.
 */
#ifndef DIOPTRE_LAB_EXPERIMENT_H
#define DIOPTRE_LAB_EXPERIMENT_H

#include "lab/methods/method.h"
#include "lab/random.h"
#include "lab/score_stats.h"

#include <stdatomic.h>

/** Most questions of a case. */
enum { SAMPLE_QUERIES_MAXIMUM = 12 };
/** Most numbers of a case's truth. */
enum { SAMPLE_EXPECTED_MAXIMUM = 12 };
/** Most numbers of a case's questions. */
enum { SAMPLE_NUMBERS_MAXIMUM = SAMPLE_QUERIES_MAXIMUM * METHOD_NUMBERS_MAXIMUM };

/** Questions that are asked together, and what is true. */
typedef struct ExperimentSample {
    Quadruple inputs[SAMPLE_NUMBERS_MAXIMUM];    /**< One after the other, rounded to the type. */
    Quadruple expected[SAMPLE_EXPECTED_MAXIMUM]; /**< What the experiment needs to judge. */
} ExperimentSample;

/** Where an experiment is made. */
typedef struct ExperimentSetup {
    const NumberType *type; /**< What the numbers of questions must be rounded to. */
    double level;           /**< The stress. */
    const void *shared;     /**< What #Experiment.create_shared has made, or NULL. */
} ExperimentSetup;

/** In place of a level: the one at which a method is best, where the stress is its own choice. */
#define TIMED_LEVEL_BEST (-1.0)

/** An experiment. */
typedef struct Experiment {
    const char *name;        /**< As on the command line, such as `sphere-distance`. */
    const char *title;       /**< What it shows. */
    const char *family;      /**< Its methods are run. */
    const char *difficulty;  /**< What grows, with its unit. */
    const char *error_label; /**< What the error is, with its unit; NULL: none is measured. */
    bool is_relative;        /**< Whether errors are relative, so that ulps make sense. */
    const char *cost_label; /**< What an answer costs, such as `steps`; NULL: nothing is counted. */
    const double *levels;   /**< Of the stress, in the order in which they are asked. */
    size_t level_count;     /**< How many. */
    size_t sample_count;    /**< How many a level. */
    size_t queries_per_sample; /**< Questions of a case, at least 1. */
    double timed_level; /**< The level at which methods are held against their time: where they
                       differ; #TIMED_LEVEL_BEST: each at the one that suits it; 0: none. */

    /** Makes what all cases of a level have in common; NULL: there is no such thing. @return It, to
     *  be given back with free; NULL without memory. */
    void *(*create_shared)(double level);

    /**
     * Makes a case.
     * @param[in,out] random  Where it comes from.
     * @param[out] posed  The case; all zero before.
     */
    void (*generate)(const ExperimentSetup *setting, Random *random, ExperimentSample *posed);

    /**
     * Judges answers.
     * @param answers  Those to its questions, one after the other.
     * @param[in,out] score  Errors and outcomes are added to it.
     */
    void (*score_sample)(const ExperimentSample *posed, const Quadruple *answers,
                         ScoreStats *score);

    /**
     * Makes the scene in which the tracer's own engines meet the same thing; NULL: they have no
     * such part.
     * @param setting  Where; its number type says nothing.
     * @return The scene, to be given back with scene_destroy; NULL if anything is wrong.
     */
    Scene *(*create_scene)(const ExperimentSetup *setting, Error *error);

    /** Asks an engine instead of a method; NULL: a question begins with a ray's origin and
     *  direction, and an answer is the distance of the nearest hit. @param tracer The tracer of the
     *  scene. */
    void (*query_engine)(const Engine *engine, Tracer *tracer, const ExperimentSample *posed,
                         Quadruple *answers);
} Experiment;

/** How many things an array has. */
#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

/** The name under which the tracer's own engines appear among the methods. */
#define TRACER_METHOD "dioptre"

/** A method in a number type at a level of stress. */
typedef struct MethodResult {
    const char *method;                      /**< Its name, or #TRACER_METHOD. */
    const char *label;                       /**< The same, short. */
    const char *type;                        /**< The number type. */
    int mantissa_bits;                       /**< Of the number type. */
    double level;                            /**< The stress. */
    size_t sample_count;                     /**< How often it was asked; 0: not at all. */
    double median;                           /**< Error; NaN where there is none, here and below. */
    double p999;                             /**< Error that one in a thousand exceeds. */
    double maximum;                          /**< Largest error. */
    double outcome_fractions[OUTCOME_COUNT]; /**< Outcomes, 0 to 1. */
    double mean_cost;                        /**< Mean cost of an answer. */
} MethodResult;

/** All that was found in an experiment: method by method, in each type by type, level by level. */
typedef struct ExperimentResults {
    MethodResult *rows;  /**< The findings; owned. */
    size_t method_count; /**< Methods. */
    size_t type_count;   /**< Number types. */
    size_t level_count;  /**< Levels. */
} ExperimentResults;

/** @return The number types there are, the narrowest first; ended by NULL. */
const NumberType *const *number_types(void);

/** @return The experiments there are, ended by NULL. */
const Experiment *const *experiment_list(void);

/**
 * Makes an experiment.
 * @param threads  How many work at once.
 * @param stop  It is given up once this is true; may be NULL.
 * @param[out] results  What was found, to be given back with #experiment_results_deinit.
 * @param[out] error  What is wrong: #STATUS_INTERRUPTED, or no memory.
 * @return false if anything is wrong: then there are no findings.
 */
bool experiment_run(const Experiment *experiment, int threads, const atomic_bool *stop,
                    ExperimentResults *results, Error *error);

/** @return A finding. */
MethodResult *experiment_results_at(const ExperimentResults *results, size_t method, size_t type,
                                    size_t level);

/** Finds a finding by names: for tests. @return The finding, or NULL. */
const MethodResult *experiment_results_find(const ExperimentResults *results, const char *method,
                                            const char *type, double level);

/** Gives findings back. */
void experiment_results_deinit(ExperimentResults *results);

#endif
