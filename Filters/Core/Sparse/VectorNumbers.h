// SPDX-License-Identifier: BSD-3-Clause
// As many numbers as one instruction takes, for inner loops that are compiled for several widths
// and choose the widest that the processor has.
#pragma once

#include <array>
#include <cstring>

#if defined(__GNUC__)
#define FLATTENING_INLINE inline __attribute__((always_inline))
#else
#define FLATTENING_INLINE inline
#endif
#if defined(__GNUC__) && defined(__x86_64__)
#define FLATTENING_X86 1
#endif

namespace flattening
{
#if defined(__GNUC__)
using Double2 = double __attribute__((vector_size(16)));
using FourNumbers = double __attribute__((vector_size(32)));
using EightNumbers = double __attribute__((vector_size(64)));

/// From memory, where numbers may be of single precision.
template <typename Vector>
FLATTENING_INLINE void load(const double* from, Vector& to)
{
  std::memcpy(&to, from, sizeof(Vector));
}
FLATTENING_INLINE void load(const float* from, Double2& to)
{
  to = Double2{ double(from[0]), double(from[1]) };
}
FLATTENING_INLINE void load(const float* from, FourNumbers& to)
{
  float singles __attribute__((vector_size(16)));
  std::memcpy(&singles, from, sizeof(singles));
  to = __builtin_convertvector(singles, FourNumbers);
}
FLATTENING_INLINE void load(const float* from, EightNumbers& to)
{
  float singles __attribute__((vector_size(32)));
  std::memcpy(&singles, from, sizeof(singles));
  to = __builtin_convertvector(singles, EightNumbers);
}
#else
using Double2 = std::array<double, 2>;
#endif

/// The function for the widest instructions that the processor has.
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
