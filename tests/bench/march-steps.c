/**
 * @file
 * @brief Sphere tracing in float: number of steps to a plane, and the cost of normals.
 *
 * Called by `make bench`: `march-steps steps` and `march-steps normals`, which print CSV. Steps:
 * method, angle, steps, the formula ln(h / eps) / -ln(1 - sin a), and the error of the distance
 * times the sine, in tolerances. Normals: field, method, width of the difference, nanoseconds per
 * normal, worst error in radians.
 *
 * The tracer's own sources are compiled into this program, for one lane.
 */
#ifndef REAL_BITS
#define REAL_BITS 32
#endif
#define LANES 1
#include "../src/trace/sdf/sphere_tracer.c"
#include "../src/trace/sdf/sphere_tracer_init.c"
#include "../src/trace/shapes/aabb.c"
#include "sdf_compiled.h"

#include "sdf_builders.h"

#include <time.h>

/* --- steps ------------------------------------------------------------------------------------ */

/** Counts evaluations of a field by its first instruction. */
static struct {
    void (*run)(SdfVm *machine, const SdfInstruction *code); /**< The original instruction. */
    int count;                                               /**< Number of evaluations. */
} count_state;

/** Counts, and executes the original instruction. See #SdfInstruction.execute. */
static void counted_run(SdfVm *m, const SdfInstruction *code) {
    count_state.count++;
    count_state.run(m, code);
}

/** Traces a ray to a plane and prints its steps. @param way Name of the method. */
static void steps_print(const char *way, double relaxation, double degrees) {
    const double eps = 1e-4, angle = degrees * M_PI / 180;
    // A sphere far away makes the field's box as high as the ray's origin.
    Sdf *ground = translate_sdf(make_sdf("box", (double[]){4096, 16, 4096}), 0, -8, 0);
    Sdf *both = join_sdfs(SDF_COMBINE_UNION, ground,
                          translate_sdf(make_sdf("sphere", NULL), -1900, 1, 0), 0);
    void *memory = allocate_program(both);
    StepLimitCounter step_limit = {0};
    SphereTracer sphere_tracer = {.tolerance = (scalar)eps,
                                  .relaxation = (scalar)relaxation,
                                  .max_steps = 1000000,
                                  .step_limit_counter = &step_limit};
    Aabbs box;
    sphere_tracer_init(&sphere_tracer, both, memory, &box);
    SdfInstruction *codes = sphere_tracer.program.instructions;
    count_state.run = codes[0].execute;
    count_state.count = 0;
    codes[0].execute = counted_run;
    Ray ray = ray_of((Vec3){0, 1, 0}, (Vec3){(scalar)cos(angle), (scalar)-sin(angle), 0});
    SphereTrace march;
    bool is_met = sphere_trace_run(&sphere_tracer, &ray, 1, INFINITE, false, &march);
    double law = log(1 / (double)sphere_tracer.tolerance) / -log(1 - sin(angle)),
           truth = -1 / (double)ray.direction.y;
    double error = fabs((double)sphere_trace_distance(&march) - truth) * sin(angle) /
                   (double)sphere_tracer.tolerance;
    printf("%s,%g,%d,%.1f,%.3f\n", way, degrees, is_met ? count_state.count : -1, law, error);
    free(memory);
    free(both);
}

/** Prints the steps of all methods at all angles. */
static void steps_print_all(void) {
    static const double angles[] = {30, 10, 3, 1, 0.3, 0.1};
    static const struct {
        const char *name;
        double relaxation;
    } ways[] = {{"1", 1}, {"1.2", 1.2}, {"1.6", 1.6}, {"slope", 0}};
    printf("way,degrees,steps,law,error\n");
    for (size_t w = 0; w < sizeof ways / sizeof *ways; w++) {
        for (size_t i = 0; i < sizeof angles / sizeof *angles; i++) {
            steps_print(ways[w].name, ways[w].relaxation, angles[i]);
        }
    }
}

/* --- normals ---------------------------------------------------------------------------------- */

/** Points on a surface, and repetitions of the measurement. */
enum { POINTS = 4096, ROUNDS = 50 };

/** A surface. */
typedef struct SampledSurface {
    const char *name;    /**< Its name. */
    SdfProgram program;  /**< Its program. */
    Vec3 at[POINTS];     /**< Points near it, rounded. */
    double n[POINTS][3]; /**< Exact normals there. */
} SampledSurface;

/** @return The value of a field at a point. */
static real sdf_value(const SampledSurface *s, Vec3 p) {
    return sdf_distance(&s->program, p, 1);
}

/** @return The analytic normal. */
static Vec3 exact_normal(const SampledSurface *s, Vec3 p, real h) {
    (void)h;
    return sdf_sample(&s->program, p, 1).gradient;
}

/** @return The normal by central differences: six points. */
static Vec3 central_normal(const SampledSurface *s, Vec3 p, real h) {
    return (Vec3){sdf_value(s, (Vec3){p.x + h, p.y, p.z}) - sdf_value(s, (Vec3){p.x - h, p.y, p.z}),
                  sdf_value(s, (Vec3){p.x, p.y + h, p.z}) - sdf_value(s, (Vec3){p.x, p.y - h, p.z}),
                  sdf_value(s, (Vec3){p.x, p.y, p.z + h}) -
                      sdf_value(s, (Vec3){p.x, p.y, p.z - h})};
}

/** @return The normal by forward differences: four points, one of them the point itself. */
static Vec3 forward_normal(const SampledSurface *s, Vec3 p, real h) {
    real here = sdf_value(s, p);
    return (Vec3){sdf_value(s, (Vec3){p.x + h, p.y, p.z}) - here,
                  sdf_value(s, (Vec3){p.x, p.y + h, p.z}) - here,
                  sdf_value(s, (Vec3){p.x, p.y, p.z + h}) - here};
}

/** @return The normal by the vertices of a tetrahedron. */
static Vec3 tetrahedron_normal(const SampledSurface *s, Vec3 p, real h) {
    real a = sdf_value(s, (Vec3){p.x + h, p.y - h, p.z - h});
    real b = sdf_value(s, (Vec3){p.x - h, p.y - h, p.z + h});
    real c = sdf_value(s, (Vec3){p.x - h, p.y + h, p.z - h});
    real d = sdf_value(s, (Vec3){p.x + h, p.y + h, p.z + h});
    return (Vec3){a - b - c + d, -a - b + c + d, -a + b - c + d};
}

/** @return Processor time of this process, seconds. */
static double process_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/**
 * @return The angle between a normal and the exact one, radians.
 * @param truth  The exact one, a unit vector.
 */
static double normal_angle(Vec3 n, const double *truth) {
    Vec3d normal = {(double)n.x, (double)n.y, (double)n.z};
    double length = vec3d_length(normal);
    Vec3d difference =
        vec3d_subtract(vec3d_scale(normal, 1 / length), (Vec3d){truth[0], truth[1], truth[2]});
    return length > 0 ? 2 * asin(fmin(1, 0.5 * vec3d_length(difference))) : M_PI;
}

/** Measures a method. */
static void normals_print(const SampledSurface *s, const char *way,
                          Vec3 (*normal)(const SampledSurface *, Vec3, real), double h) {
    double worst = 0, fastest = HUGE_VAL;
    static volatile real sink;
    for (int i = 0; i < POINTS; i++) {
        worst = fmax(worst, normal_angle(normal(s, s->at[i], (real)h), s->n[i]));
    }
    for (int round = 0; round < ROUNDS; round++) {
        double start = process_seconds();
        for (int i = 0; i < POINTS; i++) {
            sink = normal(s, s->at[i], (real)h).x;
        }
        fastest = fmin(fastest, (process_seconds() - start) / POINTS);
    }
    (void)sink;
    printf("%s,%s,%g,%.2f,%.3g\n", s->name, way, h, 1e9 * fastest, worst);
}

/**
 * Sets points on a surface by its equation.
 * @param ring Major radius of a torus with minor radius 0.25; 0: a sphere of radius 1.
 */
static void place_points(SampledSurface *s, double ring) {
    uint64_t seed = 1;
    for (int i = 0; i < POINTS; i++) {
        double turn = 2 * M_PI * random_unit_double(&seed),
               around = 2 * M_PI * random_unit_double(&seed);
        double up = ring > 0 ? sin(around) : 2 * random_unit_double(&seed) - 1;
        double across = ring > 0 ? cos(around) : sqrt(1 - up * up), radius = ring > 0 ? 0.25 : 1;
        double *n = s->n[i];
        n[0] = across * cos(turn);
        n[1] = up;
        n[2] = across * sin(turn);
        s->at[i] = (Vec3){(real)(ring * cos(turn) + radius * n[0]), (real)(radius * n[1]),
                          (real)(ring * sin(turn) + radius * n[2])};
    }
}

/** Prints all methods for a field. */
static void surface_print(const char *name, Sdf *field, double ring) {
    static SampledSurface s;
    CompiledSdf compiled = compile_sdf(field);
    s = (SampledSurface){.name = name, .program = compiled.program};
    place_points(&s, ring);
    normals_print(&s, "exact", exact_normal, 0);
    for (double h = 0.1; h > 5e-7; h /= sqrt(10)) {
        normals_print(&s, "central", central_normal, h);
        normals_print(&s, "forward", forward_normal, h);
        normals_print(&s, "tetrahedron", tetrahedron_normal, h);
    }
    free(compiled.memory);
    free(field);
}

/** Prints steps or normals. @return 0 */
int main(int count, char **arguments) {
    if (count == 2 && strcmp(arguments[1], "steps") == 0) {
        steps_print_all();
    } else {
        printf("field,way,h,ns,error\n");
        surface_print("ball", make_sdf("sphere", NULL), 0);
        surface_print("ring", make_sdf("torus", (double[]){1, 0.25}), 1);
        Sdf *near = join_sdfs(SDF_COMBINE_SMOOTH_UNION, make_sdf("torus", (double[]){1, 0.25}),
                              translate_sdf(make_sdf("sphere", NULL), 0, 9, 0), 0.25);
        surface_print("melted", near, 1);
    }
    return 0;
}
