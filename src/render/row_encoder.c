/**
 * @file
 * @brief Encoding of rows, one ray at a time and eight at once.
 *
 * Engines have vectors by the extensions of the compiler; those have no look-up in a table. The
 * rooms outside the engines are compiled for any processor, so this file asks which one it is.
 */
#include "render/row_encoder.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

void row_encode_from(const Encoder *encoder, const SampleRow *row, int first, uint8_t *rgb) {
    for (int i = first; i < row->columns; i++) {
        double per_count = 1.0 / row->counts[i];
        for (size_t channel = 0; channel < 3; channel++) {
            float linear = (float)(row->sums[channel * row->plane + (size_t)i] * per_count);
            rgb[3 * (size_t)i + channel] = encoder_encode(encoder, linear);
        }
    }
}

#if defined(__x86_64__)

/** Rays at once. */
enum { ROW_LANES = 8 };

/** A function for processors with AVX2. */
#define AVX2 __attribute__((target("avx2")))

/** @return Eight sums times two halves of factors, rounded to float. */
static inline AVX2 __m256 average_avx2(const double *sums, __m256d low, __m256d high) {
    __m128 first = _mm256_cvtpd_ps(_mm256_mul_pd(_mm256_loadu_pd(sums), low));
    __m128 last = _mm256_cvtpd_ps(_mm256_mul_pd(_mm256_loadu_pd(sums + ROW_LANES / 2), high));
    return _mm256_set_m128(last, first);
}

/** @return Eight codes: encoder_encode(). Of NaN, the maximum takes its second operand. */
static inline AVX2 __m256i encode_avx2(const Encoder *encoder, __m256 linear) {
    __m256 light = _mm256_min_ps(_mm256_max_ps(linear, _mm256_setzero_ps()), _mm256_set1_ps(1));
    __m256i cells = _mm256_cvttps_epi32(_mm256_mul_ps(light, _mm256_set1_ps(ENCODER_CELLS)));
    // Four bytes are loaded, of which the lowest is the code: the table has room behind itself.
    __m256i codes = _mm256_and_si256(
        _mm256_i32gather_epi32((const int *)(const void *)encoder->first_codes, cells, 1),
        _mm256_set1_epi32(0xff));
    __m256 next = _mm256_i32gather_ps(encoder->thresholds + 1, codes, sizeof(float));
    __m256 is_beyond = _mm256_cmp_ps(light, next, _CMP_GE_OQ);
    return _mm256_sub_epi32(codes, _mm256_castps_si256(is_beyond));
}

/** Writes red, green and blue of eight rays: 24 bytes. */
static inline AVX2 void rgb_store_avx2(__m256i red, __m256i green, __m256i blue, uint8_t *rgb) {
    __m256i pixels = _mm256_or_si256(
        red, _mm256_or_si256(_mm256_slli_epi32(green, 8), _mm256_slli_epi32(blue, 16)));
    const __m256i without_fourth =
        _mm256_setr_epi8(0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, -1, -1, -1, -1, 0, 1, 2, 4, 5, 6,
                         8, 9, 10, 12, 13, 14, -1, -1, -1, -1);
    const __m256i without_gap = _mm256_setr_epi32(0, 1, 2, 4, 5, 6, 3, 7);
    __m256i packed =
        _mm256_permutevar8x32_epi32(_mm256_shuffle_epi8(pixels, without_fourth), without_gap);
    _mm_storeu_si128((__m128i *)(void *)rgb, _mm256_castsi256_si128(packed));
    _mm_storel_epi64((__m128i *)(void *)(rgb + 16), _mm256_extracti128_si256(packed, 1));
}

/** Encodes the rays of a row eight by eight. @return The first ray that is left. */
static AVX2 int row_encode_avx2(const Encoder *encoder, const SampleRow *row, uint8_t *rgb) {
    const __m256d one = _mm256_set1_pd(1);
    int first = 0;
    for (; first + ROW_LANES <= row->columns; first += ROW_LANES) {
        const __m128i *counts = (const __m128i *)(const void *)(row->counts + first);
        __m256d low = _mm256_div_pd(one, _mm256_cvtepi32_pd(_mm_loadu_si128(counts)));
        __m256d high = _mm256_div_pd(one, _mm256_cvtepi32_pd(_mm_loadu_si128(counts + 1)));
        const double *sums = row->sums + first;
        __m256i red = encode_avx2(encoder, average_avx2(sums, low, high));
        __m256i green = encode_avx2(encoder, average_avx2(sums + row->plane, low, high));
        __m256i blue = encode_avx2(encoder, average_avx2(sums + 2 * row->plane, low, high));
        rgb_store_avx2(red, green, blue, rgb + 3 * first);
    }
    return first;
}

#endif

void row_encode(const Encoder *encoder, const SampleRow *row, uint8_t *rgb) {
    int first = 0;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) {
        first = row_encode_avx2(encoder, row, rgb);
    }
#endif
    row_encode_from(encoder, row, first, rgb);
}
