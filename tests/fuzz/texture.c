/**
 * @file
 * @brief Fuzz target: the texture that a worker hands over.
 */
#include "shared/handover.h"

#include "assets/images/image_worker.h"
#include "dioptre/parameter.h"

/** Most texels that are made up for a head that fits its block. */
enum { SIDE_LIMIT = 64 };

/** The input of the run. */
static FuzzInput input;
/** The block that is handed over. */
static union {
    Texture texture;                                               /**< Its head. */
    uint8_t bytes[sizeof(Texture) + 16 * SIDE_LIMIT * SIDE_LIMIT]; /**< All bytes. */
} block;

const void *fuzz_reply(const WorkerCall *call, size_t *size) {
    // The first byte of a report says that there is a result.
    memset(call->report, 0, call->report_capacity);
    uint8_t kind = fuzz_take_byte(&input);
    fuzz_take(&input, call->report, kind & 1 ? 1 : call->report_capacity);
    memset(&block, 0, sizeof block);
    size_t given = input.size < sizeof block ? input.size : sizeof block;
    fuzz_take(&input, block.bytes, given);
    if (kind & 2) { // A head that fits.
        block.texture.width = block.texture.width % SIDE_LIMIT;
        block.texture.height = block.texture.height % SIDE_LIMIT;
        unsigned char is_hdr = (unsigned char)(kind >> 2);
        memcpy(&block.texture.is_hdr, &is_hdr, 1);
        size_t channel = is_hdr ? sizeof(float) : 1;
        *size = sizeof(Texture) + (size_t)abs(block.texture.width) *
                                      (size_t)abs(block.texture.height) * TEXEL_CHANNELS * channel;
    } else {
        *size = given;
    }
    return kind & 128 ? NULL : block.bytes;
}

/** Reads all of an accepted texture. */
static void check_texture(Texture *texture) {
    size_t count = (size_t)texture->width * (size_t)texture->height * TEXEL_CHANNELS;
    unsigned sum = 0;
    for (size_t i = 0; i < count; i++) {
        if (texture->is_hdr) {
            float texel = texture_hdr_texels(texture)[i];
            FUZZ_REQUIRE(texel >= 0 && texel <= (float)INTENSITY_MAXIMUM);
        } else {
            sum += texture_ldr_texels(texture)[i];
        }
    }
    FUZZ_REQUIRE(sum <= UINT8_MAX * count && texture->reference_count == 1);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static const ImageWorker worker = {.program = "fuzz", .task = "fuzz"};
    static const ImageReadLimits limits = {
        .time_limit = 1, .memory_limit = 1 << 20, .texture_capacity = 1 << 20};
    static const ImageSource source = {.format = "png"};
    Texture *texture = NULL;
    Error error = {0};
    AssetBudget budget;
    asset_budget_init(&budget);
    input = (FuzzInput){data, size};
    if (image_worker_call(&worker, &source, &limits, &budget, &texture, &error)) {
        check_texture(texture);
    } else {
        FUZZ_REQUIRE(!texture && error.status != STATUS_OK);
        FUZZ_REQUIRE(error.status <= STATUS_SCENE || error.status == STATUS_INTERRUPTED);
        FUZZ_REQUIRE(memchr(error.message, '\0', sizeof error.message));
    }
    texture_release(texture);
    return 0;
}
