#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#  include <emmintrin.h>
#endif

// Vectors of eight floats or four doubles, by the extension that GCC and Clang share. The compiler
// splits them for processors without AVX2.
namespace medial
{

// Without AVX the compiler aligns them to 16 bytes only: what keeps them in memory is alignas(32).
using Float8 = float __attribute__((vector_size(32)));
using Double4 = double __attribute__((vector_size(32)));
using Long4 = std::int64_t __attribute__((vector_size(32))); ///< result of comparing Double4
using Int8 =
  int __attribute__((vector_size(32))); ///< result of a comparison: -1 where true, 0 where false

constexpr int kLanes = 8;
constexpr int kDoubleLanes = 4; ///< more are compared one by one

/// Keeps vectors in registers: functions marked so are inlined, and the caller decides for which
/// processor they are compiled.
#define MEDIAL_INLINE inline __attribute__((always_inline))

/// Compiles a function twice; the better version is picked when the program is loaded, which is too
/// early for ThreadSanitizer. Such a function must not throw, and so not allocate: GCC 12 assumes
/// at its calls that it does not, and an exception ends the program.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#  define MEDIAL_VECTORISED __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#  define MEDIAL_VECTORISED
#endif

MEDIAL_INLINE Float8 splat(float value)
{
  return Float8{} + value;
}

MEDIAL_INLINE Double4 splat(double value)
{
  return Double4{} + value;
}

MEDIAL_INLINE Float8 ramp()
{
  return Float8{ 0, 1, 2, 3, 4, 5, 6, 7 };
}

MEDIAL_INLINE Float8 min(Float8 a, Float8 b)
{
  return a < b ? a : b;
}

MEDIAL_INLINE Float8 max(Float8 a, Float8 b)
{
  return a > b ? a : b;
}

MEDIAL_INLINE Double4 min(Double4 a, Double4 b)
{
  return a < b ? a : b;
}

MEDIAL_INLINE Double4 max(Double4 a, Double4 b)
{
  return a > b ? a : b;
}

/// One instruction, since the library is compiled without errno for the functions of <cmath>.
MEDIAL_INLINE Float8 squareRoot(Float8 value)
{
  Float8 root{};
  for (int i = 0; i < kLanes; ++i)
  {
    root[i] = std::sqrt(value[i]);
  }
  return root;
}

MEDIAL_INLINE Float8 loaded(const float* from)
{
  Float8 value;
  std::memcpy(&value, from, sizeof(value));
  return value;
}

MEDIAL_INLINE Int8 loadedInts(const std::int32_t* from)
{
  Int8 value;
  std::memcpy(&value, from, sizeof(value));
  return value;
}

MEDIAL_INLINE void store(Float8 value, float* to)
{
  std::memcpy(to, &value, sizeof(value));
}

/// Bit i is set where lane i is true.
MEDIAL_INLINE unsigned bits(Int8 mask)
{
#ifdef __SSE2__
  __m128i halves[2];
  std::memcpy(halves, &mask, sizeof(halves));
  const __m128i words = _mm_packs_epi32(halves[0], halves[1]);
  return static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(words, __m128i{})));
#else
  constexpr Int8 kWeights = { 1, 2, 4, 8, 16, 32, 64, 128 };
  const Long4 parts = (Long4)(mask & kWeights);
  const long long sum = (parts[0] | parts[1]) | (parts[2] | parts[3]);
  return static_cast<unsigned>(sum) | static_cast<unsigned>(sum >> 32);
#endif
}

MEDIAL_INLINE unsigned bits(Long4 mask)
{
#ifdef __SSE2__
  __m128d halves[2];
  std::memcpy(halves, &mask, sizeof(halves));
  return static_cast<unsigned>(_mm_movemask_pd(halves[0]) | _mm_movemask_pd(halves[1]) << 2);
#else
  return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
#endif
}

/// Whether all lanes are true.
MEDIAL_INLINE bool all(Int8 mask)
{
  return bits(mask) == 0xffu;
}

} // namespace medial
