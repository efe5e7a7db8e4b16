/**
 * @file
 * @brief A second camera, which views the rays of a pixel from the side.
 */
#include "render/orbit_camera.h"

#include "render/renderer_internal.h"

/** Horizontal field of view of the second camera, degrees. */
static const double ORBIT_FOV = 40;
/** Rays without an end are drawn so long, relative to the distance of the first hit. */
static const double MAX_DISTANCE_FACTOR = 2;
/** Rays with an end are drawn whole up to so many times that. */
static const double WHOLE_RAY_FACTOR = 4;
/** Size of the picture relative to the rays. */
static const double FIT_MARGIN = 1.25;
/** Largest tilt, degrees. */
static const double ORBIT_TILT_MAXIMUM = 89;
/** Least depth of a ray, and least size of a picture by parallel light, relative to the rays. */
static const double LEAST_FRACTION = 1e-3;

/** Most points of a tree. */
enum { RAY_POINTS_MAXIMUM = 64 };

/** Origins and hit points of the rays of a tree. */
typedef struct RayPoints {
    Vec3d points[RAY_POINTS_MAXIMUM]; /**< The points. */
    size_t count;                     /**< Number of #points. */
} RayPoints;

/** @return The distance of two points, scene units. */
static double points_distance(Vec3d a, Vec3d b) {
    return vec3d_length(vec3d_subtract(a, b));
}

/** @return The point of a ray at a distance. */
static Vec3d ray_at(const RayTreeNode *ray, double distance) {
    return vec3d_add(ray->origin, vec3d_scale(ray->direction, distance));
}

/** @return The length of a ray: to its hit, to its light, or infinite. */
static double ray_length(const RayTreeNode *ray) {
    return fmin(ray->distance, ray->limit);
}

/** Adds a point, if its distance from a centre is at most a radius. */
static void ray_points_add(RayPoints *points, Vec3d point, Vec3d center, double radius) {
    if (points->count < RAY_POINTS_MAXIMUM && points_distance(point, center) <= radius) {
        points->points[points->count++] = point;
    }
}

/** @return How long a ray is drawn. @param maximum See #OrbitCamera.ray_length_maximum. */
static double drawn_length(const RayTreeNode *ray, double maximum) {
    double length = ray_length(ray);
    return length <= WHOLE_RAY_FACTOR * maximum ? length : maximum;
}

/** @return Whether a ray is drawn: rays of hidden kinds are not, but for the first. */
static bool is_drawn(const RayTree *tree, size_t ray, unsigned hidden_kinds) {
    return ray == 0 || !(hidden_kinds >> tree->nodes[ray].kind & 1);
}

/** @return The points of a tree: the ends of all rays, as far as they are drawn, and the lamps that
 *  blocked shadow rays were sent to. @param radius See #OrbitCamera.ray_length_maximum. */
static RayPoints ray_points_of(const RayTree *tree, unsigned hidden_kinds, double radius) {
    RayPoints points = {.count = 0};
    const RayTreeNode *camera = &tree->nodes[0];
    Vec3d first = ray_at(camera, fmin(ray_length(camera), radius));
    ray_points_add(&points, camera->origin, first, HUGE_VAL);
    ray_points_add(&points, first, first, HUGE_VAL);
    for (size_t i = 1; i < tree->count; i++) {
        const RayTreeNode *ray = &tree->nodes[i];
        if (!is_drawn(tree, i, hidden_kinds)) {
            continue;
        }
        if (ray->kind == RAY_SHADOW && ray->is_hit && ray->limit <= WHOLE_RAY_FACTOR * radius) {
            ray_points_add(&points, ray_at(ray, ray->limit), first, HUGE_VAL);
        }
        // The infinite ones count as short, so that the others fill the picture.
        bool is_whole = drawn_length(ray, radius) == ray_length(ray);
        double length = is_whole ? ray_length(ray) : radius / 2;
        ray_points_add(&points, ray_at(ray, length), first, HUGE_VAL);
    }
    return points;
}

/** @return The direction of view, of length 1. */
static Vec3d orbit_camera_direction(const OrbitCamera *orbit) {
    double pan = orbit->pan * (M_PI / 180), tilt = orbit->tilt * (M_PI / 180);
    return (Vec3d){sin(pan) * cos(tilt), sin(tilt), -cos(pan) * cos(tilt)};
}

/** @return The position of the camera. @param half Half of the smaller field of view, radians. */
static Vec3d orbit_camera_position(const OrbitCamera *orbit, double half) {
    double distance = FIT_MARGIN * orbit->radius / (sin(half) * orbit->zoom);
    return vec3d_subtract(orbit->target, vec3d_scale(orbit_camera_direction(orbit), distance));
}

/** @return How many points are not occluded. */
static size_t count_visible(const Renderer *renderer, const CutAway *cut, const OrbitCamera *orbit,
                            const RayPoints *points) {
    /** A hit that is nearer by this fraction of the distance occludes a point. */
    const double tolerance = 1e-3;
    RayQuery rays[RAY_POINTS_MAXIMUM];
    int shapes[RAY_POINTS_MAXIMUM];
    double distances[RAY_POINTS_MAXIMUM];
    Vec3d origin = orbit_camera_position(orbit, ORBIT_FOV / 2 * (M_PI / 180));
    for (size_t i = 0; i < points->count; i++) {
        Vec3d to = vec3d_subtract(points->points[i], origin);
        rays[i] = (RayQuery){{origin.x, origin.y, origin.z}, {to.x, to.y, to.z}};
    }
    renderer->settings.engine->closest_hits(renderer->tracer, points->count, rays, shapes,
                                            distances);
    size_t visible = 0;
    for (size_t i = 0; i < points->count; i++) {
        visible += distances[i] >= 1 - tolerance || cut_away_may_hide(cut, shapes[i]);
    }
    return visible;
}

/** @return How clearly the rays lie apart in a picture, 0 to 1: how much it shows of their lengths,
 *  and of the angles between each and the one that it comes from. Rays count by their share of the
 *  pixel's light. @param forward Direction of view, of length 1. */
static double view_clarity(const RayTree *tree, unsigned hidden_kinds, Vec3d forward) {
    const RayTreeNode *rays = tree->nodes;
    double seen = vec3d_length(vec3d_cross(rays[0].direction, forward)), lengths = 1;
    double open = 0, angles = 0;
    for (size_t i = 1; i < tree->count; i++) {
        if (is_drawn(tree, i, hidden_kinds)) {
            const Vec3d direction = rays[i].direction;
            const Vec3d plane = vec3d_cross(rays[rays[i].parent].direction, direction);
            const double share = rays[i].throughput;
            seen += share * vec3d_length(vec3d_cross(direction, forward));
            lengths += share;
            open += share * fabs(vec3d_dot(plane, forward));
            angles += share * vec3d_length(plane);
        }
    }
    return angles > 0 ? (seen / lengths + open / angles) / 2 : seen / lengths;
}

/** Rotates the camera to where it sees the most points, and the rays lie apart. @param[in,out]
 *  orbit Has the pan of the pixel's camera. */
static void choose_angles(const Renderer *renderer, const CutAway *cut, const RayTree *tree,
                          unsigned hidden_kinds, OrbitCamera *orbit) {
    static const double pans[] = {-50, 50, -80, 80, -25, 25, -115, 115};
    static const double tilts[] = {-18, -40, -5, -65};
    const RayPoints points = ray_points_of(tree, hidden_kinds, orbit->ray_length_maximum);
    double initial_pan = orbit->pan, best_score = -1;
    OrbitCamera best = *orbit;
    for (size_t i = 0; i < sizeof pans / sizeof *pans * (sizeof tilts / sizeof *tilts); i++) {
        orbit->pan = initial_pan + pans[i % (sizeof pans / sizeof *pans)];
        orbit->tilt = tilts[i / (sizeof pans / sizeof *pans)];
        double clarity = view_clarity(tree, hidden_kinds, orbit_camera_direction(orbit));
        // A view from where rays lie upon each other is worth half of one where they lie apart.
        double score = (double)count_visible(renderer, cut, orbit, &points) * (1 + clarity);
        if (score > best_score) {
            best = *orbit;
            best_score = score;
        }
    }
    *orbit = best;
}

void orbit_camera_rotate(OrbitCamera *orbit, double pan, double tilt) {
    orbit->pan = remainder(orbit->pan + pan, 360);
    orbit->tilt = fmin(fmax(orbit->tilt + tilt, -ORBIT_TILT_MAXIMUM), ORBIT_TILT_MAXIMUM);
}

Vec3d orbit_camera_ray_middle(const OrbitCamera *orbit, const RayTreeNode *ray) {
    return ray_at(ray, drawn_length(ray, orbit->ray_length_maximum) / 2);
}

void orbit_camera_zoom(OrbitCamera *orbit, double factor, Vec3d focus) {
    /** Times as near, or as far, as at first. */
    const double range = 50;
    const double before = orbit->zoom;
    orbit->zoom = fmin(fmax(before * factor, 1 / range), range);
    const Vec3d off = vec3d_subtract(orbit->target, focus);
    orbit->target = vec3d_add(focus, vec3d_scale(off, before / orbit->zoom));
}

ProjectedView orbit_camera_project(const OrbitCamera *orbit, int width, int height) {
    double half = ORBIT_FOV / 2 * (M_PI / 180), pan = orbit->pan * (M_PI / 180);
    double half_height = atan(tan(half) * height / width);
    Vec3d direction = orbit_camera_direction(orbit), right = {cos(pan), 0, sin(pan)};
    SceneCamera camera = {.position = orbit_camera_position(orbit, fmin(half, half_height)),
                          .direction = direction,
                          .up = vec3d_cross(right, direction),
                          .fov = ORBIT_FOV};
    camera.target_distance = points_distance(camera.position, orbit->target);
    camera.look_at = orbit->target;
    return (ProjectedView){camera, width, height};
}

/** The cone of places along one axis of the picture from which all points are in sight. */
typedef struct SightCone {
    double low;  /**< Its one side at depth 0: the maximum of coordinate minus slope times depth. */
    double high; /**< Its other side: the minimum of coordinate plus slope times depth. */
    double slope; /**< How far the picture reaches per depth. */
} SightCone;

/** @return The depth up to which the camera may go. */
static double cone_depth(const SightCone *cone) {
    return (cone->high - cone->low) / (2 * cone->slope);
}

/** Moves the camera so that its points fill the picture: as near as all are in sight, in closed
 *  form. @param width Of the picture, pixels. */
static void orbit_camera_fit_points(OrbitCamera *orbit, const RayPoints *points, int width,
                                    int height) {
    const double edge = tan(ORBIT_FOV / 2 * (M_PI / 180)) / FIT_MARGIN;
    SightCone cones[2] = {{-HUGE_VAL, HUGE_VAL, edge},
                          {-HUGE_VAL, HUGE_VAL, edge * height / width}};
    ProjectedView view = orbit_camera_project(orbit, width, height);
    double nearest = HUGE_VAL, farthest = -HUGE_VAL;
    for (size_t i = 0; i < points->count; i++) {
        Vec3d p = camera_space(&view.camera, points->points[i]);
        const double across[] = {p.x, p.y};
        nearest = fmin(nearest, p.z);
        farthest = fmax(farthest, p.z);
        for (int axis = 0; axis < 2; axis++) {
            SightCone *cone = &cones[axis];
            cone->low = fmax(cone->low, across[axis] - cone->slope * p.z);
            cone->high = fmin(cone->high, across[axis] + cone->slope * p.z);
        }
    }
    double least = LEAST_FRACTION * orbit->radius, middle = (nearest + farthest) / 2;
    double depth = fmin(fmin(cone_depth(&cones[0]), cone_depth(&cones[1])), nearest - least);
    Vec3d right = vec3d_scale(scene_camera_right(&view.camera), (cones[0].low + cones[0].high) / 2);
    Vec3d up = vec3d_scale(view.camera.up, (cones[1].low + cones[1].high) / 2);
    Vec3d ahead = vec3d_scale(view.camera.direction, middle);
    orbit->target = vec3d_add(view.camera.position, vec3d_add(vec3d_add(right, up), ahead));
    double half = fmin(ORBIT_FOV / 2 * (M_PI / 180), atan(edge * FIT_MARGIN * height / width));
    orbit->radius = (middle - depth) * sin(half) / FIT_MARGIN;
}

OrbitCamera orbit_camera_fit(const Renderer *renderer, const Scene *scene, const CutAway *cut,
                             const RayTree *tree, unsigned hidden_kinds, int width, int height) {
    const SceneCamera *camera = &scene->camera;
    double first = ray_length(&tree->nodes[0]);
    OrbitCamera orbit = {.zoom = 1,
                         .ray_length_maximum = MAX_DISTANCE_FACTOR *
                                               (isfinite(first) ? first : camera->target_distance)};
    RayPoints points = ray_points_of(tree, hidden_kinds, orbit.ray_length_maximum);
    Vec3d low = points.points[0], high = low;
    for (size_t i = 1; i < points.count; i++) {
        low = vec3d_min(low, points.points[i]);
        high = vec3d_max(high, points.points[i]);
    }
    orbit.target = vec3d_scale(vec3d_add(low, high), 0.5);
    for (size_t i = 0; i < points.count; i++) {
        orbit.radius = fmax(orbit.radius, points_distance(points.points[i], orbit.target));
    }
    orbit.pan = atan2(camera->direction.x, -camera->direction.z) * (180 / M_PI);
    choose_angles(renderer, cut, tree, hidden_kinds, &orbit);
    orbit_camera_fit_points(&orbit, &points, width, height);
    return orbit;
}

ProjectedView parallel_view_fit(const OrbitCamera *orbit, const RayTree *tree, Vec3d forward,
                                Vec3d up, int width, int height, double *nearest) {
    /** Distance of the camera, in sizes of the picture. */
    const double distance = 1e4;
    RayPoints points = ray_points_of(tree, 0, orbit->ray_length_maximum);
    SceneCamera camera = {.direction = forward, .up = up};
    Vec3d low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < points.count; i++) {
        Vec3d p = camera_space(&camera, points.points[i]);
        low = vec3d_min(low, p);
        high = vec3d_max(high, p);
    }
    Vec3d middle = vec3d_scale(vec3d_add(low, high), 0.5);
    double size = fmax(high.x - low.x, (high.y - low.y) * width / height);
    size = FIT_MARGIN * fmax(size, LEAST_FRACTION * fmax(1e-3, vec3d_max_abs(middle)));
    camera.target_distance = distance * size;
    camera.fov = 2 * atan(0.5 / distance) * (180 / M_PI);
    camera.look_at =
        vec3d_add(vec3d_scale(scene_camera_right(&camera), middle.x),
                  vec3d_add(vec3d_scale(up, middle.y), vec3d_scale(forward, middle.z)));
    camera.position = vec3d_subtract(camera.look_at, vec3d_scale(forward, camera.target_distance));
    *nearest = camera.target_distance + low.z - middle.z;
    return (ProjectedView){camera, width, height};
}

/** @return The intersection of a line with the near plane. @param behind Its end behind it. */
static Vec3d clip_to_near(Vec3d behind, Vec3d ahead, double near_plane) {
    double t = (near_plane - behind.z) / (ahead.z - behind.z);
    Vec3d along = vec3d_scale(vec3d_subtract(ahead, behind), t);
    Vec3d point = vec3d_add(behind, along);
    point.z = near_plane;
    return point;
}

bool orbit_camera_project_ray(const OrbitCamera *orbit, const ProjectedView *view,
                              const RayTreeNode *ray, ProjectedRay *projected) {
    double length = ray_length(ray), near_plane = camera_near_depth(&view->camera);
    Vec3d from = camera_space(&view->camera, ray->origin);
    double drawn = drawn_length(ray, orbit->ray_length_maximum);
    Vec3d to = camera_space(&view->camera, ray_at(ray, drawn));
    projected->is_truncated = length > drawn;
    if (from.z <= near_plane && to.z <= near_plane) {
        return false;
    }
    if (from.z < near_plane) {
        from = clip_to_near(from, to, near_plane);
    } else if (to.z < near_plane) {
        to = clip_to_near(to, from, near_plane);
    }
    projected_view_place(view, from, &projected->x[0], &projected->y[0]);
    projected_view_place(view, to, &projected->x[1], &projected->y[1]);
    return true;
}
