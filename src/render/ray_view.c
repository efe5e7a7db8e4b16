/**
 * @file
 * @brief Looking at the rays of a pixel from beside.
 */
#include "dioptre/ray_view.h"

#include "dioptre/language.h"
#include "render/renderer.h"

#include <libintl.h>
#include <stdio.h>

/** Horizontal field of view of the second camera, degrees. */
static const double FOV = 40;
/** Ways from the eye to the first hit: what is farther from there is not looked at. */
static const double FAR = 2;
/** How many times as large as the rays the picture is. */
static const double MARGIN = 1.25;
/** Degrees that the second camera tilts at most. */
static const double TILT_MAXIMUM = 89;
/** What is nearer to the second camera, in radii, is cut off. */
static const double NEAREST = 1e-3;

/** How often a view is fitted to its points. */
enum { FIT_TURNS = 4 };
/** Points of a tree that are looked at, at most. */
enum { POINTS_MAXIMUM = 64 };

/** Points of a tree: where its rays start and where they hit. */
typedef struct TreePoints {
    Vector3 points[POINTS_MAXIMUM]; /**< The points. */
    size_t count;                   /**< How many. */
} TreePoints;

/** @return The way from one point to another, scene units. @param a One. @param b The other. */
static double way(Vector3 a, Vector3 b) {
    return vector3_length(vector3_subtract(a, b));
}

/** @return The point of a ray at a distance. @param ray The ray. @param distance It. */
static Vector3 ray_at(const ProbeRay *ray, double distance) {
    return vector3_add(ray->origin, vector3_scale(ray->direction, distance));
}

/** @return How far a ray goes: to what it hit, to its lamp, or without end. @param ray The ray. */
static double ray_end(const ProbeRay *ray) {
    return fmin(ray->distance, ray->limit);
}

/** Adds a point that is near enough. @param[in,out] tree The points. @param point The point.
 *  @param middle Where the camera's ray hit. @param reach How far counts as near. */
static void points_add(TreePoints *tree, Vector3 point, Vector3 middle, double reach) {
    if (tree->count < POINTS_MAXIMUM && way(point, middle) <= reach) {
        tree->points[tree->count++] = point;
    }
}

/** @return The points of a tree that are looked at. @param probe The tree. @param reach How far
 *  from the first hit. */
static TreePoints points_of(const Probe *probe, double reach) {
    TreePoints tree = {.count = 0};
    const ProbeRay *camera = &probe->rays[0];
    Vector3 first = ray_at(camera, fmin(ray_end(camera), reach));
    points_add(&tree, camera->origin, first, HUGE_VAL);
    points_add(&tree, first, first, HUGE_VAL);
    for (size_t i = 1; i < probe->count; i++) {
        const ProbeRay *ray = &probe->rays[i];
        points_add(&tree, ray_at(ray, fmin(ray_end(ray), reach)), first, reach);
    }
    return tree;
}

/** @return Which way a view looks, one long. @param view The view. */
static Vector3 view_direction(const RayView *view) {
    double pan = view->pan * (M_PI / 180), tilt = view->tilt * (M_PI / 180);
    return (Vector3){sin(pan) * cos(tilt), sin(tilt), -cos(pan) * cos(tilt)};
}

/** @return Where the camera of a view is. @param view The view. @param half Half of the smaller
 *  field of view, radians. */
static Vector3 view_eye(const RayView *view, double half) {
    double distance = MARGIN * view->radius / (sin(half) * view->zoom);
    return vector3_subtract(view->middle, vector3_scale(view_direction(view), distance));
}

/** @return How many of some points a view sees. @param renderer Who traces. @param view The view.
 *  @param tree The points. */
static size_t count_seen(const Renderer *renderer, const RayView *view, const TreePoints *tree) {
    /** A point is seen that is not behind something by more than this share of the way. */
    const double slack = 1e-3;
    PlainRay rays[POINTS_MAXIMUM];
    int shapes[POINTS_MAXIMUM];
    double distances[POINTS_MAXIMUM];
    Vector3 eye = view_eye(view, FOV / 2 * (M_PI / 180));
    for (size_t i = 0; i < tree->count; i++) {
        Vector3 to = vector3_subtract(tree->points[i], eye);
        rays[i] = (PlainRay){{eye.x, eye.y, eye.z}, {to.x, to.y, to.z}};
    }
    renderer->settings.engine->nearest(renderer->tracer, tree->count, rays, shapes, distances);
    size_t seen = 0;
    for (size_t i = 0; i < tree->count; i++) {
        seen += distances[i] >= 1 - slack;
    }
    return seen;
}

/** Turns a view to where it sees most points. @param renderer Who traces. @param[in,out] view The
 *  view; it looks the camera's way. @param tree The points. */
static void choose_side(const Renderer *renderer, RayView *view, const TreePoints *tree) {
    static const double pans[] = {-50, 50, -80, 80, -25, 25, -115, 115};
    static const double tilts[] = {-18, -40, -5, -65};
    double ahead = view->pan;
    RayView best = *view;
    size_t most = 0;
    for (size_t i = 0; i < sizeof pans / sizeof *pans * (sizeof tilts / sizeof *tilts); i++) {
        view->pan = ahead + pans[i % (sizeof pans / sizeof *pans)];
        view->tilt = tilts[i / (sizeof pans / sizeof *pans)];
        size_t seen = count_seen(renderer, view, tree);
        if (i == 0 || seen > most) {
            best = *view;
            most = seen;
        }
    }
    *view = best;
}

void ray_view_turn(RayView *view, double pan, double tilt) {
    view->pan = remainder(view->pan + pan, 360);
    view->tilt = fmin(fmax(view->tilt + tilt, -TILT_MAXIMUM), TILT_MAXIMUM);
}

void ray_view_zoom(RayView *view, double factor) {
    /** Times as near, or as far, as at first. */
    const double range = 50;
    view->zoom = fmin(fmax(view->zoom * factor, 1 / range), range);
}

RaySight ray_view_sight(const RayView *view, int width, int height) {
    double half = FOV / 2 * (M_PI / 180), pan = view->pan * (M_PI / 180);
    double half_height = atan(tan(half) * height / width);
    Vector3 direction = view_direction(view), right = {cos(pan), 0, sin(pan)};
    Camera camera = {.position = view_eye(view, fmin(half, half_height)),
                     .direction = direction,
                     .up = vector3_cross(right, direction),
                     .fov = FOV};
    camera.focus = way(camera.position, view->middle);
    camera.look_at = view->middle;
    return (RaySight){camera, width, height};
}

/** @return A point as the camera has it: to the right, up, and ahead. @param camera The camera.
 *  @param point The point. */
static Vector3 before_camera(const Camera *camera, Vector3 point) {
    Vector3 from = vector3_subtract(point, camera->position);
    return (Vector3){vector3_dot(from, camera_right(camera)), vector3_dot(from, camera->up),
                     vector3_dot(from, camera->direction)};
}

/** Brings a view nearer, and aside, to where its points fill the picture. @param[in,out] view The
 *  view. @param tree The points. @param width Pixels of the picture. @param height Pixels. */
static void view_fit(RayView *view, const TreePoints *tree, int width, int height) {
    RaySight sight = ray_view_sight(view, width, height);
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < tree->count; i++) {
        Vector3 p = before_camera(&sight.camera, tree->points[i]);
        const double place[] = {p.x / p.z, p.y / p.z};
        for (int axis = 0; axis < 2; axis++) {
            low[axis] = fmin(low[axis], place[axis]);
            high[axis] = fmax(high[axis], place[axis]);
        }
    }
    double aside = sight.camera.focus * (low[0] + high[0]) / 2;
    double up = sight.camera.focus * (low[1] + high[1]) / 2, edge = tan(FOV / 2 * (M_PI / 180));
    Vector3 right = vector3_scale(camera_right(&sight.camera), aside);
    view->middle =
        vector3_add(view->middle, vector3_add(right, vector3_scale(sight.camera.up, up)));
    double across = (high[0] - low[0]) / 2 / edge,
           down = (high[1] - low[1]) / 2 * width / height / edge;
    view->radius *= MARGIN * fmax(fmax(across, down), NEAREST);
}

RayView ray_view_choose(const Renderer *renderer, const Camera *camera, const Probe *probe,
                        int width, int height) {
    double first = ray_end(&probe->rays[0]);
    RayView view = {.zoom = 1, .reach = FAR * (isfinite(first) ? first : camera->focus)};
    TreePoints tree = points_of(probe, view.reach);
    Vector3 low = tree.points[0], high = low;
    for (size_t i = 1; i < tree.count; i++) {
        low = vector3_lowest(low, tree.points[i]);
        high = vector3_highest(high, tree.points[i]);
    }
    view.middle = vector3_scale(vector3_add(low, high), 0.5);
    for (size_t i = 0; i < tree.count; i++) {
        view.radius = fmax(view.radius, way(tree.points[i], view.middle));
    }
    view.pan = atan2(camera->direction.x, -camera->direction.z) * (180 / M_PI);
    choose_side(renderer, &view, &tree);
    // What is nearer grows faster: a few turns come near enough.
    for (int turn = 0; turn < FIT_TURNS; turn++) {
        view_fit(&view, &tree, width, height);
    }
    return view;
}

/** Projects a point. @param sight The camera. @param p The point, see #before_camera; it is ahead.
 *  @param[out] x Pixels. @param[out] y Pixels. */
static void project(const RaySight *sight, Vector3 p, double *x, double *y) {
    double pixel = 2 * tan(sight->camera.fov / 2 * (M_PI / 180)) / sight->width;
    *x = sight->width / 2.0 + p.x / p.z / pixel;
    *y = sight->height / 2.0 - p.y / p.z / pixel;
}

bool ray_sight_point(const RaySight *sight, Vector3 point, double *x, double *y) {
    Vector3 p = before_camera(&sight->camera, point);
    if (p.z <= NEAREST * sight->camera.focus) {
        return false;
    }
    project(sight, p, x, y);
    return true;
}

/** @return The point of a line where it comes before the camera. @param behind Its end behind the
 *  camera. @param ahead Its other end. @param nearest How far ahead points must be. */
static Vector3 cut(Vector3 behind, Vector3 ahead, double nearest) {
    double share = (nearest - behind.z) / (ahead.z - behind.z);
    Vector3 along = vector3_scale(vector3_subtract(ahead, behind), share);
    Vector3 point = vector3_add(behind, along);
    point.z = nearest;
    return point;
}

bool ray_view_line(const RayView *view, const RaySight *sight, const ProbeRay *ray, RayLine *line) {
    double end = ray_end(ray), nearest = NEAREST * sight->camera.focus;
    Vector3 from = before_camera(&sight->camera, ray->origin);
    Vector3 to = before_camera(&sight->camera, ray_at(ray, fmin(end, view->reach)));
    line->goes_on = end > view->reach;
    if (from.z <= nearest && to.z <= nearest) {
        return false;
    }
    if (from.z < nearest) {
        from = cut(from, to, nearest);
    } else if (to.z < nearest) {
        to = cut(to, from, nearest);
    }
    project(sight, from, &line->x[0], &line->y[0]);
    project(sight, to, &line->x[1], &line->y[1]);
    return true;
}

const RayStyle *ray_styles(void) {
    static const RayStyle styles[RAY_STYLES] = {
        {0x000000, 0, 0, N_("camera ray")},          {0x0072B2, 0, 0, N_("mirrored ray")},
        {0x009E73, 8, 2, N_("refracted ray")},       {0xE69F00, 3, 2, N_("shadow ray: lit")},
        {0xCC79A7, 1, 2, N_("shadow ray: blocked")},
    };
    return styles;
}

const RayStyle *ray_style(const ProbeRay *ray) {
    static const int places[] = {
        [PROBE_CAMERA] = 0, [PROBE_MIRROR] = 1, [PROBE_REFRACT] = 2, [PROBE_SHADOW] = 3};
    return &ray_styles()[places[ray->kind] + (ray->kind == PROBE_SHADOW && ray->is_hit)];
}

const char *ray_keyword(const Scene *scene, const ProbeRay *ray) {
    // The keywords are the same in every engine.
    return engine_list()[0]->shape_keywords[scene->shapes[ray->shape].kind]->name;
}

void ray_name_met(const Scene *scene, const ProbeRay *ray, char name[RAY_NAME_SIZE]) {
    if (!ray->is_hit) {
        snprintf(name, RAY_NAME_SIZE, "%s", gettext("nothing but the sky"));
    } else if (ray->shape < 0) {
        snprintf(name, RAY_NAME_SIZE, gettext("lamp %d"), ray->lamp + 1);
    } else if (scene->shapes[ray->shape].line > 0) {
        snprintf(name, RAY_NAME_SIZE, gettext("the %s of line %d"), ray_keyword(scene, ray),
                 scene->shapes[ray->shape].line);
    } else {
        snprintf(name, RAY_NAME_SIZE, gettext("%s number %d"), ray_keyword(scene, ray),
                 ray->shape + 1);
    }
}

double ray_angle(const ProbeRay *ray) {
    return acos(fmin(1, ray->surface.cosine)) * (180 / M_PI);
}
