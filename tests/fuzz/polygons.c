/**
 * @file
 * @brief Fuzz target: polygons of any corners, as a library may hand them over, become a valid
 * mesh.
 */
#include "fuzz.h"

#include "assets/meshes/mesh_builder.h"
#include "assets/meshes/triangulate.h"

/** Most corners of a polygon. */
enum { CORNERS_LIMIT = 32 };

/** Takes a coordinate: a small whole number, so that corners meet, or any double. */
static double take_coordinate(FuzzInput *input) {
    double value;
    uint8_t kind = fuzz_take_byte(input);
    if (kind < 240) {
        return (kind % 16) - 8;
    }
    fuzz_take(input, &value, sizeof value);
    return value;
}

/** Takes a corner. */
static MeshCorner take_corner(FuzzInput *input) {
    MeshCorner corner = {.has_normal = fuzz_take_byte(input) % 2};
    corner.has_uv = fuzz_take_byte(input) % 2;
    for (int i = 0; i < 3; i++) {
        corner.position[i] = take_coordinate(input);
        corner.normal[i] = corner.has_normal ? take_coordinate(input) : 0;
    }
    for (int i = 0; i < 2; i++) {
        corner.uv[i] = corner.has_uv ? take_coordinate(input) : 0;
    }
    return corner;
}

/** Takes a polygon, cuts it and adds its triangles. @return false if the builder refuses one. */
static bool add_polygon(FuzzInput *input, MeshBuilder *builder) {
    MeshCorner corners[CORNERS_LIMIT];
    Vec3d positions[CORNERS_LIMIT];
    uint32_t triangles[3 * (CORNERS_LIMIT - 2)], work[CORNERS_LIMIT];
    size_t missing = 0, count = 3 + fuzz_take_byte(input) % (CORNERS_LIMIT - 2);
    for (size_t i = 0; i < count; i++) {
        corners[i] = take_corner(input);
        const double *p = corners[i].position;
        positions[i] = (Vec3d){p[0], p[1], p[2]};
    }
    size_t cut = triangulate_polygon(positions, count, triangles, work, &missing);
    FUZZ_REQUIRE(cut + missing <= count - 2);
    bool is_added = true;
    for (size_t i = 0; i < cut && is_added; i++) {
        MeshCorner triangle[3];
        for (int k = 0; k < 3; k++) {
            FUZZ_REQUIRE(triangles[3 * i + (size_t)k] < count);
            triangle[k] = corners[triangles[3 * i + (size_t)k]];
        }
        is_added = mesh_builder_add(builder, triangle);
    }
    return is_added;
}

/** Creates the mesh of a builder, which must be valid, with unit normals everywhere. */
static void check_mesh(MeshBuilder *builder) {
    Mesh counts;
    Error error = {0};
    if (!mesh_builder_finish(builder, &counts)) {
        return;
    }
    Mesh *mesh = mesh_create(&counts, &error);
    Vec3d *normals = calloc(counts.position_count, sizeof *normals);
    FUZZ_REQUIRE(mesh && normals);
    mesh_builder_copy(builder, mesh);
    FUZZ_REQUIRE(mesh_validate(mesh, &error));
    mesh_smooth_normals(mesh, normals);
    for (size_t i = 0; i < mesh->position_count; i++) {
        FUZZ_REQUIRE(fabs(vec3d_dot(normals[i], normals[i]) - 1) < 1e-9);
    }
    free(normals);
    mesh_release(mesh);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    FuzzInput input = {data, size};
    MeshBuilder builder;
    Error error = {0};
    bool is_good = true;
    mesh_builder_init(&builder, &error);
    while (input.size > 0 && is_good) {
        is_good = add_polygon(&input, &builder);
    }
    if (is_good) {
        check_mesh(&builder);
    }
    if (error.status != STATUS_OK) {
        fuzz_check_error(&error);
    }
    mesh_builder_deinit(&builder);
    return 0;
}
