/**
 * @file
 * @brief Tests of mesh files: what is read, corrected and refused.
 */
#include "fixtures.h"

#include "assets/meshes/mesh_file.h"
#include "assets/meshes/vertex_welder.h"
#include "dioptre/parameter.h"

#include <fenv.h>
#include <time.h>

/** Folder of the mesh files for tests, relative to the project. */
#define MODELS "tests/meshes/"

/** Vertices of a cube of edge 2 around the origin. */
#define CUBE_CORNERS                                                                               \
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
/** The cube, of quads whose fronts are outside. */
#define CUBE CUBE_CORNERS "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 1 5 8 4\n"
/** Three vertices, enough for one triangle. */
#define THREE "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
/** Header of a PLY file of three vertices. */
#define PLY_HEAD                                                                                   \
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"                \
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"

// --- helpers -------------------------------------------------------------------------------------

/** Creates a folder, and links the plugin. @return 0 on success. */
static int mesh_fixture_set_up(void **state) {
    symlink_plugin("dioptre-meshes.so");
    return fixture_set_up(state);
}

/** Reads a mesh file, with a whole budget. @return Whether it was read. */
static bool read_mesh_file(const char *path, const MeshProgress *progress, Mesh **mesh,
                           Error *error) {
    AssetFile file;
    AssetBudget budget;
    *mesh = NULL;
    asset_budget_init(&budget);
    if (!open_asset(path, &file, error)) {
        return false;
    }
    bool is_read = mesh_file_read(&file, &budget, progress, mesh, error);
    close(file.descriptor);
    return is_read;
}

/** @return The mesh of a file, which must be valid and pass all checks. */
static Mesh *read_valid_mesh(const char *path) {
    Mesh *mesh;
    Error error = {0};
    if (!read_mesh_file(path, NULL, &mesh, &error)) {
        fail_msg("%s: %s", path, error.message);
    }
    assert_true(mesh_validate(mesh, &error));
    assert_int_equal(mesh->normal_count > 0, mesh->triangle_normals != NULL);
    assert_int_equal(mesh->uv_count > 0, mesh->triangle_uvs != NULL);
    return mesh;
}

/** @return The mesh of a text. */
static Mesh *read_text(void **state, const char *text) {
    const char *path = fixture_path(state, "model.obj");
    write_file(path, text, strlen(text));
    return read_valid_mesh(path);
}

/** Asserts that a file is refused. */
static void assert_file_refused(const char *path, const char *words) {
    Mesh *mesh = (Mesh *)&mesh;
    Error error = {0};
    bool is_read = read_mesh_file(path, NULL, &mesh, &error);
    if (is_read || mesh || error.status != STATUS_SCENE || !strstr(error.message, words)) {
        fail_msg("%s: wanted: %s, got: (%d) %s", path, words, error.status, error.message);
    }
}

/** Asserts that a text is refused. */
static void assert_text_refused(void **state, const char *name, const char *text,
                                const char *words) {
    const char *path = fixture_path(state, name);
    write_file(path, text, strlen(text));
    assert_file_refused(path, words);
}

/** @return Twice the area of a triangle, as a vector. */
static Vec3d area_of(const Mesh *mesh, size_t i) {
    const uint32_t *at = mesh->triangles[i].index;
    const Vec3d *p = mesh->positions;
    return vec3d_cross(vec3d_subtract(p[at[1]], p[at[0]]), vec3d_subtract(p[at[2]], p[at[0]]));
}

/** @return The area of a mesh. */
static double area_of_all(const Mesh *mesh) {
    double sum = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        sum += vec3d_length(area_of(mesh, i)) / 2;
    }
    return sum;
}

/** @return The volume of a closed mesh. */
static double volume_of(const Mesh *mesh) {
    double sum = 0;
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        sum += vec3d_dot(mesh->positions[mesh->triangles[i].index[0]], area_of(mesh, i)) / 6;
    }
    return sum;
}

// --- reading -------------------------------------------------------------------------------------

/** Texts and their expected results. */
static const struct {
    const char *text;  /**< An OBJ file. */
    size_t positions;  /**< Number of positions. */
    size_t triangles;  /**< Number of triangles. */
    size_t normals;    /**< Number of normals. */
    size_t uvs;        /**< Number of (u, v) pairs. */
    size_t degenerate; /**< Number of omitted triangles. */
    size_t lost;       /**< Number of corners without a normal. */
} texts[] = {
    {THREE "f 1 2 3\n", 3, 1, 0, 0, 0, 0},
    {CUBE, 8, 12, 0, 0, 0, 0},
    {THREE "f 1 2 3", 3, 1, 0, 0, 0, 0},
    {THREE "f -3 -2 -1\n", 3, 1, 0, 0, 0, 0},
    // Points, lines and material names are ignored.
    {"mtllib ../none.mtl\n" THREE "usemtl none\np 1\nl 1 2\nf 1 2 3\n", 3, 1, 0, 0, 0, 0},
    // Triangles without area: a repeated vertex, collinear vertices, equal positions.
    {THREE "v 2 0 0\nv 1 0 0\nf 1 2 3\nf 1 1 2\nf 1 2 4\nf 2 5 3\n", 3, 1, 0, 0, 3, 0},
    // Equal positions are merged, and so are 0 and -0.
    {THREE "v -0 0 0\nv 1 0 0\nv 0 -1 0\nf 1 2 3\nf 4 6 5\n", 4, 2, 0, 0, 0, 0},
    // Normals: of any length, missing, zero.
    {THREE "vn 0 0 9\nf 1//1 2//1 3//1\n", 3, 1, 1, 0, 0, 0},
    {THREE "vn 0 0 1\nvn 0 0 0\nf 1//1 2//2 3//1\n", 3, 1, 1, 0, 0, 1},
    {THREE "vn 0 0 0\nf 1//1 2//1 3//1\n", 3, 1, 0, 0, 0, 3},
    {THREE "vt 0 0\nvt 1 0.5 7\nf 1/1 2/2 3/1\n", 3, 1, 0, 2, 0, 0},
    // Numbers that begin with their decimal point; coordinates as large as they may be.
    {"v .5 -.5 +.5\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", 3, 1, 0, 0, 0, 0},
    {"v 1e14 0 0\nv 0 1e14 0\nv 0 0 -1e14\nf 1 2 3\n", 3, 1, 0, 0, 0, 0},
    // A concave quad, and a concave polygon.
    {"v 0 0 0\nv 2 2 0\nv 0 1 0\nv -2 2 0\nf 1 2 3 4\n", 4, 2, 0, 0, 0, 0},
    {"v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n", 5, 3, 0, 0, 0, 0},
};

/** Texts have the expected results. */
static void test_texts(void **state) {
    for (size_t i = 0; i < COUNT(texts); i++) {
        Mesh *mesh = read_text(state, texts[i].text);
        bool is_right = mesh->position_count == texts[i].positions &&
                        mesh->triangle_count == texts[i].triangles &&
                        mesh->normal_count == texts[i].normals && mesh->uv_count == texts[i].uvs &&
                        mesh->repairs.degenerate_triangles == texts[i].degenerate &&
                        mesh->repairs.missing_normals == texts[i].lost;
        if (!is_right) {
            fail_msg("%s: %zu positions, %zu triangles, %zu normals, %zu uvs, %zu without area, "
                     "%zu without normal",
                     texts[i].text, mesh->position_count, mesh->triangle_count, mesh->normal_count,
                     mesh->uv_count, mesh->repairs.degenerate_triangles,
                     mesh->repairs.missing_normals);
        }
        mesh_release(mesh);
    }
}

/** Coordinates and orientation are those of the file, to the last bit of a double. */
static void test_numbers(void **state) {
    Mesh *mesh = read_text(state, "v .1 -.25 3e-5\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const uint32_t *at = mesh->triangles[0].index;
    Vec3d p = mesh->positions[at[0]];
    assert_true(p.x == 0.1 && p.y == -0.25 && p.z == 3e-5);
    assert_true(mesh->positions[at[1]].x == 1 && mesh->positions[at[2]].y == 1);
    mesh_release(mesh);
    mesh = read_text(state, CUBE);
    assert_true(volume_of(mesh) == 8 && area_of_all(mesh) == 24);
    mesh_release(mesh);
}

/** Polygons are triangulated without gaps or overlaps, including concave ones. */
static void test_concave(void **state) {
    Mesh *mesh = read_text(state, "v 0 0 0\nv 2 2 0\nv 0 1 0\nv -2 2 0\nf 1 2 3 4\n");
    assert_at_most(fabs(area_of_all(mesh) - 2), 1e-12, "area of an arrowhead");
    mesh_release(mesh);
    mesh = read_text(state, "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n");
    assert_at_most(fabs(area_of_all(mesh) - 10), 1e-12, "area of a notched square");
    mesh_release(mesh);
}

/** The missing part of a self-intersecting polygon, which cannot be triangulated, is counted. */
static void test_uncut(void **state) {
    Mesh *mesh = read_text(state, "v 0 1 0\nv 3 0 0\nv 0 0 0\nv 1 2 0\nv 1 3 0\nf 1 2 3 4 5\n" THREE
                                  "f -3 -2 -1\n");
    assert_int_equal(mesh->triangle_count + mesh->repairs.degenerate_triangles +
                         mesh->repairs.untriangulated_polygons,
                     4);
    assert_true(mesh->repairs.untriangulated_polygons > 0);
    mesh_release(mesh);
}

/**
 * Corners have the normal and (u, v) of the file; corners without a normal get that of the
 * triangle.
 */
static void test_corners(void **state) {
    Mesh *mesh = read_text(state, THREE "vn 0 3 4\nvn 0 0 0\nvt 0.25 0.75\nvt 2 -1\n"
                                        "f 1/1/1 2/2/2 3/1/1\n");
    const uint32_t *n = mesh->triangle_normals[0].index, *t = mesh->triangle_uvs[0].index;
    assert_true(mesh->normals[n[0]].y == 0.6 && mesh->normals[n[0]].z == 0.8);
    assert_true(mesh->normals[n[1]].z == 1 && n[2] == n[0]);
    assert_true(mesh->uvs[t[0]].u == 0.25 && mesh->uvs[t[0]].v == 0.75);
    assert_true(mesh->uvs[t[1]].u == 2 && mesh->uvs[t[1]].v == -1 && t[2] == t[0]);
    mesh_release(mesh);
}

/** Unusual but valid files give the expected triangles. */
static void test_awkward(void **state) {
    (void)state;
    static const struct {
        const char *path; /**< The file. */
        size_t triangles; /**< Number of triangles. */
        size_t lost;      /**< Number of corners without a normal. */
    } files[] = {{MODELS "hand-bad-normals.obj", 3, 3},
                 {MODELS "hand-bom-cube.obj", 12, 0},
                 {MODELS "hand-continuation.obj", 4, 0},
                 {MODELS "hand-crlf-cube.obj", 12, 0},
                 {MODELS "hand-groups-smoothing.obj", 4, 0},
                 {MODELS "hand-mixed-refs.obj", 6, 12},
                 {MODELS "hand-negative.obj", 4, 0},
                 {MODELS "hand-nonplanar-ngon.obj", 7, 0},
                 {MODELS "obj-hand-mtllib-traversal.obj", 1, 0}};
    for (size_t i = 0; i < COUNT(files); i++) {
        Mesh *mesh = read_valid_mesh(files[i].path);
        if (mesh->triangle_count != files[i].triangles ||
            mesh->repairs.missing_normals != files[i].lost) {
            fail_msg("%s: %zu triangles, %zu corners without normal", files[i].path,
                     mesh->triangle_count, mesh->repairs.missing_normals);
        }
        mesh_release(mesh);
    }
}

/** PLY, STL and glTF are read too. */
static void test_formats(void **state) {
    static const char *const files[][2] = {
        {"a.ply", PLY_HEAD "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
        {"a.STL", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                  "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"},
        // A triangle of floats in base 64, which a node translates by (5, 0, 0).
        {"a.gltf",
         "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
         "\"nodes\":[{\"mesh\":0,\"translation\":[5,0,0]}],"
         "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
         "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\","
         "\"min\":[0,0,0],\"max\":[1,1,0]}],"
         "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}],"
         "\"buffers\":[{\"byteLength\":36,\"uri\":\"data:application/octet-stream;base64,"
         "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\"}]}"},
    };
    for (size_t i = 0; i < COUNT(files); i++) {
        const char *path = fixture_path(state, files[i][0]);
        write_file(path, files[i][1], strlen(files[i][1]));
        Mesh *mesh = read_valid_mesh(path);
        assert_int_equal(mesh->triangle_count, 1);
        assert_true(mesh->positions[mesh->triangles[0].index[1]].x == (i == 2 ? 6 : 1));
        assert_true(area_of(mesh, 0).z == 1);
        mesh_release(mesh);
    }
}

/** @return The key of an edge, equal in both directions. */
static uint64_t edge_of(uint32_t a, uint32_t b) {
    return a < b ? (uint64_t)a << 32 | b : (uint64_t)b << 32 | a;
}

/** @return Order of two edges, for qsort. */
static int compare_edges(const void *a, const void *b) {
    uint64_t x = *(const uint64_t *)a, y = *(const uint64_t *)b;
    return (x > y) - (x < y);
}

/** A closed mesh stays closed: each edge belongs to two triangles. */
static void test_closed(void **state) {
    (void)state;
    Mesh *mesh = read_valid_mesh("scenes/models/spot.obj");
    assert_int_equal(mesh->triangle_count, 5856);
    assert_int_equal(mesh->position_count, 2930);
    assert_int_equal(mesh->uv_count, 3225);
    size_t count = 3 * mesh->triangle_count;
    uint64_t *edges = calloc(count, sizeof *edges);
    for (size_t i = 0; i < count; i++) {
        const uint32_t *at = mesh->triangles[i / 3].index;
        edges[i] = edge_of(at[i % 3], at[(i + 1) % 3]);
    }
    qsort(edges, count, sizeof *edges, compare_edges);
    for (size_t i = 0; i < count; i += 2) {
        assert_true(edges[i] == edges[i + 1] && (i == 0 || edges[i] != edges[i - 1]));
    }
    free(edges);
    mesh_release(mesh);
    mesh = read_valid_mesh("scenes/models/teapot.obj");
    assert_int_equal(mesh->triangle_count + mesh->repairs.degenerate_triangles, 6320);
    mesh_release(mesh);
}

// --- smooth normals ------------------------------------------------------------------------------

/** Smooth normals of a cube point away from its centre, however its sides are triangulated. */
static void test_smooth_cube(void **state) {
    Mesh *mesh = read_text(state, CUBE);
    Vec3d normals[8];
    mesh_smooth_normals(mesh, normals);
    for (size_t i = 0; i < mesh->position_count; i++) {
        Vec3d wanted = vec3d_scale(mesh->positions[i], 1 / sqrt(3));
        assert_at_most(vec3d_length(vec3d_subtract(normals[i], wanted)), 4e-16, "corner %zu", i);
    }
    mesh_release(mesh);
}

/** @return A mesh of triangles. */
static Mesh *mesh_from_triangles(const Vec3d *positions, size_t position_count,
                                 const MeshTriangle *triangles, size_t triangle_count) {
    Error error = {0};
    const Mesh counts = {.position_count = position_count, .triangle_count = triangle_count};
    Mesh *mesh = mesh_create(&counts, &error);
    assert_non_null(mesh);
    memcpy(mesh->positions, positions, position_count * sizeof *positions);
    memcpy(mesh->triangles, triangles, triangle_count * sizeof *triangles);
    return mesh;
}

/** Where the mean is undefined, there is still a unit normal. */
static void test_smooth_extremes(void **state) {
    (void)state;
    const double scales[] = {1, 1e15, 1e-15};
    for (size_t i = 0; i < COUNT(scales); i++) {
        double s = scales[i];
        // Both sides of a sheet, a triangle without area, and an unused position.
        const Vec3d positions[] = {{0, 0, 0}, {s, 0, 0}, {0, s, 0}, {2 * s, 0, 0}, {s, s, s}};
        const MeshTriangle triangles[] = {{{0, 1, 2}}, {{0, 2, 1}}, {{0, 1, 3}}};
        Mesh *mesh = mesh_from_triangles(positions, 5, triangles, 3);
        Vec3d normals[5];
        mesh_smooth_normals(mesh, normals);
        for (size_t k = 0; k < 5; k++) {
            assert_at_most(fabs(vec3d_length(normals[k]) - 1), 1e-15, "length %zu", k);
        }
        assert_true(normals[0].z == 1 && normals[4].y == 1);
        mesh_release(mesh);
    }
}

// --- checks --------------------------------------------------------------------------------------

/** Invalid meshes are detected. */
static void test_check(void **state) {
    (void)state;
    const Vec3d good[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const MeshTriangle whole = {{0, 1, 2}}, beyond = {{0, 1, 3}};
    const double numbers[] = {NAN, INFINITY, -INFINITY, 2 * LENGTH_MAXIMUM};
    Error error = {0};
    Mesh *mesh = mesh_from_triangles(good, 3, &whole, 1);
    assert_true(mesh_validate(mesh, &error));
    for (size_t i = 0; i < COUNT(numbers); i++) {
        mesh->positions[1].y = numbers[i];
        assert_false(mesh_validate(mesh, NULL));
    }
    mesh_release(mesh);
    mesh = mesh_from_triangles(good, 3, &beyond, 1);
    assert_false(mesh_validate(mesh, &error));
    assert_int_equal(error.status, STATUS_SCENE);
    mesh_release(mesh);
    const Mesh counts = {
        .position_count = 3, .normal_count = 1, .uv_count = 1, .triangle_count = 1};
    mesh = mesh_create(&counts, &error);
    mesh->normals[0].x = 1;
    assert_true(mesh_validate(mesh, NULL));
    mesh->normals[0].x = 0.99;
    assert_false(mesh_validate(mesh, NULL));
    mesh->normals[0].x = 1;
    mesh->uvs[0].v = NAN;
    assert_false(mesh_validate(mesh, NULL));
    mesh->uvs[0].v = 0;
    mesh->triangle_uvs[0].index[2] = 1;
    assert_false(mesh_validate(mesh, NULL));
    mesh_release(mesh);
}

/** The vertex welder finds equal vertices, also after it has grown. */
static void test_vertex_welder(void **state) {
    (void)state;
    VertexWelder pool = {.dimension = 2};
    uint32_t id;
    for (int round = 0; round < 2; round++) {
        for (uint32_t i = 0; i < 100000; i++) {
            const double point[] = {(double)(i % 317), -(double)(i / 317)};
            assert_true(vertex_welder_add(&pool, point, &id));
            assert_int_equal(id, i);
        }
    }
    assert_int_equal(pool.count, 100000);
    vertex_welder_deinit(&pool);
}

/** Zeros of both signs are one vertex, in whichever direction the processor rounds. */
static void test_welded_zeros(void **state) {
    (void)state;
    static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    for (size_t i = 0; i < COUNT(modes); i++) {
        VertexWelder pool = {.dimension = 3};
        uint32_t id = 1;
        assert_int_equal(fesetround(modes[i]), 0);
        for (int signs = 0; signs < 8; signs++) {
            const double point[] = {signs & 1 ? -0.0 : 0.0, signs & 2 ? -0.0 : 0.0,
                                    signs & 4 ? -0.0 : 0.0};
            bool is_added = vertex_welder_add(&pool, point, &id);
            assert_true(is_added && id == 0);
        }
        assert_int_equal(fesetround(FE_TONEAREST), 0);
        assert_int_equal(pool.count, 1);
        vertex_welder_deinit(&pool);
    }
}

// --- refused files -------------------------------------------------------------------------------

/** Invalid texts are refused with a reason. */
static void test_refused_texts(void **state) {
    static const char *const broken[][3] = {
        {"a.obj", "", "no triangle"},
        {"a.obj", "# nothing but a comment here\n", "no triangle"},
        {"a.obj", THREE "p 1\nl 1 2 3\n", "no triangle"},
        {"a.obj", THREE "f 1 2 2\nf 3 3 3\n", "no triangle in it that has an area"},
        {"a.obj", THREE "f 1 2 4\n", "vertex 4, but there are 3"},
        {"a.obj", THREE "f 1 2 0\n", "vertex 0"},
        {"a.obj", THREE "f 1 2 -4\n", "vertex -4"},
        {"a.obj", THREE "f 1 2 99999999999999999999\n", "but there are 3"},
        {"a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "finite"},
        {"a.obj", "v inf 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "finite"},
        {"a.obj", "v 1e16 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "at most 1e+15"},
        {"a.ply", PLY_HEAD "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "not there"},
        {"a.ply", PLY_HEAD "0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n", "finite"},
        {"a.ply", "no ply at all", ""},
        {"a.stl", "no stl at all", ""},
        {"a.glb", "no glb at all", ""},
        {"a.gltf", "{}", ""},
        {"a.txt", CUBE, "must end in .obj"},
        {"obj", CUBE, "must end in .obj"},
    };
    for (size_t i = 0; i < COUNT(broken); i++) {
        assert_text_refused(state, broken[i][0], broken[i][1], broken[i][2]);
    }
}

/** Malicious files are refused with a reason, quickly. */
static void test_hostile(void **state) {
    (void)state;
    static const char *const files[][2] = {
        {MODELS "obj-hand-huge-index.obj", "but there are 3"},
        {MODELS "obj-hand-garbage.obj", "no triangle"},
        {MODELS "obj-hand-short-v.obj", "number"},
        {MODELS "ply-hand-huge-count.ply", ""},
        {MODELS "ply-hand-index-out-of-range.ply", "not there"},
        {MODELS "ply-hand-nan.ply", "finite"},
    };
    time_t start = time(NULL);
    for (size_t i = 0; i < COUNT(files); i++) {
        assert_file_refused(files[i][0], files[i][1]);
    }
    assert_at_most(time(NULL) - start, 10, "seconds");
}

/**
 * A file that crashes the library does not crash the program: a binary PLY that ends before its
 * faces.
 */
static void test_crash(void **state) {
    static const char head[] =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
        "property float y\nproperty float z\nelement face 9\n"
        "property list uchar int vertex_indices\nend_header\n";
    char bytes[sizeof head - 1 + 36 + 7];
    memset(bytes, 0, sizeof bytes);
    memcpy(bytes, head, sizeof head - 1);
    bytes[sizeof head - 1 + 36] = 3;
    write_file(fixture_path(state, "a.ply"), bytes, sizeof bytes);
    assert_file_refused(fixture_path(state, "a.ply"), "");
}

/** Anything that is not a regular file is refused without waiting. */
static void test_kinds(void **state) {
    assert_file_refused(fixture_path(state, "none.obj"), strerror(ENOENT));
    assert_int_equal(mkdir(fixture_path(state, "folder.obj"), 0700), 0);
    assert_file_refused(fixture_path(state, "folder.obj"), "folder");
    assert_int_equal(mkfifo(fixture_path(state, "pipe.obj"), 0600), 0);
    assert_file_refused(fixture_path(state, "pipe.obj"), "pipe");
    assert_int_equal(symlink("/dev/zero", fixture_path(state, "device.obj")), 0);
    assert_file_refused(fixture_path(state, "device.obj"), "device");
}

/** Files named by a mesh file are not opened: this one would block the program. */
static void test_materials_are_not_opened(void **state) {
    assert_int_equal(mkfifo(fixture_path(state, "model.mtl"), 0600), 0);
    time_t start = time(NULL);
    mesh_release(read_text(state, "mtllib model.mtl\n" THREE "usemtl a\nf 1 2 3\n"));
    assert_at_most(time(NULL) - start, 2, "seconds");
}

/** Changes a file while it is read, and counts the progress reports. */
typedef struct FileChanger {
    const char *path;    /**< The file. */
    const char *mode;    /**< Mode in which it is opened for the change: `ab`, `wb`; NULL: no
                              change. */
    const char *text;    /**< The written text. */
    int progress_count;  /**< Number of progress reports. */
    int end_count;       /**< Number of reports of the end. */
    double bad_fraction; /**< A fraction outside 0 to 1, if there was one. */
} FileChanger;

/**
 * Changes the file right after it was opened. See MeshProgress::tell.
 * @param fraction Fraction that is read.
 */
static void change_file(void *context, const char *name, double fraction, double seconds) {
    FileChanger *changer = context;
    assert_string_equal(name, "model.obj");
    if (!(fraction >= 0 && fraction <= 1) || (changer->progress_count == 0 && seconds > 0)) {
        changer->bad_fraction = fraction;
    }
    if (changer->progress_count++ == 0 && changer->mode) {
        // Longer than the time resolution of a file system.
        nanosleep(&(struct timespec){.tv_nsec = 20000000}, NULL);
        FILE *file = fopen(changer->path, changer->mode);
        fputs(changer->text, file);
        fclose(file);
    }
}

/** Counts the end. See MeshProgress::end. */
static void count_end(void *context) {
    ((FileChanger *)context)->end_count++;
}

/** A file that changes while it is read is refused; an unchanged one has progress reports. */
static void test_changes(void **state) {
    const char *path = fixture_path(state, "model.obj");
    const struct {
        const char *mode, *text, *words;
    } changes[] = {{NULL, NULL, NULL},
                   {"ab", "f 3 2 1\n", "changed"},
                   {"wb", "v 0 0 0\n", "shorter"},
                   {"wb", CUBE, "changed"}};
    for (size_t i = 0; i < COUNT(changes); i++) {
        FileChanger changer = {.path = path, .mode = changes[i].mode, .text = changes[i].text};
        const MeshProgress progress = {
            .report = change_file, .end = count_end, .context = &changer};
        Mesh *mesh;
        Error error = {0};
        write_file(path, CUBE, strlen(CUBE));
        bool is_read = read_mesh_file(path, &progress, &mesh, &error);
        assert_int_equal(is_read, changes[i].mode == NULL);
        assert_true(is_read || strstr(error.message, changes[i].words));
        assert_true(changer.progress_count >= 1 && changer.end_count == 1 &&
                    changer.bad_fraction == 0);
        mesh_release(mesh);
    }
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_texts, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_numbers, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_concave, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_uncut, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_corners, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_awkward, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_formats, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_closed, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_smooth_cube, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test(test_smooth_extremes),
        cmocka_unit_test(test_check),
        cmocka_unit_test(test_vertex_welder),
        cmocka_unit_test(test_welded_zeros),
        cmocka_unit_test_setup_teardown(test_refused_texts, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_hostile, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_crash, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_kinds, mesh_fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_materials_are_not_opened, mesh_fixture_set_up,
                                        fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_changes, mesh_fixture_set_up, fixture_tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
