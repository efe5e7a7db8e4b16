/**
 * @file
 * @brief An experiment: the same inputs for all methods of a family, at growing difficulty.
 *
 * An experiment is one `const Experiment` and a line in experiments.c. It generates samples (inputs
 * of one query or of several, and what is expected of them), and scores the outputs. It does not
 * depend on the methods, on the number types or on the engines.
 */
#ifndef DIOPTRE_LAB_EXPERIMENT_H
#define DIOPTRE_LAB_EXPERIMENT_H

#include "lab/methods/method.h"
#include "lab/random.h"
#include "lab/score_stats.h"

#include <stdatomic.h>

/** Most queries of a sample. */
enum { SAMPLE_QUERIES_MAXIMUM = 12 };
/** Most numbers that are expected of a sample. */
enum { SAMPLE_EXPECTED_MAXIMUM = 12 };
/** Most numbers of a sample's inputs. */
enum { SAMPLE_NUMBERS_MAXIMUM = SAMPLE_QUERIES_MAXIMUM * METHOD_NUMBERS_MAXIMUM };

/** Inputs that are scored together, and what is expected. */
typedef struct ExperimentSample {
    Quadruple inputs[SAMPLE_NUMBERS_MAXIMUM]; /**< Query after query, rounded to the number type. */
    Quadruple expected[SAMPLE_EXPECTED_MAXIMUM]; /**< What the experiment needs to score outputs. */
} ExperimentSample;

/** One level of an experiment in one number type. */
typedef struct ExperimentSetup {
    const NumberType *type; /**< Inputs are rounded to it. */
    double level;           /**< The difficulty. */
    const void *shared;     /**< Result of #Experiment.create_shared, or NULL. */
} ExperimentSetup;

/** In place of a level: the best one of each method, where the level is a parameter of methods. */
#define TIMED_LEVEL_BEST (-1.0)

/** An experiment. */
typedef struct Experiment {
    const char *name;        /**< As on the command line, such as `sphere-distance`. */
    const char *title;       /**< What it shows. */
    const char *family;      /**< Its methods are run. */
    const char *difficulty;  /**< What the levels are, with its unit. */
    const char *error_label; /**< What the error is, with its unit; NULL: none is measured. */
    bool is_relative;        /**< Whether errors are relative, and can be given in ulps. */
    const char *cost_label; /**< What an output costs, such as `steps`; NULL: nothing is counted. */
    const double *levels;   /**< Levels of difficulty, in this order. */
    size_t level_count;     /**< Number of levels. */
    size_t sample_count;    /**< Samples per level. */
    size_t queries_per_sample; /**< At least 1. */
    double timed_level; /**< The level at which the errors of methods are charted against their
                           time; #TIMED_LEVEL_BEST: the best one of each; 0: none. */

    /** Creates what all samples of a level share; NULL: nothing. @return It, to be released with
     *  free; NULL without memory. */
    void *(*create_shared)(double level);

    /** Generates a sample. @param[out] sample The sample, all zero before. */
    void (*generate)(const ExperimentSetup *setup, Random *random, ExperimentSample *sample);

    /** Scores the outputs of all queries of a sample. @param[in,out] score Errors and outcomes are
     *  added to it. */
    void (*score_sample)(const ExperimentSample *sample, const Quadruple *outputs,
                         ScoreStats *score);

    /**
     * Creates the scene in which the tracer's own engines compute the same; NULL: they have no such
     * function.
     * @param setup  The level; its number type is not set.
     * @return The scene, to be released with scene_destroy; NULL if anything is wrong.
     */
    Scene *(*create_scene)(const ExperimentSetup *setup, Error *error);

    /** Computes outputs by an engine in that scene. NULL: inputs begin with a ray's origin and
     *  direction, and the output is the distance of its nearest hit. */
    void (*query_engine)(const Engine *engine, Tracer *tracer, const ExperimentSample *sample,
                         Quadruple *outputs);

    /** Whether #query_engine asks for the nearest hit of one ray and for nothing else: then the
     *  engine is timed with many rays at once. */
    bool is_nearest_hit;
} Experiment;

/** Elements of an array. */
#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

/** Name of the tracer's own engines among the methods. */
#define TRACER_METHOD "dioptre"

/** Scores of a method in a number type at a level. */
typedef struct MethodResult {
    const char *method;                      /**< Its name, or #TRACER_METHOD. */
    const char *label;                       /**< Its short name. */
    const char *type;                        /**< The number type. */
    int mantissa_bits;                       /**< Of the number type. */
    double level;                            /**< The difficulty. */
    size_t sample_count;                     /**< Samples; 0: it was not run. */
    double median;                           /**< Error; NaN: none, here and below. */
    double p999;                             /**< Error that one in a thousand exceeds. */
    double maximum;                          /**< Largest error. */
    double outcome_fractions[OUTCOME_COUNT]; /**< Fractions, 0 to 1. */
    double failure_fraction; /**< Fraction of samples with any of these; NaN: none was possible. */
    double mean_cost;        /**< Mean cost of an output. */
} MethodResult;

/** Results of an experiment, ordered by method, then type, then level. */
typedef struct ExperimentResults {
    MethodResult *rows;  /**< The results; owned. */
    size_t method_count; /**< Methods. */
    size_t type_count;   /**< Number types. */
    size_t level_count;  /**< Levels. */
} ExperimentResults;

/** @return All number types, the narrowest first; ended by NULL. */
const NumberType *const *number_types(void);

/** @return All experiments, ended by NULL. */
const Experiment *const *experiment_list(void);

/** @return The engine with one lane and a number type, or NULL. */
const Engine *experiment_engine(const NumberType *type);

/** @return The tracer of a level, or NULL: there is no scene. @param engine May be NULL. */
Tracer *experiment_create_tracer(const Experiment *experiment, const Engine *engine,
                                 const ExperimentSetup *setup);

/**
 * Runs an experiment.
 * @param threads  How many threads run it.
 * @param stop  The run stops once this is true; may be NULL.
 * @param[out] results  The results, to be released with #experiment_results_deinit.
 * @param[out] error  What is wrong: #STATUS_INTERRUPTED, or no memory.
 * @return false if anything is wrong: then there are no results.
 */
bool experiment_run(const Experiment *experiment, int threads, const atomic_bool *stop,
                    ExperimentResults *results, Error *error);

/** @return A result. */
MethodResult *experiment_results_at(const ExperimentResults *results, size_t method, size_t type,
                                    size_t level);

/** @return A result by names, or NULL. For tests. */
const MethodResult *experiment_results_find(const ExperimentResults *results, const char *method,
                                            const char *type, double level);

/** Releases results. */
void experiment_results_deinit(ExperimentResults *results);

#endif
