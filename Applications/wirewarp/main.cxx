// SPDX-License-Identifier: BSD-3-Clause
// The command, and how this process takes memory. Half the time of a surface of two million
// triangles went into first touches of small pages. What is freed is kept for what comes next, and
// much of it comes in large pages, VTK's and the standard library's arrays included.
#include "Command.h"

#include "Base/LargeArray.h"

#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__GLIBC__)
#include <malloc.h>
#include <sys/mman.h>

// NOLINTBEGIN(cppcoreguidelines-no-malloc): what operator new stands on
void* operator new(std::size_t bytes)
{
  using flattening::largePage;
  const std::size_t whole = (bytes + largePage - 1) / largePage * largePage;
  const bool large = bytes >= flattening::worthLargePages && whole >= bytes;
  void* const memory =
    large ? std::aligned_alloc(largePage, whole) : std::malloc(bytes > 0 ? bytes : 1);
  if (memory == nullptr)
  {
    throw std::bad_alloc();
  }
  if (large)
  {
    madvise(memory, bytes, MADV_HUGEPAGE); // where it is refused, pages stay small
  }
  return memory;
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}
// NOLINTEND(cppcoreguidelines-no-malloc)
#endif

int main(int argc, char** argv)
{
#if defined(__GLIBC__)
  constexpr int kept = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, kept);
  mallopt(M_TRIM_THRESHOLD, kept);
#endif
  wirewarp::runCommand(argc, argv);
}
