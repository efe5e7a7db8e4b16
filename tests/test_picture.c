/**
 * @file
 * @brief Tests of pictures: the encoder and the comparison.
 */
#include "fixtures.h"
#include "render/row_encoder.h"

#include <fenv.h>
#include <float.h>

/** Both encodings. */
static const Encoding encodings[] = {ENCODING_SRGB, ENCODING_LINEAR};
/** Number of encodings. */
enum { ENCODINGS = sizeof encodings / sizeof *encodings };

// --- the encoder ---------------------------------------------------------------------------------

/**
 * Encodes by the formula of the standard in long double.
 * @param light  Linear light, 0 to 1.
 * @return The nearest 8-bit step, 0 to 255.
 */
static int encode_by_definition(Encoding encoding, float light) {
    long double x = (long double)light;
    long double encoded = x <= 0.0031308L ? 12.92L * x : 1.055L * powl(x, 1 / 2.4L) - 0.055L;
    return (int)lroundl(255 * (encoding == ENCODING_LINEAR ? x : encoded));
}

/** The light of each 8-bit step is encoded as that step. */
static void test_steps_round_trip(void **state) {
    (void)state;
    for (int i = 0; i < ENCODINGS; i++) {
        Encoder encoder;
        encoder_init(&encoder, encodings[i]);
        for (int step = 0; step <= UINT8_MAX; step++) {
            double light = encoding_decode(encodings[i], step);
            assert_int_equal(encoder_encode(&encoder, (float)light), step);
        }
    }
}

/** White is light of 1 and no more, in whichever direction the processor rounds. */
static void test_white(void **state) {
    (void)state;
    static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    for (size_t i = 0; i < sizeof modes / sizeof *modes; i++) {
        assert_int_equal(fesetround(modes[i]), 0);
        double light = encoding_decode(ENCODING_SRGB, UINT8_MAX);
        assert_int_equal(fesetround(FE_TONEAREST), 0);
        assert_true(light <= 1 && light > 1 - 1e-12);
    }
}

/** Each step begins at the exact float of the standard. */
static void test_thresholds(void **state) {
    (void)state;
    for (int i = 0; i < ENCODINGS; i++) {
        Encoder encoder;
        encoder_init(&encoder, encodings[i]);
        for (int step = 1; step <= UINT8_MAX; step++) {
            float light = encoder.thresholds[step];
            float below = nextafterf(light, 0);
            assert_int_equal(encode_by_definition(encodings[i], light), step);
            assert_int_equal(encode_by_definition(encodings[i], below), step - 1);
            assert_int_equal(encoder_encode(&encoder, below), step - 1);
            assert_int_equal(encoder_encode(&encoder, light), step);
            assert_int_equal(encoder_encode(&encoder, nextafterf(light, 1)), step);
        }
    }
}

/** No cell of the encoder's table contains two thresholds: the look-up depends on it. */
static void test_one_threshold_a_cell(void **state) {
    (void)state;
    for (int i = 0; i < ENCODINGS; i++) {
        Encoder encoder;
        encoder_init(&encoder, encodings[i]);
        for (int step = 2; step <= UINT8_MAX; step++) {
            int cell = (int)(encoder.thresholds[step] * 4096);
            assert_true((int)(encoder.thresholds[step - 1] * 4096) < cell);
        }
    }
}

/** Every float is encoded, including NaN, infinity and negative numbers. */
static void test_odd_lights(void **state) {
    (void)state;
    static const struct {
        float light; /**< The input. */
        int step;    /**< The expected step. */
    } cases[] = {
        {NAN, 0},        {-NAN, 0},      {-INFINITY, 0}, {-1, 0},
        {-0.0F, 0},      {FLT_MIN, 0},   {1e-45F, 0},    {-1e-45F, 0},
        {0, 0},          {1, 255},       {1.0001F, 255}, {1e30F, 255},
        {INFINITY, 255}, {FLT_MAX, 255}, {-FLT_MAX, 0},  {0.9999F, 255},
    };
    for (int i = 0; i < ENCODINGS; i++) {
        Encoder encoder;
        encoder_init(&encoder, encodings[i]);
        for (size_t j = 0; j < sizeof cases / sizeof *cases; j++) {
            assert_int_equal(encoder_encode(&encoder, cases[j].light), cases[j].step);
        }
    }
}

/** A million floats from 0 to 1, of all magnitudes, are encoded as by definition. */
static void test_many_lights(void **state) {
    (void)state;
    Encoder encoder;
    encoder_init(&encoder, ENCODING_SRGB);
    uint64_t random = 1;
    for (int i = 0; i < 1000000; i++) {
        // Half of them are uniform; the others are distributed like floats down to 2^-16.
        double part = random_unit_double(&random);
        float light = (float)(i % 2 ? part : exp2(-16 * part));
        if (encoder_encode(&encoder, light) != encode_by_definition(ENCODING_SRGB, light)) {
            fail_msg("%.9g is encoded as %d", (double)light, encoder_encode(&encoder, light));
        }
    }
}

/** @return Light that is hard to encode: beside a threshold, outside of 0 to 1, or no number. */
static double hard_light(const Encoder *encoder, uint64_t *random) {
    static const float others[] = {0, -0.0F, 1, -1, 2, 1e-45F, 1e38F, INFINITY, -INFINITY, NAN};
    unsigned kind = (unsigned)(4 * random_unit_double(random));
    float threshold = encoder->thresholds[1 + (int)(255 * random_unit_double(random))];
    return kind == 0   ? (double)others[(size_t)(COUNT(others) * random_unit_double(random))]
           : kind == 1 ? (double)nextafterf(threshold, 0)
           : kind == 2 ? (double)threshold
                       : random_unit_double(random);
}

/** Rows of all lengths are encoded as their rays are one by one, and nothing is written behind
 *  them. */
static void test_rows(void **state) {
    (void)state;
    enum { COLUMNS = 70, ROUNDS = 200, GUARD = 0xa5 };
    uint64_t random = 8;
    double sums[3 * COLUMNS];
    uint32_t counts[COLUMNS];
    for (int round = 0; round < ROUNDS; round++) {
        Encoder encoder;
        encoder_init(&encoder, encodings[round % ENCODINGS]);
        for (int i = 0; i < COLUMNS; i++) {
            counts[i] = round % 3 ? 1 : 1 + (uint32_t)(99 * random_unit_double(&random));
        }
        for (int i = 0; i < 3 * COLUMNS; i++) {
            sums[i] = hard_light(&encoder, &random) * counts[i % COLUMNS];
        }
        for (int columns = 1; columns <= COLUMNS; columns++) {
            uint8_t rgb[3 * COLUMNS + 1];
            memset(rgb, GUARD, sizeof rgb);
            row_encode(&encoder, &(SampleRow){sums, COLUMNS, counts, columns}, rgb);
            for (int i = 0; i < 3 * columns; i++) {
                double mean = sums[i % 3 * COLUMNS + i / 3] * (1.0 / counts[i / 3]);
                assert_int_equal(rgb[i], encoder_encode(&encoder, (float)mean));
            }
            assert_int_equal(rgb[3 * columns], GUARD);
        }
    }
}

// --- comparison ----------------------------------------------------------------------------------

/** Equal pictures have no difference. */
static void test_compare_equal(void **state) {
    (void)state;
    Picture picture = make_test_picture(5, 4);
    Picture map = make_test_picture(5, 4);
    PictureComparison comparison = picture_compare(&picture, &picture, &map);
    assert_int_equal(comparison.width, 5);
    assert_int_equal(comparison.height, 4);
    assert_int_equal(comparison.max_difference, 0);
    assert_true(comparison.differing_fraction == 0);
    assert_true(comparison.rmse == 0);
    assert_true(isinf(comparison.psnr) && comparison.psnr > 0);
    for (int i = 0; i < 5 * 4 * 3; i++) {
        assert_int_equal(map.pixels[i], 0);
    }
    picture_deinit(&picture);
    picture_deinit(&map);
}

/** Differences equal those computed by hand. */
static void test_compare_different(void **state) {
    (void)state;
    Picture a;
    Picture b;
    Picture map;
    assert_true(picture_init(&a, 4, 1, NULL));
    assert_true(picture_init(&b, 4, 1, NULL));
    assert_true(picture_init(&map, 4, 1, NULL));
    b.pixels[0] = 1;   // One step of difference: allowed.
    a.pixels[4] = 255; // The largest difference.
    PictureComparison comparison = picture_compare(&a, &b, &map);
    assert_int_equal(comparison.max_difference, 255);
    assert_true(comparison.differing_fraction == 0.25);
    double step_error = (1.0 + 255.0 * 255.0) / 12;
    assert_true(fabs(comparison.psnr - 10 * log10(255.0 * 255.0 / step_error)) < 1e-12);
    double dim = 1 / 255.0 / 12.92;
    assert_true(fabs(comparison.rmse - sqrt((1 + dim * dim) / 12)) < 1e-12);
    assert_in_range(map.pixels[0], 1, 254);
    assert_int_equal(map.pixels[3], 255);
    assert_int_equal(map.pixels[6], 0);
    picture_deinit(&a);
    picture_deinit(&b);
    picture_deinit(&map);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_rows),
        cmocka_unit_test(test_steps_round_trip),
        cmocka_unit_test(test_white),
        cmocka_unit_test(test_thresholds),
        cmocka_unit_test(test_one_threshold_a_cell),
        cmocka_unit_test(test_odd_lights),
        cmocka_unit_test(test_many_lights),
        cmocka_unit_test(test_compare_equal),
        cmocka_unit_test(test_compare_different),
    };
    return cmocka_run_group_tests_name("picture", tests, NULL, NULL);
}
