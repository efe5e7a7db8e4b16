/**
 * @file
 * @brief Forecasting errors from the numbers of a scene.
 *
 * Each cause is a product: half an ulp of float, times how often it happens, times what makes it
 * grow, times how many steps the picture changes with it. The factors were compared with the whole
 * pictures of all scenes (doc/needs.md).
 */
#include "dioptre/forecast.h"

#include "render/facets.h"

#include <math.h>
#include <string.h>

/** Half an ulp of 1 in float. */
#define FLOAT_ROUNDOFF 0x1p-24

/** Steps of a picture. */
#define STEPS 255.0

/** Half ulps that a point may be off, and as far away rays start that leave it. */
#define PLACE_ROUNDINGS 16

/** Half ulps that a direction may be off. */
#define DIRECTION_ROUNDINGS 4

/** Share of a pixel that an edge may be moved by and nobody can tell. */
#define EDGE_SHARE (1.0 / 16)

/** How much farther apart rays go at a curved mirror: four spheres that mirror one another turn
 * them apart by 2.5 in the middle and by 4 in one case of a hundred. */
#define MIRROR_SPREAD 4

/** The same at a curved surface of glass, which bends less. */
#define GLASS_SPREAD 2

/** Steps between neighbouring texels of a picture that is full of detail. */
#define TEXEL_STEPS 40.0

/** How much more neighbouring texels differ in pictures of light, which hold the sun itself. */
#define LIGHT_CONTRAST 4

/** Share of the pixels that may be off. */
#define PIXELS_OFF 1e-4

/** How many times the share of faces in doubt it may become by chance: they come in rows. */
#define FACETS_CHANCE 1.25

/** Walls of glass that are thinner than so many half ulps of their coordinates may be jumped. */
#define WALL_ROUNDINGS 64

/** How deep rays are followed at most where nobody says: a guard, and deeper than eyes can count.
 */
enum { DEPTH_GUARD = 64 };

/** Turns that are counted with: fewer than one ray in ten thousand makes more on curved mirrors,
 *  even between four that touch. */
enum { TURNS_COUNTED = 8 };

/** Transparent shapes whose walls are compared; more are not looked at. */
enum { WALLS_MAXIMUM = 64 };

/** A box in the scene. */
typedef struct Box3 {
    Vector3 low;  /**< Lowest corner. */
    Vector3 high; /**< Highest corner. */
} Box3;

/** What is gathered from the shapes. */
typedef struct Survey {
    const Scene *scene;        /**< The scene. */
    const Engine *engine;      /**< Who measures. */
    Forecast *forecast;        /**< What comes of it. */
    int mirrors;               /**< Curved shapes that mirror. */
    int glasses;               /**< Curved shapes that let light through. */
    double mirrored;           /**< The largest share that a curved shape mirrors. */
    Box3 all;                  /**< A box around all shapes with an end. */
    Vector3 origin;            /**< Where tracers count from. */
    double facets;             /**< Share of the picture whose faces are lit otherwise in float. */
    double texels;             /**< Most texels that a turn of one radian may pass. */
    Box3 walls[WALLS_MAXIMUM]; /**< Boxes of transparent shapes. */
    size_t wall_count;         /**< How many. */
} Survey;

/** @return The largest primary. @param color A colour. */
static double largest(Color color) {
    return fmax(color.red, fmax(color.green, color.blue));
}

/** Keeps a number of steps that float may be off by. @param[in,out] forecast The forecast.
 *  @param cause Why. @param steps How many. */
static void note(Forecast *forecast, ForecastCause cause, double steps) {
    forecast->steps[cause] = fmax(forecast->steps[cause], steps);
}

/** @return A box around points of a model. @param mesh The model. */
static Box3 mesh_box(const Mesh *mesh) {
    Box3 box = {mesh->positions[0], mesh->positions[0]};
    for (size_t i = 1; i < mesh->position_count; i++) {
        box.low = vector3_lowest(box.low, mesh->positions[i]);
        box.high = vector3_highest(box.high, mesh->positions[i]);
    }
    return box;
}

/** @return A box around a transformed box that ends. @param t The transform. @param box The box. */
static Box3 box_transformed(const Transform *t, Box3 box) {
    Box3 out = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (int corner = 0; corner < 8; corner++) {
        Vector3 p = {corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                     corner & 4 ? box.high.z : box.low.z};
        p = transform_point(t, p);
        out.low = vector3_lowest(out.low, p);
        out.high = vector3_highest(out.high, p);
    }
    return out;
}

/** @return The row of a shape's table with a name and a type; NULL: there is none. @param survey
 * The survey. @param shape The shape. @param name The row's. @param type The row's. */
static const Parameter *shape_row(const Survey *survey, const SceneShape *shape, const char *name,
                                  ParameterType type) {
    const Parameter *row = survey->engine->shape_keywords[shape->kind]->parameters;
    while (row->name && !(row->type == type && strcmp(row->name, name) == 0)) {
        row++;
    }
    return row->name ? row : NULL;
}

/** @return The value of a row of a shape, by name; NULL: it has none. @param survey The survey.
 *  @param shape The shape. @param name The row's. @param type The row's. */
static const void *shape_value(const Survey *survey, const SceneShape *shape, const char *name,
                               ParameterType type) {
    const Parameter *row = shape_row(survey, shape, name, type);
    return row ? (const char *)shape->parameters + row->offset : NULL;
}

/** @return Whether a shape says a word. @param survey The survey. @param shape The shape.
 *  @param name The row's. @param word The word. */
static bool shape_says(const Survey *survey, const SceneShape *shape, const char *name,
                       const char *word) {
    const Parameter *row = shape_row(survey, shape, name, PARAMETER_WORD);
    const int *place = shape_value(survey, shape, name, PARAMETER_WORD);
    return row && strcmp(row->words[*place], word) == 0;
}

/** @return A shape's box in the scene. @param survey The survey. @param shape The shape.
 *  @param measure Its measures. */
static Box3 shape_box(const Survey *survey, const SceneShape *shape, const ShapeMeasure *measure) {
    Box3 box = {measure->low, measure->high};
    const size_t *model = shape_value(survey, shape, "file", PARAMETER_MESH);
    if (model && survey->scene->meshes[*model].mesh) {
        box = mesh_box(survey->scene->meshes[*model].mesh);
    }
    bool ends = vector3_largest(box.low) < HUGE_VAL && vector3_largest(box.high) < HUGE_VAL;
    return shape->transform && ends ? box_transformed(shape->transform, box) : box;
}

/** @return How far a point is from a box; 0 inside. @param box The box. @param p The point. */
static double box_distance(const Box3 *box, Vector3 p) {
    Vector3 away = {fmax(0, fmax(box->low.x - p.x, p.x - box->high.x)),
                    fmax(0, fmax(box->low.y - p.y, p.y - box->high.y)),
                    fmax(0, fmax(box->low.z - p.z, p.z - box->high.z))};
    return vector3_length(away);
}

/** @return The largest coordinate of a point, as tracers count. @param survey The survey.
 *  @param p The point. */
static double reach_of(const Survey *survey, Vector3 p) {
    return vector3_largest(vector3_subtract(p, survey->origin));
}

/** Notes how far away a shape is, and how far its coordinates reach. @param[in,out] survey The
 *  survey. @param box The shape's box, which ends. */
static void box_look(Survey *survey, const Box3 *box) {
    Forecast *forecast = survey->forecast;
    const Camera *camera = &survey->scene->camera;
    double radius = vector3_length(vector3_subtract(box->high, box->low)) / 2;
    double distance = box_distance(box, camera->position);
    if (!(radius > 0)) {
        return;
    }
    forecast->radii = fmax(forecast->radii, distance / radius);
    // A thing that is smaller than a pixel is hardly there.
    double radii = fmin(distance / radius, 1 / forecast->pixel);
    note(forecast, FORECAST_DISTANCE, STEPS * DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF * radii);
    survey->all.low = vector3_lowest(survey->all.low, box->low);
    survey->all.high = vector3_highest(survey->all.high, box->high);
    double reach = fmax(reach_of(survey, box->low), reach_of(survey, box->high));
    reach = fmax(reach, reach_of(survey, camera->position));
    double seen = fmax(distance, fmin(radius, camera->focus)) * forecast->pixel;
    double pixels = PLACE_ROUNDINGS * FLOAT_ROUNDOFF * reach / seen;
    note(forecast, FORECAST_PLACE, FORECAST_VISIBLE * pixels / EDGE_SHARE);
}

/** Notes a picture on a shape without end. Near the horizon, rows of pixels are h / p^2 apart from
 *  a height h, and so much larger are roundings of the way. @param[in,out] survey The survey.
 *  @param shape The shape. @param texture What it shows. */
static void horizon_look(Survey *survey, const SceneShape *shape, const Texture *texture) {
    const Forecast *forecast = survey->forecast;
    double scale = shape->transform ? vector3_largest(shape->transform->scale) : 1;
    double height = survey->scene->camera.focus;
    double lost = DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF * height / pow(forecast->pixel, 2);
    double texels = lost * texture->width / scale;
    note(survey->forecast, FORECAST_HORIZON, TEXEL_STEPS * fmin(1, texels));
}

/** Notes the fractals in a shape's field: their normals turn within a tolerance.
 *  @param[in,out] survey The survey. @param shape The shape. */
static void field_look(Survey *survey, const SceneShape *shape) {
    const Field *const *field = shape_value(survey, shape, "field", PARAMETER_FIELD);
    const double *tolerance = shape_value(survey, shape, "tolerance", PARAMETER_NUMBER);
    for (int i = 0; field && tolerance && i < (*field)->count; i++) {
        const FieldStep *step = &(*field)->steps[i];
        if (step->operation == FIELD_MANDELBULB) {
            double power = step->numbers[0], iterations = step->numbers[1];
            double detail = fmax(*tolerance, pow(power, 1 - iterations));
            note(survey->forecast, FORECAST_FRACTAL,
                 STEPS * PLACE_ROUNDINGS * FLOAT_ROUNDOFF / detail);
        }
    }
}

/** Adds the faces of a model that float lights otherwise. @param[in,out] survey The survey.
 *  @param shape The shape. @param box Its box. */
static void facets_look(Survey *survey, const SceneShape *shape, const Box3 *box) {
    const size_t *model = shape_value(survey, shape, "file", PARAMETER_MESH);
    const Scene *scene = survey->scene;
    const Mesh *mesh = model ? scene->meshes[*model].mesh : NULL;
    if (!mesh || shape_says(survey, shape, "normals", "flat")) {
        return;
    }
    double reach = fmax(reach_of(survey, box->low), reach_of(survey, box->high));
    Facets facets = {scene, mesh, shape->transform, PLACE_ROUNDINGS * FLOAT_ROUNDOFF * reach};
    // A model fills about as much of the picture as a ball between those in and around its box.
    double size = vector3_length(vector3_subtract(box->high, box->low)) / 3.2;
    Vector3 middle = vector3_scale(vector3_add(box->low, box->high), 0.5);
    double away = vector3_length(vector3_subtract(middle, scene->camera.position));
    double pixels = M_PI * pow(size / fmax(away, size) / survey->forecast->pixel, 2);
    double picture = (double)scene->image.width * scene->image.height;
    survey->facets += fmin(1, pixels / picture) * facets_in_doubt(&facets);
}

/** Takes a shape's surface into account. @param[in,out] survey The survey. @param shape The shape.
 *  @param box Its box. @param is_flat Whether it is flat. */
static void surface_look(Survey *survey, const SceneShape *shape, const Box3 *box, bool is_flat) {
    const Material *material = &survey->scene->materials[shape->material];
    double mirrored = largest(material->reflectivity), through = largest(material->transparency);
    bool ends = vector3_largest(box->high) < HUGE_VAL && vector3_largest(box->low) < HUGE_VAL;
    survey->forecast->share = fmax(survey->forecast->share, fmin(1, mirrored + through));
    survey->mirrors += !is_flat && mirrored > 0;
    survey->glasses += !is_flat && through > 0;
    survey->mirrored = !is_flat ? fmax(survey->mirrored, mirrored) : survey->mirrored;
    if (through > 0 && ends && survey->wall_count < WALLS_MAXIMUM) {
        survey->walls[survey->wall_count++] = *box;
    }
    if (material->texture) {
        const Texture *texture = survey->scene->textures[material->texture - 1].texture;
        survey->texels = fmax(survey->texels, texture->width / (2 * M_PI));
        if (!ends) {
            horizon_look(survey, shape, texture);
        }
    }
}

/** Takes a shape into account. @param[in,out] survey The survey. @param shape The shape. */
static void shape_look(Survey *survey, const SceneShape *shape) {
    ShapeMeasure measure = survey->engine->measure(shape);
    Box3 box = shape_box(survey, shape, &measure);
    if (vector3_largest(box.low) < HUGE_VAL && vector3_largest(box.high) < HUGE_VAL) {
        box_look(survey, &box);
        facets_look(survey, shape, &box);
    } else {
        // Without end: as far as the eye can tell things apart.
        note(survey->forecast, FORECAST_DISTANCE,
             STEPS * DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF / survey->forecast->pixel);
    }
    field_look(survey, shape);
    surface_look(survey, shape, &box, measure.is_flat);
}

/** @return The smaller of a gap and the distance of two walls; the gap where they are in one place
 *          but for roundings of the scene's own numbers: then they are one. @param gap The gap.
 *  @param away From one wall to the other. @param reach The largest coordinate. */
static double gap_narrowed(double gap, double away, double reach) {
    /** Roundings of a few operations in double. */
    const double same = 0x1p-40;
    return fabs(away) > same * reach ? fmin(gap, fabs(away)) : gap;
}

/** Notes how near the walls of two things of glass are to each other. @param[in,out] survey The
 *  survey. @param a A box. @param b Another. */
static void walls_look(Survey *survey, const Box3 *a, const Box3 *b) {
    double reach = fmax(reach_of(survey, a->low), reach_of(survey, a->high)), gap = HUGE_VAL;
    Vector3 low = vector3_subtract(a->low, b->low), high = vector3_subtract(a->high, b->high);
    const double aways[] = {low.x, low.y, low.z, high.x, high.y, high.z};
    for (size_t i = 0; i < sizeof aways / sizeof *aways; i++) {
        gap = gap_narrowed(gap, aways[i], reach);
    }
    note(survey->forecast, FORECAST_WALL,
         FORECAST_VISIBLE * WALL_ROUNDINGS * FLOAT_ROUNDOFF * reach / gap);
}

/** Forecasts what curved mirrors and glass make of roundings. @param[in,out] survey The survey, all
 *  shapes seen. @param depth How deep rays are followed. */
static void turns_look(Survey *survey, int depth) {
    Forecast *forecast = survey->forecast;
    double spread = MIRROR_SPREAD * survey->mirrored, grown = 1;
    int most = survey->mirrors > 1 ? TURNS_COUNTED : survey->mirrors;
    int turns = most < depth ? most : depth;
    for (int i = 0; i < turns && spread > 1; i++) {
        grown *= spread;
    }
    int crossings = 2 * survey->glasses < depth ? 2 * survey->glasses : depth;
    double bent = pow(GLASS_SPREAD, crossings);
    forecast->turns = grown > bent ? turns : crossings;
    double turned = FLOAT_ROUNDOFF * fmax(grown, bent) * fmax(1, survey->texels);
    note(forecast, FORECAST_TURNS, forecast->turns > 0 ? STEPS * turned : 0);
}

/** @return How deep rays must be followed until none can change 8 bits, whatever they meet: a share
 *          of so many factors is below the weight where rays end. @param share The largest share
 *          that a surface sends on. */
static int depth_of(double share) {
    /** As the tracer has it (src/trace/engine.c). */
    const double cutoff = 1.5e-4;
    if (share <= 0) {
        return 0;
    }
    double depth = share < 1 ? ceil(log(cutoff) / log(share)) : DEPTH_GUARD;
    return depth < DEPTH_GUARD ? (int)depth : DEPTH_GUARD;
}

/** Looks at all shapes. @param scene The scene. @param origin Where tracers count from.
 *  @param[out] forecast What comes of it. @return What was gathered. */
static Survey scene_look(const Scene *scene, Vector3 origin, Forecast *forecast) {
    Survey survey = {.scene = scene,
                     .engine = engine_find("f64x1", NULL),
                     .forecast = forecast,
                     .all = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}},
                     .origin = origin};
    *forecast =
        (Forecast){.pixel = 2 * tan(scene->camera.fov / 2 * (M_PI / 180)) / scene->image.width};
    for (size_t i = 0; i < scene->shape_count; i++) {
        shape_look(&survey, &scene->shapes[i]);
    }
    return survey;
}

Forecast forecast_of(const Scene *scene) {
    /** As far away, in sizes, tracers move there (src/trace/origin.c). */
    const double far_sizes = 4;
    Forecast forecast;
    Survey survey = scene_look(scene, (Vector3){0, 0, 0}, &forecast);
    Vector3 middle = vector3_scale(vector3_add(survey.all.low, survey.all.high), 0.5);
    double size = vector3_largest(vector3_subtract(survey.all.high, survey.all.low));
    if (vector3_largest(middle) > far_sizes * size) {
        survey = scene_look(scene, middle, &forecast);
    }
    for (size_t i = 0; i < survey.wall_count; i++) {
        for (size_t k = 0; k < i; k++) {
            walls_look(&survey, &survey.walls[i], &survey.walls[k]);
        }
    }
    if (scene->sky.image) {
        const Texture *panorama = scene->textures[scene->sky.image - 1].texture;
        double contrast = panorama->is_light ? LIGHT_CONTRAST : 1;
        survey.texels = fmax(survey.texels, contrast * panorama->width / (2 * M_PI));
    }
    double shift = DIRECTION_ROUNDINGS * FLOAT_ROUNDOFF / forecast.pixel;
    note(&forecast, FORECAST_PIXEL, FORECAST_VISIBLE * shift / EDGE_SHARE);
    forecast.depth = depth_of(forecast.share);
    // What mirrors shows the models once more.
    double images = forecast.share > 0 ? 2 : 1;
    note(&forecast, FORECAST_FACETS,
         FORECAST_VISIBLE * FACETS_CHANCE * images * survey.facets / PIXELS_OFF);
    turns_look(&survey, scene->image.depth >= 0 ? scene->image.depth : forecast.depth);
    for (int cause = 0; cause < FORECAST_COUNT; cause++) {
        bool is_more = forecast.steps[cause] > forecast.steps[forecast.cause];
        forecast.cause = is_more ? (ForecastCause)cause : forecast.cause;
    }
    return forecast;
}

const Engine *forecast_engine(const Forecast *forecast) {
    const Engine *wide = engine_find("f64x4", NULL);
    if (forecast_steps(forecast) < FORECAST_VISIBLE) {
        return engine_find("auto", NULL);
    }
    return wide ? wide : engine_find("f64x1", NULL);
}
