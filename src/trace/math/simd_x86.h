/**
 * @file
 * @brief Processor instructions (intrinsics) of x86; those of WebAssembly are in simd_wasm.h.
 *
 * LANES_MIN and LANES_MAX are `a < b ? a : b` and `a > b ? a : b` to the bit, as the instructions
 * define them. For a macro that is not defined for an engine, real.h and columns.h have plain C.
 */
#ifndef DIOPTRE_TRACE_MATH_SIMD_X86_H
#define DIOPTRE_TRACE_MATH_SIMD_X86_H

// <immintrin.h> takes a third of a second to compile, so only engines that need it include it.
#if LANES > 1 && defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

#if LANES > 1 && defined(__wasm_simd128__)
#include "trace/math/simd_wasm.h"
#elif LANES == 16 && defined(__AVX512DQ__)
/** Bit i set where lane i of the mask m is. */
#define LANES_BITS(m) (unsigned)_mm512_movepi32_mask((__m512i)(m))
/** Bit i set where a <= b in lane i, by one instruction. */
#define LANES_LESS_EQUAL_BITS(a, b)                                                                \
    (unsigned)_mm512_cmp_ps_mask((__m512)(a), (__m512)(b), _CMP_LE_OQ)
/** base[places[i]] in lane i. */
#define LANES_GATHER(base, places)                                                                 \
    (real) _mm512_i32gather_ps((__m512i)(places), base, sizeof(scalar))
/** Stores the lanes of x whose bits are set, one after another, and writes over what follows. */
#define LANES_COMPRESS(to, x, bits)                                                                \
    _mm512_storeu_ps(to, _mm512_maskz_compress_ps((__mmask16)(bits), (__m512)(x)))
/** Lane places[i] of x in lane i; of these numbers the lowest four bits count. */
#define LANES_PERMUTE(x, places) (real) _mm512_permutexvar_ps((__m512i)(places), (__m512)(x))
/** Half i of the lanes of a vector of integers. */
#define LANES_HALF(x, i)                                                                           \
    ((i) ? _mm512_extracti64x4_epi64((__m512i)(x), 1) : _mm512_castsi512_si256((__m512i)(x)))
/** Eight of the next wider numbers of two halves. @param places Which of the 16: half a vector. */
#define LANES_PERMUTE_HALVES(low, high, places)                                                    \
    (half_wide)                                                                                    \
        _mm512_permutex2var_pd((__m512d)(low), _mm512_cvtepi32_epi64(places), (__m512d)(high))
/** 64 bits in each pair of lanes. */
#define LANES_OF_BITS(bits) (integer) _mm512_set1_epi64((long long)(bits))
/** Lane i of x shifted to the right by lane i of counts, with zeros. */
#define LANES_SHIFT_RIGHT(x, counts) (integer) _mm512_srlv_epi32((__m512i)(x), (__m512i)(counts))
/** LANES_COMPRESS for eight of the next wider numbers, at x. */
#define LANES_COMPRESS_HALF(to, x, bits)                                                           \
    _mm512_storeu_pd(to, _mm512_maskz_compress_pd((__mmask8)(bits), _mm512_loadu_pd(x)))
/** LANES_COMPRESS for the next wider numbers, at x: eight at a time. */
#define LANES_COMPRESS_WIDE(to, x, bits)                                                           \
    (LANES_COMPRESS_HALF(to, x, (bits)&255),                                                       \
     LANES_COMPRESS_HALF((to) + __builtin_popcount((bits)&255), (const double *)(x) + 8,           \
                         (bits) >> 8))
/** a where the mask m is set, b elsewhere; compiled to one instruction. */
#define LANES_SELECT(m, a, b) (real)(((m) & (mask)(a)) | (~(m) & (mask)(b)))
/** The minimum; b if either is NaN. */
#define LANES_MIN(a, b) (real) _mm512_min_ps((__m512)(a), (__m512)(b))
/** The maximum; b if either is NaN. */
#define LANES_MAX(a, b) (real) _mm512_max_ps((__m512)(a), (__m512)(b))
/** The largest integer that is not larger. */
#define LANES_FLOOR(x) (real) _mm512_floor_ps((__m512)(x))
#elif LANES == 8 && defined(__AVX2__)
/** For each set of four lanes, their numbers, one per byte: those lanes first. */
static const uint32_t FOUR_LANES_FIRST[16] = {0,     0,       0x1,     0x100,    0x2,   0x200,
                                              0x201, 0x20100, 0x3,     0x300,    0x301, 0x30100,
                                              0x302, 0x30200, 0x30201, 0x3020100};
/** Stores the lanes of x whose bits are set, one after another, and writes over what follows. */
static inline __attribute__((always_inline)) void lanes_compress(float *to, __m256 x,
                                                                 unsigned bits) {
    const uint32_t last_four = 0x4040404; // Added to each number: lanes 4 to 7.
    uint64_t low = FOUR_LANES_FIRST[bits & 15], high = FOUR_LANES_FIRST[bits >> 4] + last_four;
    uint64_t order = low | high << 8 * __builtin_popcount(bits & 15);
    __m256i lanes = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128((long long)order));
    _mm256_storeu_ps(to, _mm256_permutevar8x32_ps(x, lanes));
}
/** Stores the lanes of x whose bits are set, one after another, and writes over what follows. */
#define LANES_COMPRESS(to, x, bits) lanes_compress(to, (__m256)(x), bits)
/** Lane places[i] of x in lane i; of these numbers the lowest three bits count. */
#define LANES_PERMUTE(x, places) (real) _mm256_permutevar8x32_ps((__m256)(x), (__m256i)(places))
/** 32 bits in each lane. */
#define LANES_OF_BITS(bits) (integer) _mm256_set1_epi32((int)(bits))
/** Lane i of x shifted to the right by lane i of counts, with zeros. */
#define LANES_SHIFT_RIGHT(x, counts) (integer) _mm256_srlv_epi32((__m256i)(x), (__m256i)(counts))
/** #lanes_compress for four of the next wider numbers. @param bits Of these four. */
static inline __attribute__((always_inline)) void lanes_compress_wide(double *to, __m256d x,
                                                                      unsigned bits) {
    // Each is two numbers of 32 bits for the permutation.
    __m256i twice =
        _mm256_slli_epi64(_mm256_cvtepu8_epi64(_mm_cvtsi32_si128((int)FOUR_LANES_FIRST[bits])), 1);
    __m256i next = _mm256_add_epi64(twice, _mm256_set1_epi64x(1));
    __m256i halves = _mm256_or_si256(twice, _mm256_slli_epi64(next, 32));
    __m256 y = _mm256_permutevar8x32_ps(_mm256_castpd_ps(x), halves);
    _mm256_storeu_pd(to, _mm256_castps_pd(y));
}
/** LANES_COMPRESS for the next wider numbers, at x: four at a time. */
#define LANES_COMPRESS_WIDE(to, x, bits)                                                           \
    (lanes_compress_wide(to, _mm256_loadu_pd((const double *)(x)), (bits)&15),                     \
     lanes_compress_wide((to) + __builtin_popcount((bits)&15),                                     \
                         _mm256_loadu_pd((const double *)(x) + 4), (bits) >> 4))
/** Bit i set where lane i of the mask m is. */
#define LANES_BITS(m) (unsigned)_mm256_movemask_ps((__m256)(m))
/** base[places[i]] in lane i. */
#define LANES_GATHER(base, places)                                                                 \
    (real) _mm256_i32gather_ps(base, (__m256i)(places), sizeof(scalar))
/** a where the mask m is set, b elsewhere. */
#define LANES_SELECT(m, a, b) (real) _mm256_blendv_ps((__m256)(b), (__m256)(a), (__m256)(m))
/** The minimum; b if either is NaN. */
#define LANES_MIN(a, b) (real) _mm256_min_ps((__m256)(a), (__m256)(b))
/** The maximum; b if either is NaN. */
#define LANES_MAX(a, b) (real) _mm256_max_ps((__m256)(a), (__m256)(b))
/** The largest integer that is not larger. */
#define LANES_FLOOR(x) (real) _mm256_floor_ps((__m256)(x))
#elif LANES == 4 && REAL_BITS == 64 && defined(__AVX2__)
#define LANES_BITS(m) (unsigned)_mm256_movemask_pd((__m256d)(m))
/** For each set of two lanes, whether the second comes first: bit 1 of each lane counts. */
static const int64_t TWO_LANES_FIRST[4][2] = {{0, 0}, {0, 0}, {2, 2}, {0, 2}};
/** See above: two lanes at a time. */
static inline __attribute__((always_inline)) void lanes_compress(double *to, __m256d x,
                                                                 unsigned bits) {
    const __m128i *orders = (const __m128i *)TWO_LANES_FIRST;
    __m128d low = _mm256_castpd256_pd128(x), high = _mm256_extractf128_pd(x, 1);
    _mm_storeu_pd(to, _mm_permutevar_pd(low, _mm_loadu_si128(&orders[bits & 3])));
    _mm_storeu_pd(to + __builtin_popcount(bits & 3),
                  _mm_permutevar_pd(high, _mm_loadu_si128(&orders[bits >> 2])));
}
#define LANES_COMPRESS(to, x, bits) lanes_compress(to, (__m256d)(x), bits)
#define LANES_GATHER(base, places)                                                                 \
    (real) _mm256_i64gather_pd(base, (__m256i)(places), sizeof(scalar))
#define LANES_SELECT(m, a, b) (real) _mm256_blendv_pd((__m256d)(b), (__m256d)(a), (__m256d)(m))
#define LANES_MIN(a, b) (real) _mm256_min_pd((__m256d)(a), (__m256d)(b))
#define LANES_MAX(a, b) (real) _mm256_max_pd((__m256d)(a), (__m256d)(b))
#define LANES_FLOOR(x) (real) _mm256_floor_pd((__m256d)(x))
#elif LANES == 4 && REAL_BITS == 32 && defined(__SSE2__)
#define LANES_BITS(m) (unsigned)_mm_movemask_ps((__m128)(m))
#define LANES_SELECT(m, a, b) (real)(((m) & (mask)(a)) | (~(m) & (mask)(b)))
#define LANES_MIN(a, b) (real) _mm_min_ps((__m128)(a), (__m128)(b))
#define LANES_MAX(a, b) (real) _mm_max_ps((__m128)(a), (__m128)(b))
#elif LANES > 1
#define LANES_SELECT(m, a, b) (real)(((m) & (mask)(a)) | (~(m) & (mask)(b)))
#define LANES_MIN(a, b) real_select((a) < (b), a, b)
#define LANES_MAX(a, b) real_select((a) > (b), a, b)
#else
#define LANES_SELECT(m, a, b) ((m) ? (a) : (b))
#define LANES_MIN(a, b) ((a) < (b) ? (a) : (b))
#define LANES_MAX(a, b) ((a) > (b) ? (a) : (b))
#endif

// Packs of a few numbers: see math/pack.h.
#if LANES > 1
/** The minimum per number; b if either is NaN. */
#define PACK_MIN(a, b) LANES_MIN(a, b)
/** The maximum per number; b if either is NaN. */
#define PACK_MAX(a, b) LANES_MAX(a, b)
/** Bit i set where truth value i is. */
#define PACK_BITS(m) mask_bits(m)
#elif REAL_BITS == 64 && defined(__SSE2__)
#define PACK_MIN(a, b) (PackReal) _mm_min_pd((__m128d)(a), (__m128d)(b))
#define PACK_MAX(a, b) (PackReal) _mm_max_pd((__m128d)(a), (__m128d)(b))
#define PACK_BITS(m) (unsigned)_mm_movemask_pd((__m128d)(m))
#elif defined(__SSE2__)
#define PACK_MIN(a, b) (PackReal) _mm_min_ps((__m128)(a), (__m128)(b))
#define PACK_MAX(a, b) (PackReal) _mm_max_ps((__m128)(a), (__m128)(b))
#define PACK_BITS(m) (unsigned)_mm_movemask_ps((__m128)(m))
#else
/** @return The bits of a vector of truth values. */
static inline __attribute__((always_inline)) unsigned
pack_bits(lane_integer __attribute__((vector_size(16))) m) {
    unsigned bits = 0;
    for (unsigned i = 0; i < sizeof m / sizeof m[0]; i++) {
        bits |= (m[i] ? 1u : 0u) << i;
    }
    return bits;
}
#define PACK_MIN(a, b) (PackReal)((((a) < (b)) & (PackMask)(a)) | (~((a) < (b)) & (PackMask)(b)))
#define PACK_MAX(a, b) (PackReal)((((a) > (b)) & (PackMask)(a)) | (~((a) > (b)) & (PackMask)(b)))
#define PACK_BITS(m) pack_bits(m)
#endif

#endif
