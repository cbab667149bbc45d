// SPDX-License-Identifier: BSD-3-Clause
// Inner loops that compilers turn into vector instructions, compiled for several widths: the widest
// that the processor has is chosen at run time.
#pragma once

#if defined(__GNUC__)
#define FLATTENING_INLINE inline __attribute__((always_inline))
#else
#define FLATTENING_INLINE inline
#endif
#if defined(__GNUC__) && defined(__x86_64__)
#define FLATTENING_X86 1
#define FLATTENING_FOR_AVX2 __attribute__((target("avx2")))
#define FLATTENING_FOR_AVX512 __attribute__((target("avx512f")))
#else
#define FLATTENING_FOR_AVX2
#define FLATTENING_FOR_AVX512
#endif

namespace flattening
{
/// The function for the widest instructions that the processor has: for two, four or eight numbers
/// at a time.
template <typename Function>
Function forWidest(Function two, [[maybe_unused]] Function four, [[maybe_unused]] Function eight)
{
#if FLATTENING_X86
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f"))
  {
    return eight;
  }
  if (__builtin_cpu_supports("avx2"))
  {
    return four;
  }
#endif
  return two;
}
}
