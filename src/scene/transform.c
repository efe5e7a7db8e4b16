/**
 * @file
 * @brief Transforms: scale, rotation and translation of shapes.
 */
#include "base/language.h"
#include "dioptre/parameter.h"

#include <string.h>

/** The fields of all shapes besides their own. */
static const Parameter transform_parameters[] = {
    {.name = "scale",
     .type = PARAMETER_SCALE,
     .offset = offsetof(Transform, scale),
     .minimum = -1 / SCALE_MINIMUM,
     .maximum = 1 / SCALE_MINIMUM,
     .unit = N_("times"),
     .help = N_("first it is made so many times as large; negative: mirrored")},
    {.name = "rotate",
     .type = PARAMETER_VECTOR,
     .offset = offsetof(Transform, rotate),
     .minimum = -36000,
     .maximum = 36000,
     .unit = N_("degrees"),
     .help = N_("then turned about x, then y, then z")},
    {.name = "translate",
     .type = PARAMETER_POINT,
     .offset = offsetof(Transform, translate),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = N_("scene units"),
     .help = N_("then moved")},
    {0}};

/** The identity. */
static const Transform transform_defaults = {.scale = {1, 1, 1}};

/** A rotation about an axis. */
typedef struct CosineSine {
    double cosine; /**< Cosine of its angle. */
    double sine;   /**< Sine of its angle. */
} CosineSine;

/**
 * @return The cosine and sine of an angle; exact for multiples of 90 degrees, so that boxes stay
 *         aligned with the axes.
 */
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
 * Multiplies a matrix by a rotation about an axis from the left, which changes two rows.
 * @param[in,out] matrix  The matrix.
 * @param axis            0, 1 or 2 for x, y or z.
 * @param degrees         The angle; from y to z, z to x or x to y.
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

/**
 * Rejects scales that are zero or too small, and computes the matrix. See #Keyword.finish.
 * @return Whether all scales are valid.
 */
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
