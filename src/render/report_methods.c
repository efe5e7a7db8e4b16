/**
 * @file
 * @brief The table of the reports' methods: a row per report; words for them, for pixels and for
 * sampling.
 */
#include "base/language.h"
#include "dioptre/renderer.h"

/** Epsilon of reports whose text names none, scene units: usual in textbooks. */
static const double TEXTBOOK_EPSILON = 1e-4;

/** Methods of one report. */
typedef struct MethodSetRow {
    const char *name;      /**< Name for people, in English. */
    const char *effect;    /**< What is seen, in a sentence, in English. */
    unsigned methods;      /**< A set of #ReportMethod. */
    OffsetStrategy offset; /**< Where secondary rays start. */
    double relaxation;     /**< See #TraceSettings.relaxation. */
    bool has_footprint;    /**< Whether sphere tracing stops at a fraction of a pixel. */
} MethodSetRow;

/** The reports, in the order of #MethodSet. */
static const MethodSetRow rows[METHODS_COUNT] = {
    [METHODS_OWN] = {.name = N_("by our own methods"),
                     .effect = N_("every ray as this program follows it"),
                     .offset = OFFSET_BOUND,
                     .has_footprint = true},
    [METHODS_REPORT_A] = {.name = N_("as report A"),
                          .effect =
                              N_("mirrors fade with the distance, glass mirrors nothing behind its "
                                 "first surface, shapes behind a lamp throw shadows"),
                          .methods = METHOD_SPHERE_QUADRATIC | METHOD_SHADOW_BEYOND |
                                     METHOD_FADING_MIRRORS | METHOD_SEPARATE_CHAINS |
                                     METHOD_CONSTANT_SHARES,
                          .offset = OFFSET_FIXED,
                          .has_footprint = true},
    [METHODS_REPORT_B] = {.name = N_("as report B"),
                          .effect = N_(
                              "fields are marched with plain steps: layer 7 counts more of them"),
                          .offset = OFFSET_BOUND,
                          .relaxation = 1},
    [METHODS_REPORT_C] = {.name = N_("as report C"),
                          .effect =
                              N_("ambient light only in the shadow: a shadow may be brighter than "
                                 "what light grazes"),
                          .methods = METHOD_SPHERE_QUADRATIC_C | METHOD_AMBIENT_IN_SHADOW,
                          .offset = OFFSET_FIXED,
                          .has_footprint = true},
    [METHODS_REPORT_D] =
        {.name = N_("as report D"),
         .effect = N_("light is added as white, and mirrors and glass are the mean of four rays"),
         .methods = METHOD_SPHERE_PROJECTION | METHOD_SHADOW_BY_SHAPE | METHOD_ADDED_LIGHT |
                    METHOD_MEAN_OF_RAYS,
         .offset = OFFSET_NONE,
         .has_footprint = true},
};

const char *const method_set_words[] = {"own", "a", "b", "c", "d", NULL};

const char *const sampling_words[] = {"adaptive", "full", NULL};
const char *const pixel_point_words[] = {"center", "corner", NULL};

const char *pixel_point_name(PixelPoint point) {
    return point == PIXEL_CORNER ? N_("through the corners of pixels")
                                 : N_("through the centres of pixels");
}

const char *method_set_name(MethodSet set) {
    return rows[set].name;
}

const char *method_set_effect(MethodSet set) {
    return rows[set].effect;
}

void method_set_apply(MethodSet set, RenderSettings *settings) {
    const MethodSetRow *row = &rows[set];
    if (set == settings->method_set) {
        return;
    }
    settings->method_set = set;
    settings->trace.methods = row->methods;
    settings->trace.offset = row->offset;
    settings->trace.epsilon = TEXTBOOK_EPSILON;
    settings->trace.relaxation = row->relaxation;
    settings->trace.footprint = row->has_footprint ? RENDER_FOOTPRINT : 0;
}
