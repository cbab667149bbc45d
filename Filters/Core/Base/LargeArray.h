// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace flattening
{
inline constexpr std::size_t largePage = std::size_t(1) << 21; ///< of x86, and of most of ARM
/// From here on one large page is sooner there than the small ones.
inline constexpr std::size_t worthLargePages = largePage / 4;

/// Memory for this number of bytes. Much of it comes in large pages where the system has them,
/// since a first touch of a small one costs as much as some thousand operations, and goes back to
/// the system at once. Throws std::bad_alloc.
void* allocateLarge(std::size_t bytes);
void releaseLarge(void* memory, std::size_t bytes) noexcept;

/// Allocates so, and leaves numbers open that are made without a value.
template <typename Value>
struct LargeAllocator
{
  using value_type = Value;
  static_assert(alignof(Value) <= alignof(std::max_align_t));

  LargeAllocator() = default;
  template <typename Other>
  LargeAllocator(const LargeAllocator<Other>&) noexcept // NOLINT(google-explicit-constructor)
  {
  }
  Value* allocate(std::size_t count)
  {
    // std::vector has compared the count with its max_size(): the product does not overflow.
    return static_cast<Value*>(allocateLarge(count * sizeof(Value)));
  }
  void deallocate(Value* memory, std::size_t count) noexcept
  {
    releaseLarge(memory, count * sizeof(Value));
  }
  template <typename Made, typename... Arguments>
  void construct(Made* place, Arguments&&... arguments)
  {
    if constexpr (sizeof...(Arguments) == 0)
    {
      ::new (static_cast<void*>(place)) Made;
    }
    else
    {
      ::new (static_cast<void*>(place)) Made(std::forward<Arguments>(arguments)...);
    }
  }
  template <typename Other>
  bool operator==(const LargeAllocator<Other>&) const noexcept
  {
    return true;
  }
  template <typename Other>
  bool operator!=(const LargeAllocator<Other>&) const noexcept
  {
    return false;
  }
};

/// For as many values as a surface has triangles, or a matrix entries. Numbers that resize() adds
/// have no value yet.
template <typename Value>
using LargeArray = std::vector<Value, LargeAllocator<Value>>;
}
