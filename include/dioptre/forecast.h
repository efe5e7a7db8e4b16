/**
 * @file
 * @brief A forecast: what can be said of a scene's errors from its numbers, before any ray is
 *        traced.
 *
 * Float has 24 bits. How far that is off in the picture is the product of its half ulp and of what
 * makes it grow: lengths against lengths, and turns of rays on curved mirrors. The forecast takes
 * the largest of these products, in 8-bit steps. It is meant for what one ray in ten thousand may
 * be off: `dioptre needs` looks whether that is true.
 */
#ifndef DIOPTRE_FORECAST_H
#define DIOPTRE_FORECAST_H

#include "dioptre/engine.h"

/** Half an 8-bit step of the encoded picture: what is off by less, nobody can tell. */
#define FORECAST_VISIBLE 0.5

/** What makes roundings grow. */
typedef enum {
    FORECAST_DISTANCE, /**< How far away things are, in their own sizes. */
    FORECAST_PIXEL,    /**< How narrow a pixel is: its angle against an ulp of a direction. */
    FORECAST_PLACE,    /**< How large coordinates are against what a pixel shows of them. */
    FORECAST_TURNS,    /**< Curved mirrors and glass: each makes rays go apart. */
    FORECAST_HORIZON,  /**< A picture on a plane without end: far away its texels crowd. */
    FORECAST_FRACTAL,  /**< A fractal: normals that turn within a tolerance. */
    FORECAST_WALL,     /**< Walls of glass that are thin against their coordinates. */
    FORECAST_FACETS,   /**< Faces of models that lamps see from a little behind. */
    FORECAST_COUNT     /**< How many there are. */
} ForecastCause;

/** What is forecast. */
typedef struct Forecast {
    double steps[FORECAST_COUNT]; /**< Steps that float may be off by, for each cause. */
    ForecastCause cause;          /**< The one with most. */
    double radii; /**< How far away the farthest thing is, in its own radii; 0: nothing ends. */
    double pixel; /**< Angle of a pixel, radians. */
    double share; /**< The largest share that a surface mirrors or lets through. */
    int turns;    /**< How many turns on curved surfaces were counted with. */
    int depth;    /**< How deep rays must be followed until none can change 8 bits. */
} Forecast;

/**
 * Looks at a scene's numbers. Takes no time to speak of.
 * @param scene  The scene.
 * @return The forecast.
 */
Forecast forecast_of(const Scene *scene);

/** @return Steps that float may be off by. @param forecast The forecast. */
static inline double forecast_steps(const Forecast *forecast) {
    return forecast->steps[forecast->cause];
}

/**
 * Finds the engine for a scene.
 * @param forecast  Of the scene.
 * @return The fastest that this machine can run and that is exact enough.
 */
const Engine *forecast_engine(const Forecast *forecast);

#endif
