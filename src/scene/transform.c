/**
 * @file
 * @brief How a shape is stretched, turned and moved: its fields, and the matrix that follows.
 */
#include "dioptre/parameter.h"

#include <string.h>

/** Fields of every shape. */
static const Parameter transform_parameters[] = {
    {.name = "scale",
     .type = PARAMETER_SCALE,
     .offset = offsetof(Transform, scale),
     .minimum = -1 / SCALE_MINIMUM,
     .maximum = 1 / SCALE_MINIMUM,
     .unit = "times",
     .help = "first it is made so many times as large; negative: mirrored"},
    {.name = "rotate",
     .type = PARAMETER_VECTOR,
     .offset = offsetof(Transform, rotate),
     .minimum = -36000,
     .maximum = 36000,
     .unit = "degrees",
     .help = "then turned about x, then y, then z"},
    {.name = "translate",
     .type = PARAMETER_POINT,
     .offset = offsetof(Transform, translate),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "then moved"},
    {0}};

/** A shape as its own fields say it. */
static const Transform transform_defaults = {.scale = {1, 1, 1}};

/** A rotation about an axis. */
typedef struct CosineSine {
    double cosine; /**< Of its angle. */
    double sine;   /**< Of its angle. */
} CosineSine;

/** @return A rotation; exact for whole quarters, so that a turned box stays along the axes. */
static CosineSine cosine_sine_of(double degrees) {
    static const CosineSine quarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    double quarters_turned = degrees / 90;
    if (quarters_turned == floor(quarters_turned)) {
        return quarters[((int)quarters_turned % 4 + 4) % 4];
    }
    double angle = remainder(degrees, 360) * (M_PI / 180);
    return (CosineSine){cos(angle), sin(angle)};
}

/**
 * Turns what a matrix makes about an axis: two of its rows change.
 * @param axis  0, 1 or 2 for x, y or z.
 * @param degrees  The angle; from y to z, z to x or x to y.
 */
static void matrix_rotate(double matrix[3][3], int axis, double degrees) {
    CosineSine rotation = cosine_sine_of(degrees);
    double *row_u = matrix[(axis + 1) % 3], *row_v = matrix[(axis + 2) % 3];
    for (int column = 0; column < 3; column++) {
        double u = row_u[column], v = row_v[column];
        row_u[column] = rotation.cosine * u - rotation.sine * v;
        row_v[column] = rotation.sine * u + rotation.cosine * v;
    }
}

/** Refuses what would make a shape flat, and works out the matrix. See #Keyword.finish. @return
 *  false where a scale is zero, or as good as zero. */
static bool transform_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    Transform *transform = values;
    const Vec3d s = transform->scale, angles = transform->rotate;
    if (!(fmin(fabs(s.x), fmin(fabs(s.y), fabs(s.z))) >= SCALE_MINIMUM)) {
        return error_set(error, STATUS_SCENE, "scale must not be nearer to zero than %g",
                         SCALE_MINIMUM);
    }
    const double scaled[3][3] = {{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}};
    memcpy(transform->matrix, scaled, sizeof scaled);
    matrix_rotate(transform->matrix, 0, angles.x);
    matrix_rotate(transform->matrix, 1, angles.y);
    matrix_rotate(transform->matrix, 2, angles.z);
    return true;
}

const Keyword transform_keyword = {.name = "every shape",
                                   .help = "what all shapes take besides their own fields",
                                   .parameters = transform_parameters,
                                   .size = sizeof(Transform),
                                   .defaults = &transform_defaults,
                                   .finish = transform_finish};
