/**
 * @file
 * @brief Fuzz target: mesh files of the formats that the library reads, in a worker as the program
 * starts it. The library may crash there, but this process gets a valid mesh or a reason.
 *
 * The worker is no part of the target, so that libFuzzer sees nothing of it: its mutations are
 * blind.
 */
#include "fuzz.h"

#include "assets/meshes/mesh_file.h"

#include <fcntl.h>
#include <unistd.h>

/** @return The format that a file begins like. */
static const char *format_of(const uint8_t *data, size_t size) {
    static const struct {
        const char *start;     /**< The first bytes. */
        const char *extension; /**< The format. */
    } rows[] = {{"ply", "ply"}, {"glTF", "glb"}, {"{", "gltf"}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        size_t length = strlen(rows[i].start);
        if (size >= length && memcmp(data, rows[i].start, length) == 0) {
            return rows[i].extension;
        }
    }
    return "stl";
}

/** Writes the input to a file. @return Its path. */
static const char *write_file(const uint8_t *data, size_t size) {
    static char path[64];
    snprintf(path, sizeof path, "/tmp/dioptre-fuzz-%d.%s", (int)getpid(), format_of(data, size));
    int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    FUZZ_REQUIRE(file >= 0);
    FUZZ_REQUIRE(write(file, data, size) == (ssize_t)size);
    close(file);
    return path;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    Mesh *mesh = NULL;
    Error error = {0};
    AssetBudget budget;
    const char *path = write_file(data, size);
    AssetFile file = {.path = path, .descriptor = open(path, O_RDONLY | O_CLOEXEC)};
    FUZZ_REQUIRE(fstat(file.descriptor, &file.info) == 0);
    asset_budget_init(&budget);
    if (mesh_file_read(&file, &budget, NULL, &mesh, &error)) {
        FUZZ_REQUIRE(mesh_validate(mesh, &error));
    } else {
        FUZZ_REQUIRE(!mesh && error.status == STATUS_SCENE && error.message[0]);
    }
    mesh_release(mesh);
    close(file.descriptor);
    unlink(path);
    return 0;
}
