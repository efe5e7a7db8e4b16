/**
 * @file
 * @brief What a packet knows of all its rays changes no bit of them.
 *
 * Engines of several lanes ask once for a packet of camera rays which shapes it may meet, whether a
 * quad covers it, whether anything is between it and a lamp, and which shape its shadow rays leave.
 * Engines of one lane ask for each ray, so they are the reference. The rooms are the bad cases:
 * edges that run through packets, slivers thinner than a pixel before walls and lamps, turned and
 * stretched shapes, shapes that touch, lamps at a wall, wide and narrow fields of view, grids whose
 * last packets are not full.
 */
#include "bvh_queries.h"

/** Rooms that are drawn. */
enum { ROOMS = 16000 };

/** A room with a lamp that hardly faces a surface: its cosine is above 0 by rounding alone, and its
 *  shadow rays meet the surface. */
enum { ROOM_OF_ROUNDINGS = 19746 };

/** Most columns and rows of a grid. */
enum { MOST = 40 };

/** Columns of the smallest picture; it is half as high. */
enum { SMALLEST = 80 };

/** Number of widths of pictures: each is twice the one before. */
enum { WIDTHS = 5 };

/** Half the edge of a room. */
#define HALF 2.0

/** A random coordinate in a room: half of them on a raster, so that edges and faces coincide. */
static double room_coordinate(uint64_t *state) {
    double x = random_float(state, -HALF, HALF);
    return random_unit_double(state) < 0.5 ? floor(4 * x) / 4 : x;
}

/** @return A random point in a room. */
static Vec3d room_point(uint64_t *state) {
    double x = room_coordinate(state), y = room_coordinate(state), z = room_coordinate(state);
    return (Vec3d){x, y, z};
}

/** Begins a material: mostly matt. */
static void room_material(Scene *scene, uint64_t *state) {
    Error error = {0};
    SceneMaterial material = *(const SceneMaterial *)scene_material_keyword.defaults;
    material.color = (Rgbd){random_unit_double(state), random_unit_double(state), 0.5};
    if (random_unit_double(state) < 0.2) {
        material.reflectivity = (Rgbd){0.25, 0.5, 0.125};
    }
    material.specular = random_unit_double(state) < 0.2 ? 0.5 : 0;
    assert_true(scene_add_material(scene, &material, &error));
}

/** Adds a quad. */
static void room_quad(Scene *scene, uint64_t *state, Vec3d corner, Vec3d u, Vec3d v) {
    QuadParameters quad = {corner, u, v};
    room_material(scene, state);
    add_shape(scene, "quad", &quad);
}

/** Adds a lamp. */
static void room_lamp_at(Scene *scene, uint64_t *state, Vec3d position) {
    Error error = {0};
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    light.position = position;
    light.falloff = random_unit_double(state) < 0.5 ? FALLOFF_INVERSE_SQUARE : light.falloff;
    assert_true(scene_add_light(scene, &light, &error));
}

/** Adds a lamp, often near the floor or the ceiling: there its directions differ most. */
static void room_lamp(Scene *scene, uint64_t *state) {
    Vec3d position = room_point(state);
    if (random_unit_double(state) < 0.5) {
        double height = exp2(-12 * random_unit_double(state));
        position.y = random_unit_double(state) < 0.25 ? HALF - height : height - HALF;
    }
    room_lamp_at(scene, state, position);
}

/** Adds a ball or a box: small ones, and some in which cameras and lamps may be. */
static void room_solid(Scene *scene, uint64_t *state, Vec3d at, double thin) {
    double size = random_unit_double(state) < 0.5 ? thin : 4 * random_unit_double(state) + thin;
    room_material(scene, state);
    if (random_unit_double(state) < 0.5) {
        SphereParameters sphere = {at, 0.5 * size};
        add_shape(scene, "sphere", &sphere);
    } else {
        BoxParameters box = {at, vec3d_add(at, (Vec3d){0.5, 0.5 * size, 0.25})};
        add_shape(scene, "box", &box);
    }
}

/** Adds a disk, or a plane through the room. */
static void room_flat(Scene *scene, uint64_t *state, Vec3d at, Vec3d to, double thin) {
    Vec3d normal = {to.y, 0.5 - to.x, to.z};
    room_material(scene, state);
    if (random_unit_double(state) < 0.75) {
        DiskParameters disk = {at, normal, thin};
        add_shape(scene, "disk", &disk);
    } else {
        PlaneParameters plane = {at, normal};
        add_shape(scene, "plane", &plane);
    }
}

/** Adds a shape in a room: a panel, a sliver, a solid or a disk. */
static void room_shape(Scene *scene, uint64_t *state) {
    double kind = random_unit_double(state), thin = exp2(-14 * random_unit_double(state));
    Vec3d at = room_point(state), to = vec3d_subtract(room_point(state), at);
    if (random_unit_double(state) < 0.5) {
        at.y = -HALF; // It stands on the floor.
        to = (Vec3d){0.25 * to.x, fabs(to.y), 0.25 * to.z};
    }
    if (kind < 0.6) {
        Vec3d across = {to.y, -to.x, 0.25};
        room_quad(scene, state, at, to, vec3d_scale(across, kind < 0.3 ? thin : 1));
        if (kind < 0.1) { // In the quad's plane: roundings decide whether the lamp shines on it.
            room_lamp_at(scene, state, vec3d_add(at, vec3d_scale(to, 1.5)));
        }
        return;
    }
    if (kind < 0.9) {
        room_solid(scene, state, at, thin);
    } else {
        room_flat(scene, state, at, to, thin);
    }
}

/** Turns a camera into a room, in one of four rooms exactly along an axis. */
static void room_camera_turn(SceneCamera *camera, uint64_t *state) {
    double across = random_unit_double(state) - 0.5, along = random_unit_double(state) - 0.5;
    double turn = random_unit_double(state) < 0.25 ? 0 : 0.5;
    Vec3d forward = vec3d_normalize((Vec3d){turn * across, turn * along, -1});
    Vec3d up = vec3d_subtract((Vec3d){0, 1, 0}, vec3d_scale(forward, forward.y));
    camera->direction = forward;
    camera->up = vec3d_normalize(up);
    camera->fov = random_unit_double(state) < 0.2 ? 170 : 2 + 80 * random_unit_double(state);
}

/** @return A room with a camera before it, to be destroyed. */
static Scene *random_room(uint64_t *state) {
    const double a = HALF, e = 2 * HALF;
    Scene *scene = create_empty_scene();
    room_quad(scene, state, (Vec3d){-a, -a, -a}, (Vec3d){0, 0, e}, (Vec3d){e, 0, 0});
    room_quad(scene, state, (Vec3d){-a, -a, -a}, (Vec3d){e, 0, 0}, (Vec3d){0, e, 0});
    room_quad(scene, state, (Vec3d){-a, -a, -a}, (Vec3d){0, e, 0}, (Vec3d){0, 0, e});
    room_quad(scene, state, (Vec3d){a, -a, -a}, (Vec3d){0, 0, e}, (Vec3d){0, e, 0});
    for (int i = (int)(8 * random_unit_double(state)); i > 0; i--) {
        room_shape(scene, state);
    }
    for (int i = (int)(3 * random_unit_double(state)); i > 0; i--) {
        room_lamp(scene, state);
    }
    scene->sky.horizon = scene->sky.zenith = (Rgbd){0.25, 0.5, 0.75};
    scene->ambient = (Rgbd){0.125, 0.125, 0.125};
    scene->camera.position = room_point(state);
    scene->camera.position.z = HALF + 3 * random_unit_double(state);
    room_camera_turn(&scene->camera, state);
    return scene;
}

/** A floor that may rise to the right and to the front. */
typedef struct Floor {
    double rise_x; /**< Per length. */
    double rise_z; /**< Per length. */
} Floor;

/** @return The height of a floor. */
static double floor_height(const Floor *floor, double x, double z) {
    return floor->rise_x * (x + HALF) + floor->rise_z * (z + HALF) - HALF;
}

/** Adds a lamp at any height above or below a floor: mostly hardly any. */
static void floor_lamp(Scene *scene, uint64_t *state, const Floor *floor) {
    Vec3d position = room_point(state);
    double height = exp2(1 - 24 * random_unit_double(state));
    position.y = floor_height(floor, position.x, position.z) +
                 (random_unit_double(state) < 0.25 ? -height : height);
    room_lamp_at(scene, state, position);
}

/** @return A random vector of a length. */
static Vec3d random_of_length(uint64_t *state, double length) {
    double x = random_float(state, -1, 1), y = random_float(state, -1, 1);
    Vec3d direction = {x, y, random_float(state, -1, 1)};
    return vec3d_scale(vec3d_normalize(direction), length);
}

/** Adds a ball that a point is on the surface of, or a small box or a speck beside the point. In
 *  float, the corners of a speck are one point. */
static void floor_solid(Scene *scene, uint64_t *state, Vec3d point) {
    double size = exp2(1 - 12 * random_unit_double(state));
    Vec3d beside = random_of_length(state, size);
    room_material(scene, state);
    double kind = random_unit_double(state);
    if (kind < 0.5) {
        SphereParameters sphere = {vec3d_add(point, beside), size};
        add_shape(scene, "sphere", &sphere);
    } else if (kind < 0.625) {
        const double speck = 1e-9;
        QuadParameters quad = {vec3d_add(point, beside), {speck, 0, 0}, {0, speck, 0}};
        add_shape(scene, "quad", &quad);
    } else {
        Vec3d corner = {point.x + beside.x, point.y, point.z + beside.z};
        BoxParameters box = {corner, vec3d_add(corner, (Vec3d){size / 4, size / 8, size / 4})};
        add_shape(scene, "box", &box);
    }
}

/** Adds a floor: a quad as large as the room, or a plane without end. */
static void add_floor(Scene *scene, uint64_t *state, const Floor *floor, bool is_endless) {
    const double a = HALF, e = 2 * HALF;
    if (is_endless) {
        PlaneParameters plane = {{-a, -a, -a}, {-floor->rise_x, 1, -floor->rise_z}};
        room_material(scene, state);
        add_shape(scene, "plane", &plane);
    } else {
        room_quad(scene, state, (Vec3d){-a, -a, -a}, (Vec3d){0, floor->rise_z * e, e},
                  (Vec3d){e, floor->rise_x * e, 0});
    }
}

/** @return A floor, a camera that looks at a point of it, up to two small shapes around that point,
 *          and two lamps, to be destroyed. Many tiles of it are plain, or nearly so. */
static Scene *random_floor(uint64_t *state, bool is_endless) {
    Scene *scene = create_empty_scene();
    Floor floor = {0, 0};
    if (random_unit_double(state) < 0.5) {
        floor = (Floor){random_unit_double(state) / 4, random_unit_double(state) / 16};
    }
    add_floor(scene, state, &floor, is_endless);
    Vec3d target = {random_float(state, -1, 1), 0, 0};
    target.y = floor_height(&floor, target.x, target.z);
    for (int i = (int)(3 * random_unit_double(state)); i > 0; i--) {
        floor_solid(scene, state, target);
    }
    floor_lamp(scene, state, &floor);
    floor_lamp(scene, state, &floor);
    scene->ambient = (Rgbd){0.125, 0.125, 0.125};
    SceneCamera *camera = &scene->camera;
    camera->position = (Vec3d){0, floor_height(&floor, 0, HALF), HALF};
    camera->position.y += exp2(2 - 6 * random_unit_double(state));
    camera->direction = vec3d_normalize(vec3d_subtract(target, camera->position));
    Vec3d forward = camera->direction;
    camera->up = vec3d_normalize(vec3d_subtract((Vec3d){0, 1, 0}, vec3d_scale(forward, forward.y)));
    camera->fov = 1 + 40 * random_unit_double(state);
    return scene;
}

/** Traces a grid. @return The rays. */
static RayCounts trace_room(const Engine *engine, const Scene *scene, const TraceSettings *settings,
                            int width, const PixelGrid *grid, double *rgb) {
    Error error = {0};
    RayCounts counts = {0};
    Tracer *tracer = engine->create_tracer(scene, settings, &error);
    assert_non_null(tracer);
    engine->set_view(tracer, scene, width, width / 2);
    engine->trace(tracer, grid, rgb, &counts);
    engine->destroy(tracer);
    return counts;
}

/** @return A part of a picture. @param is_tile Whether it has whole packets only. */
static PixelGrid random_grid(uint64_t *state, int width, bool is_tile) {
    PixelGrid grid = {.x = (int)(width / 2 * random_unit_double(state)),
                      .y = (int)(width / 4 * random_unit_double(state)),
                      .columns = 1 + (int)(MOST * random_unit_double(state)),
                      .rows = 1 + (int)(MOST * random_unit_double(state)),
                      .stride = random_unit_double(state) < 0.7 ? 1 : 3,
                      .sample = (int)(3 * random_unit_double(state))};
    if (is_tile) {
        grid.columns = grid.columns < MOST / 2 ? 16 : 32;
        grid.rows = 8;
    }
    return grid;
}

/** Draws a room in all engines of a number type. @param first The engine of one lane. */
static void draw_room(const Engine *first, int room) {
    static double wanted[3 * MOST * MOST], got[3 * MOST * MOST];
    uint64_t state = (uint64_t)room;
    const bool is_floor = room % 16 >= 8;
    const bool is_endless = room % 32 >= 24;
    Scene *scene = is_floor ? random_floor(&state, is_endless) : random_room(&state);
    if (room % 8 >= 5) { // One of its shapes is turned and stretched.
        uint64_t turn = state;
        transform_last_shape(scene, &turn);
    }
    // In a large picture, a part is a narrow beam that often sees one wall.
    const int width = room < ROOMS ? SMALLEST << (room / 16 % WIDTHS) : SMALLEST;
    PixelGrid grid = random_grid(&state, width, room / 16 % 2 == 1);
    if (is_floor) { // The middle of the picture is in it.
        grid.x = width / 2 - (int)(grid.columns * grid.stride * random_unit_double(&state));
        grid.y = width / 4 - (int)(grid.rows * grid.stride * random_unit_double(&state));
    }
    const OffsetStrategy offset = room % 8 == 0   ? OFFSET_NONE
                                  : room % 8 == 1 ? OFFSET_FIXED
                                                  : OFFSET_BOUND;
    size_t bytes = 3 * (size_t)grid.columns * (size_t)grid.rows * sizeof *got;
    TraceSettings settings = {
        .depth = 3, .samples = 1, .cutoff = 0.25, .offset = offset, .epsilon = 1e-3};
    RayCounts rays = trace_room(first, scene, &settings, width, &grid, wanted);
    // Every fourth room is in a BVH, where packets meet its nodes as they meet shapes in the list.
    settings.bvh = room % 4 == 3 ? BVH_ALWAYS : settings.bvh;
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if (engine_matches_type(*engine, first) && *engine != first) {
            RayCounts same = trace_room(*engine, scene, &settings, width, &grid, got);
            if (memcmp(got, wanted, bytes) != 0 || same.shadow != rays.shadow ||
                same.reflection != rays.reflection) {
                fail_msg("room %d in %s: another picture than in %s", room, (*engine)->name,
                         first->name);
            }
        }
    }
    scene_destroy(scene);
}

/** Draws all rooms in the engines of a number type. */
static void draw_rooms(const Engine *first) {
    if (first->mantissa_bits <= 64) {
        for (int room = 0; room < ROOMS / WORKLOAD_DIVISOR; room++) {
            draw_room(first, room);
        }
        draw_room(first, ROOM_OF_ROUNDINGS);
    }
}

/** Engines of several lanes draw what engines of one lane draw, to the bit. */
static void test_rooms(void **state) {
    (void)state;
    for_every_type(draw_rooms);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_rooms)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
